#pragma once

#include "rigor/math/pose.hpp"

namespace rigor {

/// The motion of a rigid body over a span of time, with bounds that hold for the whole span: the input of the
/// search for the first contact. The origin of the body frame B is the point whose motion is simplest to
/// describe, such as the centre of mass.
class RigidMotion {
 public:
  /// Pose and velocities at an instant.
  struct Sample {
    /// Where the body is [m].
    Pose X_WB;
    Vec3 v;  ///< Velocity of the origin of B, in W [m/s].
    Vec3 w;  ///< Angular velocity, in W [rad/s].

    /// Of the point of the body at p_WP [m/s].
    Vec3 velocity_at(const Vec3& p_WP) const { return v + w.cross(p_WP - X_WB.p); }
  };

  virtual ~RigidMotion() = default;
  /// The motion at t [s].
  virtual Sample sample(double t) const = 0;
  virtual Vec3 velocity(double t) const = 0;  ///< Velocity of the origin of B, in W [m/s].
  /// Lower bound over [ta, tb] of the acceleration of the origin of B along n [m/s²].
  virtual double min_acceleration_along(const Vec3& n, double ta, double tb) const = 0;
  /// Upper bound over the whole motion of |ω| [rad/s].
  virtual double max_angular_speed() const = 0;
  /// Upper bound over the whole motion of |α| + |ω|² [1/s²]: a point at distance r from the origin of B
  /// accelerates relative to it by at most r times this.
  virtual double max_turn_acceleration() const = 0;
};

/// Upper bound over [ta, tb] of the acceleration of the origin of B in any direction [m/s²].
double largest_acceleration(const RigidMotion& motion, double ta, double tb);

/// A motion in which the origin of B follows a parabola and B rotates at a constant angular velocity. It
/// covers bodies at rest, at constant velocity, thrown, or on a screw.
class TwistMotion : public RigidMotion {
 public:
  /// At time t the body is at X_WB, its origin moves at v_W [m/s] and it rotates at w_W [rad/s]; at all times
  /// the origin accelerates by a_W [m/s²].
  TwistMotion(const Pose& X_WB, const Vec3& v_W, const Vec3& w_W, const Vec3& a_W = Vec3::Zero(),
              double t = 0)
      : X_(X_WB), v_(v_W), w_(w_W), a_(a_W), t_(t) {}

  /// The motion at t [s].
  Sample sample(double t) const override;
  Vec3 velocity(double t) const override { return v_ + (t - t_) * a_; }
  double min_acceleration_along(const Vec3& n, double, double) const override { return n.dot(a_); }
  double max_angular_speed() const override { return w_.norm(); }
  double max_turn_acceleration() const override { return w_.squaredNorm(); }

 private:
  Pose X_;
  Vec3 v_, w_, a_;
  double t_;
};

/// A motion together with the pose X_BU of the user's frame U on its body.
struct ScrewMotion {
  /// Of the body.
  TwistMotion motion;
  /// Where the other frame lies in it [m].
  Pose X_BU;
};

/// The motion with constant twist, X_WU(t) = exp(t [ω v]) X_WU, where v_W is the velocity of the point of the
/// body that passes through the origin of W [m/s]. It is a rotation about a fixed axis of W combined with a
/// translation along that axis (Chasles); the origin of B lies on the axis. With w_W = 0 it is a pure
/// translation.
ScrewMotion make_screw_motion(const Pose& X_WU, const Vec3& w_W, const Vec3& v_W);

}  // namespace rigor
