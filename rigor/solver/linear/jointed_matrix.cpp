#include "rigor/solver/linear/jointed_matrix.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/work_count.hpp"
#include "rigor/math/dense.hpp"

#include <cmath>

namespace rigor {

using Eigen::Index;

namespace {

/// x = V y + T x_parent for J x + J_p x_parent = 0, from the transposed J (6 × rows) and J_p (6 × rows, or
/// none): with Jᵀ = Q (R, 0) the last columns of Q are V, and T = -Q (R⁻ᵀ J_p, 0). Whether the rows of J are
/// independent.
bool make_attachment(const MatX& J_T, const MatX* parent_T, NodeAttachment& attachment) {
  constexpr double dependent = 1e-5;
  const Index rows = J_T.cols();
  if (rows > 6) return false;
  const Eigen::HouseholderQR<MatX> factors = householder_factors(J_T);
  const MatX R = factors.matrixQR().topRows(rows).triangularView<Eigen::Upper>();
  for (Index i = 0; i < rows; ++i)
    if (!(std::abs(R(i, i)) > dependent * J_T.col(i).norm())) return false;
  MatX Q = MatX::Identity(6, 6);
  apply_householder_q(factors, Q);
  attachment.V.leftCols(6 - rows) = Q.rightCols(6 - rows);
  if (parent_T != nullptr)
    attachment.T =
        -Q.leftCols(rows) * R.transpose().triangularView<Eigen::Lower>().solve(parent_T->transpose());
  return true;
}

}  // namespace

JointedMatrix::JointedMatrix(const ContactRows& rows, const EliminationPattern& pattern, double mass_factor)
    : matrix_(rows, pattern, mass_factor) {
  constexpr std::size_t most_loop_rows = 60;
  const JointTies ties = joint_ties(rows);
  is_held_ = !ties.ties.empty();
  is_possible_ = ties.loop_rows.size() <= most_loop_rows;
  for (const JointTies::Tie& tie : ties.ties) is_possible_ = is_possible_ && attach(pattern, tie);

  C_T_.setZero(6 * static_cast<Index>(rows.node_count()), static_cast<Index>(ties.loop_rows.size()));
  for (std::size_t k = 0; k < ties.loop_rows.size(); ++k)
    for (const auto& [node, coefficients] : ties.loop_rows[k])
      C_T_.col(static_cast<Index>(k)).segment<6>(6 * node) += coefficients;
}

/// The first of the tie's nodes that is eliminated hangs on the other one.
bool JointedMatrix::attach(const EliminationPattern& pattern, const JointTies::Tie& tie) {
  const bool is_grounded = tie.nodes.size() == 1;
  const std::size_t first = is_grounded || pattern.place(tie.nodes[0]) < pattern.place(tie.nodes[1]) ? 0 : 1;
  const auto scaled = [this, &tie](std::size_t k) {
    return MatX(matrix_.scales().segment<6>(6 * tie.nodes[k]).asDiagonal() * tie.wrenches[k]);
  };
  constexpr std::uint64_t operations = 30;  // Of the factors of a link's rows.
  count_work(operations);
  NodeAttachment attachment;
  MatX of_parent;
  if (!is_grounded) {
    attachment.parent = tie.nodes[1 - first];
    of_parent = scaled(1 - first);
  }
  if (!make_attachment(scaled(first), is_grounded ? nullptr : &of_parent, attachment)) return false;
  matrix_.attach(tie.nodes[first], attachment);
  return true;
}

bool JointedMatrix::factor(const std::vector<Mat3>& D, bool is_symmetric) {
  const bool is_regular = matrix_.factor(D, is_symmetric && !is_held_);
  if (C_T_.cols() == 0) return is_regular;
  response_.resize(C_T_.rows(), C_T_.cols());
  for (Index k = 0; k < C_T_.cols(); ++k) response_.col(k) = matrix_.solve(C_T_.col(k));
  border_.compute(C_T_.transpose() * response_);
  return is_regular;
}

// x = K⁻¹ c - K⁻¹ Cᵀ μ with C x = 0.
VecX JointedMatrix::solve(const VecX& c) const {
  VecX x = matrix_.solve(c);
  if (C_T_.cols() > 0) x -= response_ * border_.solve(C_T_.transpose() * x);
  return x;
}

}  // namespace rigor
