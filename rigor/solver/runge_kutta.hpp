#pragma once

#include "rigor/math/types.hpp"

#include <functional>
#include <span>

namespace rigor {

/// Right-hand side of ẏ = f(t, y); called once a stage, at the stage's own time and state.
using OdeFunction = std::function<VecX(double t, const VecX& y)>;

/// Coefficients of an explicit Runge-Kutta method (Butcher's tableau) with its continuous extension
///
///   kᵢ = f(t + cᵢ h, y + h Σ_{j < i} aᵢⱼ kⱼ),   y(t + θ h) = y + h Σᵢ bᵢ(θ) kᵢ,   bᵢ(θ) = Σ_{m ≥ 1} denseᵢₘ
///   θᵐ,   bᵢ = bᵢ(1).
struct ButcherTableau {
  static constexpr int max_stages = 16;
  static constexpr int max_dense_degree = 7;

  int stages;  ///< That the end and its error need.
  int order;
  double c[max_stages];
  double a[max_stages][max_stages];
  double b[max_stages];
  bool has_error;
  double error[max_stages];  ///< b - b̂, b̂ the embedded method of lower order.
  bool has_coarse_error;
  double coarse_error[max_stages];  ///< The same with a second embedded method of still lower order.
  int extra_stages;                 ///< Further stages, which only the continuous extension needs.
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
/// Dormand and Prince's method of order 8 with twelve stages and embedded methods of orders 5 and 3, by
/// Hairer and Wanner; of order 7 in between, for four stages more (one is f at the end).
/// Source: Hairer, Nørsett, Wanner, as above, II.5 and II.6, with the coefficients of their program DOP853.
ButcherTableau dop853_tableau();

/// Sets the continuous extension of a tableau, else complete,
///
///   y = y₀ + θ (r2 + (1-θ)(r3 + θ (r4 + (1-θ)(r5 + θ (r6 + …))))),
///   r2 = h Σ bᵢ kᵢ,   r3 = h k₁ - r2,   r4 = r2 - r3 - h k_end,
///
/// k_end the slope at the end: that of stage `end_stage`, from 0. weights: of h kᵢ in r5, r6 and so on.
void set_nested_extension(std::span<const double[ButcherTableau::max_stages]> weights, int end_stage,
                          ButcherTableau& tableau);

/// One step of an explicit Runge-Kutta method.
struct RungeKuttaStep {
  VecX end;           ///< y at t + h.
  VecX error;         ///< h Σ (bᵢ - b̂ᵢ) kᵢ; empty for methods without embedded method.
  VecX coarse_error;  ///< The same of the second embedded method, if there is one.
  MatX dense;         ///< n × (degree + 1): column m is the coefficient of θᵐ.

  /// y at t + θ h; θ in [0, 1].
  VecX at(double theta) const;
};
RungeKuttaStep runge_kutta_step(const ButcherTableau& tableau, const OdeFunction& f, double t, const VecX& y,
                                double h);
/// The same without the dense output and its extra stages.
RungeKuttaStep runge_kutta_end(const ButcherTableau& tableau, const OdeFunction& f, double t, const VecX& y,
                               double h);

/// The error of a step from norms e5, e3 of its error and its coarse error,
///
///   e5² / √(e5² + 0.01 e3²),
///
/// of order 8 in h for DOP853, where e5 is of order 6 and e3 of order 4. Source: Hairer, Nørsett, Wanner, as
/// above, II.10, and their program.
double combined_error(double error, double coarse_error);

}  // namespace rigor
