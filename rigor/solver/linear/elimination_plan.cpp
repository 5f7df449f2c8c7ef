#include "rigor/solver/linear/elimination_plan.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/work_count.hpp"
#include "rigor/solver/linear/joint_ties.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace rigor {

using Eigen::Index;

namespace {

double power_near_inverse_root(double x) {
  return std::ldexp(1.0, -static_cast<int>(std::floor(0.5 * std::ilogb(x))));
}

VecX unknown_scales(const ContactRows& rows) {
  VecX scales(6 * static_cast<Index>(rows.node_count()));
  for (std::size_t k = 0; k < rows.node_count(); ++k) {
    const Mat6& mass = rows.masses[k];
    const Index first = 6 * static_cast<Index>(k);
    // Unknowns of mass and inertia near 1, so that one threshold serves all pivots; powers of two round
    // nothing.
    scales.segment<3>(first).setConstant(power_near_inverse_root(mass(0, 0)));
    scales.segment<3>(first + 3).setConstant(
        power_near_inverse_root(mass.bottomRightCorner<3, 3>().diagonal().maxCoeff()));
  }
  return scales;
}

EliminationPattern pattern_of(const ContactRows& rows, const JointTies& ties) {
  std::vector<std::pair<int, int>> pairs;
  for (const ContactRows::Sides& sides : rows.contacts)
    for (std::size_t a = 0; a < sides.size(); ++a)
      for (std::size_t b = a + 1; b < sides.size(); ++b)
        if (sides[a].node >= 0 && sides[b].node >= 0 && sides[a].node != sides[b].node)
          pairs.emplace_back(sides[a].node, sides[b].node);
  if (ties.ties.empty()) return {rows.node_count(), pairs};
  for (const JointTies::Tie& tie : ties.ties)
    if (tie.nodes.size() == 2) pairs.emplace_back(tie.nodes[0], tie.nodes[1]);
  return {places_of_tied_nodes(rows.node_count(), pairs, ties.ties), pairs};
}

/// Householder's factorisation of the first columns of a matrix, Q R (Golub and Van Loan, Matrix
/// Computations, 2013, section 5.2), on storage of fixed size.
struct SixRows {
  Mat6 Q = Mat6::Identity();
  Mat6 R;
  bool is_independent = true;

  SixRows(const Mat6& columns, int count) : R(columns) {
    constexpr double dependent = 1e-5;
    for (int k = 0; k < count; ++k) {
      // The reflection that takes what is left of the column to its first entry.
      Vec6 v = R.col(k);
      v.head(k).setZero();
      const double size = v.norm();
      if (!(size > dependent * columns.col(k).norm())) {
        is_independent = false;
        return;
      }
      v(k) += v(k) < 0 ? -size : size;
      const Vec6 scaled = (2 / v.squaredNorm()) * v;
      R -= scaled * Eigen::Matrix<double, 1, 6>(v.transpose() * R);
      Q -= Vec6(Q * v) * scaled.transpose();
    }
  }
};

/// x = V y + T x_parent for J x + J_p x_parent = 0, from the transposed J and J_p (or none): with Jᵀ = Q (R,
/// 0) the last columns of Q are V, and T = -Q (R⁻ᵀ J_p, 0). Whether the rows of J are independent.
bool make_attachment(const Mat6& J_T, const Mat6* parent_T, int rows, NodeAttachment& attachment) {
  const SixRows factors(J_T, rows);
  if (!factors.is_independent) return false;
  for (int column = rows; column < 6; ++column) attachment.V.col(column - rows) = factors.Q.col(column);
  if (parent_T == nullptr) return true;
  for (int i = 0; i < rows; ++i) {
    // Row i of R⁻ᵀ J_p, forward.
    Eigen::Matrix<double, 1, 6> of_parent = parent_T->col(i).transpose();
    for (int k = 0; k < i; ++k) of_parent -= factors.R(k, i) * attachment.T.row(k);
    attachment.T.row(i) = of_parent / factors.R(i, i);
  }
  attachment.T = Block6(-factors.Q.lazyProduct(attachment.T));
  return true;
}

/// The first of the tie's nodes that is eliminated hangs on the other one.
bool add_attachment(const JointTies::Tie& tie, EliminationPlan& plan) {
  constexpr std::uint64_t operations = 30;  // Of the factors of a link's rows.
  count_work(operations);
  const auto scaled = [&](std::size_t k) {
    return Mat6(plan.scales.segment<6>(6 * tie.nodes[k]).asDiagonal() * tie.wrenches[k]);
  };
  NodeAttachment attachment;
  if (tie.nodes.size() == 1) {
    if (!make_attachment(scaled(0), nullptr, tie.rows, attachment)) return false;
    plan.attachments.emplace_back(tie.nodes[0], attachment);
    return true;
  }
  const std::size_t first = plan.pattern.place(tie.nodes[0]) < plan.pattern.place(tie.nodes[1]) ? 0 : 1;
  attachment.parent = tie.nodes[1 - first];
  const Mat6 of_parent = scaled(1 - first);
  if (!make_attachment(scaled(first), &of_parent, tie.rows, attachment)) return false;
  plan.attachments.emplace_back(tie.nodes[first], attachment);
  return true;
}

}  // namespace

EliminationPlan elimination_plan(const ContactRows& rows) {
  constexpr std::size_t most_loop_rows = 60;
  const JointTies ties = joint_ties(rows);
  EliminationPlan plan{pattern_of(rows, ties), unknown_scales(rows), {}, {}, true};
  plan.is_possible = ties.loop_rows.size() <= most_loop_rows;
  for (const JointTies::Tie& tie : ties.ties)
    plan.is_possible = plan.is_possible && add_attachment(tie, plan);
  plan.loop_rows_T.setZero(6 * static_cast<Index>(rows.node_count()),
                           static_cast<Index>(ties.loop_rows.size()));
  for (std::size_t k = 0; k < ties.loop_rows.size(); ++k)
    for (const auto& [node, coefficients] : ties.loop_rows[k])
      plan.loop_rows_T.col(static_cast<Index>(k)).segment<6>(6 * node) += coefficients;
  return plan;
}

}  // namespace rigor
