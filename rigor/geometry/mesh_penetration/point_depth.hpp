#pragma once

#include "rigor/geometry/convex/distance_result.hpp"
#include "rigor/geometry/shape/shape.hpp"
#include "rigor/math/pose.hpp"

namespace rigor {

/// Minus the largest depth of a point in both solids: max over p in A and B of the larger of its distances
/// from the surfaces of A and of B. A is a closed mesh, b a closed mesh or a bounded convex shape. `upper`
/// and `lower` enclose it: 1 % apart, or more where the search would be very long; p_WA and p_WB are that
/// point and the surface point nearest to it. Distance 0 with the upper bound infinity if the solids have no
/// point in common.
DistanceResult deepest_point(const Mesh& a, const Pose& X_WA, const Shape& b, const Pose& X_WB);

}  // namespace rigor
