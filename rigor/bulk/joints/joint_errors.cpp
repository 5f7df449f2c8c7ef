#include "rigor/bulk/joints/joint_errors.hpp"

#include "rigor/math/rotation.hpp"

#include <cmath>
#include <numbers>

namespace rigor {

namespace {

/// What the joint holds of the way d from J to K, along the axes of J.
Vec3 held_way(const Joint& joint, const Vec3& d, double twist) {
  switch (joint.type) {
    case JointType::slider:
    case JointType::cylindrical:
      return Vec3(d.x(), d.y(), 0);
    case JointType::planar:
      return Vec3(0, 0, d.z());
    case JointType::screw: {
      const double off = d.z() - joint.pitch / (2 * std::numbers::pi) * twist;
      return Vec3(d.x(), d.y(), joint.pitch == 0 ? off : std::remainder(off, joint.pitch));
    }
    case JointType::distance: {
      const bool is_limited = !joint.axes.empty() && joint.axes[0].is_limited();
      return Vec3(is_limited ? 0 : d.norm() - joint.length, 0, 0);
    }
    case JointType::gear:
      return Vec3::Zero();
    default:
      return d;
  }
}

/// The angle of what the joint holds of the rotation [rad].
double held_angle(JointType type, const Mat3& R_JK) {
  switch (type) {
    case JointType::fixed:
    case JointType::slider:
      return rotation_log(quaternion_of(R_JK)).norm();
    case JointType::hinge:
    case JointType::cylindrical:
    case JointType::planar:
    case JointType::screw:
      return std::atan2(std::hypot(R_JK(0, 2), R_JK(1, 2)), R_JK(2, 2));
    case JointType::universal:
      return std::abs(std::asin(std::min(1.0, std::max(-1.0, R_JK(2, 0)))));
    default:
      return 0;
  }
}

}  // namespace

double joint_error(const Joint& joint, const Pose& X_WA, const Pose& X_WB, double lever) {
  const Pose X_JK = (X_WA * joint.X_AJ).inverse() * (X_WB * joint.X_BK);
  const Quat q_JK = quaternion_of(X_JK.R);
  const double twist = 2 * std::atan2(q_JK.z(), q_JK.w());
  return std::hypot(held_way(joint, X_JK.p, twist).norm(), lever * held_angle(joint.type, X_JK.R));
}

}  // namespace rigor
