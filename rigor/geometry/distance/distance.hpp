#pragma once

#include "rigor/geometry/convex/distance_result.hpp"
#include "rigor/geometry/shape/shape.hpp"
#include "rigor/math/pose.hpp"

#include <optional>

namespace rigor {

/// Distance(A,B) of the course: the signed distance of two shapes. Closed forms where they exist, GJK and a
/// penetration algorithm otherwise, in double precision and in a frame near both shapes. signed_distance(A,B)
/// and signed_distance(B,A) agree bit for bit in `distance`. A mesh that bounds a convex
/// solid is that solid; of others see mesh_distance.hpp, mesh_pair_distance.hpp. Not defined for two
/// half-spaces (asserted).
///
/// Nothing is known of poses that are not finite, or so far apart that the square of their distance is not:
/// the distance and `upper` are infinite, `lower` is minus infinity, the points are zero and the normal is
/// +z.
DistanceResult signed_distance(const Shape& a, const Pose& X_WA, const Shape& b, const Pose& X_WB);
/// The same; nothing where they are farther apart than `reach` [m], which is often seen sooner.
std::optional<DistanceResult> distance_within(const Shape& a, const Pose& X_WA, const Shape& b,
                                              const Pose& X_WB, double reach);

}  // namespace rigor
