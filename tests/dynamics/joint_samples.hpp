#pragma once

#include "rigor/dynamics/joint_rows.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/model/force.hpp"

#include "random_vectors.hpp"

#include <ostream>
#include <utility>
#include <vector>

namespace rigor::tests {

inline Mat3 turned(const Vec3& phi) {
  return rotation_matrix(rotation_exp(phi));
}

/// Where a body is after the time t with constant velocities.
inline BodyMotion moved(const BodyMotion& body, double t) {
  return {body.x + t * body.v, turned(t * body.w) * body.R, body.v, body.w};
}

inline BodyMotion random_motion(test::Random& random) {
  const Vec3 x = random.vector(), turn = 2 * random.vector(), v = 0.5 * random.vector(),
             w = 0.5 * random.vector();
  return {x, turned(turn), v, w};
}

/// Joint of bodies 0 and 1 with frames anywhere on them; pitch 0.3 m, length 1.7 m.
inline Joint random_joint(JointType type, test::Random& random) {
  Joint joint;
  joint.type = type;
  joint.body_A = 0;
  joint.body_B = 1;
  const Vec3 turn_F = 2 * random.vector(), p_F = random.vector(), turn_K = 2 * random.vector(),
             p_K = random.vector();
  joint.X_AF = {turned(turn_F), p_F};
  joint.X_BK = {turned(turn_K), p_K};
  joint.parameter = 0.3;
  joint.length = 1.7;
  joint.axes.resize(static_cast<std::size_t>(coordinate_count(type)));
  return joint;
}

/// Puts B where K is at the given pose in J; velocities stay.
inline void place(const Joint& joint, const BodyMotion& A, const Pose& X_FK, BodyMotion& B) {
  const Pose X_WB = Pose{A.R, A.x} * joint.X_AF * X_FK * joint.X_BK.inverse();
  B.x = X_WB.p;
  B.R = X_WB.R;
}

/// A pose that the joint allows, and its coordinates.
struct AllowedPose {
  Pose X_FK;
  std::vector<double> coordinates;
};
inline AllowedPose random_allowed_pose(const Joint& joint, test::Random& random) {
  const double angle = 3 * random.number(), second = 3 * random.number();
  const Vec3 p = random.vector(), phi = random.vector(), z = Vec3::UnitZ();
  const Mat3 about_z = turned(angle * z);
  switch (joint.type) {
    case JointType::ball:
      return {{turned(1.5 * phi), Vec3::Zero()}, {1.5 * phi.norm()}};
    case JointType::hinge:
      return {{about_z, Vec3::Zero()}, {angle}};
    case JointType::slider:
      return {{Mat3::Identity(), p.z() * z}, {p.z()}};
    case JointType::universal:
      return {{about_z * turned(second * Vec3::UnitX()), Vec3::Zero()}, {angle, second}};
    case JointType::cylindrical:
      return {{about_z, p.z() * z}, {p.z(), angle}};
    case JointType::planar:
      return {{about_z, Vec3(p.x(), p.y(), 0)}, {p.x(), p.y(), angle}};
    case JointType::distance:
      return {{turned(phi), joint.length * p.normalized()}, {joint.length}};
    case JointType::screw:  // two whole turns are in the displacement alone
      return {{about_z, joint.parameter * (angle / (2 * M_PI) + 2) * z}, {angle}};
    case JointType::point_on_line:
      return {{turned(phi), p.z() * z}, {p.z()}};
    default:
      return {};
  }
}

inline const std::vector<JointType> kTypesWithRows = {
    JointType::fixed,     JointType::ball,         JointType::hinge,  JointType::slider,
    JointType::universal, JointType::cylindrical,  JointType::planar, JointType::distance,
    JointType::screw,     JointType::point_on_line};

}  // namespace rigor::tests

namespace rigor {

inline void PrintTo(JointType type, std::ostream* out) {
  *out << joint_type_name(type);
}

}  // namespace rigor
