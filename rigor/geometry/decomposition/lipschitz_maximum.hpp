#pragma once

#include "rigor/geometry/shape/aabb.hpp"

#include <functional>
#include <vector>

namespace rigor {

/// A function with Lipschitz constant 1 (its value changes by no more than the distance between two points)
/// over a region within a box. Negative values count as 0.
struct LipschitzFunction {
  std::function<double(const Vec3&)> value;
  /// A lower bound of the distance from the region: 0 in it, and somewhere positive outside.
  std::function<double(const Vec3&)> beyond;
  Aabb box;                    ///< Holds the region; finite.
  std::vector<Vec3> starts{};  ///< Points where a large value may be; those beyond the region are left out.
};

/// When a search for a maximum may end.
struct MaximumGoal {
  double relative_gap = 0.1;    ///< Between the bounds, against the lower one.
  double absolute_gap = 0;      ///< Or this one.
  double enough = 0;            ///< Or the maximum is known to be no larger than this.
  int max_evaluations = 20000;  ///< Or this many points were evaluated.
};

/// Bounds of a maximum.
struct MaximumBounds {
  double lower = 0;           ///< The value at `place`; 0 if no point of the region was met.
  double upper = 0;           ///< No point of the region has a larger value.
  Vec3 place = Vec3::Zero();  ///< The best point met.
};

/// Branch and bound: boxes are halved, the one with the largest bound (value at its centre plus half its
/// diagonal) first. Both bounds hold whenever the search ends.
MaximumBounds lipschitz_maximum(const LipschitzFunction& function, const MaximumGoal& goal);

}  // namespace rigor
