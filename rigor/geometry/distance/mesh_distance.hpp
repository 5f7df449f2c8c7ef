#pragma once

#include "rigor/geometry/convex/distance_result.hpp"
#include "rigor/geometry/shape/shape.hpp"
#include "rigor/math/pose.hpp"

namespace rigor {

/// Signed distance of a mesh and a shape that is not a mesh; A is the mesh, so the normal runs from the mesh
/// to b.
///
/// The minimum over the triangles, found by branch and bound over the mesh's tree. Where the shape cuts a
/// triangle, the distance is minus the penetration of that triangle, towards the nearer side. Where the
/// centre of the shape lies inside a closed mesh, the distance is minus the displacement out of it along the
/// normal at the nearest point of the surface, whether the shape cuts the surface or not. Against a
/// half-space it is exact over the vertices. The mesh must hold its tree.
DistanceResult mesh_signed_distance(const Mesh& mesh, const Pose& X_WM, const Shape& b, const Pose& X_WB);

}  // namespace rigor
