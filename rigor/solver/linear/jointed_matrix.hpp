#pragma once

#include "rigor/solver/linear/contact_matrix.hpp"

#include <Eigen/LU>

#include <vector>

namespace rigor {

/// The matrices M + Σ_i J_iᵀ D_i J_i of contacts on nodes that joints hold, on the motions that these allow:
/// trees of joints go along with the elimination of their nodes (NodeAttachment), in a time that grows about
/// in proportion to the nodes; the rows that close loops, independent and few, border the matrix.
class JointedMatrix {
 public:
  /// With a share of the masses. Holds a reference to the plan, which is that of the rows.
  JointedMatrix(const ContactRows& rows, const EliminationPlan& plan, double mass_factor = 1);

  /// Whether it can be done so: each tie holds its node by itself, and the rows of loops are few.
  bool is_possible() const { return plan_.is_possible; }
  bool has_loops() const { return plan_.loop_rows_T.cols() > 0; }
  /// Whether all pivots were nonzero and finite.
  bool factor(const std::vector<Mat3>& D, bool is_symmetric);
  /// The x that the joints allow with (M + Σ Jᵀ D J) x = c but for a reaction of the joints.
  void solve(const VecX& c, VecX& x) const;
  VecX solve(const VecX& c) const {
    VecX x;
    solve(c, x);
    return x;
  }

 private:
  const EliminationPlan& plan_;
  ContactMatrix matrix_;
  MatX response_;                     ///< Of the matrix without them to these.
  Eigen::PartialPivLU<MatX> border_;  ///< Of C times the response.
};

}  // namespace rigor
