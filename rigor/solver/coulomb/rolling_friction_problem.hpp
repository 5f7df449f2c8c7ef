#pragma once

#include "rigor/math/types.hpp"

#include <vector>

namespace rigor {

/// Contacts that resist sliding, rolling and spinning, at velocity level: find λ with w = A λ + b. Contact i
/// owns the rows 6i, 6i+1 (tangents), 6i+2 (normal), 6i+3, 6i+4 (moments about the tangents: rolling), 6i+5
/// (about the normal: spinning), with
///
///   0 ≤ λ_n ⊥ w_n ≥ 0,   |λ_t| ≤ μ λ_n,   |m_t| ≤ ρ λ_n,   |m_n| ≤ σ λ_n,
///
/// and each of the three frictions opposes its own motion with its greatest value or brings it to rest with
/// less: w_t = 0 or λ_t = -μ λ_n w_t / |w_t|, and so on.
struct RollingFrictionProblem {
  MatX A;                                      ///< 6n × 6n, symmetric positive semidefinite.
  VecX b;                                      ///< [m/s] and [rad/s].
  std::vector<double> mu, rolling, torsional;  ///< n each: μ, ρ [m], σ [m], ≥ 0.
};

struct RollingFrictionSolution {
  VecX lambda;      ///< 6n, within the bounds.
  VecX w;           ///< A λ + b.
  double residual;  ///< rolling_friction_residual.
  int iterations;   ///< Newton steps and sweeps.
  bool converged;   ///< residual ≤ solved_residual.
};

/// Sweeps of projected Gauss–Seidel bring the forces near, Newton's method on the natural map of the law
/// (which is piecewise smooth) refines them to round-off; the two alternate
/// until neither gains any more. Never throws: what is not
/// solved is in `residual`. Among redundant contacts any share of the load may
/// result. `start`: forces of a similar problem, or
/// nothing.
///
/// Sources: the three frictions as discs and an interval: Leine and Glocker, A set-valued force law for
/// spatial Coulomb-Contensou friction, Eur. J. Mech. A/Solids 22, 2003, without their coupling; the natural
/// map and its Newton method: Alart and Curnier, Comput. Methods Appl. Mech. Eng. 92, 1991.
RollingFrictionSolution solve_rolling_friction(const RollingFrictionProblem& problem,
                                               const VecX& start = VecX());

/// How far λ and w are from the law (dimensionless): the natural map as in coulomb_residual, of velocities
/// and of angular velocities, each relative to their own largest term.
double rolling_friction_residual(const RollingFrictionProblem& problem, const VecX& lambda, const VecX& w);

}  // namespace rigor
