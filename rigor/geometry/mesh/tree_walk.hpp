#pragma once

#include "rigor/core/index.hpp"
#include "rigor/geometry/mesh/triangle_tree.hpp"

#include <cstddef>

namespace rigor {

// Traversal of the hierarchy of a mesh for callers that do not depend on the layout of its nodes. The root is
// node 0 if the tree is not empty.

inline bool has_triangles(const TriangleTree& tree) {
  return !tree.nodes.empty();
}

inline const Aabb& node_box(const TriangleTree& tree, std::size_t node) {
  return tree.nodes[node].box;
}

inline bool is_leaf(const TriangleTree& tree, std::size_t node) {
  return tree.nodes[node].count > 0;
}

/// Calls visit(child) for the children of an inner node.
template <typename Visit>
void for_each_child(const TriangleTree& tree, std::size_t node, const Visit& visit) {
  visit(node + 1);
  visit(at(tree.nodes[node].first));
}

/// Calls visit(triangle) for the triangles of a leaf.
template <typename Visit>
void for_each_triangle(const TriangleTree& tree, std::size_t leaf, const Visit& visit) {
  const TriangleTree::Node& node = tree.nodes[leaf];
  for (int k = 0; k < node.count; ++k) visit(tree.order[at(node.first + k)]);
}

}  // namespace rigor
