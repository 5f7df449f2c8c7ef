#include "rigor/solver/linear/block_elimination.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

/// The place of each node in an order of little fill.
std::vector<int> places_of_little_fill(std::size_t nodes, const std::vector<std::pair<int, int>>& pairs) {
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

  std::vector<int> places(nodes);
  for (int place = 0; place < static_cast<int>(nodes); ++place) places[at(order.indices()(place))] = place;
  return places;
}

}  // namespace

EliminationPattern::EliminationPattern(std::size_t nodes, const std::vector<std::pair<int, int>>& pairs)
    : place_(places_of_little_fill(nodes, pairs)), begin_(nodes + 1, 0), first_changed_(nodes, 0) {
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

BlockFactors::BlockFactors(const Block6& A) : LU_(A) {
  for (int k = 0; k < 6; ++k) {
    // The largest entry of the column that is left becomes the pivot.
    int pivot = k;
    for (int i = k + 1; i < 6; ++i)
      if (std::abs(LU_(i, k)) > std::abs(LU_(pivot, k))) pivot = i;
    swapped_[at(k)] = pivot;
    if (pivot != k) LU_.row(k).swap(LU_.row(pivot));
    is_regular_ = is_regular_ && std::abs(LU_(k, k)) > 0 && std::isfinite(LU_(k, k));

    // Its row is taken away from those below.
    for (int i = k + 1; i < 6; ++i) {
      const double share = LU_(i, k) / LU_(k, k);
      LU_(i, k) = share;
      for (int c = k + 1; c < 6; ++c) LU_(i, c) -= share * LU_(k, c);
    }
  }
}

template <int columns>
void BlockFactors::solve_in_place(
    Eigen::Matrix<double, 6, columns, columns == 1 ? Eigen::ColMajor : Eigen::RowMajor>& X) const {
  // Forward with L, the rows exchanged as the factors' were.
  for (int k = 0; k < 6; ++k)
    if (swapped_[at(k)] != k) X.row(k).swap(X.row(swapped_[at(k)]));
  for (int i = 1; i < 6; ++i)
    for (int k = 0; k < i; ++k) X.row(i) -= LU_(i, k) * X.row(k);

  // Back with U.
  for (int i = 5; i >= 0; --i) {
    for (int k = i + 1; k < 6; ++k) X.row(i) -= LU_(i, k) * X.row(k);
    X.row(i) /= LU_(i, i);
  }
}

BlockElimination::BlockElimination(const EliminationPattern& pattern, bool is_symmetric)
    : pattern_(pattern),
      is_symmetric_(is_symmetric),
      pivots_(pattern.node_count(), Block6::Zero()),
      upper_(pattern.pair_count(), Block6::Zero()),
      lower_(pattern.pair_count(), Block6::Zero()) {}

void BlockElimination::add(int row_node, int column_node, const Block6& block) {
  const int row = pattern_.place(row_node), column = pattern_.place(column_node);
  if (row == column) {
    pivots_[at(row)] += block;
  } else if (row < column) {
    upper_[pattern_.pair(row, column)] += block;
  } else if (is_symmetric_) {
    upper_[pattern_.pair(column, row)] += block.transpose();
  } else {
    lower_[pattern_.pair(column, row)] += block;
  }
}

bool BlockElimination::factor(const VecX& scales) {
  scale(scales);
  factors_.reserve(pattern_.node_count());
  for (std::size_t place = 0; place < pattern_.node_count(); ++place) {
    if (!factors_.emplace_back(pivots_[place]).is_regular()) return false;
    eliminate(place);
  }
  return true;
}

void BlockElimination::scale(const VecX& scales) {
  scales_.resize(pattern_.node_count());
  for (int node = 0; node < static_cast<int>(scales_.size()); ++node)
    scales_[at(pattern_.place(node))] = scales.segment<6>(6 * node);
  for (std::size_t place = 0; place < scales_.size(); ++place) {
    const auto S = scales_[place].asDiagonal();
    pivots_[place] = S * pivots_[place] * S;
    for (std::size_t i = pattern_.begin(place); i < pattern_.begin(place + 1); ++i) {
      const auto S_later = scales_[pattern_.second(i)].asDiagonal();
      upper_[i] = S * upper_[i] * S_later;
      if (!is_symmetric_) lower_[i] = S_later * lower_[i] * S;
    }
  }
}

// A_ik ← A_ik - A_ip A_pp⁻¹ A_pk for all later i and k.
void BlockElimination::eliminate(std::size_t place) {
  const std::size_t begin = pattern_.begin(place), end = pattern_.begin(place + 1);
  for (std::size_t i = begin; i < end; ++i) {
    if (is_symmetric_) lower_[i] = upper_[i].transpose();
    factors_[place].solve_in_place<6>(upper_[i]);
  }
  const std::size_t* changed = pattern_.changed(place);
  for (std::size_t i = begin; i < end; ++i) {
    pivots_[pattern_.second(i)].noalias() -= lower_[i] * upper_[i];
    for (std::size_t k = i + 1; k < end; ++k) {
      const std::size_t target = *changed++;
      upper_[target].noalias() -= lower_[i] * upper_[k];
      if (!is_symmetric_) lower_[target].noalias() -= lower_[k] * upper_[i];
    }
  }
}

VecX BlockElimination::solve(const VecX& c) const {
  const int nodes = static_cast<int>(pattern_.node_count());
  VecX x(c.size());
  for (int node = 0; node < nodes; ++node)
    x.segment<6>(6 * pattern_.place(node)) =
        scales_[at(pattern_.place(node))].cwiseProduct(c.segment<6>(6 * node));
  const auto part = [&x](std::size_t place) { return x.segment<6>(6 * static_cast<Eigen::Index>(place)); };

  // Forward with L, back with U.
  for (std::size_t place = 0; place < pattern_.node_count(); ++place) {
    Vec6 solved = part(place);
    factors_[place].solve_in_place<1>(solved);
    part(place) = solved;
    for (std::size_t i = pattern_.begin(place); i < pattern_.begin(place + 1); ++i)
      part(pattern_.second(i)).noalias() -= lower_[i] * solved;
  }
  for (std::size_t place = pattern_.node_count(); place-- > 0;)
    for (std::size_t i = pattern_.begin(place); i < pattern_.begin(place + 1); ++i)
      part(place).noalias() -= upper_[i] * part(pattern_.second(i));

  VecX solution(c.size());
  for (int node = 0; node < nodes; ++node)
    solution.segment<6>(6 * node) =
        scales_[at(pattern_.place(node))].cwiseProduct(x.segment<6>(6 * pattern_.place(node)));
  return solution;
}

}  // namespace rigor
