#include "rigor/solver/linear/contact_rows.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/rounding.hpp"
#include "rigor/solver/linear/two_doubles.hpp"

#include <algorithm>
#include <utility>

namespace rigor {

using Eigen::Index;

namespace {

/// w += J V of one side.
void add_rates(const double* J, const double* V, double* w) {
  for (int r = 0; r < 3; ++r, J += 6)
    w[r] += (J[0] * V[0] + (J[1] * V[1] + J[2] * V[2])) + (J[3] * V[3] + (J[4] * V[4] + J[5] * V[5]));
}

/// p += Jᵀ λ of one side.
void add_wrench(const double* J, const double* lambda, double* p) {
  for (int c = 0; c < 6; c += 2) {
    const TwoDoubles of_row =
        lambda[0] * two_of(J + c) + (lambda[1] * two_of(J + 6 + c) + lambda[2] * two_of(J + 12 + c));
    put_two(two_of(p + c) + of_row, p + c);
  }
}

/// The same with |J|, of sizes.
void add_sizes_of_rates(const double* J, const double* V, double* w) {
  const TwoDoubles v0 = two_of(V), v1 = two_of(V + 2), v2 = two_of(V + 4);
  for (int r = 0; r < 3; ++r, J += 6) {
    const TwoDoubles sum =
        size_of(two_of(J)) * v0 + size_of(two_of(J + 2)) * v1 + size_of(two_of(J + 4)) * v2;
    w[r] += sum[0] + sum[1];
  }
}
void add_size_of_wrench(const double* J, const double* lambda, double* p) {
  for (int c = 0; c < 6; c += 2) {
    const TwoDoubles of_row = lambda[0] * size_of(two_of(J + c)) + (lambda[1] * size_of(two_of(J + 6 + c)) +
                                                                    lambda[2] * size_of(two_of(J + 12 + c)));
    put_two(two_of(p + c) + of_row, p + c);
  }
}

}  // namespace

void contact_rates(const ContactRows& rows, const VecX& V, VecX& rates) {
  rates.setZero(3 * static_cast<Index>(rows.contacts.size()));
  for (std::size_t i = 0; i < rows.contacts.size(); ++i)
    for (const ContactRows::Side& side : rows.contacts[i])
      if (side.node >= 0) add_rates(side.J.data(), V.data() + 6 * side.node, rates.data() + 3 * i);
}

bool are_masses_alike(const ContactRows& rows) {
  constexpr double kMostRatio = 1e3;
  double least = kInfinity, most = 0;
  for (const Mat6& mass : rows.masses) {
    const double largest = mass.diagonal().head<3>().maxCoeff();
    least = std::min(least, largest);
    most = std::max(most, largest);
  }
  return most <= kMostRatio * least;
}

VecX contact_rates(const ContactRows& rows, const VecX& V) {
  VecX rates;
  contact_rates(rows, V, rates);
  return rates;
}

void contact_wrenches(const ContactRows& rows, const VecX& lambda, VecX& wrenches) {
  wrenches.setZero(6 * static_cast<Index>(rows.node_count()));
  for (std::size_t i = 0; i < rows.contacts.size(); ++i)
    for (const ContactRows::Side& side : rows.contacts[i])
      if (side.node >= 0) add_wrench(side.J.data(), lambda.data() + 3 * i, wrenches.data() + 6 * side.node);
}

VecX contact_wrenches(const ContactRows& rows, const VecX& lambda) {
  VecX wrenches;
  contact_wrenches(rows, lambda, wrenches);
  return wrenches;
}

Index for_each_joint_row(const ContactRows& rows, const std::function<void(Index, int, const Vec6&)>& add) {
  if (!rows.joints) return 0;
  const ConstrainedMass& joints = *rows.joints;
  const ConstrainedMass::RowChoice& left_out = joints.choice();
  auto next_left_out = left_out.begin();
  Index count = 0;
  for (int link = 0; link < static_cast<int>(joints.graph().links.size()); ++link) {
    const ConstraintGraph::Link& equations = joints.graph().links[at(link)];
    for (int row = 0; row < equations.rows; ++row) {
      if (next_left_out != left_out.end() && *next_left_out == joints.first_row(link) + row) {
        ++next_left_out;
        continue;
      }
      for (std::size_t k = 0; k < equations.nodes.size(); ++k)
        add(count, rows.joint_nodes[at(equations.nodes[k])], joints.block(link, k).row(row).transpose());
      ++count;
    }
  }
  return count;
}

void constrain_nodes(std::shared_ptr<const ConstrainedMass> joints, std::vector<int> nodes,
                     ContactRows& rows) {
  rows.joints = std::move(joints);
  rows.joint_nodes = std::move(nodes);
  // The base is dense: with more nodes it takes longer to work with than the sparse factors of their
  // equations, and trees are eliminated without it (JointedMatrix).
  constexpr std::size_t kMostNodesWithBase = 30;
  if (rows.joints && !rows.joints->forest().loop_links.empty() &&
      rows.joint_nodes.size() <= kMostNodesWithBase)
    rows.held_motions = rows.joints->motions();
}

VecX with_joints(const ContactRows& rows, const VecX& p) {
  if (!rows.joints) return p;
  const Index count = static_cast<Index>(rows.joint_nodes.size());
  VecX held(6 * count), result = p;
  for (Index n = 0; n < count; ++n) held.segment<6>(6 * n) = p.segment<6>(6 * rows.joint_nodes[at(n)]);
  const VecX a = rows.has_held_motions() ? VecX(rows.held_motions * (rows.held_motions.transpose() * held))
                                         : rows.joints->solve(held, VecX::Zero(rows.joints->row_count())).a;
  for (Index n = 0; n < count; ++n) {
    const int node = rows.joint_nodes[at(n)];
    result.segment<6>(6 * node) = rows.masses[at(node)] * a.segment<6>(6 * n);
  }
  return result;
}

void node_accelerations(const ContactRows& rows, const VecX& p, VecX& a) {
  a.resize(p.size());
  for (std::size_t k = 0; k < rows.node_count(); ++k) {
    const Index row = 6 * static_cast<Index>(k);
    a.segment<6>(row).noalias() = rows.inverse_masses[k] * p.segment<6>(row);
  }
}

VecX node_accelerations(const ContactRows& rows, const VecX& p) {
  VecX a;
  node_accelerations(rows, p, a);
  return a;
}

void node_wrenches(const ContactRows& rows, const VecX& V, VecX& p) {
  p.resize(V.size());
  for (std::size_t k = 0; k < rows.node_count(); ++k) {
    const Index row = 6 * static_cast<Index>(k);
    p.segment<6>(row).noalias() = rows.masses[k] * V.segment<6>(row);
  }
}

VecX node_wrenches(const ContactRows& rows, const VecX& V) {
  VecX p;
  node_wrenches(rows, V, p);
  return p;
}

VecX free_diagonal(const ContactRows& rows) {
  VecX diagonal = VecX::Zero(3 * static_cast<Index>(rows.contacts.size()));
  for (std::size_t i = 0; i < rows.contacts.size(); ++i) {
    for (const ContactRows::Side& side : rows.contacts[i]) {
      if (side.node < 0) continue;
      const Eigen::Matrix<double, 3, 6> J = side.J, moved = J * rows.inverse_masses[at(side.node)];
      diagonal.segment<3>(3 * static_cast<Index>(i)) += moved.cwiseProduct(J).rowwise().sum();
    }
  }
  return diagonal;
}

MatX contact_response(const ContactRows& rows) {
  const Index size = 3 * static_cast<Index>(rows.contacts.size());
  MatX A(size, size);
  for (Index column = 0; column < size; ++column) {
    const VecX p = with_joints(rows, contact_wrenches(rows, VecX::Unit(size, column)));
    A.col(column) = contact_rates(rows, node_accelerations(rows, p));
  }
  return 0.5 * (A + A.transpose());
}

VecX contact_diagonal(const ContactRows& rows) {
  VecX diagonal = free_diagonal(rows);
  if (!rows.joints) return diagonal;
  const std::vector<Mat6> own = rows.joints->own_responses();
  std::vector<int> held(rows.node_count(), -1);
  for (std::size_t k = 0; k < rows.joint_nodes.size(); ++k)
    held[at(rows.joint_nodes[k])] = static_cast<int>(k);
  VecX lambda = VecX::Zero(diagonal.size());
  for (std::size_t i = 0; i < rows.contacts.size(); ++i) {
    const Index row = 3 * static_cast<Index>(i);
    const auto is_held = [&held](const ContactRows::Side& side) {
      return side.node >= 0 && held[at(side.node)] >= 0;
    };
    const std::ptrdiff_t count = std::count_if(rows.contacts[i].begin(), rows.contacts[i].end(), is_held);
    if (count == 0) continue;

    // One held node: its own response in place of its inverse mass.
    if (count == 1 && !own.empty()) {
      diagonal.segment<3>(row).setZero();
      for (const ContactRows::Side& side : rows.contacts[i]) {
        if (side.node < 0) continue;
        const Mat6& response =
            is_held(side) ? own[at(held[at(side.node)])] : rows.inverse_masses[at(side.node)];
        const Eigen::Matrix<double, 3, 6> J = side.J;
        diagonal.segment<3>(row) += (J * response).cwiseProduct(J).rowwise().sum().cwiseMax(0);
      }
      continue;
    }
    for (Index k = row; k < row + 3; ++k) {
      lambda(k) = 1;
      const VecX p = with_joints(rows, contact_wrenches(rows, lambda));
      // λᵀ A λ = Vᵀ M V: never below zero.
      diagonal(k) = std::max(0.0, p.dot(node_accelerations(rows, p)));
      lambda(k) = 0;
    }
  }
  return diagonal;
}

double largest_term(const ContactRows& rows, const VecX& lambda) {
  // |Jᵀ| |λ| of each node, then |M⁻¹| times that in its place.
  VecX of_nodes = VecX::Zero(6 * static_cast<Index>(rows.node_count()));
  for (std::size_t i = 0; i < rows.contacts.size(); ++i) {
    const Vec3 size_of_force = lambda.segment<3>(3 * static_cast<Index>(i)).cwiseAbs();
    if (size_of_force.isZero(0)) continue;
    for (const ContactRows::Side& side : rows.contacts[i])
      if (side.node >= 0)
        add_size_of_wrench(side.J.data(), size_of_force.data(), of_nodes.data() + 6 * side.node);
  }
  for (std::size_t k = 0; k < rows.node_count(); ++k) {
    auto own = of_nodes.segment<6>(6 * static_cast<Index>(k));
    own = Vec6(rows.inverse_masses[k].cwiseAbs() * own);
  }
  // |J| times that.
  double largest = 0;
  for (const ContactRows::Sides& sides : rows.contacts) {
    Vec3 sizes = Vec3::Zero();
    for (const ContactRows::Side& side : sides)
      if (side.node >= 0) add_sizes_of_rates(side.J.data(), of_nodes.data() + 6 * side.node, sizes.data());
    largest = std::max(largest, sizes.maxCoeff());
  }
  return largest;
}

}  // namespace rigor
