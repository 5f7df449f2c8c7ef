#include "rigor/solver/motion/projected_gauss_seidel.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"
#include "rigor/core/interrupt.hpp"
#include "rigor/solver/coulomb/coulomb_law.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigor {

using Eigen::Index;

namespace {

/// All rows of the joints, with what a unit force of each does to its nodes.
struct JointRow {
  struct Side {
    int node;
    Vec6 J, response;
  };
  std::vector<Side> sides;
  double mobility = 0;
};

std::vector<JointRow> rows_of_joints(const ContactRows& rows) {
  std::vector<JointRow> result;
  if (!rows.joints) return result;
  const ConstraintGraph& graph = rows.joints->graph();
  for (int link = 0; link < static_cast<int>(graph.links.size()); ++link) {
    const ConstraintGraph::Link& equations = graph.links[at(link)];
    for (int row = 0; row < equations.rows; ++row) {
      JointRow joint;
      for (std::size_t k = 0; k < equations.nodes.size(); ++k) {
        const int node = rows.joint_nodes[at(equations.nodes[k])];
        const Vec6 J = rows.joints->block(link, k).row(row).transpose();
        const Vec6 response = rows.inverse_masses[at(node)] * J;
        joint.sides.push_back({node, J, response});
        joint.mobility += J.dot(response);
      }
      result.push_back(std::move(joint));
    }
  }
  return result;
}

VecX joint_rates(const std::vector<JointRow>& joints, const VecX& V) {
  VecX rates = VecX::Zero(static_cast<Index>(joints.size()));
  for (std::size_t j = 0; j < joints.size(); ++j)
    for (const JointRow::Side& side : joints[j].sides)
      rates(static_cast<Index>(j)) += side.J.dot(V.segment<6>(6 * side.node));
  return rates;
}

VecX joint_wrenches(const std::vector<JointRow>& joints, const VecX& nu, Index size) {
  VecX p = VecX::Zero(size);
  for (std::size_t j = 0; j < joints.size(); ++j)
    for (const JointRow::Side& side : joints[j].sides)
      p.segment<6>(6 * side.node) += nu(static_cast<Index>(j)) * side.J;
  return p;
}

double larger_eigenvalue(const Mat3& A) {
  const double half_sum = 0.5 * (A(0, 0) + A(1, 1)), half_difference = 0.5 * (A(0, 0) - A(1, 1));
  return half_sum + std::hypot(half_difference, A(0, 1));
}

class Sweeper {
 public:
  Sweeper(const VelocityProblem& problem, const VelocityStart& start)
      : problem_(problem),
        rows_(problem.contacts.rows),
        laws_(problem.contacts.laws),
        joints_(rows_of_joints(rows_)),
        lambda_(start.lambda.size() > 0 ? start.lambda : VecX(VecX::Zero(laws_.b.size()))),
        nu_(start.nu.size() > 0 ? start.nu : VecX(VecX::Zero(problem.c.size()))) {
    RIGOR_ASSERT(problem.c.size() == static_cast<Index>(joints_.size()));
    RIGOR_ASSERT(lambda_.size() == laws_.b.size() && nu_.size() == problem.c.size());
    // The first forces must keep the law's bounds, and the motion must be theirs: sweeps change both
    // together.
    lambda_ = clamp_to_cones(laws_, lambda_);
    const Index size = 6 * static_cast<Index>(rows_.node_count());
    V_ = node_accelerations(rows_, contact_wrenches(rows_, lambda_) + joint_wrenches(joints_, nu_, size));
    for (const ContactRows::Sides& sides : rows_.contacts) add_contact(sides);
  }

  void sweep() {
    for (std::size_t j = 0; j < joints_.size(); ++j) relax_joint(j);
    for (std::size_t i = 0; i < contacts_.size(); ++i) relax_contact(i);
  }

  const VecX& lambda() const { return lambda_; }
  const VecX& nu() const { return nu_; }

 private:
  struct ContactResponse {
    std::array<Eigen::Matrix<double, 6, 3>, 3> of_sides;  ///< M⁻¹ Jᵀ.
    double normal = 0, tangent = 0;                       ///< A_nn and the larger eigenvalue of A_tt.
  };

  void add_contact(const ContactRows::Sides& sides) {
    ContactResponse response;
    // The contact's own block of J M⁻¹ Jᵀ; bodies that do not give way add nothing.
    Mat3 A = Mat3::Zero();
    for (std::size_t s = 0; s < sides.size(); ++s) {
      if (sides[s].node < 0) continue;
      response.of_sides[s] = rows_.inverse_masses[at(sides[s].node)] * sides[s].J.transpose();
      A += sides[s].J * response.of_sides[s];
    }
    response.normal = A(2, 2);
    response.tangent = larger_eigenvalue(A);
    contacts_.push_back(response);
  }

  void relax_joint(std::size_t j) {
    const JointRow& joint = joints_[j];
    const Index row = static_cast<Index>(j);
    if (!(joint.mobility > 0)) return;
    // One row at a time: the force that makes its rate zero if nothing else changes, and what it does to the
    // motion.
    double rate = problem_.c(row);
    for (const JointRow::Side& side : joint.sides) rate += side.J.dot(V_.segment<6>(6 * side.node));
    const double change = -rate / joint.mobility;
    nu_(row) += change;
    for (const JointRow::Side& side : joint.sides) V_.segment<6>(6 * side.node) += change * side.response;
  }

  Vec3 rate_of(std::size_t i) const {
    Vec3 w = laws_.b.segment<3>(3 * static_cast<Index>(i));
    for (const ContactRows::Side& side : rows_.contacts[i])
      if (side.node >= 0) w += side.J * V_.segment<6>(6 * side.node);
    return w;
  }

  void change_force(std::size_t i, const Vec3& change) {
    lambda_.segment<3>(3 * static_cast<Index>(i)) += change;
    for (std::size_t s = 0; s < rows_.contacts[i].size(); ++s) {
      const int node = rows_.contacts[i][s].node;
      if (node >= 0) V_.segment<6>(6 * node) += contacts_[i].of_sides[s] * change;
    }
  }

  void relax_contact(std::size_t i) {
    // The normal force first, from the newest motion.
    const ContactResponse& response = contacts_[i];
    const Vec3 before = lambda_.segment<3>(3 * static_cast<Index>(i));
    double normal = before(2);
    if (response.normal > 0) normal = std::max(0.0, normal - rate_of(i)(2) / response.normal);
    change_force(i, Vec3(0, 0, normal - before(2)));

    // Then friction, with the new λ_n as its bound.
    const double mu = laws_.mu[i];
    Vec2 friction = Vec2::Zero();
    if (mu > 0 && laws_.rows[i] == FrictionRow::slide) {
      friction = -mu * normal * laws_.slips[i];
    } else if (mu > 0) {
      friction = before.head<2>();
      if (response.tangent > 0) friction -= rate_of(i).head<2>() / response.tangent;
      const double length = friction.norm();
      if (length > mu * normal) friction *= mu * normal / length;
    }
    change_force(i, Vec3(friction(0) - before(0), friction(1) - before(1), 0));
  }

  const VelocityProblem& problem_;
  const ContactRows& rows_;
  const CoulombProblem& laws_;
  std::vector<JointRow> joints_;
  std::vector<ContactResponse> contacts_;
  VecX lambda_, nu_, V_;
};

VelocitySolution solution_of(const VelocityProblem& problem, const VecX& lambda, const VecX& nu) {
  const ContactRows& rows = problem.contacts.rows;
  const CoulombProblem& laws = problem.contacts.laws;
  const std::vector<JointRow> joints = rows_of_joints(rows);
  const VecX p =
      contact_wrenches(rows, lambda) + joint_wrenches(joints, nu, 6 * static_cast<Index>(rows.node_count()));
  const VecX V = node_accelerations(rows, p);
  VelocitySolution solution{lambda, nu, contact_rates(rows, V) + laws.b, joint_rates(joints, V) + problem.c,
                            0.0};
  // The size of what is summed in the rows, against which what they miss is measured.
  double size = 0;
  if (lambda.size() > 0) size = std::max(laws.b.cwiseAbs().maxCoeff(), largest_term(rows, lambda));
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const Index row = static_cast<Index>(j);
    size = std::max({size, std::abs(problem.c(row)), joints[j].mobility * std::abs(nu(row))});
  }
  if (!lambda.allFinite() || !nu.allFinite() || !V.allFinite() || !std::isfinite(size)) {
    solution.residual = std::numeric_limits<double>::infinity();
    return solution;
  }
  if (size == 0) return solution;
  if (lambda.size() > 0)
    solution.residual = law_residual(laws, free_diagonal(rows), size, lambda, solution.w);
  if (solution.r.size() > 0)
    solution.residual = std::max(solution.residual, solution.r.cwiseAbs().maxCoeff() / size);
  return solution;
}

}  // namespace

VelocitySolution solve_projected_gauss_seidel(const VelocityProblem& problem, int sweeps,
                                              const VelocityStart& start) {
  Sweeper sweeper(problem, start);
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    poll_interrupt();
    sweeper.sweep();
  }
  return solution_of(problem, sweeper.lambda(), sweeper.nu());
}

}  // namespace rigor
