#include "rigor/solver/linear/constrained_mass.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"
#include "rigor/core/sorted_unique.hpp"
#include "rigor/core/work_count.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
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

/// K with K A Kᵀ = 1, the inverse of the Cholesky factor of the first `size` rows of A (its lower triangle),
/// on active rows; 0 elsewhere. Rows that follow from the active ones before them become inactive.
Mat6 inverse_factor(const Mat6& A, int size, double threshold, ActiveRows& active) {
  Mat6 L;
  Mat6 K = Mat6::Zero();
  for (int i = 0; i < size; ++i) {
    L.row(i).setZero();
    if (!active[at(i)]) continue;
    double left = A(i, i);
    for (int j = 0; j < i; ++j) {
      double x = A(i, j);
      for (int k = 0; k < j; ++k) x -= L(i, k) * L(j, k);
      L(i, j) = x * K(j, j);
      left -= L(i, j) * L(i, j);
    }
    if (left <= threshold * A(i, i)) {
      L.row(i).setZero();
      active[at(i)] = false;
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

/// Largest coefficient of the first rows of a transposed block; 0 for the others.
Vec6 row_sizes(const Mat6& J_T, int rows) {
  Vec6 sizes = Vec6::Zero();
  for (int i = 0; i < rows; ++i) sizes(i) = J_T.col(i).cwiseAbs().maxCoeff();
  return sizes;
}

/// J_T Kᵀ for the lower triangle K of `rows` rows, and zeros after them.
Mat6 times_transposed(const Mat6& J_T, const Mat6& K, int rows) {
  Mat6 product = Mat6::Zero();
  for (int i = 0; i < rows; ++i)
    for (int k = 0; k <= i; ++k) product.col(i) += K(i, k) * J_T.col(k);
  return product;
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

void ConstrainedMass::factor(std::span<const Mat6> masses, std::span<const Mat6> rows,
                             const RowChoice* choice) {
  const bool is_new = copy_input(masses, rows);
  if (is_factored_ && !is_new && is_same_choice(choice)) return;
  set_active_rows(choice);
  factor_trees();
  for (Loop& loop : loops_) eliminate(loop);
  factor_dense(choice == nullptr ? kDependentRow : kRounding);
  count_work(operations());
  is_factored_ = true;
  asked_choice_.reset();
  if (choice != nullptr) asked_choice_ = *choice;
}

bool ConstrainedMass::copy_input(std::span<const Mat6> masses, std::span<const Mat6> rows) {
  RIGOR_ASSERT(masses.size() == masses_.size() && rows.size() == blocks_.size());
  bool is_new = false;
  const auto take = [&is_new](const Mat6& value, Mat6& place) {
    // Bit for bit: a zero of the other sign is another number.
    // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison)
    if (std::memcmp(value.data(), place.data(), sizeof(Mat6)) == 0) return;
    place = value;
    is_new = true;
  };
  for (std::size_t node = 0; node < masses.size(); ++node) take(masses[node], masses_[node]);
  std::size_t block = 0;
  for (const ConstraintGraph::Link& link : graph_.links) {
    for (std::size_t k = 0; k < link.nodes.size(); ++k, ++block) {
      Mat6 J_T = Mat6::Zero();
      for (int i = 0; i < link.rows; ++i) J_T.col(i) = rows[block].row(i).transpose();
      take(J_T, blocks_[block]);
    }
  }
  return is_new;
}

// Where no row is left out, a choice of none leads the same way as no choice.
bool ConstrainedMass::is_same_choice(const RowChoice* choice) const {
  if (choice == nullptr) return !asked_choice_;
  return asked_choice_ ? *choice == *asked_choice_ : choice->empty() && choice_.empty();
}

void ConstrainedMass::set_active_rows(const RowChoice* choice) {
  choice_.clear();
  if (choice != nullptr) choice_ = *choice;
  for (std::size_t link = 0; link < active_.size(); ++link) {
    Vec6 sizes = Vec6::Zero();
    for (std::size_t k = 0; k < graph_.links[link].nodes.size(); ++k)
      sizes = sizes.cwiseMax(row_sizes(wrenches(static_cast<int>(link), k), graph_.links[link].rows));
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
    pivot.K_Y = inverse_factor(pivot.K_Y, 6, 0, all);
    if (node.link < 0) continue;
    factor_link(node, pivot);
    if (node.parent < 0) continue;
    Mat6& Y_parent = pivots_[at(node.parent)].K_Y;
    for (int k = 0; k < pivot.rows; ++k)
      for (int j = 0; j < 6; ++j) Y_parent.col(j) += pivot.Z_T(j, k) * pivot.Z_T.col(k);
  }
}

void ConstrainedMass::factor_link(const SpanningForest::Node& node, Pivot& pivot) {
  // D = J Y⁻¹ Jᵀ = Uᵀ U with U = K_Y Jᵀ.
  const Mat6& J_T = wrenches(node.link, node.is_first_end ? 0 : 1);
  pivot.rows = rows_of(node.link);
  Mat6 U, D;
  for (int i = 0; i < pivot.rows; ++i) {
    U.col(i).noalias() = pivot.K_Y * J_T.col(i);
    for (int k = 0; k <= i; ++k) D(i, k) = U.col(i).dot(U.col(k));
  }

  // A row that has no hold on the node, or none of its own, waits for the dense system.
  ActiveRows& active = active_[link_of(node)];
  const ActiveRows counting = active;
  const Mat6* J_parent = node.parent < 0 ? nullptr : &wrenches(node.link, node.is_first_end ? 1 : 0);
  if (J_parent != nullptr) {
    const Vec6 sizes = row_sizes(J_T, pivot.rows), parent_sizes = row_sizes(*J_parent, pivot.rows);
    for (int i = 0; i < pivot.rows; ++i)
      if (sizes(i) <= kVanishedRow * parent_sizes(i)) active[static_cast<std::size_t>(i)] = false;
  }
  pivot.K_D = inverse_factor(D, pivot.rows, kDependentRow, active);
  pivot.W_T = times_transposed(U, pivot.K_D, pivot.rows);
  if (J_parent != nullptr) pivot.Z_T = times_transposed(*J_parent, pivot.K_D, pivot.rows);
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
  // The wrenches of the rows on their nodes.
  for (Mat6& U : loop.U) U.setZero();
  loop.sizes.setZero();
  const std::vector<int>& nodes = graph_.links[at(loop.link)].nodes;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const int place = forest_.places[at(nodes[k])];
    const auto found = std::find_if(loop.path.begin(), loop.path.end(),
                                    [place](const SpanningForest::PathNode& p) { return p.place == place; });
    Mat6& U = loop.U[at(found - loop.path.begin())];
    const Mat6& J_T = wrenches(loop.link, k);
    for (int i = 0; i < rows_of(loop.link); ++i) {
      if (!loop.active[at(i)]) continue;
      U.col(i) = J_T.col(i);
      loop.sizes(i) += (pivots_[at(place)].K_Y * J_T.col(i)).squaredNorm();
    }
  }

  // Up to the roots, row by row.
  for (std::size_t i = 0; i < loop.path.size(); ++i) {
    const std::size_t place = at(loop.path[i].place);
    const Pivot& pivot = pivots_[place];
    const bool is_linked = forest_.nodes[place].link >= 0;
    for (int row = 0; row < rows_of(loop.link); ++row) {
      if (!loop.active[at(row)]) continue;
      const Vec6 U = pivot.K_Y * loop.U[i].col(row);
      Vec6 P = U;
      for (int k = 0; is_linked && k < pivot.rows; ++k) {
        const double s = -pivot.W_T.col(k).dot(U);
        P += s * pivot.W_T.col(k);
        if (loop.path[i].next >= 0) loop.U[at(loop.path[i].next)].col(row) += s * pivot.Z_T.col(k);
      }
      loop.U[i].col(row) = U;
      loop.P[i].col(row) = P;
    }
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

/// What the factors of this configuration cost, with all that is asked of them (count_work).
std::uint64_t ConstrainedMass::operations() const {
  // Of a link; and so many cubes of rows of the dense system are one.
  constexpr std::uint64_t of_link = 20, rows_cubed = 500;
  std::uint64_t count = of_link * graph_.links.size();
  if (loops_.empty()) return count;
  // Loops are multiplied with each other wherever their ways to the roots meet.
  std::vector<std::uint64_t> ways(pivots_.size(), 0);
  for (const Loop& loop : loops_)
    for (const SpanningForest::PathNode& node : loop.path) count += ++ways[at(node.place)];
  const auto rows = static_cast<std::uint64_t>(S_.rows());
  return count + rows * rows * rows / rows_cubed;
}

std::size_t ConstrainedMass::block_count() const {
  std::size_t count = 4 * pivots_.size();
  for (const Loop& loop : loops_) count += 2 * loop.path.size();
  return count;
}

}  // namespace rigor
