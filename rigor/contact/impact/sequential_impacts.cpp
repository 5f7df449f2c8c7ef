#include "rigor/contact/impact/sequential_impacts.hpp"

#include "rigor/contact/impact/reflections.hpp"
#include "rigor/contact/impact/single_collision.hpp"

#include <algorithm>
#include <optional>

namespace rigor {

namespace {

using Group = std::vector<std::size_t>;

Group fastest_contacts(const VecX& u, double approach) {
  constexpr double tie = 1e-12;
  Group fastest;
  for (std::size_t i = 0; row_of(i) < u.size(); ++i) {
    if (normal_velocity(u, i) <= -approach * (1 - tie)) fastest.push_back(i);
  }
  return fastest;
}

/// The contacts apart into groups that do not act on one another.
std::vector<Group> independent_groups(const ImpactProblem& problem, Group contacts) {
  std::vector<Group> groups;
  while (!contacts.empty()) {
    Group group{contacts.front()};
    contacts.erase(contacts.begin());
    for (std::size_t k = 0; k < group.size(); ++k) {
      const auto is_coupled = [&](std::size_t i) { return !problem.A.block(i, group[k]).isZero(0); };
      const auto coupled = std::stable_partition(contacts.begin(), contacts.end(),
                                                 [&](std::size_t i) { return !is_coupled(i); });
      group.insert(group.end(), coupled, contacts.end());
      contacts.erase(coupled, contacts.end());
    }
    std::sort(group.begin(), group.end());
    groups.push_back(std::move(group));
  }
  return groups;
}

ImpactSolution resolve_group(const ImpactProblem& part, RestitutionLaw law) {
  if (part.count() == 1) return resolve_lone_contact(part, law);
  const std::optional<ImpactSolution> single = find_single_collision(part, law);
  return single ? *single : solve_reflections(part);
}

}  // namespace

ImpactSolution solve_sequential_impacts(const ImpactProblem& problem, RestitutionLaw law) {
  const int most_impacts = 1000 * static_cast<int>(problem.count());
  const double tolerance = rounding_speed(problem.u);
  ImpactSolution solution{VecX::Zero(problem.u.size())};
  VecX u = problem.u;

  // One round: all contacts that close as fast as the fastest, each group of coupled ones by itself.
  while (solution.iterations < most_impacts) {
    const double approach = fastest_approach(u);
    if (approach <= tolerance) return solution;
    for (const Group& group : independent_groups(problem, fastest_contacts(u, approach))) {
      const ImpactSolution impact = resolve_group(part_of(problem, group, u), law);
      solution.residual = std::max(solution.residual, impact.residual);
      solution.converged = solution.converged && impact.converged;
      VecX lambda = VecX::Zero(u.size());
      for (std::size_t i = 0; i < group.size(); ++i)
        lambda.segment<3>(row_of(group[i])) = impact.lambda.segment<3>(row_of(i));
      solution.lambda += lambda;
      u += problem.A * lambda;
      ++solution.iterations;
    }
    if (!solution.converged) break;
  }

  // The impacts did not end by themselves: a plastic impact ends what is left.
  const CoulombSolution rest = solve_cones(problem.A.dense(), u, frictions(problem));
  solution.lambda += rest.lambda;
  solution.residual = std::max(solution.residual, rest.residual);
  solution.converged = solution.converged && rest.converged;
  return solution;
}

}  // namespace rigor
