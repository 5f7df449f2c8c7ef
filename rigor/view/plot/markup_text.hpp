#pragma once

#include <string>
#include <string_view>

namespace rigor {

/// Text as it stands between tags and inside quotation marks of HTML and SVG.
std::string markup_text(std::string_view text);

}  // namespace rigor
