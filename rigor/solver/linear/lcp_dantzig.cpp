#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"
#include "rigor/core/interrupt.hpp"
#include "rigor/math/dense.hpp"
#include "rigor/solver/linear/lcp.hpp"
#include "rigor/solver/linear/lcp_residual.hpp"
#include "rigor/solver/linear/solved_residual.hpp"

#include <limits>
#include <vector>

namespace rigor {
namespace {

using Eigen::Index;

// Relative to the size of the sums they come from: anything smaller is round-off.
constexpr double kPivotRounding = 1e-13;

class Dantzig {
 public:
  Dantzig(const MatX& M, const VecX& q)
      : M_(M),
        q_(q),
        is_symmetric_(M == M.transpose()),
        z_(VecX::Zero(q.size())),
        w_(q),
        clamped_(at(q.size()), false) {}

  LcpSolution solve() {
    // Every index may be driven again after round-off; twice the usual number of pivots is plenty.
    const int pivot_cap = 100 + 50 * static_cast<int>(q_.size());
    while (pivots_ < pivot_cap) {
      const Index driven = most_negative();
      if (driven < 0 || !drive_to_zero(driven, pivot_cap)) break;
      solve_clamped();
    }
    return finish_lcp(M_, q_, z_, pivots_);
  }

 private:
  double size() const {
    return std::max(q_.cwiseAbs().maxCoeff(), (M_.cwiseAbs() * z_.cwiseAbs()).maxCoeff());
  }

  Index most_negative() const {
    if (q_.size() == 0) return -1;
    Index driven = 0;
    return w_.minCoeff(&driven) < -kPivotRounding * size() ? driven : -1;
  }

  std::vector<Index> clamped_indices() const {
    std::vector<Index> indices;
    for (Index i = 0; i < q_.size(); ++i)
      if (clamped_[at(i)]) indices.push_back(i);
    return indices;
  }

  VecX solve(const MatX& matrix, const VecX& right_side) const {
    if (is_symmetric_) return symmetric_solution(matrix, right_side);
    return square_solution(matrix, right_side);
  }

  // Change of z that pushes index d by one and keeps w = 0 on the clamped set.
  VecX push_direction(Index d) const {
    VecX direction = VecX::Zero(q_.size());
    direction(d) = 1;
    const std::vector<Index> C = clamped_indices();
    if (C.empty()) return direction;
    direction(C) = -solve(M_(C, C), M_(C, d));
    return direction;
  }

  // Raises z_d until w_d = 0; contacts enter and leave the clamped set on the way. False: nothing stops the
  // push.
  bool drive_to_zero(Index d, int pivot_cap) {
    while (pivots_++ < pivot_cap) {
      poll_interrupt();
      const VecX dz = push_direction(d);
      const VecX dw = M_ * dz;
      const VecX dw_size = M_.cwiseAbs() * dz.cwiseAbs();

      // As far as w_d = 0, z = 0 of a clamped index, or w = 0 of an open one.
      double step = std::numeric_limits<double>::infinity();
      Index blocking = -1;
      const auto consider = [&](double length, Index i) {
        if (!(length < step)) return;
        step = std::max(0.0, length);
        blocking = i;
      };
      if (dw(d) > kPivotRounding * dw_size(d)) consider(-w_(d) / dw(d), d);
      for (Index i = 0; i < q_.size(); ++i) {
        if (i == d) continue;
        const bool is_clamped = clamped_[at(i)];
        if (is_clamped && dz(i) < -kPivotRounding) consider(-z_(i) / dz(i), i);
        // A redundant index (dw is round-off) can neither help nor hinder.
        if (!is_clamped && w_(i) >= 0 && dw(i) < -kPivotRounding * dw_size(i)) consider(-w_(i) / dw(i), i);
      }
      if (blocking < 0) return false;

      // The index that blocks changes its set.
      z_ += step * dz;
      w_ += step * dw;
      exchange(blocking, d);
      if (blocking == d) return true;
    }
    return false;
  }

  void exchange(Index i, Index driven) {
    const bool was_clamped = clamped_[at(i)];
    clamped_[at(i)] = !was_clamped;
    if (was_clamped || i != driven) (was_clamped ? z_ : w_)(i) = 0;
  }

  // Removes the accumulated round-off: z from the clamped set alone.
  void solve_clamped() {
    const std::vector<Index> C = clamped_indices();
    if (!C.empty()) {
      const MatX M_CC = M_(C, C);
      VecX z = -solve(M_CC, q_(C));
      z -= solve(M_CC, M_CC * z + q_(C));
      if (z.allFinite() && z.minCoeff() >= -kPivotRounding * z.cwiseAbs().maxCoeff()) {
        z_.setZero();
        z_(C) = z.cwiseMax(0.0);
      }
    }
    w_ = M_ * z_ + q_;
    for (const Index i : C) w_(i) = 0;
  }

  const MatX& M_;
  const VecX& q_;
  bool is_symmetric_;
  VecX z_, w_;
  std::vector<bool> clamped_;
  int pivots_ = 0;
};

}  // namespace

LcpSolution finish_lcp(const MatX& M, const VecX& q, const VecX& z, int pivots) {
  LcpSolution solution{z, M * z + q, 0.0, pivots, false};
  const double size =
      q.size() == 0 ? 0.0 : std::max(q.cwiseAbs().maxCoeff(), (M.cwiseAbs() * z.cwiseAbs()).maxCoeff());
  double worst = 0;
  for (Index i = 0; i < q.size(); ++i) {
    // An index with no stiffness of its own is compared as if with that of the largest.
    const double stiffness = M(i, i) > 0 ? M(i, i) : M.cwiseAbs().maxCoeff();
    worst = std::max(worst, std::abs(std::min(z(i) * stiffness, solution.w(i))));
  }
  solution.residual = size > 0 ? worst / size : 0.0;
  if (!z.allFinite()) solution.residual = std::numeric_limits<double>::infinity();
  solution.converged = solution.residual <= solved_residual;
  return solution;
}

LcpSolution lcp_dantzig(const MatX& M, const VecX& q) {
  RIGOR_ASSERT(M.rows() == q.size() && M.cols() == q.size());
  return Dantzig(M, q).solve();
}

}  // namespace rigor
