#pragma once

#include "rigor/solver/linear/block_elimination.hpp"
#include "rigor/solver/linear/contact_rows.hpp"

#include <utility>
#include <vector>

namespace rigor {

/// What all eliminations of matrices on the same rows share: the order of the nodes, and how joints hold
/// them. Found once, since the rows of joints need a factorisation each.
struct EliminationPlan {
  EliminationPattern pattern;
  /// A power of two near 1/√mass for each unknown, so that those of translations and rotations have one unit
  /// and scaling with it rounds nothing: pivots compare them.
  VecX scales;
  /// Nodes with what they are attached to, in unknowns that are scaled: x = scales · (unknowns of the
  /// elimination).
  std::vector<std::pair<int, NodeAttachment>> attachments;
  /// Columns: the independent rows that close loops (6 × nodes each).
  MatX loop_rows_T;
  /// Whether each tie of a tree holds a node by itself, and the rows of loops are few.
  bool is_possible = true;
};

/// Which nodes share contacts or ties of joints, in an order that takes trees of joints from their leaves to
/// their roots, and the ties as they hold nodes then.
EliminationPlan elimination_plan(const ContactRows& rows);

}  // namespace rigor
