#pragma once

#include "rigor/core/rounding.hpp"

#include <cmath>

namespace rigor {

/// How far apart two times that a user or a sum of steps means to be one may be, by rounding [s].
inline double time_rounding_at(double t) {
  return 8 * kEpsilon * std::abs(t);
}
/// A time that is certainly before t.
inline double just_before(double t) {
  return t - 2 * time_rounding_at(t);
}

}  // namespace rigor
