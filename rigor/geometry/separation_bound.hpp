#pragma once

#include "rigor/geometry/convex_core.hpp"
#include "rigor/geometry/rigid_motion.hpp"
#include "rigor/geometry/shape.hpp"

namespace rigor {

/// A convex part of a moving body.
struct MovingCore {
  ConvexCore core;
  Pose X_BC;              ///< Place of the core in the frame of the body.
  double turning_radius;  ///< No point that turning moves is farther from the origin of B [m].
  const RigidMotion* motion;
};

/// Lower bound of the gap of two convex parts along a fixed normal, for all times near the one it was made
/// at:
///   gap(τ) ≥ gap + ġ_cm τ + ½ min(a, 0) τ² - [s_A(τ) - s_A(0)] - [s_B(τ) - s_B(0)],
/// where the support of a turning body along n grows to no more than
///   s(τ) ≤ max_p (n + τ n × ω)·p + ½ (|α| + |ω|²) ρ τ².
/// The right side is concave in τ: where it is positive, it is positive at all earlier τ > 0.
///
/// Where a face of a turning body faces the other one, a normal that turns with that body is better: the face
/// stays in its plane (docs/theory/time_of_impact.md).
class SeparationBound {
 public:
  /// Bodies with which the normal may turn.
  enum class NormalOf { world, A, B };

  /// At time t, for times up to t_end: the distance there, its unit normal n_W from A to B. The parts must
  /// outlive this. With a half-space the normal must be that of the world.
  SeparationBound(const MovingCore& A, const MovingCore& B, const Vec3& n_W, double gap, double t,
                  double t_end, NormalOf normal = NormalOf::world);

  /// The bound at t + tau [m].
  double at(double tau) const;
  /// A large tau ≤ tau_max with at(tau) ≥ level, by safeguarded false position; 0 if none could be found.
  double safe_step(double tau_max, double level) const;

 private:
  struct Support {
    const ConvexCore* core = nullptr;  ///< Null where nothing turns.
    Mat3 R_CW = Mat3::Identity();
    Vec3 offset_W = Vec3::Zero();   ///< From the origin of the body to that of the core, in W.
    Vec3 direction = Vec3::Zero();  ///< Outward, W.
    Vec3 turn = Vec3::Zero();       ///< direction × ω, relative to the normal's body.
    double quadratic = 0;           ///< ½ (|α| + |ω|²) ρ, and what the turning of the normal adds.
    double start = 0;

    double growth(double tau) const;
    double value(const Vec3& direction_W) const;
  };
  static Support make_support(const MovingCore& part, const Vec3& outward_W, double t,
                              const RigidMotion* normal);

  double gap_, rate_ = 0, half_acceleration_ = 0;
  Support A_, B_;
};

/// Radius of the ball about the origin of B that holds all points of the shape that turning moves apart (the
/// core of round shapes, whose radius does not matter) [m]; `radius` is that of the ball about the origin of
/// S that holds the shape. 0 for a half-space: it may turn about its normal only, so that its surface stays.
double turning_radius(const Shape& shape, const Pose& X_BS, double radius);

/// The core of a shape as the bound sees it: of a mesh all its vertices (their hull), of a half-space a point
/// that does not turn.
MovingCore make_moving_core(const Shape& shape, const Pose& X_BS, double radius, const RigidMotion& motion);

}  // namespace rigor
