#pragma once

#include "rigor/geometry/convex/distance_result.hpp"
#include "rigor/geometry/shape/shape.hpp"
#include "rigor/math/pose.hpp"

namespace rigor {

/// Signed distance of two meshes that hold their trees. Exact where the surfaces are apart and neither lies
/// in the other; then the bounds are a few roundings wide. Otherwise as
/// rigor/geometry/distance/mesh_overlap.hpp says. Of open meshes the surfaces alone count.
DistanceResult mesh_pair_signed_distance(const Mesh& a, const Pose& X_WA, const Mesh& b, const Pose& X_WB);

/// Negative, zero or positive: an order of two meshes by their numbers, so that (a, b) and (b, a) can be
/// computed alike.
int compare_meshes(const Mesh& a, const Mesh& b);

/// Whether (b, a) is the order in which the pair is computed.
bool is_mesh_pair_swapped(const Mesh& a, const Pose& X_WA, const Mesh& b, const Pose& X_WB);

}  // namespace rigor
