#pragma once

#include "rigor/model/joint.hpp"

namespace rigor {

/// How far a joint of any type but a gear is off: the length [m] of what it holds of the vector from F to K
/// and, times the lever [m], of the rotation.
double joint_error(const Joint& joint, const Pose& X_WA, const Pose& X_WB, double lever);

}  // namespace rigor
