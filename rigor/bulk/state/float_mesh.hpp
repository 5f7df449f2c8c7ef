#pragma once

#include "rigor/bulk/lanes/float_lanes.hpp"
#include "rigor/geometry/mesh/triangle_tree.hpp"

#include <array>
#include <memory>
#include <vector>

namespace rigor {

/// What the narrow phase needs of a mesh: its triangles with their planes in 64 bits, and a tree of boxes in
/// 32 bits, eight of which are looked at together. Everything is in the mesh's frame M.
struct FloatMesh {
  /// Eight boxes; those left over are empty.
  struct alignas(32) Node {
    float lower[3][kLaneCount], upper[3][kLaneCount];  ///< [m].
    std::array<std::int32_t, kLaneCount> child;        ///< Index of a node, or ~t for triangle t.
  };
  struct Triangle {
    std::array<int, 3> vertices;
    std::array<int, 3> neighbour;      ///< Across the side from corner k to k + 1, or -1.
    std::array<MeshEdgeKind, 3> side;  ///< Of that side.
    std::array<bool, 3> is_corner;     ///< Whether corner k is a corner of the flat patch.
    int patch;                         ///< Least index of the triangles of the flat patch.
    Vec3 n;                            ///< Unit, outward.
    double offset;                     ///< n · p of its points [m].
  };

  std::vector<Node> nodes;  ///< Root first.
  std::vector<Triangle> triangles;
  std::vector<Vec3> vertices;  ///< [m].
  std::shared_ptr<const TriangleTree> topology;
  bool is_closed = false;

  /// Lists the triangles whose boxes meet the box, in an order of the tree's own.
  void list_near(const Eigen::Vector3f& lower, const Eigen::Vector3f& upper, std::vector<int>& stack,
                 std::vector<int>& triangles_near) const;
};

std::shared_ptr<const FloatMesh> make_float_mesh(const Mesh& mesh);

}  // namespace rigor
