#pragma once

#include <string_view>

namespace rigor {

/// Version of this program; the build file says the same.
inline constexpr std::string_view version = "0.2.0";

}  // namespace rigor
