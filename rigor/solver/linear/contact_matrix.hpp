#pragma once

#include "rigor/solver/linear/elimination_plan.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace rigor {

/// The matrices ε M + Σ_i J_iᵀ D_i J_i of contacts without joints, for many D on the same rows, as Newton's
/// method has them: what does not depend on D is prepared once, and no step allocates.
///
/// Contacts of one pair of bodies A, B whose force acts on both at one point have J_B = -J_A X with one X
/// that shifts a motion from B to A. Their sum S of J_Aᵀ D J_A is formed once; the four blocks of the pair
/// are S, -S X, -Xᵀ S and Xᵀ S X.
class ContactMatrix {
 public:
  /// Holds references to the plan's pattern and scales, which are those of the rows.
  ContactMatrix(const ContactRows& rows, const EliminationPlan& plan, double mass_factor = 1);

  /// Holds a node in all matrices (BlockElimination::hold), in unknowns that are scaled. None of them is to
  /// be symmetric.
  void attach(int node, const NodeAttachment& attachment) { blocks_.attach(node, attachment); }
  /// Whether all pivots were nonzero and finite.
  bool factor(const std::vector<Mat3>& D, bool is_symmetric);
  /// x with (M + Σ Jᵀ D J) x = c, after `factor`.
  void solve(const VecX& c, VecX& x) const;
  VecX solve(const VecX& c) const {
    VecX x;
    solve(c, x);
    return x;
  }

 private:
  /// A side's rows, by rows, with the unknowns scaled.
  using Rows = Eigen::Matrix<double, 3, 6, Eigen::RowMajor>;
  /// A pair whose contacts see one rigid motion.
  struct Pair {
    int A, B;                ///< Nodes.
    Mat3 arm;                ///< X = [1 arm; 0 1].
    double linear, angular;  ///< Of X between scaled unknowns, diag(linear, angular) and
    Mat3 scaled_arm;         ///< its upper right block.
    std::size_t slot_A, slot_B, slot_AB, slot_BA;
    Block6 sum;
    bool is_used;
  };
  static constexpr int no_pair = -1;

  void add_sides(const ContactRows::Sides& sides);
  int pair_of(const ContactRows::Side& A, const ContactRows::Side& B);
  void add_contact(std::size_t contact, const Mat3& D);
  void add_square(std::size_t contact, const Mat3& D, Block6& block);
  void add_pair(const Pair& pair);
  static void add_product(const Rows& left, const Mat3& D, const Rows& right, Block6& block);

  const EliminationPattern& pattern_;
  BlockElimination blocks_;
  const VecX& scales_;
  std::vector<Block6> masses_;      ///< By node, scaled.
  std::vector<Rows> rows_;          ///< Of all sides, contact by contact.
  std::vector<std::size_t> first_;  ///< Side of each contact, and the end.
  std::vector<std::size_t> slots_;  ///< Of each two sides of a contact, by rows.
  std::vector<std::size_t> first_slot_;
  std::vector<std::optional<Block6>> squares_;  ///< Jᵀ J of the first side of a contact, once asked for.
  std::vector<int> pair_of_;                    ///< One a contact: its pair, or none.
  std::vector<Pair> pairs_;
  mutable VecX scaled_;  ///< Scratch.
};

}  // namespace rigor
