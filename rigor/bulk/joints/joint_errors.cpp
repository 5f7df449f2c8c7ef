#include "rigor/bulk/joints/joint_errors.hpp"

#include "rigor/core/index.hpp"
#include "rigor/math/rotation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigor {

Vec3 held_displacement(const Joint& joint, const Vec3& d, double twist) {
  const JointTraits& traits = joint_traits(joint.type);
  Vec3 held = Vec3::Zero();
  // The components along the axes that the type holds.
  for (int k = 0; k < 3; ++k) {
    if (traits.holds_displacement[at(k)]) held[k] = d[k];
  }
  // What the relation misses.
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

Vec3 held_turn(JointType type, const Quat& q_FK) {
  switch (joint_traits(type).held_rotation) {
    case LockedRotation::none:
      break;
    case LockedRotation::all:
      return rotation_log(q_FK);
    case LockedRotation::swing: {
      // From the axis z of F to that of K.
      const Vec3 z = q_FK * Vec3::UnitZ();
      const double sine = std::hypot(z.x(), z.y()), angle = std::atan2(sine, z.z());
      return sine > 0 ? Vec3(Vec3(-z.y(), z.x(), 0) * (angle / sine)) : Vec3(angle * Vec3::UnitX());
    }
    case LockedRotation::middle_angle: {
      // By how much z of F and x of K are not perpendicular.
      const Vec3 x = q_FK * Vec3::UnitX();
      const double cosine = std::hypot(x.x(), x.y()), angle = std::atan2(x.z(), cosine);
      return cosine > 0 ? Vec3(Vec3(x.y(), -x.x(), 0) * (angle / cosine)) : Vec3(angle * Vec3::UnitX());
    }
  }
  return Vec3::Zero();
}

double joint_error(const Joint& joint, const Pose& X_WA, const Pose& X_WB, double lever) {
  const Pose X_FK = (X_WA * joint.X_AF).inverse() * (X_WB * joint.X_BK);
  // The twist about z is twice the angle of the part (w, z) of the quaternion.
  const Quat q_FK = quaternion_of(X_FK.R);
  const double twist = 2 * std::atan2(q_FK.z(), q_FK.w());
  return std::hypot(held_displacement(joint, X_FK.p, twist).norm(),
                    lever * held_turn(joint.type, q_FK).norm());
}

}  // namespace rigor
