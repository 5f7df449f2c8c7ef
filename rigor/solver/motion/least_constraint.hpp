#pragma once

#include "rigor/math/types.hpp"

#include <vector>

namespace rigor {

/// Find the y of least norm with
///
///   G_i y = d_i  for the first `equalities` rows,   G_i y ≥ d_i  for the others.
///
/// Gauss' principle of least constraint in motion space: with y = M^½ (a - a₀) and G = J M^(-½) the least
/// constraint ½ |y|² gives the accelerations that contacts (inequalities) and joints (equalities) allow, and
/// the multipliers are their forces. G is used as it is: its condition, not that of G Gᵀ, which is the
/// square.
struct LeastConstraintProblem {
  MatX G;  ///< m × n.
  VecX d;  ///< m.
  Eigen::Index equalities = 0;
};

struct LeastConstraintSolution {
  VecX y;       ///< n; unique.
  VecX lambda;  ///< m, y = Gᵀ λ; ≥ 0 at inequalities, zero at those that are not active. Not unique where
                ///< rows are redundant: the redundant ones have none.
  std::vector<Eigen::Index>
      active;  ///< Rows held as equations, independent of each other; to start from again.
  /// Largest violation of a row, of y = Gᵀ λ, or λ below zero; relative to the largest term of each. Where
  /// nothing satisfies all rows it is that of the rows that were given up.
  double residual;
  bool converged;  ///< residual ≤ solved_residual.
  int iterations;  ///< Steps of the active set.
};

/// Active-set method of Goldfarb and Idnani: from the unconstrained minimum, rows are added one by one, the
/// most violated first, and dropped when their multiplier reaches zero; each step keeps an orthogonal
/// factorisation of the active rows. Finite; redundant rows are no trouble. `start`: rows to be added first,
/// as `active` of a similar problem before; it changes the time that is needed and not y.
///
/// Source: Goldfarb and Idnani, A Numerically Stable Dual Method for Solving Strictly Convex Quadratic
/// Programs, Math. Prog. 27, 1983, with the unit matrix in the objective; Redon, Kheddar and Coquillart,
/// Gauss' Least Constraints Principle and Rigid Body Simulations, ICRA 2002, for its use.
LeastConstraintSolution solve_least_constraint(const LeastConstraintProblem& problem,
                                               const std::vector<Eigen::Index>& start = {});

}  // namespace rigor
