#pragma once

#include "rigor/geometry/convex/distance_result.hpp"
#include "rigor/geometry/shape/shape.hpp"
#include "rigor/math/pose.hpp"

namespace rigor {

/// Signed distance of a mesh and a shape that is not a mesh; A is the mesh, so the normal runs from the mesh
/// to b.
///
/// The minimum over the faces (mesh_faces.hpp) and the triangles of patches that are none, found by branch
/// and bound over the mesh's tree. Where the two overlap it is minus the largest depth of a part: a face, the
/// ball about the centre of the shape with that about it in the mesh, or a convex piece of a closed mesh if
/// the overlap is deeper than 1e-6 of its size. `upper` states that no shorter translation parts them,
/// `lower` is minus the length of one that does. Against a half-space it is exact over the vertices. The mesh
/// must hold its tree.
DistanceResult mesh_signed_distance(const Mesh& mesh, const Pose& X_WM, const Shape& b, const Pose& X_WB);

}  // namespace rigor
