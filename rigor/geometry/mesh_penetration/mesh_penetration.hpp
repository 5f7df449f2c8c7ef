#pragma once

#include "rigor/geometry/distance/distance.hpp"

#include <vector>

namespace rigor {

/// Signed distance of two solids bounded by closed meshes (a broken promise otherwise), insides included:
/// what lies wholly inside the other penetrates it.
///
/// The solids are cut into convex pieces, exact up to rounding (once for each mesh). The signed distance is
/// the least of the signed distances of a piece of A and a piece of B: apart it is the distance; overlapping
/// it is minus the largest depth of two pieces. So it is zero where the solids touch, changes by no more than
/// they move, is the convex signed distance if both are convex, does not depend on the frame or on the order
/// of A and B. No translation shorter than -distance parts the solids.
///
/// A solid of more than MeshSolid::kMostPieces pieces: minus the largest depth of a point, max over p in both
/// solids of its distance from the surface of either, with the same properties but the third; its bounds are
/// farther apart (point_depth.hpp). Apart, the distance is then given as 0, with the upper bound infinity.
DistanceResult mesh_penetration(const Mesh& a, const Pose& X_WA, const Mesh& b, const Pose& X_WB);

/// The same of a closed mesh and a shape that is not a mesh: one convex piece. Against a half-space: exact
/// over the vertices.
DistanceResult mesh_penetration(const Mesh& a, const Pose& X_WA, const Shape& b, const Pose& X_WB);

/// Whether there is a closed mesh among the two shapes, and no open one: then mesh_penetration knows how deep
/// they overlap.
bool are_solid(const Shape& a, const Shape& b);
/// mesh_penetration of two such shapes.
DistanceResult solid_distance(const Shape& a, const Pose& X_WA, const Shape& b, const Pose& X_WB);

/// Whether two closed meshes, of which one may be a convex shape, are seen to overlap by more than the depth
/// [m] although their surfaces only touch, as those of equal meshes at equal poses: a point that far inside
/// one, under the middle of a triangle, lies as far inside the other.
bool share_inside(const Shape& a, const Pose& X_WA, const Shape& b, const Pose& X_WB, double depth);

/// A part of space where two solids overlap, not joined to the others.
struct OverlapRegion {
  DistanceResult deepest;  ///< Of the two pieces that penetrate each other most.
  int pair_count = 0;      ///< Pairs of pieces that overlap there.
};

/// The regions where the solids overlap, deepest first; the first has the signed distance of
/// mesh_penetration. Two overlapping pairs of pieces are of one region if their pieces of A are the same or
/// touch, and so do those of B. b may be a mesh, or any bounded shape. One region, with no pairs, for solids
/// of too many pieces.
std::vector<OverlapRegion> find_overlap_regions(const Mesh& a, const Pose& X_WA, const Shape& b,
                                                const Pose& X_WB);

}  // namespace rigor
