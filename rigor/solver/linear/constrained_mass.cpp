#include "rigor/solver/linear/constrained_mass.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/sorted_unique.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rigor {
namespace {

/// A row whose coefficients are smaller than this part of the largest of its link has vanished. Coefficients
/// are lever arms and directions, of sizes 1e-6 to 1e6; what cancels leaves 1e-16 of them.
constexpr double kVanishedRow = 1e-12;
/// A row follows from others if they leave less than this part of its mobility J M⁻¹ Jᵀ. That part is the
/// square of an angle: rows that differ by more than 1e-5 are told apart, and neither rounding nor the drift
/// of the positions (1e-9 and less) makes a row that follows from others look new.
constexpr double kDependentRow = 1e-10;
/// The same for rows that must count: above the rounding of the mobility.
constexpr double kRounding = 1e-15;

using ActiveRows = std::array<bool, 6>;

/// K with K A Kᵀ = 1, the inverse of the Cholesky factor of A, on active rows; 0 elsewhere. Rows that follow
/// from the active ones before them become inactive.
Mat6 inverse_factor(const Mat6& A, double threshold, ActiveRows& active) {
  Mat6 L = Mat6::Zero();
  Mat6 K = Mat6::Zero();
  for (int i = 0; i < 6; ++i) {
    if (!active[static_cast<std::size_t>(i)]) continue;
    double left = A(i, i);
    for (int j = 0; j < i; ++j) {
      double x = A(i, j);
      for (int k = 0; k < j; ++k) x -= L(i, k) * L(j, k);
      L(i, j) = x * K(j, j);
      left -= L(i, j) * L(i, j);
    }
    if (left <= threshold * A(i, i)) {
      L.row(i).setZero();
      active[static_cast<std::size_t>(i)] = false;
      continue;
    }
    K(i, i) = 1 / std::sqrt(left);
    for (int j = 0; j < i; ++j) {
      double x = 0;
      for (int k = j; k < i; ++k) x -= L(i, k) * K(k, j);
      K(i, j) = x * K(i, i);
    }
  }
  return K;
}

Vec6 row_sizes(const Mat6& J) {
  return J.cwiseAbs().rowwise().maxCoeff();
}

}  // namespace

ConstrainedMass::ConstrainedMass(ConstraintGraph graph) : graph_(std::move(graph)), forest_(graph_) {
  std::size_t blocks = 0;
  for (const ConstraintGraph::Link& link : graph_.links) {
    first_rows_.push_back(row_count_);
    first_blocks_.push_back(blocks);
    row_count_ += link.rows;
    blocks += link.nodes.size();
  }
  masses_.resize(static_cast<std::size_t>(graph_.node_count));
  blocks_.resize(blocks);
  active_.resize(graph_.links.size());
  pivots_.resize(masses_.size());
  choice_.reserve(static_cast<std::size_t>(row_count_));
  for (const int link : forest_.loop_links) add_loop(link);
}

void ConstrainedMass::factor(std::span<const Mat6> masses, std::span<const std::vector<Rows>> rows,
                             const RowChoice* choice) {
  copy_input(masses, rows);
  set_active_rows(choice);
  factor_trees();
  for (Loop& loop : loops_) eliminate(loop);
  factor_dense(choice == nullptr ? kDependentRow : kRounding);
}

void ConstrainedMass::copy_input(std::span<const Mat6> masses, std::span<const std::vector<Rows>> rows) {
  RIGOR_ASSERT(masses.size() == masses_.size() && rows.size() == graph_.links.size());
  std::copy(masses.begin(), masses.end(), masses_.begin());
  for (std::size_t link = 0; link < rows.size(); ++link) {
    RIGOR_ASSERT(rows[link].size() == graph_.links[link].nodes.size());
    for (std::size_t k = 0; k < rows[link].size(); ++k) {
      RIGOR_ASSERT(rows[link][k].rows() == graph_.links[link].rows);
      Mat6& J = blocks_[first_blocks_[link] + k];
      J.setZero();
      J.topRows(graph_.links[link].rows) = rows[link][k];
    }
  }
}

void ConstrainedMass::set_active_rows(const RowChoice* choice) {
  choice_.clear();
  if (choice != nullptr) choice_ = *choice;
  for (std::size_t link = 0; link < active_.size(); ++link) {
    Vec6 sizes = Vec6::Zero();
    for (std::size_t k = 0; k < graph_.links[link].nodes.size(); ++k)
      sizes = sizes.cwiseMax(row_sizes(block(static_cast<int>(link), k)));
    const double vanished = kVanishedRow * sizes.maxCoeff();
    for (int i = 0; i < 6; ++i) {
      bool& is_active = active_[link][static_cast<std::size_t>(i)];
      is_active = i < graph_.links[link].rows && !(sizes(i) <= vanished);
      if (i < graph_.links[link].rows && !is_active) choice_.push_back(first_rows_[link] + i);
    }
  }
  choice_ = sorted_unique(std::move(choice_));
  for (const Eigen::Index row : choice_) {
    const auto next = std::upper_bound(first_rows_.begin(), first_rows_.end(), static_cast<int>(row));
    const std::size_t link = static_cast<std::size_t>(next - first_rows_.begin()) - 1;
    active_[link][static_cast<std::size_t>(row - first_rows_[link])] = false;
  }
}

void ConstrainedMass::factor_trees() {
  loops_.resize(forest_.loop_links.size());
  for (Loop& loop : loops_) loop.active = active_[static_cast<std::size_t>(loop.link)];

  // The place of K_Y holds Y until its node is reached.
  for (std::size_t place = 0; place < pivots_.size(); ++place)
    pivots_[place].K_Y = masses_[static_cast<std::size_t>(forest_.nodes[place].node)];
  for (std::size_t place = pivots_.size(); place-- > 0;) {
    const SpanningForest::Node& node = forest_.nodes[place];
    Pivot& pivot = pivots_[place];
    ActiveRows all;
    all.fill(true);
    pivot.K_Y = inverse_factor(pivot.K_Y, 0, all);
    if (node.link < 0) continue;
    factor_link(node, pivot);
    if (node.parent < 0) continue;
    pivots_[static_cast<std::size_t>(node.parent)].K_Y += pivot.Z.transpose() * pivot.Z;
  }
}

void ConstrainedMass::factor_link(const SpanningForest::Node& node, Pivot& pivot) {
  const Mat6& J = block(node.link, node.is_first_end ? 0 : 1);
  const Mat6& J_parent = block(node.link, node.is_first_end ? 1 : 0);
  const Mat6 Y = pivot.K_Y * J.transpose();
  const Mat6 A = Y.transpose() * Y;

  // A row that has no hold on the node, or none of its own, waits for the dense system.
  ActiveRows& active = active_[link_of(node)];
  const ActiveRows counting = active;
  if (node.parent >= 0) {
    const Vec6 sizes = row_sizes(J), parent_sizes = row_sizes(J_parent);
    for (int i = 0; i < 6; ++i)
      if (sizes(i) <= kVanishedRow * parent_sizes(i)) active[static_cast<std::size_t>(i)] = false;
  }
  pivot.K_D = inverse_factor(A, kDependentRow, active);
  pivot.W.noalias() = pivot.K_D * Y.transpose();
  if (node.parent >= 0) pivot.Z.noalias() = pivot.K_D * J_parent;
  if (active == counting) return;

  add_loop(node.link);
  for (std::size_t i = 0; i < 6; ++i) loops_.back().active[i] = counting[i] && !active[i];
}

void ConstrainedMass::add_loop(int link) {
  Loop& loop = loops_.emplace_back();
  loop.link = link;
  loop.path = forest_.path(graph_.links[static_cast<std::size_t>(link)].nodes);
  loop.U.resize(loop.path.size());
  loop.P.resize(loop.path.size());
}

void ConstrainedMass::eliminate(Loop& loop) const {
  for (Mat6& U : loop.U) U.setZero();
  loop.sizes.setZero();
  const std::vector<int>& nodes = graph_.links[static_cast<std::size_t>(loop.link)].nodes;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const int place = forest_.places[static_cast<std::size_t>(nodes[k])];
    const auto at = std::find_if(loop.path.begin(), loop.path.end(),
                                 [place](const SpanningForest::PathNode& p) { return p.place == place; });
    const Mat6 G = block(loop.link, k).transpose();
    for (int i = 0; i < 6; ++i)
      if (loop.active[static_cast<std::size_t>(i)])
        loop.U[static_cast<std::size_t>(at - loop.path.begin())].col(i) = G.col(i);
    loop.sizes += (pivots_[static_cast<std::size_t>(place)].K_Y * G).colwise().squaredNorm().transpose();
  }
  for (std::size_t i = 0; i < loop.path.size(); ++i) {
    const std::size_t place = static_cast<std::size_t>(loop.path[i].place);
    const Pivot& pivot = pivots_[place];
    loop.U[i] = pivot.K_Y * loop.U[i];
    loop.P[i] = loop.U[i];
    if (forest_.nodes[place].link < 0) continue;
    const Mat6 V = -pivot.W * loop.U[i];
    loop.P[i] += pivot.W.transpose() * V;
    if (loop.path[i].next >= 0)
      loop.U[static_cast<std::size_t>(loop.path[i].next)] += pivot.Z.transpose() * V;
  }
}

Vec6 ConstrainedMass::padded(const Eigen::Ref<const VecX>& x, int link) const {
  Vec6 values = Vec6::Zero();
  for (int i = 0; i < rows_of(link); ++i) values(i) = x(first_row(link) + i);
  return values;
}

void ConstrainedMass::store(const Vec6& values, int link, Eigen::Ref<VecX> x) const {
  for (int i = 0; i < rows_of(link); ++i) x(first_row(link) + i) = values(i);
}

std::size_t ConstrainedMass::block_count() const {
  std::size_t count = 4 * pivots_.size();
  for (const Loop& loop : loops_) count += 2 * loop.path.size();
  return count;
}

}  // namespace rigor
