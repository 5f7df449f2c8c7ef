#include "rigor/contact/impact.hpp"

#include "rigor/contact/newton_impacts.hpp"
#include "rigor/contact/reflections.hpp"
#include "rigor/contact/sequential_impacts.hpp"
#include "rigor/contact/single_collision.hpp"

#include <optional>

namespace rigor {

ImpactSolution solve_impact(const ContactSystem& system, const std::vector<double>& restitutions,
                            RestitutionLaw collision_law, SimultaneousLaw law) {
  const ImpactProblem problem = make_impact_problem(system, restitutions);
  if (problem.count() == 1) return resolve_lone_contact(problem, collision_law);
  if (law == SimultaneousLaw::lcp) return solve_newton_impacts(problem);
  if (const std::optional<ImpactSolution> single = find_single_collision(problem, collision_law))
    return *single;
  return law == SimultaneousLaw::sequential ? solve_sequential_impacts(problem, collision_law)
                                            : solve_reflections(problem);
}

}  // namespace rigor
