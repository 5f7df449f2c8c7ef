#pragma once

#include "rigor/geometry/shape.hpp"
#include "rigor/math/pose.hpp"

namespace rigor {

/// Signed distance of two shapes with its proof.
struct DistanceResult {
  double distance;  ///< [m]; negative when the interiors overlap: minus the penetration depth.
  double lower;     ///< Certified lower bound of the true signed distance [m].
  double upper;     ///< Certified upper bound [m]; upper - lower is the duality gap.
  Vec3 p_WA;        ///< Witness point on A [m].
  Vec3 p_WB;        ///< Witness point on B; p_WB - p_WA = distance * n_W.
  Vec3 n_W;         ///< Unit normal from A to B.
};

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
