#include "rigor/solver/linear/pivoted_cholesky.hpp"

#include "rigor/core/index.hpp"

#include <cmath>

namespace rigor {

void PivotedCholesky::factor(const MatX& S, const VecX& scales, double threshold) {
  pivots_.clear();
  L_.setZero(S.rows(), S.rows());
  diagonal_ = S.diagonal();
  for (Eigen::Index k = 0; k < S.rows(); ++k) {
    Eigen::Index pivot = -1;
    double largest = threshold;
    for (Eigen::Index i = 0; i < S.rows(); ++i) {
      const double left = scales(i) == 0 ? 0 : diagonal_(i) / scales(i);
      if (left <= largest) continue;
      largest = left;
      pivot = i;
      if (std::isnan(left)) break;  // Taken, so that it is seen in the solution.
    }
    if (pivot < 0) return;
    const double root = std::sqrt(diagonal_(pivot));
    L_.col(k).noalias() = S.col(pivot) - L_.leftCols(k) * L_.row(pivot).head(k).transpose();
    L_.col(k) /= root;
    for (const Eigen::Index taken : pivots_) L_(taken, k) = 0;
    L_(pivot, k) = root;
    diagonal_ -= L_.col(k).cwiseAbs2();
    diagonal_(pivot) = 0;
    pivots_.push_back(pivot);
  }
}

VecX PivotedCholesky::solve(const VecX& b) const {
  const Eigen::Index rank = static_cast<Eigen::Index>(pivots_.size());
  VecX y(rank);
  for (Eigen::Index k = 0; k < rank; ++k) {
    const Eigen::Index pivot = pivots_[at(k)];
    y(k) = (b(pivot) - L_.row(pivot).head(k).dot(y.head(k))) / L_(pivot, k);
  }
  VecX x = VecX::Zero(b.size());
  for (Eigen::Index k = rank - 1; k >= 0; --k) {
    const Eigen::Index pivot = pivots_[at(k)];
    x(pivot) = (y(k) - L_.col(k).dot(x)) / L_(pivot, k);
  }
  return x;
}

}  // namespace rigor
