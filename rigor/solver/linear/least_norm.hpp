#pragma once

#include "rigor/math/types.hpp"

namespace rigor {

/// Least-norm, least-squares solutions of B x = c for a square B of any rank: rank-revealing complete
/// orthogonal decomposition that stops at the rank, so a matrix of low rank is cheap (order k² r).
class LeastNormSystem {
 public:
  /// Directions of B smaller than `rank_tolerance` times its largest column count as zero.
  explicit LeastNormSystem(MatX B, double rank_tolerance = kRankTolerance);

  Eigen::Index rank() const { return rank_; }
  const MatX& matrix() const { return B_; }

  /// The x of least norm among those of least |B x - c|, with one step of refinement.
  VecX solve(const VecX& c) const;

  /// Orthonormal basis (k × rank) of the rows' space: the solutions of B x = c are solve(c) plus its
  /// complement.
  MatX row_space() const;

 private:
  /// Above the round-off of a Delassus operator with redundant contacts (some ε), far below any real one:
  /// two contacts a millionth of the lever arm apart are still told apart.
  static constexpr double kRankTolerance = 1e-13;

  void factor(double rank_tolerance);
  VecX solve_once(const VecX& c) const;

  MatX B_;
  MatX factors_;       ///< Householder vectors below, R (rank_ rows) above the diagonal; columns permuted.
  VecX coefficients_;  ///< Of the Householder reflections of factors_.
  Eigen::VectorXi permutation_;  ///< Column j of factors_ is column permutation_(j) of B.
  Eigen::Index rank_ = 0;
  Eigen::HouseholderQR<MatX> row_factors_;  ///< Of Rᵀ (k × rank); empty for full rank.
};

}  // namespace rigor
