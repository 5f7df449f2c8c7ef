#pragma once

#include "rigor/model/joint.hpp"

namespace rigor {

/// What the joint holds at zero of the displacement d from F to K, by components along the axes of F [m];
/// `twist` is its angle about z [rad]. What the relation misses stands where no component is held: along z of
/// a screw, along x of a distance joint.
Vec3 held_displacement(const Joint& joint, const Vec3& d, double twist);
/// The rotation vector of what it holds of the rotation from F to K, along the axes of F [rad]: K turned back
/// by it is where the joint allows it.
Vec3 held_turn(JointType type, const Quat& q_FK);

/// How far a joint of any type but a gear is off: the length [m] of what it holds of the vector from F to K
/// and, times the lever [m], of the rotation.
double joint_error(const Joint& joint, const Pose& X_WA, const Pose& X_WB, double lever);

}  // namespace rigor
