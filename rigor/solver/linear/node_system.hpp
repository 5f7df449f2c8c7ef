#pragma once

#include "rigor/solver/linear/elimination_plan.hpp"

#include <memory>
#include <vector>

namespace rigor {

/// Linear systems over nodes of six unknowns, with a block wherever two nodes share a contact:
///
///   (ε M + Σ_i J_iᵀ D_i J_i) x = c
///
/// and, where joints hold nodes, the x that they allow (G x = 0) which solves this but for a reaction Gᵀ ν.
///
/// The matrix is eliminated block by block in an order of little fill, in a time that grows about in
/// proportion to the nodes in stacks, rows and trees of joints (JointedMatrix). Where joints are not ties of
/// such trees, or close loops, it is solved on the base of the motions that they allow if the rows have
/// one, else with the joints' independent rows (those that ConstrainedMass has chosen) as a border of the
/// matrix: a few nodes densely, more by a sparse factorisation.
class NodeSystem {
 public:
  /// One 3 × 3 matrix D per contact. Symmetric: all D are, and are positive semidefinite. Holds references
  /// to the rows and to the plan, which is that of the rows and serves all systems of them.
  NodeSystem(const ContactRows& rows, const EliminationPlan& plan, const std::vector<Mat3>& D,
             double mass_factor, bool is_symmetric);
  NodeSystem(NodeSystem&& other) noexcept;
  ~NodeSystem();

  bool is_regular() const { return is_regular_; }
  VecX solve(const VecX& c) const;

 private:
  bool factor_blocks(const EliminationPlan& plan, const std::vector<Mat3>& D, double mass_factor,
                     bool is_symmetric);
  struct Factors;  ///< Of the matrix: kept apart, since Eigen's sparse templates take long to compile.
  void factor_on_motions(const std::vector<Mat3>& D, double mass_factor, bool is_symmetric);
  void find_places();

  const ContactRows& rows_;
  const VecX& scales_;  ///< Of the nodes' unknowns.
  bool is_regular_ = true;
  /// First unknown of each node if there is a base of held motions; of held nodes their first row in it.
  std::vector<Eigen::Index> places_;
  std::vector<bool> is_held_;
  Eigen::Index free_ = 0;  ///< Unknowns of nodes that are not held; those of the base follow.
  Eigen::Index size_ = 0;  ///< Unknowns, with the rows of joints if they border the matrix.
  std::unique_ptr<Factors> factors_;
};

}  // namespace rigor
