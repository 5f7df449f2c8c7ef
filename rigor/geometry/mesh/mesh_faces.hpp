#pragma once

#include "rigor/geometry/mesh/triangle_tree.hpp"

namespace rigor {

/// Finds the faces of the surface, and the convex solid that it bounds if it bounds one; after
/// find_mesh_edges.
///
/// A patch of coplanar triangles is a face if its border is one convex polygon: however it is cut, the face
/// is the same. A closed surface of one shell whose patches are faces, whose edges are all convex, and which
/// turns about none of its vertices by 2π or more, bounds a convex solid.
///
/// Source: that local convexity suffices is the theorem of Tietze and Nakajima (1928).
void find_mesh_faces(const TriangleMesh& mesh, TriangleTree& tree);

}  // namespace rigor
