#include "rigor/solver/linear/least_norm.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/math/dense.hpp"

#include <numeric>
#include <utility>

namespace rigor {

using Eigen::Index;

LeastNormSystem::LeastNormSystem(MatX B, double rank_tolerance) : B_(std::move(B)), factors_(B_) {
  RIGOR_ASSERT(B_.rows() == B_.cols());
  factor(rank_tolerance);
  if (rank_ > 0 && rank_ < B_.cols()) {
    const MatX R = factors_.topRows(rank_).template triangularView<Eigen::Upper>();
    row_factors_ = householder_factors(R.transpose());
  }
}

// Householder QR with column pivoting that stops when the remaining columns are round-off.
void LeastNormSystem::factor(double rank_tolerance) {
  const Index n = factors_.cols();
  coefficients_ = VecX::Zero(n);
  permutation_.resize(n);
  std::iota(permutation_.data(), permutation_.data() + n, 0);
  VecX workspace(n);
  double threshold = 0;
  for (Index j = 0; j < n; ++j) {
    // The column of which most is left is the pivot.
    Index pivot = 0;
    const double largest = factors_.bottomRightCorner(n - j, n - j).colwise().squaredNorm().maxCoeff(&pivot);
    if (j == 0) threshold = largest * rank_tolerance * rank_tolerance;
    if (!(largest > threshold)) break;
    if (pivot > 0) {
      factors_.col(j).swap(factors_.col(j + pivot));
      std::swap(permutation_(j), permutation_(j + pivot));
    }

    // Its reflection, applied to the columns that remain.
    double beta = 0;
    factors_.col(j).tail(n - j).makeHouseholderInPlace(coefficients_(j), beta);
    factors_(j, j) = beta;
    factors_.bottomRightCorner(n - j, n - j - 1)
        .applyHouseholderOnTheLeft(factors_.col(j).tail(n - j - 1), coefficients_(j), workspace.data());
    ++rank_;
  }
}

VecX LeastNormSystem::solve_once(const VecX& c) const {
  VecX y = c;
  y.applyOnTheLeft(Eigen::householderSequence(factors_, coefficients_).setLength(rank_).adjoint());
  VecX permuted = VecX::Zero(c.size());
  if (rank_ == c.size()) {
    permuted = factors_.template triangularView<Eigen::Upper>().solve(y);
  } else if (rank_ > 0) {
    // R = Tᵀ Zᵀ with Rᵀ = Z T: the least-norm solution of R x = y is Z T⁻ᵀ y.
    permuted.head(rank_) =
        row_factors_.matrixQR().topRows(rank_).template triangularView<Eigen::Upper>().transpose().solve(
            y.head(rank_));
    permuted.applyOnTheLeft(row_factors_.householderQ());
  }
  VecX x(c.size());
  for (Index j = 0; j < x.size(); ++j) x(permutation_(j)) = permuted(j);
  return x;
}

VecX LeastNormSystem::solve(const VecX& c) const {
  VecX x = solve_once(c);
  x += solve_once(c - B_ * x);
  return x;
}

MatX LeastNormSystem::row_space() const {
  const Index n = B_.cols();
  if (rank_ == n) return MatX::Identity(n, n);
  MatX permuted = MatX::Identity(n, rank_);
  if (rank_ > 0) apply_householder_q(row_factors_, permuted);
  MatX basis(n, rank_);
  for (Index j = 0; j < n; ++j) basis.row(permutation_(j)) = permuted.row(j);
  return basis;
}

}  // namespace rigor
