#include "rigor/contact/impact/impact_problem.hpp"

#include "rigor/core/assert.hpp"

#include <algorithm>

namespace rigor {

ImpactProblem make_impact_problem(const ContactSystem& system, const std::vector<double>& restitutions) {
  RIGOR_ASSERT(restitutions.size() == system.contacts.size());
  ImpactProblem problem{{}, delassus(system), relative_velocities(system)};
  for (std::size_t i = 0; i < system.contacts.size(); ++i) {
    const Contact& contact = system.contacts[i];
    const bool is_ascending = contact.body_A < contact.body_B;
    problem.contacts.push_back({std::min(contact.body_A, contact.body_B),
                                std::max(contact.body_A, contact.body_B),
                                (is_ascending ? 1.0 : -1.0) * system.frames[i], contact.friction,
                                restitutions[i], contact.tangential_restitution});
  }
  return problem;
}

ImpactProblem part_of(const ImpactProblem& problem, const std::vector<std::size_t>& chosen, const VecX& u) {
  const Eigen::Index size = row_of(chosen.size());
  ImpactProblem part{{}, MatX(size, size), VecX(size)};
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    part.contacts.push_back(problem.contacts[chosen[i]]);
    part.u.segment<3>(row_of(i)) = u.segment<3>(row_of(chosen[i]));
    for (std::size_t k = 0; k < chosen.size(); ++k) {
      part.A.block<3, 3>(row_of(i), row_of(k)) = problem.A.block<3, 3>(row_of(chosen[i]), row_of(chosen[k]));
    }
  }
  return part;
}

double rounding_speed(const VecX& u) {
  constexpr double rounding = 1e-13;
  return rounding * u.cwiseAbs().maxCoeff();
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
  return solve_coulomb({A, b, mu, std::vector<FrictionRow>(mu.size(), FrictionRow::cone),
                        std::vector<Vec2>(mu.size(), Vec2::Zero())},
                       options);
}

std::vector<double> frictions(const ImpactProblem& problem) {
  std::vector<double> mu;
  for (const ImpactContact& contact : problem.contacts) mu.push_back(contact.mu);
  return mu;
}

}  // namespace rigor
