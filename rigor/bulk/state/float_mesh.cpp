#include "rigor/bulk/state/float_mesh.hpp"

#include "rigor/bulk/lanes/lane_bits.hpp"
#include "rigor/core/index.hpp"
#include "rigor/geometry/lanes/lane_target.hpp"
#include "rigor/geometry/shape/triangle_mesh.hpp"

#include <bit>
#include <cmath>
#include <limits>

namespace rigor {

namespace {

constexpr float kNowhere = std::numeric_limits<float>::infinity();

/// A box in 32 bits that holds the one in 64 bits.
void put_box(const Aabb& box, std::size_t lane, FloatMesh::Node& node) {
  for (int k = 0; k < 3; ++k) {
    node.lower[k][lane] = std::nextafter(static_cast<float>(box.lower[k]), -kNowhere);
    node.upper[k][lane] = std::nextafter(static_cast<float>(box.upper[k]), kNowhere);
  }
}

Aabb box_of_triangle(const TriangleMesh& mesh, int t) {
  const std::array<int, 3>& corners = mesh.triangles[at(t)];
  Aabb box{mesh.vertices[at(corners[0])], mesh.vertices[at(corners[0])]};
  for (const int v : corners) box = box.united({mesh.vertices[at(v)], mesh.vertices[at(v)]});
  return box;
}

/// Fills in the node of this index, and those under it; returns the box about all of it.
Aabb fill_node(const WideTree& tree, const TriangleMesh& mesh, int index,
               std::vector<FloatMesh::Node>& nodes) {
  const WideTree::Node& from = tree.nodes[at(index)];
  Aabb all;
  for (std::size_t lane = 0; lane < kLaneCount; ++lane) {
    FloatMesh::Node& node = nodes[at(index)];
    node.child[lane] = 0;
    if (lane >= at(from.count)) {
      for (int k = 0; k < 3; ++k) node.lower[k][lane] = kNowhere, node.upper[k][lane] = -kNowhere;
      continue;
    }
    const int child = from.child[lane];
    const Aabb box = child < 0 ? box_of_triangle(mesh, ~child) : fill_node(tree, mesh, child, nodes);
    nodes[at(index)].child[lane] = child;
    put_box(box, lane, nodes[at(index)]);
    all = lane == 0 ? box : all.united(box);
  }
  return all;
}

RIGOR_FLOAT_LANES unsigned boxes_meet(const FloatMesh::Node& node, const Eigen::Vector3f& lower,
                                      const Eigen::Vector3f& upper) {
  IntLanes meets = IntLanes{} == IntLanes{};
  for (int k = 0; k < 3; ++k)
    meets &= (load_floats(node.lower[k]) <= float_lanes(upper[k])) &
             (load_floats(node.upper[k]) >= float_lanes(lower[k]));
  return lane_bits(meets);
}

RIGOR_FLOAT_LANES void near_kernel(const std::vector<FloatMesh::Node>& nodes, const Eigen::Vector3f& lower,
                                   const Eigen::Vector3f& upper, std::vector<int>& stack,
                                   std::vector<int>& near) {
  stack.assign(1, 0);
  while (!stack.empty()) {
    const FloatMesh::Node& node = nodes[at(stack.back())];
    stack.pop_back();
    for (unsigned bits = boxes_meet(node, lower, upper); bits != 0; bits &= bits - 1) {
      const int child = node.child[at(std::countr_zero(bits))];
      if (child < 0) {
        near.push_back(~child);
      } else {
        stack.push_back(child);
      }
    }
  }
}

#if defined(__x86_64__)
[[gnu::target("avx2")]] void near_avx2(const std::vector<FloatMesh::Node>& nodes,
                                       const Eigen::Vector3f& lower, const Eigen::Vector3f& upper,
                                       std::vector<int>& stack, std::vector<int>& near) {
  near_kernel(nodes, lower, upper, stack, near);
}
#endif

}  // namespace

void FloatMesh::list_near(const Eigen::Vector3f& lower, const Eigen::Vector3f& upper, std::vector<int>& stack,
                          std::vector<int>& triangles_near) const {
  triangles_near.clear();
  if (nodes.empty()) return;
#if defined(__x86_64__)
  if (best_lane_target() == LaneTarget::avx2) return near_avx2(nodes, lower, upper, stack, triangles_near);
#endif
  near_kernel(nodes, lower, upper, stack, triangles_near);
}

std::shared_ptr<const FloatMesh> make_float_mesh(const Mesh& mesh) {
  auto made = std::make_shared<FloatMesh>();
  const TriangleTree& tree = *mesh.tree;
  made->topology = mesh.tree;
  made->is_closed = tree.is_closed;
  made->vertices = mesh.mesh->vertices;
  // Planes through the first corners.
  for (std::size_t t = 0; t < tree.triangles.size(); ++t) {
    const TriangleTree::Triangle& from = tree.triangles[t];
    const std::array<int, 3>& corners = mesh.mesh->triangles[t];
    made->triangles.push_back({corners, from.neighbour, from.edge, from.is_patch_corner, from.patch,
                               from.normal, from.normal.dot(made->vertices[at(corners[0])])});
  }
  // The tree has the nodes of that for meshes against each other, with boxes along the axes.
  made->nodes.resize(tree.wide.nodes.size());
  if (!made->nodes.empty()) fill_node(tree.wide, *mesh.mesh, 0, made->nodes);
  return made;
}

}  // namespace rigor
