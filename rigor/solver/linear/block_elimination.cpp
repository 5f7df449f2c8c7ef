#include "rigor/solver/linear/block_elimination.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"
#include "rigor/core/work_count.hpp"
#include "rigor/solver/linear/two_doubles.hpp"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

namespace rigor {

namespace {

/// The place of each of at most 32 nodes, eliminated in the order of their degrees: the least coupled node
/// that is left comes next, and couples its neighbours. Neighbours are bits.
std::vector<int> places_of_least_degree(std::size_t nodes, const std::vector<std::pair<int, int>>& pairs) {
  std::array<std::uint32_t, 32> neighbours{};
  for (const auto& [a, b] : pairs) {
    neighbours[at(a)] |= std::uint32_t{1} << b;
    neighbours[at(b)] |= std::uint32_t{1} << a;
  }
  std::vector<int> places(nodes, -1);
  for (std::size_t place = 0; place < nodes; ++place) {
    std::size_t least = nodes;
    for (std::size_t node = 0; node < nodes; ++node) {
      if (places[node] >= 0) continue;
      if (least == nodes || std::popcount(neighbours[node]) < std::popcount(neighbours[least])) least = node;
    }
    places[least] = static_cast<int>(place);
    const std::uint32_t coupled = neighbours[least], own = std::uint32_t{1} << least;
    for (std::size_t node = 0; node < nodes; ++node)
      if ((coupled >> node & 1) != 0)
        neighbours[node] = (neighbours[node] | coupled) & ~own & ~(std::uint32_t{1} << node);
  }
  return places;
}

/// The place of each node in an order of little fill.
std::vector<int> places_of_little_fill(std::size_t nodes, const std::vector<std::pair<int, int>>& pairs) {
  // Any order will do for two.
  std::vector<int> places(nodes);
  std::iota(places.begin(), places.end(), 0);
  if (nodes <= 2) return places;
  // Of few nodes the degrees themselves cost less than their bounds, and less than the matrix that Eigen
  // asks for.
  constexpr std::size_t few = 32;
  if (nodes <= few) return places_of_least_degree(nodes, pairs);
  Eigen::SparseMatrix<double> graph(static_cast<Eigen::Index>(nodes), static_cast<Eigen::Index>(nodes));
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(2 * pairs.size() + nodes);
  for (int node = 0; node < static_cast<int>(nodes); ++node) entries.emplace_back(node, node, 1.0);
  for (const auto& [a, b] : pairs) {
    entries.emplace_back(a, b, 1.0);
    entries.emplace_back(b, a, 1.0);
  }
  graph.setFromTriplets(entries.begin(), entries.end());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
  Eigen::AMDOrdering<int>()(graph, order);

  for (int place = 0; place < static_cast<int>(nodes); ++place) places[at(order.indices()(place))] = place;
  return places;
}

}  // namespace

EliminationPattern::EliminationPattern(std::size_t nodes, const std::vector<std::pair<int, int>>& pairs)
    : EliminationPattern(places_of_little_fill(nodes, pairs), pairs) {}

EliminationPattern::EliminationPattern(std::vector<int> places, const std::vector<std::pair<int, int>>& pairs)
    : place_(std::move(places)), begin_(place_.size() + 1, 0), first_changed_(place_.size(), 0) {
  const std::size_t nodes = place_.size();

  // Later places that are coupled to each place from the beginning.
  std::vector<std::vector<std::size_t>> later(nodes);
  for (const auto& [a, b] : pairs) {
    const auto [first, second] = std::minmax(place_[at(a)], place_[at(b)]);
    later[at(first)].push_back(at(second));
  }

  // Eliminating a place couples all of its later ones: the first of them takes over the others, and so all
  // of them are coupled when their turn comes.
  for (std::size_t place = 0; place < nodes; ++place) {
    std::vector<std::size_t>& of_place = later[place];
    std::sort(of_place.begin(), of_place.end());
    of_place.erase(std::unique(of_place.begin(), of_place.end()), of_place.end());
    if (!of_place.empty()) {
      std::vector<std::size_t>& heir = later[of_place.front()];
      heir.insert(heir.end(), of_place.begin() + 1, of_place.end());
    }
    begin_[place] = later_.size();
    later_.insert(later_.end(), of_place.begin(), of_place.end());
  }
  begin_[nodes] = later_.size();

  // Where the products of the elimination go.
  for (std::size_t place = 0; place < nodes; ++place) {
    first_changed_[place] = changed_.size();
    for (std::size_t i = begin_[place]; i < begin_[place + 1]; ++i) {
      std::size_t found = begin_[later_[i]];
      for (std::size_t k = i + 1; k < begin_[place + 1]; ++k) {
        while (later_[found] != later_[k]) ++found;
        changed_.push_back(found);
      }
    }
  }
}

std::size_t EliminationPattern::pair(int first, int second) const {
  const auto begin = later_.begin() + static_cast<std::ptrdiff_t>(begin_[at(first)]),
             end = later_.begin() + static_cast<std::ptrdiff_t>(begin_[at(first) + 1]);
  const auto found = std::lower_bound(begin, end, at(second));
  RIGOR_ASSERT(found != end && *found == at(second));
  return static_cast<std::size_t>(found - later_.begin());
}

std::size_t EliminationPattern::slot(int row_node, int column_node) const {
  const int row = place(row_node), column = place(column_node);
  if (row == column) return at(row);
  return row < column ? node_count() + pair(row, column) : node_count() + pair_count() + pair(column, row);
}

namespace {

/// T -= L U, two columns at a time.
void subtract_product(const Block6& L, const Block6& U, Block6& T) {
  const double *l = L.data(), *u = U.data();
  for (int c = 0; c < 6; c += 2) {
    double* target = T.data() + c;
    const TwoDoubles u0 = two_of(u + c), u1 = two_of(u + 6 + c), u2 = two_of(u + 12 + c),
                     u3 = two_of(u + 18 + c), u4 = two_of(u + 24 + c), u5 = two_of(u + 30 + c);
    for (int r = 0; r < 36; r += 6) {
      const TwoDoubles product =
          (l[r] * u0 + l[r + 1] * u1) + (l[r + 2] * u2 + l[r + 3] * u3) + (l[r + 4] * u4 + l[r + 5] * u5);
      put_two(two_of(target + r) - product, target + r);
    }
  }
}

}  // namespace

BlockElimination::BlockElimination(const EliminationPattern& pattern, bool is_symmetric)
    : pattern_(pattern),
      is_symmetric_(is_symmetric),
      blocks_(pattern.node_count() + 2 * pattern.pair_count()),
      is_used_(pattern.pair_count()),
      swaps_(pattern.node_count()) {
  restart(is_symmetric);
}

void BlockElimination::restart(bool is_symmetric) {
  is_symmetric_ = is_symmetric;
  for (std::size_t place = 0; place < pattern_.node_count(); ++place) blocks_[place].setZero();
  std::fill(is_used_.begin(), is_used_.end(), false);
  // What nodes are attached to takes over their blocks as they come.
  if (!attachments_.empty()) use_all();
  scales_.clear();
}

void BlockElimination::use_all() {
  for (std::size_t pair = 0; pair < is_used_.size(); ++pair) use(pair);
}

void BlockElimination::add(int row_node, int column_node, const Block6& block) {
  const std::size_t slot = pattern_.slot(row_node, column_node);
  if (is_read(slot))
    this->block(slot) += block;
  else
    this->block(slot - pattern_.pair_count()) += block.transpose();
}

bool BlockElimination::factor(const VecX& scales) {
  scales_.resize(pattern_.node_count());
  for (int node = 0; node < static_cast<int>(scales_.size()); ++node)
    scales_[at(pattern_.place(node))] = scales.segment<6>(6 * node);
  scale();
  return factor();
}

bool BlockElimination::factor() {
  for (std::size_t place = 0; place < pattern_.node_count(); ++place) {
    if (!attachments_.empty() && attachments_[place].is_held) substitute_attachment(place);
    if (!factor_pivot(blocks_[place], swaps_[place])) return false;
    eliminate(place);
  }
  return true;
}

void BlockElimination::scale() {
  Block6* const upper = blocks_.data() + pattern_.node_count();
  Block6* const lower = blocks_.data() + first_lower();
  for (std::size_t place = 0; place < scales_.size(); ++place) {
    const auto S = scales_[place].asDiagonal();
    blocks_[place] = S * blocks_[place] * S;
    for (std::size_t i = pattern_.begin(place); i < pattern_.begin(place + 1); ++i) {
      if (!is_used_[i]) continue;
      const auto S_later = scales_[pattern_.second(i)].asDiagonal();
      upper[i] = S * upper[i] * S_later;
      if (!is_symmetric_) lower[i] = S_later * lower[i] * S;
    }
  }
}

/// Partial pivoting within the block (Golub and Van Loan, Matrix Computations, 2013, algorithm 3.4.1).
bool BlockElimination::factor_pivot(Block6& A, Swaps& swapped) {
#pragma GCC unroll 6
  for (int k = 0; k < 6; ++k) {
    // The largest entry of the column that is left becomes the pivot.
    int largest = k;
    for (int i = k + 1; i < 6; ++i)
      if (std::abs(A(i, k)) > std::abs(A(largest, k))) largest = i;
    swapped[at(k)] = largest;
    if (largest != k) A.row(k).swap(A.row(largest));
    if (!(std::abs(A(k, k)) > 0) || !std::isfinite(A(k, k))) return false;

    // Its row is taken away from those below.
    for (int i = k + 1; i < 6; ++i) {
      const double share = A(i, k) / A(k, k);
      A(i, k) = share;
      for (int c = k + 1; c < 6; ++c) A(i, c) -= share * A(k, c);
    }
  }
  return true;
}

/// X ← A⁻¹ X, two columns at a time.
void BlockElimination::solve_pivot(const Block6& LU, const Swaps& swapped, Block6& X) {
  for (int k = 0; k < 6; ++k)
    if (swapped[at(k)] != k) X.row(k).swap(X.row(swapped[at(k)]));
  for (int c = 0; c < 6; c += 2) {
    TwoDoubles x[6];
    for (int i = 0; i < 6; ++i) x[i] = two_of(X.data() + 6 * i + c);
      // Forward with L, back with U.
#pragma GCC unroll 6
    for (int i = 1; i < 6; ++i)
      for (int k = 0; k < i; ++k) x[i] -= LU(i, k) * x[k];
#pragma GCC unroll 6
    for (int i = 5; i >= 0; --i) {
      for (int k = i + 1; k < 6; ++k) x[i] -= LU(i, k) * x[k];
      x[i] /= LU(i, i);
    }
    for (int i = 0; i < 6; ++i) put_two(x[i], X.data() + 6 * i + c);
  }
}

void BlockElimination::solve_pivot(const Block6& LU, const Swaps& swapped, Vec6& x) {
  for (int k = 0; k < 6; ++k)
    if (swapped[at(k)] != k) std::swap(x(k), x(swapped[at(k)]));
  for (int i = 1; i < 6; ++i)
    for (int k = 0; k < i; ++k) x(i) -= LU(i, k) * x(k);
  for (int i = 5; i >= 0; --i) {
    for (int k = i + 1; k < 6; ++k) x(i) -= LU(i, k) * x(k);
    x(i) /= LU(i, i);
  }
}

void BlockElimination::attach(int node, const NodeAttachment& attachment) {
  attachments_.resize(pattern_.node_count());
  use_all();
  const std::size_t place = at(pattern_.place(node));
  PlaceAttachment& held = attachments_[place];
  held = {true, place, {}, attachment.V, attachment.T};
  if (!attachment.parent) return;
  held.parent = at(pattern_.place(*attachment.parent));
  for (std::size_t i = pattern_.begin(place); i < pattern_.begin(place + 1); ++i) {
    const std::size_t other = pattern_.second(i);
    if (other == held.parent) continue;
    const auto [first, second] = std::minmax(other, held.parent);
    held.rows.push_back(pattern_.pair(static_cast<int>(first), static_cast<int>(second)));
  }
}

/// The equations and unknowns of the place become those of its y; what T takes of them goes to its parent.
void BlockElimination::substitute_attachment(std::size_t place) {
  const PlaceAttachment& attachment = attachments_[place];
  Block6* const upper = blocks_.data() + pattern_.node_count();
  Block6* const lower = blocks_.data() + first_lower();
  if (hangs_on_node(place)) move_to_parent(place);
  Block6& own = blocks_[place];
  own = Block6(attachment.V.transpose().lazyProduct(Block6(own.lazyProduct(attachment.V))));
  // Columns of V that are zero stand for unknowns that are not there: y = 0.
  for (int k = 0; k < 6; ++k)
    if (attachment.V.col(k).isZero(0)) own(k, k) = 1;
  for (std::size_t i = pattern_.begin(place); i < pattern_.begin(place + 1); ++i) {
    upper[i] = Block6(attachment.V.transpose().lazyProduct(upper[i]));
    lower[i] = Block6(lower[i].lazyProduct(attachment.V));
  }
}

/// With x = V y + T x_p for place c: A_pp += Tᵀ A_cc T + Tᵀ A_cp + A_pc T, for other places k A_pk += Tᵀ A_ck
/// and A_kp += A_kc T, and A_cp and A_pc become A_cp + A_cc T and A_pc + Tᵀ A_cc.
void BlockElimination::move_to_parent(std::size_t place) {
  const PlaceAttachment& attachment = attachments_[place];
  Block6* const upper = blocks_.data() + pattern_.node_count();
  Block6* const lower = blocks_.data() + first_lower();
  const Block6& own = blocks_[place];
  const Block6 T_T = attachment.T.transpose();
  auto row = attachment.rows.begin();
  for (std::size_t i = pattern_.begin(place); i < pattern_.begin(place + 1); ++i) {
    const std::size_t other = pattern_.second(i);
    if (other == attachment.parent) {
      Block6& of_parent = blocks_[attachment.parent];
      of_parent += T_T.lazyProduct(upper[i]);
      upper[i] += own.lazyProduct(attachment.T);
      lower[i] += T_T.lazyProduct(own);
      // (A_pc + Tᵀ A_cc) T has the two terms that are left.
      of_parent += lower[i].lazyProduct(attachment.T);
      continue;
    }
    const bool is_after = other > attachment.parent;
    (is_after ? upper : lower)[*row] += T_T.lazyProduct(upper[i]);
    (is_after ? lower : upper)[*row] += lower[i].lazyProduct(attachment.T);
    ++row;
  }
}

// A_ik ← A_ik - A_ip A_pp⁻¹ A_pk for all later i and k.
void BlockElimination::eliminate(std::size_t place) {
  Block6* const upper = blocks_.data() + pattern_.node_count();
  Block6* const lower = blocks_.data() + first_lower();
  const std::size_t begin = pattern_.begin(place), end = pattern_.begin(place + 1), count = end - begin;
  count_work((1 + count) * (1 + count));
  later_used_.clear();
  for (std::size_t i = begin; i < end; ++i) {
    if (!is_used_[i]) continue;
    later_used_.push_back(i);
    if (is_symmetric_) lower[i] = upper[i].transpose();
    solve_pivot(blocks_[place], swaps_[place], upper[i]);
  }
  for (auto i = later_used_.begin(); i != later_used_.end(); ++i) {
    subtract_product(lower[*i], upper[*i], blocks_[pattern_.second(*i)]);
    // Of the pairs that the place changes, those of its i-th later place.
    const std::size_t before = *i - begin;
    const std::size_t* changed = pattern_.changed(place) + before * (2 * count - before - 1) / 2;
    for (auto k = i + 1; k != later_used_.end(); ++k) {
      const std::size_t target = changed[*k - *i - 1];
      use(target);
      subtract_product(lower[*i], upper[*k], upper[target]);
      if (!is_symmetric_) subtract_product(lower[*k], upper[*i], lower[target]);
    }
  }
}

void BlockElimination::solve(const VecX& c, VecX& solution) const {
  const int nodes = static_cast<int>(pattern_.node_count());
  const Block6* const upper = blocks_.data() + pattern_.node_count();
  const Block6* const lower = blocks_.data() + first_lower();
  std::vector<Vec6>& x = x_;
  x.resize(pattern_.node_count());
  for (int node = 0; node < nodes; ++node) x[at(pattern_.place(node))] = c.segment<6>(6 * node);
  for (std::size_t place = 0; place < scales_.size(); ++place)
    x[place] = scales_[place].cwiseProduct(x[place]);

  // Forward with L, back with U.
  for (std::size_t place = 0; place < x.size(); ++place) {
    if (!attachments_.empty() && attachments_[place].is_held) {
      if (hangs_on_node(place)) x[attachments_[place].parent] += attachments_[place].T.transpose() * x[place];
      x[place] = Vec6(attachments_[place].V.transpose() * x[place]);
    }
    solve_pivot(blocks_[place], swaps_[place], x[place]);
    for (std::size_t i = pattern_.begin(place); i < pattern_.begin(place + 1); ++i)
      if (is_used_[i]) x[pattern_.second(i)].noalias() -= lower[i] * x[place];
  }
  for (std::size_t place = x.size(); place-- > 0;) {
    for (std::size_t i = pattern_.begin(place); i < pattern_.begin(place + 1); ++i)
      if (is_used_[i]) x[place].noalias() -= upper[i] * x[pattern_.second(i)];
    if (attachments_.empty() || !attachments_[place].is_held) continue;
    x[place] = Vec6(attachments_[place].V * x[place]);
    if (hangs_on_node(place)) x[place] += attachments_[place].T * x[attachments_[place].parent];
  }

  for (std::size_t place = 0; place < scales_.size(); ++place)
    x[place] = scales_[place].cwiseProduct(x[place]);
  solution.resize(c.size());
  for (int node = 0; node < nodes; ++node) solution.segment<6>(6 * node) = x[at(pattern_.place(node))];
}

}  // namespace rigor
