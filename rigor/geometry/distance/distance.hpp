#pragma once

#include "rigor/geometry/convex/distance_result.hpp"
#include "rigor/geometry/shape/shape.hpp"
#include "rigor/math/pose.hpp"

namespace rigor {

/// Distance(A,B) of the course, signed. Exact closed forms where they exist, GJK and a penetration algorithm
/// otherwise, in double and in a frame near both shapes. signed_distance(A,B) and signed_distance(B,A) agree
/// bit for bit in `distance`. Mesh against convex is the minimum over the triangles; two meshes as in
/// mesh_pair_distance.hpp. Not for two half-spaces (a broken promise).
///
/// Of poses that are not finite, or so far apart that the square of their distance is not, nothing is known:
/// the distance and `upper` are infinite, `lower` is minus infinity, the points are zero and the normal is
/// +z.
DistanceResult signed_distance(const Shape& a, const Pose& X_WA, const Shape& b, const Pose& X_WB);

}  // namespace rigor
