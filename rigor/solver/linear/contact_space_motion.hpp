#pragma once

#include "rigor/solver/linear/block_elimination.hpp"
#include "rigor/solver/linear/contact_motion.hpp"

#include <cstddef>
#include <vector>

namespace rigor {

/// Of a matrix A most of whose 3 × 3 blocks are zero: the motion of a contact is its force by its effective
/// mass m, so that M = m, L = A m, and the forces stand for Lᵀ λ. The matrix of a Newton step is then
/// (1 + D A) m, which has as few blocks as A, and D times the sum of positive semidefinite D⁻¹ and A: its
/// elimination needs no pivots outside of its diagonal blocks.
class ContactSpaceMotion : public ContactMotion {
 public:
  explicit ContactSpaceMotion(const MatX& A);
  ContactSpaceMotion(const ContactSpaceMotion&) = delete;
  ContactSpaceMotion& operator=(const ContactSpaceMotion&) = delete;
  using ContactMotion::apply_inverse_mass, ContactMotion::apply_transpose, ContactMotion::rates,
      ContactMotion::apply_mass, ContactMotion::solve;
  /// Multiplications of one factorisation.
  double work() const;
  void rates(const VecX& v, VecX& w) const override;
  void apply_transpose(const VecX& lambda, VecX& p) const override { p = lambda; }
  void apply_mass(const VecX& v, VecX& p) const override { p = masses_.cwiseProduct(v); }
  void apply_inverse_mass(const VecX& p, VecX& v) const override { v = p.cwiseQuotient(masses_); }
  const VecX& diagonal() const override { return diagonal_; }
  void factor(const std::vector<Mat3>& D, Symmetry symmetry) const override;
  void solve(const VecX& g, VecX& v) const override;

 private:
  /// A block of A that is not zero.
  struct Block {
    int row, column;   ///< Contacts.
    std::size_t slot;  ///< Of the elimination, whose nodes are pairs of contacts,
    int i, k;          ///< and where the block begins in there.
    Mat3 A;
  };

  VecX diagonal_;
  VecX masses_;            ///< 3n.
  std::vector<int> half_;  ///< By contact: 2 × its node, and 1 more for the second of the node.
  EliminationPattern pattern_;
  std::vector<Block> blocks_;
  mutable BlockElimination matrix_;
  mutable VecX padded_, solution_;
};

}  // namespace rigor
