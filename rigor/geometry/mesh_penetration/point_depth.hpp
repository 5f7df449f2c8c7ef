#pragma once

#include "rigor/geometry/convex/distance_result.hpp"
#include "rigor/geometry/shape/shape.hpp"
#include "rigor/math/pose.hpp"

namespace rigor {

/// Minus the largest depth of a point in both solids [m]: the depth is the larger of its distances from the
/// surfaces of A and of B, and the maximum is over all points p in A and B. A is a closed mesh, b a closed
/// mesh or a bounded convex shape. `upper` and `lower` enclose the value, within 1 % unless the search would
/// be very long; p_WA and p_WB are the deepest point and the surface point nearest to it. If the solids have
/// no point in common, the distance is 0 with the upper bound infinity.
DistanceResult deepest_point(const Mesh& a, const Pose& X_WA, const Shape& b, const Pose& X_WB);

}  // namespace rigor
