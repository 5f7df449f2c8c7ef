#pragma once

#include "rigor/dynamics/motion.hpp"

namespace rigor {

/// One convex shape of a moving body.
struct MovingShape {
  const BodyShape* shape;
  const Motion* motion;

  Pose pose(double t) const { return motion->sample(t).X_WB * shape->X_BS; }
};

/// Lower bound of the gap of two shapes along a fixed normal, for all times near the one it was made at:
///   gap(τ) ≥ gap + ġ_cm τ + ½ min(a, 0) τ² - [s_A(τ) - s_A(0)] - [s_B(τ) - s_B(0)],
/// where the support of a turning body along n grows to no more than
///   s(τ) ≤ max_p (n + τ n × ω)·p + ½ (|α| + |ω|²) ρ τ².
/// The right side is concave in τ: where it is positive, it is positive at all earlier τ > 0.
class SeparationBound {
 public:
  /// At time t, for times up to t_end: the distance there, its unit normal n_W from A to B.
  SeparationBound(const MovingShape& A, const MovingShape& B, const Vec3& n_W, double gap, double t,
                  double t_end);

  /// The bound at t + tau [m].
  double at(double tau) const;
  /// A large tau ≤ tau_max with at(tau) ≥ level, by safeguarded false position; 0 if none could be found.
  double safe_step(double tau_max, double level) const;

 private:
  struct Support {
    const Shape* shape = nullptr;  ///< Null where nothing turns.
    Mat3 R_SW = Mat3::Identity();
    Vec3 offset_W = Vec3::Zero();   ///< From the centre of mass to the shape's frame, in W.
    Vec3 direction = Vec3::Zero();  ///< Outward, W.
    Vec3 turn = Vec3::Zero();       ///< direction × ω.
    double quadratic = 0;           ///< ½ (|α| + |ω|²) ρ.
    double start = 0;

    double growth(double tau) const;
    double value(const Vec3& direction_W) const;
  };
  static Support make_support(const MovingShape& moving, const Vec3& outward_W, double t);

  double gap_, rate_, half_acceleration_;
  Support A_, B_;
};

/// Radius of the ball about the body's centre that holds all points of the shape that its turning moves apart
/// (the core of round shapes, whose radius does not matter) [m].
double turning_radius(const BodyShape& shape);

}  // namespace rigor
