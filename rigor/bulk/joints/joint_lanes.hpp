#pragma once

#include "rigor/bulk/joints/joint_forest.hpp"
#include "rigor/bulk/joints/joint_loop_solver.hpp"
#include "rigor/bulk/joints/taut_links.hpp"
#include "rigor/bulk/lanes/float_lanes.hpp"

#include <array>
#include <memory>
#include <vector>

namespace rigor {

/// A rotation in lanes.
struct FloatQuat {
  FloatLanes w;
  FloatVec3 v;
};

/// A body in lanes, and what the solve knows of it.
struct alignas(32) JointSlot {
  FloatVec3 v, w, dp, dr;
  FloatLanes inverse_mass, mass;
  FloatLanes moments[3], inverse_moments[3];  ///< About the principal axes.
  FloatVec3 axis0, axis1;                     ///< The first two of them at the beginning of the step.
  FloatSym3 inertia, inverse_inertia;         ///< Where the body is.
  FloatQuat rotation;                         ///< Since the beginning of the step.
  FloatQuat next_rotation;                    ///< The same at the end of the substep, if velocities stay.
  FloatLanes articulated[21];  ///< Inertia: of the body and of all that hangs on it; lower triangle.
  FloatLanes push[6];          ///< Impulse that is to be taken up.
  FloatLanes change[6];        ///< Of v and w, by the last solve.
  FloatVec3 made_v, made_w;    ///< All of the changes in this substep.
};

constexpr int kMostJointRows = 6;

/// A joint in lanes with the rows of its equations: of a row n, a_A, a_B the rate is
///
///   u = n · (v_B - v_A) + a_B · ω_B - a_A · ω_A.
///
/// The first rows are what the joint holds; those of its coordinates follow if laws act along them.
struct alignas(32) JointLanes {
  // Constant within a step: W's axes, at its begin.
  FloatVec3 arm_A, arm_B;  ///< From the centres to the anchors [m].
  FloatVec3 offset;        ///< From F to K [m].
  FloatQuat J, K;          ///< Orientations of the joint's frames.
  FloatLanes length;       ///< Of a distance joint [m].
  FloatLanes slack;        ///< Below which it makes nothing taut (Slack).
  FloatLanes parameter;    ///< Of the relation; per radian what is per turn.

  FloatVec3 n[kMostJointRows], a_A[kMostJointRows], a_B[kMostJointRows];
  FloatLanes residual[kMostJointRows];  ///< What the next solve takes away of the rates.
  FloatLanes impulse[kMostJointRows];

  // Of the laws: u + softness (impulse) = target where `on` is 1, impulse = given where it is 0.
  FloatLanes on[kMostJointRows], softness[kMostJointRows], target[kMostJointRows], given[kMostJointRows];
  FloatLanes coordinate[kMostJointRows], rate[kMostJointRows], mobility[kMostJointRows];
  bool has_law_on = false;  ///< Whether one is on in any lane; else the rows of laws are left out.

  // Factors: L Lᵀ is the articulated inertia of the child, F Fᵀ = C (L Lᵀ)⁻¹ Cᵀ + softness that of the joint,
  // with its rows C on the child and P on the parent.
  FloatLanes L[21];
  FloatLanes W[36];  ///< L⁻¹ Cᵀ, by columns.
  FloatLanes F[21];
  FloatLanes X[36];  ///< F⁻¹ P, by rows.
  FloatLanes t[6], z[6];
};

/// A ball joint without laws in lanes, on its way from the child up (docs/theory/bulk_joints.md, §2).
struct alignas(32) BallLanes {
  FloatVec3 arm_child, arm_parent;  ///< From the centres to the anchor [m].
  FloatVec3 wanted;  ///< Change of the anchor's velocity on the child against that on the parent.
  // Factors. Articulated inertia of the child to velocities u of its anchor and ω: (S, H; Hᵀ, L D Lᵀ).
  FloatLanes inverse_D[3], L[3];  ///< L: elements 10, 20, 21.
  FloatVec3 G[3];                 ///< Rows of H (L D Lᵀ)⁻¹.
  FloatSym3 S;                    ///< Articulated inertia of the anchor to u if the child rotates freely.
  FloatVec3 free_dw,
      reaction;  ///< If the anchor is held: the change of the child's ω, and what the anchor takes up.
};

/// What a body and all that hangs on it resist at an anchor, to its velocity u and to ω: (M, H; Hᵀ, J).
struct ArticulatedInertia {
  FloatSym3 M, J;
  FloatVec3 H[3];  ///< Rows.
};

/// A hinge in a tree in lanes, on its way from the child up (docs/theory/bulk_joints.md, §2).
struct alignas(32) HingeLanes {
  FloatVec3 arm_child, arm_parent, axis;  ///< Arms from the centres to the anchor [m].
  ArticulatedInertia all;                 ///< Of the child.
  FloatVec3 axis_force, axis_torque;      ///< What it resists to a rotation about the axis.
  FloatLanes follows, yields;  ///< How far that rotation is what is wanted, and gives way to a torque.
  // Changes of the child against the parent that are wanted, and the push that these leave.
  FloatVec3 wanted_u, wanted_w;
  FloatLanes wanted_turn;
  FloatVec3 force, torque;
  FloatLanes about_axis;  ///< The torque about it.
};

/// Gears in lanes.
struct GearLanes {
  std::array<double, kLaneCount> ratio{};
  /// What whole turns add to the coordinates' difference is a multiple of this; 0: anything, so that only
  /// rates are held.
  std::array<double, kLaneCount> period{};
  FloatLanes residual;
};

/// Eight alike systems at work.
struct JointBlock {
  JointSystems systems;
  std::vector<JointSlot> slots;
  std::vector<JointLanes> joints;  ///< Of each link.
  std::vector<BallLanes> balls;    ///< Of each link of a tree.
  std::vector<HingeLanes> hinges;  ///< Likewise, if there are any.
  std::vector<GearLanes> gears;
  std::unique_ptr<LoopSolver> loops;  ///< Of systems that are no trees.
  bool has_laws = false;
  bool is_of_balls = false;        ///< Trees of ball joints without laws.
  bool is_position_error = false;  ///< Whether the residuals are those of places, not of rates.
  bool gives = false;              ///< Whether the next solve begins with the given impulses.
  /// Whether the pull of joints makes bodies vibrate faster than substeps can follow; then, of all slots, by
  /// how much their inertia is raised.
  bool is_taut = false, may_be_taut = false;
  std::vector<TautBody> taut_bodies;
  std::vector<TautLink> taut_links;
};

/// Whether the rows need the orientations of the joint's frames: not those of a point or a distance.
constexpr bool needs_frames(JointType type, bool has_laws) {
  const JointTraits& traits = joint_traits(type);
  if (traits.relation == JointRelation::distance) return false;
  return has_laws || !traits.holds_point() || traits.held_rotation != LockedRotation::none ||
         traits.relation != JointRelation::none;
}

/// Rows that a joint of this type holds. A distance joint with laws is one with limits (JointForest), which
/// holds nothing.
constexpr int held_row_count(JointType type, bool has_laws) {
  const bool has_limits = has_laws && joint_traits(type).relation == JointRelation::distance;
  return has_limits ? 0 : held_row_count(type);
}
/// Rows of a coordinate: those of a whole rotation are about three axes, since its damper is isotropic.
constexpr int law_row_count(CoordinateType coordinate) {
  return coordinate == CoordinateType::whole_angle ? 3 : 1;
}
/// Rows of the coordinates of a joint of this type.
constexpr int law_row_count(JointType type, bool has_laws) {
  int count = 0;
  for (const CoordinateType coordinate : joint_traits(type).coordinates()) count += law_row_count(coordinate);
  return has_laws ? count : 0;
}
/// Whether the lanes of a joint have room for the rows of each type, and the first row of the k-th coordinate
/// is the k-th row behind those that are held.
constexpr bool do_all_types_fit() {
  for (const JointTraits& traits : joint_table) {
    const int laws = law_row_count(traits.type, true);
    if (held_row_count(traits.type, true) + laws > kMostJointRows) return false;
    if (traits.coordinate_count > 1 && laws != traits.coordinate_count) return false;
  }
  return true;
}
static_assert(do_all_types_fit(), "a type of joint has rows for which its lanes have no room");
constexpr int row_count(const JointLink& link) {
  if (!link.has_joint) return 0;
  return held_row_count(link.type, link.has_laws) + law_row_count(link.type, link.has_laws);
}

/// A correction leaves of places this part of the arms [rad²] at most, or another one is made.
constexpr float kSmallMiss = 1e-4F;

/// 1 in lanes in which the last solve has left more: it changes ω by Δω as if arms did not rotate meanwhile,
/// and is off by h² |ω| |Δω| of them. What it has stopped had rotated. Else 0.
RIGOR_FLOAT_LANES FloatLanes lanes_off(float h, const JointBlock& block) {
  FloatLanes most = float_lanes(0);
  for (std::size_t s = 0; s < block.systems.moved; ++s) {
    const JointSlot& slot = block.slots[s];
    const FloatVec3 change{slot.change[3], slot.change[4], slot.change[5]}, before = slot.w - change;
    const FloatLanes spin = float_max(dot(slot.w, slot.w), dot(before, before));
    most = float_max(most, spin * dot(change, change));
  }
  const float least = kSmallMiss / (h * h);
  return most > float_lanes(least * least) ? float_lanes(1) : float_lanes(0);
}

RIGOR_FLOAT_LANES bool is_zero(const FloatLanes& x) {
  bool all = true;
  for (int i = 0; i < kLaneCount; ++i) all = all && x[i] == 0;
  return all;
}

/// Rows of a joint that act now.
inline int acting_rows(const JointLink& link, const JointLanes& joint) {
  return joint.has_law_on ? row_count(link) : held_row_count(link.type, link.has_laws);
}

}  // namespace rigor
