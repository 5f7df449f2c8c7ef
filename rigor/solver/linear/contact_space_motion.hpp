#pragma once

#include "rigor/solver/linear/block_elimination.hpp"
#include "rigor/solver/linear/contact_motion.hpp"

#include <cstddef>
#include <vector>

namespace rigor {

/// Whether at most half of the 3 × 3 blocks of A are other than zero.
bool has_few_blocks(const MatX& A);

/// Of a matrix A most of whose 3 × 3 blocks are zero: the motion of a contact is its force by its effective
/// mass m, so that M = m, L = A m, and the forces stand for Lᵀ λ. The matrix of a Newton step is then
/// (1 + D A) m, which has as few blocks as A, whatever D. It is eliminated with pivots within the blocks of
/// pairs of contacts: for symmetric D, positive semidefinite as A, that is stable; for the D of slides, which
/// are not symmetric, it has proved to be (a test holds it against dense algebra).
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
  /// NaN where the elimination met a pivot that is zero.
  void solve(const VecX& g, VecX& v) const override;

 private:
  /// `near`: the contacts that A couples with each.
  ContactSpaceMotion(const MatX& A, const std::vector<std::vector<int>>& near);

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
  mutable bool is_regular_ = true;
  mutable VecX padded_, solution_;
};

}  // namespace rigor
