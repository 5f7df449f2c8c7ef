// ConstrainedMass: the motions that its links allow.

#include "rigor/core/index.hpp"
#include "rigor/math/dense.hpp"
#include "rigor/solver/linear/constrained_mass.hpp"

#include <algorithm>

namespace rigor {
namespace {

/// Orthonormal columns that complete the active ones of W_T, which are orthonormal, to a base.
Eigen::Matrix<double, 6, Eigen::Dynamic> complement(const Mat6& W_T, const std::array<bool, 6>& active) {
  MatX held(6, std::count(active.begin(), active.end(), true));
  Eigen::Index count = 0;
  for (int i = 0; i < 6; ++i)
    if (active[at(i)]) held.col(count++) = W_T.col(i);
  MatX base = Mat6::Identity().rightCols(6 - count);
  if (count > 0) apply_householder_q(householder_factors(held), base);
  return base;
}

}  // namespace

// The response to forces is Uᵀ (1 - Wᵀ W) U, U the way up along the trees to K_Y g. With the columns V of a
// base of what W leaves, 1 - Wᵀ W = V Vᵀ, and Uᵀ V are the motions: each begins at a node along one of its V
// and carries along what hangs on it.
MatX ConstrainedMass::motions_of_trees() const {
  // The number of motions that begin at each node.
  std::vector<Eigen::Matrix<double, 6, Eigen::Dynamic>> own;
  Eigen::Index count = 0;
  for (std::size_t place = 0; place < pivots_.size(); ++place) {
    const int link = forest_.nodes[place].link;
    own.push_back(complement(pivots_[place].W_T, link < 0 ? ActiveRows{} : active_[at(link)]));
    count += own.back().cols();
  }

  // Down the trees: a = K_Yᵀ (u - Wᵀ Z a_parent), u = V for those that begin there.
  MatX N = MatX::Zero(6 * graph_.node_count, count);
  Eigen::Index first = 0;
  for (std::size_t place = 0; place < pivots_.size(); ++place) {
    const SpanningForest::Node& node = forest_.nodes[place];
    const Pivot& pivot = pivots_[place];
    for (Eigen::Index k = 0; k < first && node.parent >= 0; ++k) {
      const Vec6 a_parent = N.col(k).segment<6>(6 * forest_.nodes[at(node.parent)].node);
      if (a_parent.isZero(0)) continue;
      Vec6 u = Vec6::Zero();
      for (int i = 0; i < pivot.rows; ++i) u -= pivot.Z_T.col(i).dot(a_parent) * pivot.W_T.col(i);
      N.col(k).segment<6>(6 * node.node) = pivot.K_Y.transpose() * u;
    }
    for (Eigen::Index k = 0; k < own[place].cols(); ++k)
      N.col(first + k).segment<6>(6 * node.node) = pivot.K_Y.transpose() * own[place].col(k);
    first += own[place].cols();
  }
  return N;
}

// Down the trees: a = K_Yᵀ (1 - Wᵀ W) K_Y f + T a_parent with T = -K_Yᵀ Wᵀ Z, and what a node's parent does
// in response to f is Tᵀ f on the parent.
std::vector<Mat6> ConstrainedMass::own_responses() const {
  std::vector<Mat6> result;
  if (S_.size() > 0) return result;
  result.resize(masses_.size());
  for (std::size_t place = 0; place < pivots_.size(); ++place) {
    const SpanningForest::Node& node = forest_.nodes[place];
    const Pivot& pivot = pivots_[place];
    Mat6& response = result[at(node.node)];
    if (node.link < 0) {
      response = pivot.K_Y.transpose() * pivot.K_Y;
      continue;
    }
    const auto W_T = pivot.W_T.leftCols(pivot.rows);
    const Mat6 free = pivot.K_Y - W_T * (W_T.transpose() * pivot.K_Y);
    response = free.transpose() * free;
    if (node.parent < 0) continue;
    const Mat6 T = -pivot.K_Y.transpose() * (W_T * pivot.Z_T.leftCols(pivot.rows).transpose());
    response += T * result[at(forest_.nodes[at(node.parent)].node)] * T.transpose();
  }
  return result;
}

MatX ConstrainedMass::loop_rates(const MatX& velocities) const {
  MatX rates(static_cast<Eigen::Index>(dense_.pivots().size()), velocities.cols());
  Eigen::Index next = 0;
  for (const Loop& loop : loops_) {
    for (int row = 0; row < 6; ++row) {
      const std::vector<Eigen::Index>& taken = dense_.pivots();
      if (loop.dense[at(row)] < 0 ||
          std::find(taken.begin(), taken.end(), loop.dense[at(row)]) == taken.end())
        continue;
      rates.row(next).setZero();
      const std::vector<int>& nodes = graph_.links[at(loop.link)].nodes;
      for (std::size_t k = 0; k < nodes.size(); ++k)
        rates.row(next) +=
            wrenches(loop.link, k).col(row).transpose() * velocities.middleRows<6>(6 * nodes[k]);
      ++next;
    }
  }
  return rates;
}

MatX ConstrainedMass::motions() const {
  MatX N = motions_of_trees();
  if (dense_.pivots().empty() || N.cols() == 0) return N;

  // Of the trees' motions those that keep the loops closed: the complement of C N.
  const MatX C_T = loop_rates(N).transpose();
  if (C_T.rows() == C_T.cols()) return MatX(N.rows(), 0);
  MatX kept = MatX::Zero(C_T.rows(), C_T.rows() - C_T.cols());
  kept.bottomRows(kept.cols()).setIdentity();
  apply_householder_q(householder_factors(C_T), kept);
  return N * kept;
}

}  // namespace rigor
