#pragma once

#include "rigor/geometry/distance/distance.hpp"

#include <vector>

namespace rigor {

/// Signed distance of the two solids bounded by closed meshes (a broken promise otherwise), interiors
/// included: a solid that lies wholly inside the other penetrates it.
///
/// The solids are cut into convex pieces, exact up to rounding (once for each mesh). The signed distance is
/// the least signed distance of a piece of A and a piece of B: for separated solids their distance, for
/// overlapping ones minus the largest penetration depth of two pieces. So it is zero where the solids touch,
/// changes by no more than they move, is the convex signed distance if both are convex, and depends neither
/// on the frame nor on the order of A and B. No translation shorter than -distance separates the solids.
///
/// If a solid has more than MeshSolid::kMostPieces pieces, the result is minus the largest depth of a point,
/// max over p in both solids of its distance from the surface of either. It has the same properties except
/// that for convex solids; its bounds are farther apart (point_depth.hpp). For separated solids the distance
/// is then given as 0 with the upper bound infinity.
DistanceResult mesh_penetration(const Mesh& a, const Pose& X_WA, const Mesh& b, const Pose& X_WB);

/// The same for a closed mesh and a shape that is not a mesh, which is one convex piece. Against a half-space
/// the result is exact, from the vertices.
DistanceResult mesh_penetration(const Mesh& a, const Pose& X_WA, const Shape& b, const Pose& X_WB);

/// Whether at least one of the two shapes is a closed mesh and neither is an open one: the pairs for which
/// mesh_penetration knows how deep they overlap.
bool are_solid(const Shape& a, const Shape& b);
/// mesh_penetration() of two such shapes, in either order.
DistanceResult solid_distance(const Shape& a, const Pose& X_WA, const Shape& b, const Pose& X_WB);

/// Whether two closed meshes, or one and a convex shape, are seen to overlap by more than the depth [m]
/// although their surfaces only touch, as those of equal meshes at equal poses do: a point that far below the
/// middle of a triangle of one lies as far inside the other as well.
bool share_inside(const Shape& a, const Pose& X_WA, const Shape& b, const Pose& X_WB, double depth);

/// A connected region in which two solids overlap.
struct OverlapRegion {
  DistanceResult deepest;  ///< Signed distance of the two pieces that penetrate most.
  int pair_count = 0;      ///< Number of pairs of pieces that overlap there.
};

/// The regions where the solids overlap, deepest first; the first has the signed distance of
/// mesh_penetration. Two overlapping pairs of pieces belong to one region if their pieces of A are the same
/// or touch, and those of B as well. b may be a mesh or any bounded shape. For solids of too many pieces
/// there is one region without pairs.
std::vector<OverlapRegion> find_overlap_regions(const Mesh& a, const Pose& X_WA, const Shape& b,
                                                const Pose& X_WB);

}  // namespace rigor
