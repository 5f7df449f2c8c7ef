#pragma once

#include "rigor/model/model.hpp"

#include <array>
#include <vector>

namespace rigor {

/// A joint on its way from a body up to the next one. Slots number the bodies of a tree.
struct JointLink {
  std::array<int, 8> joints{};  ///< By model index, one a lane; -1 in lanes without a tree.
  JointType type = JointType::ball;
  bool has_joint = true;  ///< Not the root of a tree that floats.
  bool child_is_B = true;
  bool has_laws = false;        ///< Whether a coordinate has limits, a motor, a spring, a damper, friction.
  bool parent_is_free = false;  ///< Whether the parent is a dynamic body, of the same tree.
  int parent = 0;               ///< Its slot.
};

/// Up to eight trees of joints that are alike, one a lane. The links are in an order in which all children
/// of a body come before it; the child of link i has slot i, bodies that are not moved by joints have the
/// slots behind.
struct JointTrees {
  std::vector<JointLink> links;
  std::vector<std::array<int, 8>> bodies;  ///< Of each slot; the world and lanes without a tree: -1.
};

/// All joints of a model: trees, whose joints are held together at once, and joints that close loops of them
/// (gears among them).
struct JointForest {
  std::vector<JointTrees> trees;
  std::vector<int> closing;           ///< By model index, ascending.
  std::vector<bool> has_coordinates;  ///< Of each joint, whether something acts along its coordinates.
};
JointForest make_joint_forest(const Model& model);

/// A joint of any type but a gear as a tree of its own, in the first lane.
JointTrees single_joint_tree(const Model& model, int joint, bool has_coordinates);

}  // namespace rigor
