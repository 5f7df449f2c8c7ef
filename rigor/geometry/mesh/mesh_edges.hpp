#pragma once

#include "rigor/geometry/mesh/triangle_tree.hpp"
#include "rigor/geometry/shape/triangle_mesh.hpp"

namespace rigor {

/// Fills the parts of the tree that do not depend on its boxes: normals, neighbours, kinds of edges, flat
/// patches and their corners. Vertices are the same if their indices are.
void find_mesh_edges(const TriangleMesh& mesh, TriangleTree& tree);

}  // namespace rigor
