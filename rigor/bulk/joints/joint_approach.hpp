#pragma once

#include "rigor/bulk/joints/joint_lanes.hpp"
#include "rigor/model/joint.hpp"

#include <vector>

namespace rigor {

/// A joint at the beginning of a step, along W's axes.
struct JointStart {
  Vec3 arm_A, arm_B;  ///< From the centres to the anchors [m].
  Vec3 offset;        ///< From F to K [m].
  Quat J, K;          ///< Orientations of the joint's frames.
};

/// A joint that its bodies miss by more than a substep puts back: within a step its lane sees a part of that,
/// which grows from substep to substep.
struct JointApproach {
  int link = 0, lane = 0;
  JointStart start;
  double length = 0;              ///< Of a distance joint [m].
  Vec3 gap = Vec3::Zero();        ///< What the joint holds of the offset, in W [m].
  double stretch = 0;             ///< Of a distance joint [m].
  Vec3 turn = Vec3::Zero();       ///< Rotation vector of what it holds of the rotation, in W [rad].
  double moved = 0, rotated = 0;  ///< Put back so far [m], [rad].
};

/// Notes the joint of the link and lane if its bodies miss it by more than kApproachSpeed h, h being the
/// substep [s].
void note_approach(const Joint& joint, const JointStart& start, int link, int lane, double h,
                   std::vector<JointApproach>& approaches);

/// Before each substep: the lanes see so much more of what is to be put back.
void approach(double h, std::vector<JointApproach>& approaches, JointBlock& block);

/// Writes a vector or a quaternion into a lane.
void set_lane(const Vec3& a, int lane, FloatVec3& to);
void set_lane(const Quat& q, int lane, FloatQuat& to);

}  // namespace rigor
