#pragma once

#include "rigor/model/model.hpp"

#include <array>
#include <vector>

namespace rigor {

/// A joint of a system. Slots number the bodies of a system. In a tree a joint is on the way from its child
/// up to the next body.
struct JointLink {
  std::array<int, 8> joints{};  ///< By model index, one a lane; -1 in lanes without a system.
  JointType type = JointType::ball;
  bool has_joint = true;  ///< Not the root of a tree that floats.
  bool child_is_B = true;
  bool has_laws = false;        ///< Whether a coordinate has limits, a motor, a spring, a damper, friction.
  bool parent_is_free = false;  ///< Whether the parent is a dynamic body, of the same system.
  int child = 0;                ///< Its slot.
  int parent = 0;               ///< Its slot.

  bool is_plain_ball() const { return has_joint && type == JointType::ball && !has_laws; }
  bool is_hinge() const { return has_joint && type == JointType::hinge; }
};

/// A gear between the first coordinates of two joints.
struct GearLink {
  std::array<int, 8> joints{};  ///< The gears, by model index, one a lane; -1: none.
  int first = 0, second = 0;    ///< Links of the joints that it ties.
};

/// Up to eight systems of joints that are alike, one a lane. Bodies that joints move have the first slots.
struct JointSystems {
  /// In a tree all children of a body come before it, and the child of link i has slot i.
  std::vector<JointLink> links;
  std::vector<GearLink> gears;
  std::vector<std::array<int, 8>> bodies;  ///< Of each slot; the world and lanes without a system: -1.
  std::size_t moved = 0;                   ///< How many slots joints move.
  bool has_loops = false;                  ///< Or gears: no tree.
};

/// How many joints the bodies of each slot have.
std::vector<int> joint_counts(const JointSystems& systems);

/// All joints of a model: those that hang together, whether by bodies or by gears, are one system.
struct JointForest {
  std::vector<JointSystems> systems;  ///< Trees first.
  std::vector<bool> has_coordinates;  ///< Of each joint, whether something acts along its coordinates.
};
JointForest make_joint_forest(const Model& model);

/// Whether joints can move the body: not the world, nor one whose motion is given.
inline bool moves_freely(const Model& model, int body) {
  return body != world_body && model.body(body).motion == MotionType::dynamic;
}

}  // namespace rigor
