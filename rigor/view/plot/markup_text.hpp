#pragma once

#include <string>
#include <string_view>

namespace rigor {

/// The text escaped for use between tags and inside quotation marks of HTML and SVG.
std::string markup_text(std::string_view text);

}  // namespace rigor
