#include "rigor/bulk/joints/joint_errors.hpp"

#include "rigor/core/index.hpp"
#include "rigor/math/rotation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigor {

namespace {

/// What the joint holds of the displacement d from F to K, along the axes of F.
Vec3 held_displacement(const Joint& joint, const Vec3& d, double twist) {
  const JointTraits& traits = joint_traits(joint.type);
  Vec3 held = Vec3::Zero();
  // The components along the axes that the type holds.
  for (int k = 0; k < 3; ++k) {
    if (traits.holds_displacement[at(k)]) held[k] = d[k];
  }
  // What the relation misses stands where no component is held: along z of a screw, along x of a distance
  // joint.
  switch (traits.relation) {
    case JointRelation::none:
    case JointRelation::gear:
      break;
    case JointRelation::screw: {
      const double pitch = joint.parameter;
      const double off = d.z() - pitch / (2 * std::numbers::pi) * twist;
      held.z() = pitch == 0 ? off : std::remainder(off, pitch);
      break;
    }
    case JointRelation::distance: {
      const bool is_limited = !joint.axes.empty() && joint.axes[0].is_limited();
      held.x() = is_limited ? 0 : d.norm() - joint.length;
      break;
    }
  }
  return held;
}

/// The angle of what the joint holds of the rotation [rad].
double held_angle(JointType type, const Mat3& R_FK) {
  switch (joint_traits(type).held_rotation) {
    case LockedRotation::none:
      break;
    case LockedRotation::all:
      // The whole angle.
      return rotation_log(quaternion_of(R_FK)).norm();
    case LockedRotation::swing:
      // The angle between the two axes z.
      return std::atan2(std::hypot(R_FK(0, 2), R_FK(1, 2)), R_FK(2, 2));
    case LockedRotation::middle_angle:
      // By how much z of F and x of K are not perpendicular.
      return std::abs(std::asin(std::min(1.0, std::max(-1.0, R_FK(2, 0)))));
  }
  return 0;
}

}  // namespace

double joint_error(const Joint& joint, const Pose& X_WA, const Pose& X_WB, double lever) {
  const Pose X_FK = (X_WA * joint.X_AF).inverse() * (X_WB * joint.X_BK);
  // The twist about z is twice the angle of the part (w, z) of the quaternion.
  const Quat q_FK = quaternion_of(X_FK.R);
  const double twist = 2 * std::atan2(q_FK.z(), q_FK.w());
  return std::hypot(held_displacement(joint, X_FK.p, twist).norm(), lever * held_angle(joint.type, X_FK.R));
}

}  // namespace rigor
