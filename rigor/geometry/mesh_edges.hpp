#pragma once

#include "rigor/geometry/triangle_mesh.hpp"
#include "rigor/geometry/triangle_tree.hpp"

namespace rigor {

/// Fills everything of the tree that does not need its boxes: normals, neighbours, kinds of edges, flat
/// patches and their corners. Vertices are the same if their indices are.
void find_mesh_edges(const TriangleMesh& mesh, TriangleTree& tree);

}  // namespace rigor
