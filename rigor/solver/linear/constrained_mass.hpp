#pragma once

#include "rigor/core/index.hpp"
#include "rigor/math/types.hpp"
#include "rigor/solver/linear/pivoted_cholesky.hpp"
#include "rigor/solver/linear/spanning_forest.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace rigor {

/// Solves
///
///   M a = f + Gᵀ λ,   G a = c
///
/// for nodes with masses M (6 × 6 blocks, symmetric positive definite) under the equations of links. Links of
/// one or two nodes that form no loop are eliminated along their trees, from the leaves to the roots, in time
/// linear in the number of nodes; those that close loops make a dense system in which rows that follow from
/// the others are found and left out (their λ are zero, their c are not looked at). Derivation:
/// docs/theory/constrained_mass.md. Source: Baraff, Linear-Time Dynamics using Lagrange Multipliers, SIGGRAPH
/// 1996, for the order of elimination.
class ConstrainedMass {
 public:
  /// The rows that are left out, ascending: those that follow from others, and those that vanish
  /// (coefficients of at most 1e-12 of the largest in their link). To be used again where the same rows must
  /// count: off the manifold of the constraints, rows that followed from others contradict them.
  using RowChoice = std::vector<Eigen::Index>;

  explicit ConstrainedMass(ConstraintGraph graph);

  /// masses: one a node. rows: one block for each node of each link, in the graph's order; of each the rows
  /// of its link are looked at. Without a choice the independent rows are found here; with one, its rows are
  /// left out and all others count, as far as rounding can tell them apart. What is factored already is not
  /// factored again: many questions are asked about one configuration.
  void factor(std::span<const Mat6> masses, std::span<const Mat6> rows, const RowChoice* choice = nullptr);
  /// The next configuration is factored, also if it is the last one.
  void forget() { is_factored_ = false; }
  const RowChoice& choice() const { return choice_; }

  struct Solution {
    VecX a;       ///< 6 × nodes.
    VecX lambda;  ///< All links' rows, in their order.
  };
  /// f: 6 × nodes; c: one a row.
  Solution solve(const VecX& f, const VecX& c) const;
  /// The a for c = 0 and each column f of F (6 nodes × k). Blocks of zeros in a column cost little.
  MatX solve(const MatX& F) const;
  /// Columns N: a base of the motions that the links allow (6 nodes × their number), G N = 0 and Nᵀ M N = 1.
  MatX motions() const;

  /// For each node the response a of its own velocities to its own forces: its block of the matrix that
  /// `solve` multiplies with. Empty where rows close loops.
  std::vector<Mat6> own_responses() const;

  const ConstraintGraph& graph() const { return graph_; }
  const SpanningForest& forest() const { return forest_; }
  /// Coefficients of a link's rows on the k-th of its nodes; unused rows are 0.
  Mat6 block(int link, std::size_t k) const { return wrenches(link, k).transpose(); }
  int row_count() const { return row_count_; }
  /// First row of a link.
  int first_row(int link) const { return first_rows_[at(link)]; }
  /// How many 6 × 6 blocks the factors have: the work of factor() and solve() but for the dense system.
  std::size_t block_count() const;

 private:
  using ActiveRows = std::array<bool, 6>;
  /// One step of the elimination along a tree: a node and its link towards the root. Blocks of rows are kept
  /// transposed, one column of six numbers a row of the link.
  struct Pivot {
    Mat6 K_Y;  ///< K_Yᵀ K_Y = Y⁻¹, Y the node's mass with all that hangs on it; lower triangular.
    Mat6 K_D;  ///< K_Dᵀ K_D = D⁻¹, D = J Y⁻¹ Jᵀ of the link's rows on the node; 0 at rows that do not count.
    Mat6 W_T;                 ///< K_Y Jᵀ K_Dᵀ: orthonormal columns.
    Mat6 Z_T = Mat6::Zero();  ///< Jᵀ K_Dᵀ of the link's rows on the parent.
    int rows = 0;             ///< Of the link.
  };
  /// Rows of a link that are no pivots of a tree, eliminated along the ways to the roots.
  struct Loop {
    int link = 0;
    ActiveRows active{};
    std::vector<SpanningForest::PathNode> path;
    std::vector<Mat6> U;  ///< One a place of the path: K_Y times what the rows' wrenches become there.
    std::vector<Mat6> P;  ///< U without what the tree's links hold.
    Vec6 sizes;           ///< Of each row: Σ J D⁻¹ Jᵀ of its nodes.
    std::array<Eigen::Index, 6> dense{};  ///< Its rows in the dense system; -1 if not active.
  };

  /// Takes the input over; whether it is another one than before.
  bool copy_input(std::span<const Mat6> masses, std::span<const Mat6> rows);
  /// Whether this choice leads to the factors that there are.
  bool is_same_choice(const RowChoice* choice) const;
  void set_active_rows(const RowChoice* choice);
  void factor_trees();
  void factor_link(const SpanningForest::Node& node, Pivot& pivot);
  void add_loop(int link);
  void eliminate(Loop& loop) const;
  Eigen::Index number_dense_rows();
  void factor_dense(double threshold);
  std::uint64_t operations() const;

  MatX motions_of_trees() const;
  /// Coefficients of the dense system's rows on these velocities.
  MatX loop_rates(const MatX& velocities) const;

  Solution solve_once(const VecX& f, const VecX& c) const;
  /// Takes M a - Gᵀ λ from f and G a from c.
  void subtract_product(const Solution& x, VecX& f, VecX& c) const;
  void eliminate(Eigen::Ref<VecX> a, Eigen::Ref<VecX> lambda, const VecX* c) const;
  VecX close_loops(Eigen::Ref<VecX> a, Eigen::Ref<VecX> lambda, const VecX* c) const;
  void substitute(Eigen::Ref<VecX> a, Eigen::Ref<VecX> lambda) const;

  /// A link's part of x, one number a row, and zeros up to 6.
  Vec6 padded(const Eigen::Ref<const VecX>& x, int link) const;
  void store(const Vec6& values, int link, Eigen::Ref<VecX> x) const;
  /// A link's rows on the k-th of its nodes, transposed: a column a row, that of a unit force's wrench.
  const Mat6& wrenches(int link, std::size_t k) const { return blocks_[first_blocks_[at(link)] + k]; }
  std::size_t link_of(const SpanningForest::Node& node) const { return at(node.link); }
  int rows_of(int link) const { return graph_.links[at(link)].rows; }

  ConstraintGraph graph_;
  SpanningForest forest_;
  std::vector<int> first_rows_;
  std::vector<std::size_t> first_blocks_;
  int row_count_ = 0;

  std::vector<Mat6> masses_;
  std::vector<Mat6> blocks_;  ///< Transposed: wrenches().
  bool is_factored_ = false;
  std::optional<RowChoice> asked_choice_;  ///< That the factors were made with.
  std::vector<ActiveRows> active_;         ///< Rows that count, for each link: of the trees' links as pivots.
  std::vector<Pivot> pivots_;              ///< In the order of the forest.
  std::vector<Loop> loops_;  ///< Those of the graph, then those of trees' links that lost their pivot.
  MatX S_;                   ///< Mobility of the loops' active rows under the trees' links: Σ Pᵀ P.
  VecX row_sizes_;           ///< The same without links.
  PivotedCholesky dense_;
  RowChoice choice_;
};

}  // namespace rigor
