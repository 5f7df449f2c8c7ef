#pragma once

#include "rigor/geometry/convex/distance_result.hpp"
#include "rigor/geometry/shape/shape.hpp"
#include "rigor/math/pose.hpp"

namespace rigor {

/// Signed distance of two meshes that hold their trees. Exact where the surfaces are apart and neither lies
/// inside the other; the bounds are then a few roundings wide. Otherwise the depth of their convex pieces
/// (pieces_distance.hpp), or, of meshes that are open or have too many, as defined in mesh_overlap.hpp, with
/// minus the length of a translation that was found to part the surfaces as the lower bound. Of open meshes
/// only the surfaces count.
DistanceResult mesh_pair_signed_distance(const Mesh& a, const Pose& X_WA, const Mesh& b, const Pose& X_WB);

/// Order of two meshes by their numbers (negative, zero or positive), so that (a, b) and (b, a) can be
/// computed alike.
int compare_meshes(const Mesh& a, const Mesh& b);

/// Whether the pair is computed in the order (b, a).
bool is_mesh_pair_swapped(const Mesh& a, const Pose& X_WA, const Mesh& b, const Pose& X_WB);

}  // namespace rigor
