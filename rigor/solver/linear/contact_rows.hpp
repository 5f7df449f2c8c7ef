#pragma once

#include "rigor/solver/linear/constrained_mass.hpp"

#include <array>
#include <functional>
#include <memory>
#include <vector>

namespace rigor {

/// How contacts hang on bodies: the sparse J and M of A = J M⁻¹ Jᵀ, which is not formed. A node is a body
/// with six velocities (v, ω); contact i has the rows 3i, 3i+1 (tangents), 3i+2 (normal), each with at most
/// three nodes: two bodies, and one for what is no body (a load that does not depend on them). Velocities and
/// wrenches of all nodes are stacked, six numbers a node.
///
/// Joints are equations G V = 0 that hold throughout: with them M⁻¹ in A is M⁻¹ - M⁻¹ Gᵀ (G M⁻¹ Gᵀ)⁺ G M⁻¹.
struct ContactRows {
  /// By rows: forces are pulled back to wrenches a whole row at a time.
  using Block = Eigen::Matrix<double, 3, 6, Eigen::RowMajor>;
  /// One body of a contact. Bodies that do not give way (node -1) have no part in J.
  struct Side {
    int node = -1;
    Block J = Block::Zero();
  };
  std::vector<Mat6> masses;          ///< One a node, symmetric positive definite.
  std::vector<Mat6> inverse_masses;  ///< Their inverses.
  using Sides = std::array<Side, 3>;
  std::vector<Sides> contacts;
  std::shared_ptr<const ConstrainedMass> joints;  ///< Factored with these masses; none if no node is held.
  std::vector<int> joint_nodes;                   ///< The node of each node of `joints`.
  /// Columns N: a base of the motions of the joint nodes (6 rows each) that the joints allow, with G N = 0
  /// and Nᵀ M N = 1. Empty where these nodes are many or no joints close loops: then their equations are
  /// worked with.
  MatX held_motions;

  std::size_t node_count() const { return masses.size(); }
  bool has_held_motions() const { return held_motions.rows() > 0; }
};

/// Gives the rows these joints on these of its nodes, factored with their masses.
void constrain_nodes(std::shared_ptr<const ConstrainedMass> joints, std::vector<int> nodes,
                     ContactRows& rows);

/// Whether springs that are stiff for one body are so for all: no mass is a thousand times another one. Under
/// a body of a million times its mass those of a light one give way.
bool are_masses_alike(const ContactRows& rows);

/// J V (3n).
VecX contact_rates(const ContactRows& rows, const VecX& V);
void contact_rates(const ContactRows& rows, const VecX& V, VecX& rates);
/// Jᵀ λ (6 × nodes).
VecX contact_wrenches(const ContactRows& rows, const VecX& lambda);
void contact_wrenches(const ContactRows& rows, const VecX& lambda, VecX& wrenches);
/// Calls add(row, node, coefficients) for all coefficients of the joints' independent rows (those that
/// ConstrainedMass has chosen), numbered from 0; returns the number of rows.
Eigen::Index for_each_joint_row(const ContactRows& rows,
                                const std::function<void(Eigen::Index, int, const Vec6&)>& add);
/// p + Gᵀ ν with G M⁻¹ (p + Gᵀ ν) = 0: wrenches with what the joints do about them (6 × nodes).
VecX with_joints(const ContactRows& rows, const VecX& p);
/// M⁻¹ p and M V (6 × nodes).
VecX node_accelerations(const ContactRows& rows, const VecX& p);
void node_accelerations(const ContactRows& rows, const VecX& p, VecX& a);
VecX node_wrenches(const ContactRows& rows, const VecX& V);
void node_wrenches(const ContactRows& rows, const VecX& V, VecX& p);

/// A (3n × 3n), formed.
MatX contact_response(const ContactRows& rows);
/// Diagonal of A (3n).
VecX contact_diagonal(const ContactRows& rows);
/// That of J M⁻¹ Jᵀ, as if there were no joints: at least as large.
VecX free_diagonal(const ContactRows& rows);
/// The largest of |J| |M⁻¹| |Jᵀ| |λ|: of the sizes of the terms that A λ is summed from, but for those of
/// joints.
double largest_term(const ContactRows& rows, const VecX& lambda);

}  // namespace rigor
