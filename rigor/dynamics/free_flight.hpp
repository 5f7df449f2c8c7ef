#pragma once

#include "rigor/dynamics/free_rotation.hpp"
#include "rigor/geometry/shape/aabb.hpp"

namespace rigor {

/// Motion of a body under a constant force (gravity and others together) and no torque, in closed form from
/// its epoch: the centre of mass on a parabola, the attitude by FreeRotation. Every evaluation starts from
/// the epoch, so that sampling the motion does not change it and rounding does not accumulate. L is
/// constant bit for bit.
struct FreeFlight {
  double epoch = 0;  ///< [s].
  BodyPhase start;   ///< Phase at the epoch.
  double mass = 1;   ///< [kg].
  Vec3 a_W =
      Vec3::Zero();  ///< Acceleration of the centre of mass: gravity plus constant force over mass [m/s²].
  FreeRotation rotation;

  FreeFlight() = default;
  FreeFlight(const BodyInertia& inertia, const BodyPhase& phase, double t, const Vec3& acceleration_W);

  /// p_WB at t [m]: x + τ (v + ½ a τ), τ = t - epoch. No elliptic function is evaluated.
  Vec3 position(double t) const;
  /// v_WB at t [m/s].
  Vec3 velocity(double t) const;
  /// q_WB at t.
  Quat orientation(double t) const { return rotation.orientation(t - epoch); }
  /// Whole phase at t; at the epoch exactly the start.
  BodyPhase at(double t) const;

  /// Box in W of the centre's path over [ta, tb] (ta ≤ tb): the parabola's ends and vertices, widened by the
  /// rounding of position(), so that it contains every position() in between.
  Aabb path_box(double ta, double tb) const;
  /// Largest |ω| over all times [rad/s].
  double max_angular_speed() const { return rotation.max_angular_speed(); }
};

}  // namespace rigor
