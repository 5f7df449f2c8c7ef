#include "rigor/geometry/motion/rigid_motion.hpp"

#include "rigor/math/rotation.hpp"

#include <algorithm>

namespace rigor {

double largest_acceleration(const RigidMotion& motion, double ta, double tb) {
  Vec3 along_axes = Vec3::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      along_axes[axis] =
          std::max(along_axes[axis], -motion.min_acceleration_along(sign * Vec3::Unit(axis), ta, tb));
    }
  }
  return along_axes.norm();
}

RigidMotion::Sample TwistMotion::sample(double t) const {
  const double tau = t - t_;
  const Mat3 R = w_.isZero(0) ? X_.R : (rotation_matrix(rotation_exp(tau * w_)) * X_.R).eval();
  return {{R, X_.p + tau * (v_ + 0.5 * tau * a_)}, v_ + tau * a_, w_};
}

ScrewMotion make_screw_motion(const Pose& X_WU, const Vec3& w_W, const Vec3& v_W) {
  const double squared = w_W.squaredNorm();
  if (squared == 0) return {TwistMotion(X_WU, v_W, w_W), Pose{}};
  // The axis passes through ω × v / |ω|²; along it the body glides.
  const Pose X_WB{Mat3::Identity(), w_W.cross(v_W) / squared};
  const Vec3 glide = w_W.dot(v_W) / squared * w_W;
  return {TwistMotion(X_WB, glide, w_W), X_WB.inverse() * X_WU};
}

}  // namespace rigor
