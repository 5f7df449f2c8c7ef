#include "rigor/solver/possible_rates.hpp"

#include <Eigen/Eigenvalues>

namespace rigor {

using Eigen::Index;

namespace {

/// Rows of the contacts that hold.
std::vector<Index> holding_rows(const CoulombProblem& problem, const CoulombSolution& solution,
                                double limit) {
  std::vector<Index> rows;
  for (Index row = 0; row < problem.b.size(); row += 3) {
    const Vec3 force = solution.lambda.segment<3>(row), motion = solution.w.segment<3>(row);
    if (!(force.z() > 0) && motion.z() > limit) continue;
    const std::size_t contact = static_cast<std::size_t>(row / 3);
    const bool may_stick = problem.rows[contact] == FrictionRow::cone && problem.mu[contact] > 0;
    if (may_stick && motion.head<2>().norm() <= limit) rows.insert(rows.end(), {row, row + 1});
    rows.push_back(row + 2);
  }
  return rows;
}

}  // namespace

std::optional<CoulombProblem> with_possible_rates(const CoulombProblem& problem,
                                                  const CoulombSolution& solution, double limit) {
  constexpr double rank_tolerance = 1e-11;
  const std::vector<Index> rows = holding_rows(problem, solution, limit);
  if (rows.empty() || !solution.lambda.allFinite() || !solution.w.allFinite()) return std::nullopt;
  const Index count = static_cast<Index>(rows.size());
  const MatX A = problem.A(rows, rows);
  const Eigen::SelfAdjointEigenSolver<MatX> modes(A);
  const double least = rank_tolerance * modes.eigenvalues()[count - 1];
  Index nullity = 0;
  while (nullity < count && modes.eigenvalues()[nullity] <= least) ++nullity;
  if (nullity == 0) return std::nullopt;
  const MatX nothing = modes.eigenvectors().leftCols(nullity);
  const VecX change = -(nothing * (nothing.transpose() * problem.b(rows)));
  if (change.isZero(0) || change.cwiseAbs().maxCoeff() > limit) return std::nullopt;
  CoulombProblem possible = problem;
  possible.b(rows) += change;
  return possible;
}

}  // namespace rigor
