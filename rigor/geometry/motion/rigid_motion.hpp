#pragma once

#include "rigor/math/pose.hpp"

namespace rigor {

/// How a rigid body moves over a span of time, with bounds that hold for all of it: what the search for the
/// first contact stands on. The body frame B has its origin where it is simplest to describe, as in the
/// centre of mass.
class RigidMotion {
 public:
  /// Pose and velocities at an instant.
  struct Sample {
    Pose X_WB;
    Vec3 v;  ///< Of the origin of B [m/s].
    Vec3 w;  ///< In W [rad/s].

    Vec3 velocity_at(const Vec3& p_WP) const { return v + w.cross(p_WP - X_WB.p); }
  };

  virtual ~RigidMotion() = default;
  virtual Sample sample(double t) const = 0;
  virtual Vec3 velocity(double t) const = 0;  ///< Of the origin of B [m/s].
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

/// The origin of B flies on a parabola while B turns at a constant angular velocity: at rest, at constant
/// velocities, thrown, or along a screw.
class TwistMotion : public RigidMotion {
 public:
  /// At time t the body is at X_WB, its origin moves at v_W [m/s] and accelerates by a_W [m/s²] always, and
  /// it turns at w_W [rad/s].
  TwistMotion(const Pose& X_WB, const Vec3& v_W, const Vec3& w_W, const Vec3& a_W = Vec3::Zero(),
              double t = 0)
      : X_(X_WB), v_(v_W), w_(w_W), a_(a_W), t_(t) {}

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

/// A motion and where on its body the user's frame U is.
struct ScrewMotion {
  TwistMotion motion;
  Pose X_BU;
};

/// The motion with constant twist: X_WU(t) = exp(t [ω v]) X_WU, where v_W is the velocity of the point of the
/// body that passes through the origin of W. A turn about a fixed axis of W with a glide along it: B lies on
/// the axis. Without turning it is a translation.
ScrewMotion make_screw_motion(const Pose& X_WU, const Vec3& w_W, const Vec3& v_W);

}  // namespace rigor
