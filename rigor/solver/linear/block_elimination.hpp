#pragma once

#include "rigor/math/types.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace rigor {

/// In which order to eliminate nodes that are coupled in pairs, and which blocks are not zero then: found
/// once for a graph, used for all matrices on it. The order is one of minimum degree (Tinney and Walker,
/// Direct Solutions of Sparse Network Equations, Proc. IEEE 55, 1967), of more than 32 nodes of approximate
/// minimum degree (Amestoy, Davis and Duff, An Approximate Minimum Degree Ordering Algorithm, 1996), by
/// Eigen.
class EliminationPattern {
 public:
  /// Pairs of different nodes below `nodes`, in any order, as often as they occur.
  EliminationPattern(std::size_t nodes, const std::vector<std::pair<int, int>>& pairs);
  /// The same in another order: the place of each node.
  EliminationPattern(std::vector<int> places, const std::vector<std::pair<int, int>>& pairs);

  std::size_t node_count() const { return place_.size(); }
  std::size_t pair_count() const { return later_.size(); }
  /// When a node is eliminated: 0 is first.
  int place(int node) const { return place_[static_cast<std::size_t>(node)]; }
  /// Number of the pair of two places, the first of which is eliminated before the second.
  std::size_t pair(int first, int second) const;
  /// Where the block of these nodes stands in an elimination: the pivots by place, then the blocks above the
  /// diagonal by pair, then those below it.
  std::size_t slot(int row_node, int column_node) const;
  /// The pairs of a place with those after it are begin(place) ≤ pair < begin(place + 1), with these second
  /// places, in increasing order.
  std::size_t begin(std::size_t place) const { return begin_[place]; }
  std::size_t second(std::size_t pair) const { return later_[pair]; }
  /// Pairs that the elimination of a place changes: those of its later places i < k, in the order
  /// (i₀, i₁), (i₀, i₂), …, (i₁, i₂), …
  const std::size_t* changed(std::size_t place) const { return changed_.data() + first_changed_[place]; }

 private:
  std::vector<int> place_;
  std::vector<std::size_t> begin_, later_, first_changed_, changed_;
};

/// A 6 × 6 block by rows: what elimination does to it, it does to whole rows.
using Block6 = Eigen::Matrix<double, 6, 6, Eigen::RowMajor>;

/// How a node hangs on another one that is eliminated later, or on the ground: of its unknowns x = V y + T
/// x_parent only y (as many as V has columns that are not zero, the first ones) are free.
struct NodeAttachment {
  std::optional<int> parent;  ///< A node that is paired with it; none: the ground.
  Block6 V = Block6::Zero(), T = Block6::Zero();
};

/// Gaussian elimination of a matrix of 6 × 6 blocks, a block wherever two nodes are coupled, with
/// pivots within each node's own block. That is stable for matrices whose symmetric part is positive
/// definite, such as masses with contacts that give way; of others `is_regular` tells whether the pivots
/// were nonzero, and the caller refines. One elimination serves many matrices, one after the other.
///
/// Where nodes hang on others, of the x that this allows the one is found that solves A x = c but for what
/// holds the nodes: Wᵀ A W y = Wᵀ c, x = W y, with the base W of what is allowed. W is not formed. A node's
/// x = V y + T x_parent is put into the matrix when its turn comes, which adds no block to those that its
/// elimination has anyway.
class BlockElimination {
 public:
  /// Holds a reference to the pattern. All blocks are zero.
  BlockElimination(const EliminationPattern& pattern, bool is_symmetric);

  /// Holds a node in all matrices from now on; none of them is to be symmetric.
  void attach(int node, const NodeAttachment& attachment);
  /// Begins with another matrix: all blocks are zero again.
  void restart(bool is_symmetric);
  /// Adds to the block of these nodes; of symmetric matrices only one of (row, column), (column, row) for
  /// different nodes, whichever.
  void add(int row_node, int column_node, const Block6& block);
  /// The block at a slot of the pattern, to add to; of symmetric matrices not those below the diagonal.
  Block6& block(std::size_t slot) {
    if (slot >= pattern_.node_count()) use(pair_of(slot));
    return blocks_[slot];
  }
  /// Whether a slot is above the diagonal or on it, or the matrix is not symmetric.
  bool is_read(std::size_t slot) const { return !is_symmetric_ || slot < first_lower(); }

  /// Factors the matrix A as it is, whose unknowns compare like units. Whether all pivots were nonzero and
  /// finite.
  bool factor();
  /// Factors S A S with the diagonal S, one number an unknown, such that the pivots of a node compare like
  /// units.
  bool factor(const VecX& scales);
  /// A⁻¹ c (6 × nodes), after `factor`.
  void solve(const VecX& c, VecX& x) const;
  VecX solve(const VecX& c) const {
    VecX x;
    solve(c, x);
    return x;
  }

 private:
  /// With which row each row of a pivot P A = L U was exchanged; L, without its ones, and U stand in its
  /// block.
  using Swaps = std::array<int, 6>;
  std::size_t first_lower() const { return pattern_.node_count() + pattern_.pair_count(); }
  std::size_t pair_of(std::size_t slot) const {
    return slot < first_lower() ? slot - pattern_.node_count() : slot - first_lower();
  }
  /// The blocks of the pair may be other than zero from now on.
  void use(std::size_t pair) {
    if (is_used_[pair]) return;
    is_used_[pair] = true;
    blocks_[pattern_.node_count() + pair].setZero();
    if (!is_symmetric_) blocks_[first_lower() + pair].setZero();
  }
  void use_all();
  static bool factor_pivot(Block6& A, Swaps& swapped);
  static void solve_pivot(const Block6& LU, const Swaps& swapped, Block6& X);
  static void solve_pivot(const Block6& LU, const Swaps& swapped, Vec6& x);
  /// A hold by places.
  struct PlaceAttachment {
    bool is_held = false;
    std::size_t parent = 0;         ///< Place; its own: the ground.
    std::vector<std::size_t> rows;  ///< Pairs of the parent with the other later places, in their order.
    Block6 V, T;
  };
  bool hangs_on_node(std::size_t place) const { return attachments_[place].parent != place; }
  void scale();
  void substitute_attachment(std::size_t place);
  void move_to_parent(std::size_t place);
  void eliminate(std::size_t place);

  const EliminationPattern& pattern_;
  bool is_symmetric_;
  std::vector<Vec6> scales_;  ///< One a place; none: 1.
  std::vector<Block6> blocks_;  ///< By slot. Above the diagonal A_pk, once p is eliminated A_pp⁻¹ A_pk; below
                                ///< it A_kp, of symmetric matrices from when p is eliminated.
  /// By pair: whether its blocks may be other than zero. Of heaps half of the contacts are open, and what
  /// would be done to zeros is left out.
  std::vector<char> is_used_;
  std::vector<Swaps> swaps_;                  ///< By place.
  std::vector<PlaceAttachment> attachments_;  ///< By place; none: no node is held.
  mutable std::vector<Vec6> x_;               ///< By place: scratch,
  std::vector<std::size_t> later_used_;       ///< and pairs.
};

}  // namespace rigor
