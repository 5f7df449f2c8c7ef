#pragma once

#include "rigor/core/index.hpp"
#include "rigor/geometry/lanes/lane_target.hpp"
#include "rigor/geometry/shape/triangle_mesh.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace rigor {

/// A box with axes of its own, in the frame of some mesh.
struct OrientedBox {
  Vec3 center;
  Mat3 axes;  ///< Columns: orthonormal.
  Vec3 half;  ///< Half lengths along them [m].
};

/// Hierarchy of oriented boxes over the triangles of a mesh, with up to eight children per node and one
/// triangle per leaf. The boxes are quantised to 16 bits per number (centre and half lengths on a grid of the
/// node, the axes as an integer quaternion), always so that they hold their triangles.
///
/// Oriented boxes: Gottschalk, Lin and Manocha, OBBTree: A Hierarchical Structure for Rapid Interference
/// Detection, SIGGRAPH 1996. Cuts by the surface-area heuristic: Wald, On Fast Construction of SAH-based
/// Bounding Volume Hierarchies, IEEE Symposium on Interactive Ray Tracing, 2007. The packing is ours.
struct WideTree {
  static constexpr int kWidth = 8;

  struct Node {
    std::array<double, 3> origin{};  ///< Of the grid of centres [m].
    double center_unit = 0;          ///< [m].
    double half_unit = 0;            ///< [m].
    std::array<std::array<std::int16_t, kWidth>, 3> center{};
    std::array<std::array<std::uint16_t, kWidth>, 3> half{};
    std::array<std::array<std::int16_t, kWidth>, 4> turn{};  ///< w, x, y, z, not normalised.
    /// Index of a node, or ~t for triangle t.
    std::array<std::int32_t, kWidth> child{};
    int count = 0;  ///< Children.
  };

  std::vector<Node> nodes;  ///< Root first; empty if no triangle has an area.
  OrientedBox root;         ///< Holds all; along the axes of the mesh.

  /// A place in the tree is child `slot % kWidth` of node `slot / kWidth`, or the root (-1).
  int child_at(int slot) const { return slot < 0 ? 0 : nodes[at(slot / kWidth)].child[lane_of(slot)]; }
  OrientedBox box_at(int slot) const;

 private:
  static std::size_t lane_of(int slot) { return at(slot % kWidth); }
};

/// Builds the hierarchy over the triangles with these indices (each with an area).
WideTree make_wide_tree(const TriangleMesh& mesh, const std::vector<int>& triangles);

/// The other box of a test, in the frame of the node's mesh.
struct OtherBox {
  OrientedBox box;
  Vec3 direction = Vec3::Zero();  ///< A unit vector from the other box to the node along which the two may
                                  ///< be apart, or zero.
  double slack = 0;               ///< All bounds are lowered by this [m].
};

/// Bounds of the distance of each child of a node from another box: d², where d is a lower bound of the
/// distance less the slack, if that is positive; otherwise a number ≤ 0, the lower the deeper the boxes
/// overlap.
///
/// d is the largest of four gaps: along the axes of the child, between the child and the box about the other
/// one; the same with the roles exchanged; along the line of the two centres; and along the direction.
using ChildBounds = std::array<double, WideTree::kWidth>;
ChildBounds child_bounds(const WideTree::Node& node, const OtherBox& other,
                         LaneTarget target = best_lane_target());

}  // namespace rigor
