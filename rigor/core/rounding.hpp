#pragma once

#include <limits>

namespace rigor {

/// Distance from 1 to the next double, 2⁻⁵².
inline constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
/// Largest relative error of one rounding, 2⁻⁵³.
inline constexpr double kUnitRoundoff = kEpsilon / 2;
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace rigor
