#pragma once

#include "rigor/bulk/joints/joint_lanes.hpp"
#include "rigor/geometry/lanes/lane_target.hpp"

namespace rigor {

// Trees of ball joints without laws: what the stages of joint_stages.hpp do, in few passes.

/// Before the displacements: anchors meet after the time h [s].
void hold_balls(float h, LaneTarget target, JointBlock& block);
/// After the displacements: anchors move together; factors where the bodies are.
void slow_balls(LaneTarget target, JointBlock& block);

}  // namespace rigor
