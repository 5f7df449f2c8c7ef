#pragma once

#include "rigor/model/findings.hpp"
#include "rigor/model/joint.hpp"

namespace rigor {

/// Checks the laws along the coordinates of a joint. start: the first coordinate at t = 0 (all others are 0).
void check_joint_axes(JointType type, const std::vector<JointAxis>& axes, double start, Findings& findings);

}  // namespace rigor
