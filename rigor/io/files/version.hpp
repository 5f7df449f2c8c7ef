#pragma once

#include <string_view>

namespace rigor {

/// Version of this program, equal to that in the build file.
inline constexpr std::string_view version = "0.2.0";

}  // namespace rigor
