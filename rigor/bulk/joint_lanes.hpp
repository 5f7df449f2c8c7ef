#pragma once

#include "rigor/bulk/float_lanes.hpp"
#include "rigor/bulk/joint_forest.hpp"

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
  FloatSym3 inertia, inverse_inertia;
  FloatQuat turn;             ///< Since the begin of the step.
  FloatQuat next_turn;        ///< The same at the end of the substep, if velocities stay.
  FloatLanes resistance[21];  ///< To a push: of the body and of all that hangs on it; lower triangle.
  FloatLanes push[6];         ///< Impulse that is to be taken up.
  FloatLanes change[6];       ///< Of v and w.
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
  FloatVec3 offset;        ///< From J to K [m].
  FloatQuat J, K;          ///< Orientations of the joint's frames.
  FloatLanes length;       ///< Of a distance joint [m].
  FloatLanes lead;         ///< Of a screw [m/rad].

  FloatVec3 n[kMostJointRows], a_A[kMostJointRows], a_B[kMostJointRows];
  FloatLanes residual[kMostJointRows];  ///< What the next solve takes away of the rates.
  FloatLanes impulse[kMostJointRows];

  // Of the laws: u + softness (impulse) = target where `on` is 1, impulse = given where it is 0.
  FloatLanes on[kMostJointRows], softness[kMostJointRows], target[kMostJointRows], given[kMostJointRows];
  FloatLanes coordinate[kMostJointRows], rate[kMostJointRows], mobility[kMostJointRows];

  // Factors: L Lᵀ is the resistance of the child, F Fᵀ = C (L Lᵀ)⁻¹ Cᵀ + softness that of the joint, with its
  // rows C on the child and P on the parent.
  FloatLanes L[21];
  FloatLanes W[36];  ///< L⁻¹ Cᵀ, by columns.
  FloatLanes F[21];
  FloatLanes X[36];  ///< F⁻¹ P, by rows.
  FloatLanes t[6], z[6];
};

/// Eight alike trees at work.
struct JointBlock {
  JointTrees trees;
  std::vector<JointSlot> slots;
  std::vector<JointLanes> joints;  ///< Of each link.
  bool has_laws = false;
  bool gives = false;  ///< Whether the next solve begins with the given impulses.
};

/// Rows that a joint of this type holds, and those of its coordinates.
constexpr int held_row_count(JointType type, bool has_laws) {
  switch (type) {
    case JointType::fixed:
      return 6;
    case JointType::ball:
      return 3;
    case JointType::universal:
    case JointType::cylindrical:
      return 4;
    case JointType::planar:
      return 3;
    case JointType::distance:
      return has_laws ? 0 : 1;
    case JointType::gear:
      return 0;
    default:
      return 5;
  }
}
constexpr int law_row_count(JointType type, bool has_laws) {
  if (!has_laws) return 0;
  // A ball's damper acts about all axes.
  switch (type) {
    case JointType::fixed:
    case JointType::gear:
      return 0;
    case JointType::ball:
    case JointType::planar:
      return 3;
    case JointType::universal:
    case JointType::cylindrical:
      return 2;
    default:
      return 1;
  }
}
constexpr int row_count(const JointLink& link) {
  if (!link.has_joint) return 0;
  return held_row_count(link.type, link.has_laws) + law_row_count(link.type, link.has_laws);
}

}  // namespace rigor
