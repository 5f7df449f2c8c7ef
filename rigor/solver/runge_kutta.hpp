#pragma once

#include "rigor/math/types.hpp"

#include <functional>

namespace rigor {

/// Right-hand side of ẏ = f(t, y); called once a stage, at the stage's own time and state.
using OdeFunction = std::function<VecX(double t, const VecX& y)>;

/// Coefficients of an explicit Runge-Kutta method (Butcher's tableau) with its continuous extension
///
///   kᵢ = f(t + cᵢ h, y + h Σ_{j < i} aᵢⱼ kⱼ),   y(t + θ h) = y + h Σᵢ bᵢ(θ) kᵢ,   bᵢ(θ) = Σ_{m ≥ 1} denseᵢₘ
///   θᵐ,   bᵢ = bᵢ(1).
struct ButcherTableau {
  static constexpr int max_stages = 7;
  static constexpr int max_dense_degree = 4;

  int stages;
  int order;
  double c[max_stages];
  double a[max_stages][max_stages];
  double b[max_stages];
  bool has_error;
  double error[max_stages];  ///< b - b̂, b̂ the embedded method of lower order.
  int dense_degree;
  double dense[max_stages][max_dense_degree + 1];
};

/// Order 1; linear in between.
ButcherTableau explicit_euler_tableau();
/// Order 2 with the slope at the middle; a parabola of order 2 in between.
ButcherTableau midpoint_tableau();
/// The classical method of order 4; cubic of order 3 in between.
/// Source: Hairer, Nørsett, Wanner, Solving Ordinary Differential Equations I, 2nd ed. 1993, II.1 and II.6.
ButcherTableau rk4_tableau();
/// Dormand and Prince's 5(4) pair of seven stages (the last is f at the end); quartic of order 4 by Shampine
/// in between. Source: Hairer, Nørsett, Wanner, as above, table II.5.2 and II.6.
ButcherTableau dopri5_tableau();

/// One step of an explicit Runge-Kutta method.
struct RungeKuttaStep {
  VecX end;    ///< y at t + h.
  VecX error;  ///< h Σ (bᵢ - b̂ᵢ) kᵢ; empty for methods without embedded method.
  MatX dense;  ///< n × (degree + 1): column m is the coefficient of θᵐ.

  /// y at t + θ h; θ in [0, 1].
  VecX at(double theta) const;
};
RungeKuttaStep runge_kutta_step(const ButcherTableau& tableau, const OdeFunction& f, double t, const VecX& y,
                                double h);

}  // namespace rigor
