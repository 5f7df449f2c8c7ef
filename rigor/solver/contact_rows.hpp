#pragma once

#include "rigor/math/types.hpp"

#include <array>
#include <vector>

namespace rigor {

/// How contacts hang on bodies: the sparse J and M of A = J M⁻¹ Jᵀ, which is not formed. A node is a body
/// with six velocities (v, ω); contact i has the rows 3i, 3i+1 (tangents), 3i+2 (normal), each with at most
/// two nodes. Velocities and wrenches of all nodes are stacked, six numbers a node.
struct ContactRows {
  using Block = Eigen::Matrix<double, 3, 6>;
  /// One body of a contact. Bodies that do not give way (node -1) have no part in J.
  struct Side {
    int node = -1;
    Block J = Block::Zero();
  };
  std::vector<Mat6> masses;          ///< One a node, symmetric positive definite.
  std::vector<Mat6> inverse_masses;  ///< Their inverses.
  std::vector<std::array<Side, 2>> contacts;

  std::size_t node_count() const { return masses.size(); }
};

/// J V (3n).
VecX contact_rates(const ContactRows& rows, const VecX& V);
/// Jᵀ λ (6 × nodes).
VecX contact_wrenches(const ContactRows& rows, const VecX& lambda);
/// M⁻¹ p and M V (6 × nodes).
VecX node_accelerations(const ContactRows& rows, const VecX& p);
VecX node_wrenches(const ContactRows& rows, const VecX& V);

/// Diagonal of A (3n).
VecX contact_diagonal(const ContactRows& rows);
/// |J| |M⁻¹| |Jᵀ| |λ| (3n): the sizes of the terms that A λ is summed from.
VecX term_sizes(const ContactRows& rows, const VecX& lambda);

}  // namespace rigor
