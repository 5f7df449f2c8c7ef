#pragma once

#include "rigor/bulk/bulk_bodies.hpp"
#include "rigor/bulk/joint_laws.hpp"
#include "rigor/bulk/joint_stages.hpp"

#include <array>
#include <vector>

namespace rigor {

using LaneArray = std::array<float, kLaneCount>;

/// The pose of a body, or of the world.
Pose bulk_pose(const BulkBodies& bodies, int body);

/// A block with the bodies that it stands for.
struct BulkJointBlock {
  JointBlock lanes;
  std::vector<JointRecords> records;
  alignas(64) std::array<float, 16> nothing{};                        ///< The world.
  alignas(64) std::array<std::array<float, 16>, kLaneCount> empty{};  ///< Of lanes whose bodies do not move.
  struct alignas(32) Made {
    FloatVec3 v, w;
  };
  std::vector<Made> before;  ///< Velocities at the begin of a solve.
  std::vector<Made> made;    ///< What this substep has changed.
  bool is_new_substep = true;
  bool stirs = true;  ///< Whether one of its bodies moves in this step: not all of them sleep.
  /// Of rows of laws, in the order of links, rows and lanes: what limits do after the displacements.
  struct Law {
    int link = 0, row = 0, axis = -1;  ///< Axis -1: a ball's damper across its axis.
    std::array<LawPiece, kLaneCount> pieces{};
    LaneArray prior{};  ///< Impulses of earlier turns of this substep.
    LaneArray rate{};   ///< At its begin.
  };
  std::vector<Law> laws;
};

BulkJointBlock make_joint_block(JointTrees trees);

/// How a block is worked on.
struct JointEffort {
  const Model& model;
  float h = 0;  ///< Of a substep [s].
  LaneTarget target = LaneTarget::portable;
};

/// At the begin of a step.
void prepare_joint_block(const JointEffort& effort, const BulkBodies& bodies, BulkJointBlock& block);
/// Where the bodies are; their vector may have moved since the last call.
void find_joint_records(BulkBodies& bodies, BulkJointBlock& block);
/// Velocities from which changes are counted, and the count of what has been changed since.
void keep_joint_velocities(BulkJointBlock& block);
void add_joint_change(BulkJointBlock& block);
/// What is solved before the displacements of a substep, and after them. Several turns may be taken.
void solve_before_displacements(const JointEffort& effort, BulkJointBlock& block);
void solve_after_displacements(const JointEffort& effort, BulkJointBlock& block);

}  // namespace rigor
