#include "rigor/solver/linear/contact_space_motion.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace rigor {

using Eigen::Index;

namespace {

Mat3 block_of(const MatX& A, int row, int column) {
  return A.block<3, 3>(3 * row, 3 * column);
}

/// Contacts that A couples with each.
std::vector<std::vector<int>> neighbours(const MatX& A) {
  const int count = static_cast<int>(A.rows() / 3);
  std::vector<std::vector<int>> result(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
    for (int k = 0; k < count; ++k)
      if (i != k && !(block_of(A, i, k).isZero(0) && block_of(A, k, i).isZero(0)))
        result[static_cast<std::size_t>(i)].push_back(k);
  return result;
}

/// Contacts in pairs, the halves of nodes: each with one that it is coupled with, rather with one whose
/// neighbours are as many (of the same two bodies), else alone.
std::vector<int> halves(const std::vector<std::vector<int>>& near) {
  std::vector<int> result(near.size(), -1);
  int node = 0;
  for (std::size_t i = 0; i < near.size(); ++i) {
    if (result[i] >= 0) continue;
    int partner = -1;
    for (const int k : near[i]) {
      if (result[static_cast<std::size_t>(k)] >= 0) continue;
      const bool is_alike = near[static_cast<std::size_t>(k)].size() == near[i].size();
      if (partner < 0 || is_alike) partner = k;
      if (is_alike) break;
    }
    result[i] = 2 * node;
    if (partner >= 0) result[static_cast<std::size_t>(partner)] = 2 * node + 1;
    ++node;
  }
  return result;
}

EliminationPattern pattern_of(const std::vector<std::vector<int>>& near, const std::vector<int>& half) {
  int nodes = 0;
  std::vector<std::pair<int, int>> pairs;
  for (std::size_t i = 0; i < near.size(); ++i) {
    nodes = std::max(nodes, half[i] / 2 + 1);
    for (const int k : near[i])
      if (half[i] / 2 < half[static_cast<std::size_t>(k)] / 2)
        pairs.emplace_back(half[i] / 2, half[static_cast<std::size_t>(k)] / 2);
  }
  return {static_cast<std::size_t>(nodes), pairs};
}

VecX masses_of_rows(const VecX& diagonal) {
  const VecX masses = effective_masses(diagonal);
  VecX result(diagonal.size());
  for (Index i = 0; i < masses.size(); ++i) result.segment<3>(3 * i).setConstant(masses(i));
  return result;
}

}  // namespace

bool has_few_blocks(const MatX& A) {
  const std::vector<std::vector<int>> near = neighbours(A);
  std::size_t couples = 0;
  for (const std::vector<int>& each : near) couples += each.size();
  return 2 * couples <= near.size() * near.size();
}

ContactSpaceMotion::ContactSpaceMotion(const MatX& A) : ContactSpaceMotion(A, neighbours(A)) {}

ContactSpaceMotion::ContactSpaceMotion(const MatX& A, const std::vector<std::vector<int>>& near)
    : diagonal_(A.diagonal()),
      masses_(masses_of_rows(diagonal_)),
      half_(halves(near)),
      pattern_(pattern_of(near, half_)),
      matrix_(pattern_, false) {
  const int count = static_cast<int>(half_.size());
  for (int row = 0; row < count; ++row) {
    for (int column = 0; column < count; ++column) {
      const Mat3 A_rc = block_of(A, row, column);
      if (row != column && A_rc.isZero(0)) continue;
      const int r = half_[static_cast<std::size_t>(row)], c = half_[static_cast<std::size_t>(column)];
      blocks_.push_back({row, column, pattern_.slot(r / 2, c / 2), 3 * (r % 2), 3 * (c % 2), A_rc});
    }
  }
}

double ContactSpaceMotion::work() const {
  double work = 0;
  for (std::size_t place = 0; place < pattern_.node_count(); ++place) {
    const auto later = static_cast<double>(pattern_.begin(place + 1) - pattern_.begin(place));
    work += 216 * (1 + later) * (1 + later);
  }
  return work;
}

void ContactSpaceMotion::rates(const VecX& v, VecX& w) const {
  w.setZero(v.size());
  for (const Block& block : blocks_) {
    const Index column = 3 * block.column;
    w.segment<3>(3 * block.row).noalias() += block.A * (masses_(column) * v.segment<3>(column));
  }
}

void ContactSpaceMotion::factor(const std::vector<Mat3>& D, Symmetry) const {
  // 1, also where a node has one contact alone, and D A.
  matrix_.restart(false);
  for (std::size_t node = 0; node < pattern_.node_count(); ++node)
    matrix_.block(pattern_.slot(static_cast<int>(node), static_cast<int>(node))).setIdentity();
  for (const Block& block : blocks_) {
    // An open contact gives nothing back.
    const Mat3& D_row = D[static_cast<std::size_t>(block.row)];
    if (!D_row.isZero(0))
      matrix_.block(block.slot).block<3, 3>(block.i, block.k).noalias() += D_row * block.A;
  }
  is_regular_ = matrix_.factor();
}

void ContactSpaceMotion::solve(const VecX& g, VecX& v) const {
  if (!is_regular_) {
    v.setConstant(g.size(), std::numeric_limits<double>::quiet_NaN());
    return;
  }
  padded_.setZero(6 * static_cast<Index>(pattern_.node_count()));
  for (std::size_t i = 0; i < half_.size(); ++i)
    padded_.segment<3>(3 * half_[i]) = g.segment<3>(3 * static_cast<Index>(i));
  matrix_.solve(padded_, solution_);
  v.resize(g.size());
  for (std::size_t i = 0; i < half_.size(); ++i) {
    const Index row = 3 * static_cast<Index>(i);
    v.segment<3>(row) = solution_.segment<3>(3 * half_[i]) / masses_(row);
  }
}

}  // namespace rigor
