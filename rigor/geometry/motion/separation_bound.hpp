#pragma once

#include "rigor/geometry/motion/rigid_motion.hpp"
#include "rigor/geometry/shape/convex_core.hpp"
#include "rigor/geometry/shape/shape.hpp"

#include <array>

namespace rigor {

/// A convex part of a moving body.
struct MovingCore {
  ConvexCore core;
  Pose X_BC;              ///< Pose of the core in the frame of the body.
  double turning_radius;  ///< No point that the rotation moves is farther from the origin of B [m].
  const RigidMotion* motion;
  const RigidMotion::Sample* sample = nullptr;  ///< Sample at the time of the bound, if at hand.
};

/// A direction along which parts of two bodies are separated, and its rotation: n(τ) = exp(τ [turn]) n.
struct PartingDirection {
  Vec3 n_W;                    ///< Unit, from A to B.
  Vec3 turn_W = Vec3::Zero();  ///< Angular velocity of the direction [rad/s].

  PartingDirection(const Vec3& n, const Vec3& turn = Vec3::Zero()) : n_W(n), turn_W(turn) {}
};

/// Lower bound of the gap between two convex parts along a normal that is fixed or rotates at a constant
/// rate, for all times after the one at which it was made. For a fixed normal
///   gap(τ) ≥ gap + ġ_cm τ + ½ min(a, 0) τ² - [s_A(τ) - s_A(0)] - [s_B(τ) - s_B(0)],
/// where the support of a rotating body along n is bounded by
///   s(τ) ≤ max_p (n + τ n × ω)·p + ½ (|α| + |ω|²) ρ τ².
/// A normal that rotates with a face, or stays perpendicular to two edges, keeps the bound exact to first
/// order there (docs/theory/time_of_impact.md). The right side is concave in τ and not negative at τ = 0, so
/// where it is positive it is positive at all earlier τ > 0 too.
class SeparationBound {
 public:
  /// Makes the bound at time t for times up to t_end; `gap` [m] is the separation along the direction at t.
  /// The parts must outlive this object. A half-space admits no rotating direction.
  SeparationBound(const MovingCore& A, const MovingCore& B, const PartingDirection& along, double gap,
                  double t, double t_end);

  /// The bound at t + tau [m].
  double at(double tau) const;
  /// Its slope at tau = 0 [m/s].
  double rate() const { return rate_ - A_.rate() - B_.rate(); }
  /// A large tau ≤ tau_max with at(tau) ≥ level, by safeguarded false position; 0 if none could be found.
  double safe_step(double tau_max, double level) const;

 private:
  struct Support {
    const ConvexCore* core = nullptr;  ///< Null if the support cannot grow.
    Mat3 R_CW = Mat3::Identity();
    Vec3 offset_W = Vec3::Zero();   ///< From the origin of the body to that of the core, in W.
    Vec3 direction = Vec3::Zero();  ///< Outward unit vector, in W.
    Vec3 turn = Vec3::Zero();       ///< (Ω of the direction - ω) × direction.
    double start = 0;

    double growth(double tau) const;
    double rate() const;
    Vec3 farthest(const Vec3& direction_W) const;
  };
  static Support make_support(const MovingCore& part, const Vec3& outward_W, const Vec3& turn_W, double t);
  void add_loss_by_turning(const MovingCore& A, const MovingCore& B, const PartingDirection& along);

  double t_, t_end_;
  double gap_, rate_;
  std::array<double, 3> loss_{};  ///< Coefficients of τ², τ³ and τ⁴, ≥ 0.
  Support A_, B_;
};

/// Radius of the ball about the origin of B that holds all points of the shape whose positions the rotation
/// affects (of round shapes only the core, since a ball about it looks the same under rotation) [m]. `radius`
/// is that of the ball about the origin of S that holds the shape. The result is 0 for a half-space, which
/// may rotate about its normal only, so that its surface stays in place.
double turning_radius(const Shape& shape, const Pose& X_BS, double radius);

/// The core of a shape as the bound uses it: all vertices of a mesh (hence their hull), and of a half-space a
/// point that no rotation moves.
MovingCore make_moving_core(const Shape& shape, const Pose& X_BS, double radius, const RigidMotion& motion);

}  // namespace rigor
