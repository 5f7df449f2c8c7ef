#pragma once

#include "rigor/bulk/joints/joint_approach.hpp"
#include "rigor/bulk/joints/joint_laws.hpp"
#include "rigor/bulk/joints/joint_stages.hpp"
#include "rigor/bulk/state/bulk_bodies.hpp"
#include "rigor/core/index.hpp"

#include <array>
#include <vector>

namespace rigor {

using LaneArray = std::array<float, kLaneCount>;

/// Where a body, or the world, is at the beginning of a step.
struct BodyPlace {
  Vec3 x = Vec3::Zero();      ///< p_WB [m].
  Quat q = Quat::Identity();  ///< q_WB.
};
BodyPlace place_of(const BulkBodies& bodies, int body);

/// A block with the bodies that it stands for.
struct BulkJointBlock {
  JointBlock lanes;
  std::vector<JointRecords> records;
  /// Orientations of the joint's frames on its bodies.
  struct Frames {
    std::array<Quat, kLaneCount> q_AF, q_BK;
  };
  std::vector<Frames> frames;                   ///< Of each link; only of those whose rows need them.
  alignas(64) std::array<float, 16> nothing{};  ///< The world.
  alignas(64) std::array<std::array<float, 16>, kLaneCount> empty{};  ///< Of lanes whose bodies do not move.
  struct alignas(32) Velocities {
    FloatVec3 v, w;
  };
  std::vector<Velocities> before;  ///< At the beginning of a solve, of bodies that joints with laws move.
  unsigned free_lanes = 0;         ///< Of trees that ContactFreeChains takes in this step, one bit each.
  /// As `records`, in this step, but with bodies of systems in flight alone: of none if there are none.
  std::vector<JointRecords> flying_records;
  std::vector<std::array<FloatLanes, kMostJointRows>> kept;  ///< keep_impulses().
  bool is_moving = true;   ///< Whether one of its bodies moves in this step: not all of them sleep.
  bool is_driven = false;  ///< Whether one of its bodies moves as it must.
  /// Of rows of laws, in the order of links, rows and lanes: what limits do after the displacements.
  struct Law {
    int link = 0, row = 0, axis = -1;  ///< Axis -1: a ball's damper across its axis.
    std::array<LawPiece, kLaneCount> pieces{};
    LaneArray rate{};                       ///< At the beginning of the substep.
    LaneArray last_rate{}, last_impulse{};  ///< At the end of the last solve before the displacements.
    /// Limits of lanes where nothing else acts; infinite where nothing does, NaN where more does.
    std::array<double, kLaneCount> lower, upper;
    bool is_off = false;                           ///< Whether no lane has an impulse, and the rows say so.
    LaneArray factored_on{}, factored_softness{};  ///< What the factors were made with.
  };
  std::vector<Law> laws;
  std::vector<JointApproach> approaches;  ///< In this step, of joints that its bodies miss.
};

BulkJointBlock make_joint_block(const Model& model, JointSystems systems);
/// Takes over the limits that the Model has now.
void read_limits(const Model& model, BulkJointBlock& block);

/// How a block is worked on.
struct JointEffort {
  const Model& model;
  float h = 0;  ///< Of a substep [s].
  LaneTarget target = LaneTarget::portable;
};

/// At the beginning of a step; the bodies stay where they are until its end.
/// `impulses`: those of all joints in a substep before, six numbers each, or none.
void prepare_joint_block(const JointEffort& effort, const std::vector<float>& impulses, BulkBodies& bodies,
                         BulkJointBlock& block);
/// After that: finds `flying_records`. `flies`, by body: as BulkJoints::find_flying() changes it.
void find_flying_lanes(const BulkBodies& bodies, std::vector<char>& flies, BulkJointBlock& block);
/// What is solved before the displacements of a substep, and after them. `anew`: takes back first what joints
/// have changed since the call of the same name before.
void solve_before_displacements(const JointEffort& effort, bool anew, BulkJointBlock& block);
/// (ends_substep: not if it is repeated, to hold what impacts change.)
void solve_after_displacements(const JointEffort& effort, bool ends_substep, BulkJointBlock& block);
/// Of the systems in flight, before the first substep (`are_displaced` is false) and after the last one:
/// their rates are what joints allow again after half a kick. These impulses are those of no substep.
void solve_flying_rates(const JointEffort& effort, bool are_displaced, BulkJointBlock& block);
/// Notes the impulses of all joints.
void keep_impulses(BulkJointBlock& block);
/// Displaces the bodies that the block moves.
void displace_bodies(float h, BulkBodies& bodies, const BulkJointBlock& block);
/// Calls visit(body) for each of these.
template <class Visit>
void for_moved_bodies(const BulkBodies& bodies, const BulkJointBlock& block, const Visit& visit) {
  for (std::size_t s = 0; s < block.lanes.systems.moved; ++s) {
    for (std::size_t lane = 0; lane < kLaneCount; ++lane) {
      const int body = block.lanes.systems.bodies[s][lane];
      // Lanes of systems that sleep, or are taken by ContactFreeChains, have records of their own.
      if (body >= 0 && block.records[s][lane] == bodies.motion[at(body)].v) visit(body);
    }
  }
}

}  // namespace rigor
