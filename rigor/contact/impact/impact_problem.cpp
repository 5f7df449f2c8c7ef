#include "rigor/contact/impact/impact_problem.hpp"

#include "rigor/contact/system/motion_rows.hpp"
#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"
#include "rigor/solver/motion/motion_problem.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace rigor {

namespace {

/// From so many contacts on the sparse rows are faster than the dense A, three to twelve times already of
/// these few; of fewer the forces of least norm cost little.
constexpr std::size_t worth_rows = 5, worth_jointed_rows = 12;

/// From so many on the dense A is not formed, unless the rows leave a problem to it.
constexpr std::size_t too_many_for_matrix = 48;

/// Joints and loads have rows of their own kind, which contact space eliminates.
bool bodies_bear_all(const ContactSystem& system) {
  return !system.joints && std::none_of(system.contacts.begin(), system.contacts.end(),
                                        [](const Contact& contact) { return contact.stop.has_value(); });
}

CoulombProblem cones_of(const VecX& b, const std::vector<double>& mu) {
  return {{},
          b,
          mu,
          std::vector<FrictionRow>(mu.size(), FrictionRow::cone),
          std::vector<Vec2>(mu.size(), Vec2::Zero())};
}

}  // namespace

ImpactProblem make_impact_problem(const ContactSystem& system, const std::vector<double>& restitutions) {
  RIGOR_ASSERT(restitutions.size() == system.contacts.size());
  ImpactProblem problem{{}, {}, relative_velocities(system)};
  for (std::size_t i = 0; i < system.contacts.size(); ++i) {
    const Contact& contact = system.contacts[i];
    // Laws see each pair in ascending order, so that it does not matter which body is called A.
    const bool is_ascending = contact.body_A < contact.body_B;
    problem.contacts.push_back({std::min(contact.body_A, contact.body_B),
                                std::max(contact.body_A, contact.body_B),
                                (is_ascending ? 1.0 : -1.0) * system.frames[i], contact.friction,
                                restitutions[i], contact.tangential_restitution});
  }
  const bool by_bodies = bodies_bear_all(system);
  if (problem.count() >= (by_bodies ? worth_rows : worth_jointed_rows))
    (by_bodies ? problem.rows : problem.jointed_rows) =
        std::make_shared<const ContactRows>(motion_rows(system));
  problem.A = problem.rows && problem.count() >= too_many_for_matrix ? DelassusOperator(problem.rows)
                                                                     : DelassusOperator(delassus(system));
  return problem;
}

ImpactProblem part_of(const ImpactProblem& problem, const std::vector<std::size_t>& chosen, const VecX& u) {
  const Eigen::Index size = row_of(chosen.size());
  ImpactProblem part{{}, {}, VecX(size)};
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    part.contacts.push_back(problem.contacts[chosen[i]]);
    part.u.segment<3>(row_of(i)) = u.segment<3>(row_of(chosen[i]));
  }
  if (problem.rows && chosen.size() >= too_many_for_matrix) {
    part.rows = std::make_shared<const ContactRows>(rows_of(*problem.rows, chosen));
    part.A = DelassusOperator(part.rows);
    return part;
  }
  // Of many contacts rows say at least what the matrix does.
  if (problem.jointed_rows && chosen.size() >= too_many_for_matrix)
    part.jointed_rows = std::make_shared<const ContactRows>(rows_of(*problem.jointed_rows, chosen));

  // A dense problem is cut out of the dense operator, block by block.
  MatX A(size, size);
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    for (std::size_t k = 0; k < chosen.size(); ++k)
      A.block<3, 3>(row_of(i), row_of(k)) = problem.A.block(chosen[i], chosen[k]);
  }
  part.A = DelassusOperator(std::move(A));
  return part;
}

ContactRows rows_of(const ContactRows& rows, const std::vector<std::size_t>& contacts) {
  // Joints are factored on all of their nodes.
  if (rows.joints) {
    ContactRows result = rows;
    result.contacts.clear();
    for (const std::size_t i : contacts) result.contacts.push_back(rows.contacts[i]);
    return result;
  }

  // The nodes that take part, in their order.
  std::vector<int> nodes(rows.node_count(), -1);
  for (const std::size_t i : contacts) {
    for (const ContactRows::Side& side : rows.contacts[i])
      if (side.node >= 0) nodes[at(side.node)] = 0;
  }
  ContactRows result;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    if (nodes[k] < 0) continue;
    nodes[k] = static_cast<int>(result.masses.size());
    result.masses.push_back(rows.masses[k]);
    result.inverse_masses.push_back(rows.inverse_masses[k]);
  }
  for (const std::size_t i : contacts) {
    result.contacts.push_back(rows.contacts[i]);
    for (ContactRows::Side& side : result.contacts.back())
      if (side.node >= 0) side.node = nodes[at(side.node)];
  }
  return result;
}

double rounding_speed(const VecX& u) {
  constexpr double rounding = 1e-13;
  return rounding * u.cwiseAbs().maxCoeff();
}

double contradiction_speed(const VecX& u) {
  // The tilt of a face against its neighbour, the contact tolerance over the size of bodies.
  constexpr double tilt = 1e-6;
  return tilt * u.cwiseAbs().maxCoeff();
}

double fastest_approach(const VecX& u) {
  double approach = 0;
  for (Eigen::Index row = 2; row < u.size(); row += 3) approach = std::max(approach, -u[row]);
  return approach;
}

double energy_change(const ImpactProblem& problem, const VecX& lambda) {
  return lambda.dot(problem.u + 0.5 * (problem.A * lambda));
}

CoulombSolution solve_cones(const MatX& A, const VecX& b, const std::vector<double>& mu) {
  CoulombOptions options;
  options.resolution = 0;  // Velocities of bodies: contacts do not contradict each other.
  CoulombProblem problem = cones_of(b, mu);
  problem.A = A;
  return solve_coulomb(problem, options);
}

CoulombSolution solve_cones(const ImpactProblem& problem, const VecX& b, const std::vector<double>& mu) {
  if (const auto& rows = problem.rows ? problem.rows : problem.jointed_rows) {
    // First in the space of motions; what that does not solve is left to the chain of dense methods.
    constexpr double enough_of_many = 1e-10;
    const MotionProblem motion{*rows, cones_of(b, mu)};
    CoulombOptions any_share;
    any_share.least_norm = false;
    any_share.enough = enough_of_many;
    any_share.resolution = contradiction_speed(b);
    if (std::optional<CoulombSolution> any = solve_in_motion_space(motion, {}, any_share))
      return std::move(*any);
  }
  return solve_cones(problem.A.dense(), b, mu);
}

std::vector<double> frictions(const ImpactProblem& problem) {
  std::vector<double> mu;
  for (const ImpactContact& contact : problem.contacts) mu.push_back(contact.mu);
  return mu;
}

}  // namespace rigor
