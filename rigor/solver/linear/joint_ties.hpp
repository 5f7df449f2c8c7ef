#pragma once

#include "rigor/solver/linear/contact_rows.hpp"

#include <cstddef>
#include <utility>
#include <vector>

namespace rigor {

/// The independent rows of joints (those that ConstrainedMass has chosen) as an elimination of nodes takes
/// them: ties of two nodes, or of one to the ground, that form trees, and rows that close loops.
struct JointTies {
  struct Tie {
    std::vector<int> nodes;      ///< One or two.
    std::vector<Mat6> wrenches;  ///< One a node: a column a row, then zeros.
    int rows = 0;                ///< Six at most.
  };
  /// Coefficients of a row on its nodes.
  using LoopRow = std::vector<std::pair<int, Vec6>>;
  std::vector<Tie> ties;
  std::vector<LoopRow> loop_rows;
};

JointTies joint_ties(const ContactRows& rows);

/// For each node when to eliminate it, so that of the ties of a node that form trees no more than one is left
/// when its turn comes: from the leaves to the roots, of the nodes that may be next the one with the fewest
/// neighbours.
std::vector<int> places_of_tied_nodes(std::size_t nodes, const std::vector<std::pair<int, int>>& pairs,
                                      const std::vector<JointTies::Tie>& ties);

}  // namespace rigor
