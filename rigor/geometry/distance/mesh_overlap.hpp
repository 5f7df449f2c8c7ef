#pragma once

#include "rigor/geometry/convex/distance_result.hpp"
#include "rigor/geometry/shape/shape.hpp"
#include "rigor/math/pose.hpp"

namespace rigor {

/// Signed distance, zero or negative, of two meshes whose surfaces meet: minus the largest depth of two
/// triangles that meet.
///
/// The depth of two triangles is the shortest displacement of B that separates the two, along the normals of
/// A's faces, against those of B's, or along the common normals of two edges (from which both surfaces bend
/// away), each from the pairs that meet next to this one. For shallow overlaps that is the displacement that
/// moves the contact back; for deep ones it is a measure that vanishes where the bodies separate, not the
/// least translation. `lower` holds for the least translation: minus the displacement along n_W after which
/// no point of B lies below any of A.
DistanceResult overlap_distance(const Mesh& a, const Pose& X_WA, const Mesh& b, const Pose& X_WB);

/// Signed distance, negative, of mesh A whose surface lies inside the closed mesh B: minus the displacement
/// along the line of the nearest points of the surfaces that brings A past the point of B.
DistanceResult enclosed_distance(const Mesh& a, const Pose& X_WA, const Vec3& p_WA, const Vec3& p_WB);

}  // namespace rigor
