#pragma once

#include "rigor/math/types.hpp"

#include <span>
#include <vector>

namespace rigor {

/// What joins what: nodes of six velocities each, and links, each some linear equations on the velocities of
/// its nodes. A node may appear once in a link; a link with one node holds it to the ground.
struct ConstraintGraph {
  struct Link {
    int rows = 0;            ///< 1 to 6.
    std::vector<int> nodes;  ///< One or more.
  };
  int node_count = 0;
  std::vector<Link> links;
};

/// Solves
///
///   M a = f + Gᵀ λ,   G a = c
///
/// for nodes with masses M (6 × 6 blocks, symmetric positive definite) under the equations of links. Links of
/// one or two nodes that form no loop are eliminated along their trees, from the leaves to the roots, in time
/// linear in the number of nodes; those that close loops make a dense system in which rows that follow from
/// the others are found and left out (their λ are zero). Sources: Baraff, Linear-Time Dynamics using Lagrange
/// Multipliers, SIGGRAPH 1996, for the order of elimination.
class ConstrainedMass {
 public:
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, 6, Eigen::ColMajor, 6, 6>;
  /// Which rows of the loops count, by pivots; to be used again where the same rows must.
  using RowChoice = std::vector<Eigen::Index>;

  explicit ConstrainedMass(ConstraintGraph graph);

  /// masses: one a node. rows: for each link, one block a node of it, in the graph's order. Without a choice
  /// the independent rows are found here.
  void factor(std::span<const Mat6> masses, std::span<const std::vector<Rows>> rows,
              const RowChoice* choice = nullptr);
  const RowChoice& choice() const { return choice_; }

  struct Solution {
    VecX a;       ///< 6 × nodes.
    VecX lambda;  ///< All links' rows, in their order.
  };
  /// f: 6 × nodes; c: one a row. Several right-hand sides: one a column.
  Solution solve(const VecX& f, const VecX& c) const;

  int row_count() const { return row_count_; }
  /// First row of a link.
  int first_row(int link) const { return first_rows_[static_cast<std::size_t>(link)]; }

 private:
  ConstraintGraph graph_;
  std::vector<int> first_rows_;
  int row_count_ = 0;
  RowChoice choice_;
};

}  // namespace rigor
