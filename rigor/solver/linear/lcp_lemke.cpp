#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"
#include "rigor/core/interrupt.hpp"
#include "rigor/solver/linear/lcp.hpp"
#include "rigor/solver/linear/lcp_residual.hpp"

#include <limits>
#include <vector>

namespace rigor {
namespace {

using Eigen::Index;

// Entries smaller than this, relative to the largest of their column, are not pivoted on.
constexpr double kPivotTolerance = 1e-12;

// Tableau of  w - M z - e z₀ = q:  columns w (n), z (n), z₀, q. The w columns hold the inverse of the basis,
// which the lexicographic test needs.
class Lemke {
 public:
  Lemke(const MatX& M, const VecX& q) : n_(q.size()), tableau_(n_, 2 * n_ + 2), basis_(at(n_)) {
    tableau_ << MatX::Identity(n_, n_), -M, VecX::Constant(n_, -1.0), q;
    for (Index i = 0; i < n_; ++i) basis_[at(i)] = i;
  }

  /// Runs to a solution (true) or a secondary ray.
  bool run(int pivot_cap) {
    // The covering variable z₀ enters where q is most negative: then the basis is feasible.
    Index row = 0;
    if (n_ == 0 || tableau_.col(2 * n_ + 1).minCoeff(&row) >= 0) return true;
    Index entering = 2 * n_;

    // The complement of what left enters, until z₀ leaves (a solution) or nothing does (a ray).
    while (pivots_ < pivot_cap) {
      poll_interrupt();
      const Index leaving = basis_[at(row)];
      pivot(row, entering);
      if (leaving == 2 * n_) return true;
      entering = leaving < n_ ? leaving + n_ : leaving - n_;
      row = leaving_row(entering);
      if (row < 0) return false;
    }
    return false;
  }

  VecX z() const {
    VecX z = VecX::Zero(n_);
    for (Index i = 0; i < n_; ++i) {
      const Index variable = basis_[at(i)];
      if (variable >= n_ && variable < 2 * n_) z(variable - n_) = std::max(0.0, tableau_(i, 2 * n_ + 1));
    }
    return z;
  }

  /// Indices whose z is basic.
  std::vector<Index> closed() const {
    std::vector<Index> closed;
    for (const Index variable : basis_)
      if (variable >= n_ && variable < 2 * n_) closed.push_back(variable - n_);
    return closed;
  }

  int pivots() const { return pivots_; }

 private:
  void pivot(Index row, Index column) {
    tableau_.row(row) /= tableau_(row, column);
    for (Index i = 0; i < n_; ++i) {
      if (i == row) continue;
      const double factor = tableau_(i, column);
      if (factor != 0) tableau_.row(i) -= factor * tableau_.row(row);
    }
    basis_[at(row)] = column;
    ++pivots_;
  }

  // Smallest ratio q_i / column_i over positive entries; ties by z₀ first, then by the rows of the inverse
  // basis.
  Index leaving_row(Index column) const {
    const double threshold = kPivotTolerance * tableau_.col(column).cwiseAbs().maxCoeff();
    Index best = -1;
    for (Index i = 0; i < n_; ++i) {
      if (!(tableau_(i, column) > threshold)) continue;
      if (best < 0 || is_smaller(i, best, column)) best = i;
    }
    return best;
  }

  bool is_smaller(Index i, Index k, Index column) const {
    const double a = tableau_(i, 2 * n_ + 1) / tableau_(i, column);
    const double b = tableau_(k, 2 * n_ + 1) / tableau_(k, column);
    const double slack = kPivotTolerance * std::max(std::abs(a), std::abs(b));
    if (a < b - slack) return true;
    if (a > b + slack) return false;
    if (basis_[at(i)] == 2 * n_) return true;
    if (basis_[at(k)] == 2 * n_) return false;
    for (Index j = 0; j < n_; ++j) {
      const double difference = tableau_(i, j) / tableau_(i, column) - tableau_(k, j) / tableau_(k, column);
      if (difference != 0) return difference < 0;
    }
    return false;
  }

  Index n_;
  MatX tableau_;
  std::vector<Index> basis_;
  int pivots_ = 0;
};

// The same closed set solved afresh, if that is a solution of less residual.
LcpSolution refined(const MatX& M, const VecX& q, const Lemke& lemke) {
  LcpSolution raw = finish_lcp(M, q, lemke.z(), lemke.pivots());
  const std::vector<Index> C = lemke.closed();
  if (C.empty()) return raw;
  const Eigen::FullPivLU<MatX> factors(M(C, C));
  VecX z_closed = -factors.solve(q(C).eval());
  z_closed -= factors.solve(M(C, C) * z_closed + q(C));
  VecX z = VecX::Zero(q.size());
  z(C) = z_closed.cwiseMax(0.0);
  const LcpSolution fresh = finish_lcp(M, q, z, lemke.pivots());
  return fresh.residual <= raw.residual ? fresh : raw;
}

}  // namespace

LcpSolution lcp_lemke(const MatX& M, const VecX& q) {
  RIGOR_ASSERT(M.rows() == q.size() && M.cols() == q.size());
  // Lemke's pivots grow with n in practice, exponentially only in constructed examples.
  const int pivot_cap = 100 + 50 * static_cast<int>(q.size());
  Lemke lemke(M, q);
  lemke.run(pivot_cap);
  return refined(M, q, lemke);
}

}  // namespace rigor
