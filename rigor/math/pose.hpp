#pragma once

#include "rigor/math/types.hpp"

namespace rigor {

/// Pose X_AB of a frame B in a frame A. It maps coordinates in B to coordinates in A, p_A = R p_B + p.
struct Pose {
  Mat3 R = Mat3::Identity();  ///< R_AB, orthonormal, det +1.
  Vec3 p = Vec3::Zero();      ///< p_AB: position of the origin of B in A [m].

  /// The same point in the outer frame.
  Vec3 operator*(const Vec3& p_B) const { return R * p_B + p; }
  /// One pose after the other.
  Pose operator*(const Pose& X_BC) const { return {R * X_BC.R, R * X_BC.p + p}; }
  /// The pose of the outer frame in the inner one.
  Pose inverse() const { return {R.transpose(), -(R.transpose() * p)}; }
};

}  // namespace rigor
