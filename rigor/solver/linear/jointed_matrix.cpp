#include "rigor/solver/linear/jointed_matrix.hpp"

namespace rigor {

using Eigen::Index;

JointedMatrix::JointedMatrix(const ContactRows& rows, const EliminationPlan& plan, double mass_factor)
    : plan_(plan), matrix_(rows, plan, mass_factor) {
  for (const auto& [node, attachment] : plan.attachments) matrix_.attach(node, attachment);
}

bool JointedMatrix::factor(const std::vector<Mat3>& D, bool is_symmetric) {
  const bool is_regular = matrix_.factor(D, is_symmetric && plan_.attachments.empty());
  if (!has_loops()) return is_regular;
  const MatX& C_T = plan_.loop_rows_T;
  response_.resize(C_T.rows(), C_T.cols());
  VecX column;
  for (Index k = 0; k < C_T.cols(); ++k) {
    matrix_.solve(C_T.col(k), column);
    response_.col(k) = column;
  }
  border_.compute(C_T.transpose() * response_);
  return is_regular;
}

// x = K⁻¹ c - K⁻¹ Cᵀ μ with C x = 0.
void JointedMatrix::solve(const VecX& c, VecX& x) const {
  matrix_.solve(c, x);
  if (has_loops()) x -= response_ * border_.solve(plan_.loop_rows_T.transpose() * x);
}

}  // namespace rigor
