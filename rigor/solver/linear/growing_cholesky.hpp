#pragma once

#include "rigor/math/types.hpp"

#include <cmath>

namespace rigor {

/// Cholesky factor of a symmetric positive semidefinite matrix that gains and loses rows, each in time
/// quadratic in their number.
class GrowingCholesky {
 public:
  explicit GrowingCholesky(Eigen::Index capacity) : L_(MatX::Zero(capacity, capacity)) {}

  Eigen::Index size() const { return size_; }

  /// Adds a last row: its products with the rows that are there, and its own entry. False, and nothing
  /// changes, if it depends on them: if what is left of `own` is below `least`.
  bool append(const VecX& products, double own, double least) {
    const VecX row = L_.topLeftCorner(size_, size_).triangularView<Eigen::Lower>().solve(products);
    const double rest = own - row.squaredNorm();
    if (!(rest > least)) return false;
    L_.row(size_).head(size_) = row.transpose();
    L_(size_, size_) = std::sqrt(rest);
    ++size_;
    return true;
  }

  /// Takes away row k; the later ones move up.
  void remove(Eigen::Index k) {
    for (Eigen::Index i = k; i + 1 < size_; ++i) L_.row(i).head(i + 2) = L_.row(i + 1).head(i + 2);
    // Each later row has one entry right of the diagonal: rotate it away.
    for (Eigen::Index i = k; i + 1 < size_; ++i) {
      Eigen::JacobiRotation<double> rotation;
      rotation.makeGivens(L_(i, i), L_(i, i + 1));
      L_.block(i, 0, size_ - 1 - i, size_).applyOnTheRight(i, i + 1, rotation);
    }
    --size_;
    L_.row(size_).setZero();
    L_.col(size_).setZero();
  }

  VecX solve(const VecX& c) const {
    const auto L = L_.topLeftCorner(size_, size_);
    return L.transpose().triangularView<Eigen::Upper>().solve(L.triangularView<Eigen::Lower>().solve(c));
  }

 private:
  MatX L_;
  Eigen::Index size_ = 0;
};

}  // namespace rigor
