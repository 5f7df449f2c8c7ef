#include "rigor/contact/impact/impact.hpp"

#include "rigor/contact/impact/newton_impacts.hpp"
#include "rigor/contact/impact/reflections.hpp"
#include "rigor/contact/impact/rolling_friction_collision.hpp"
#include "rigor/contact/impact/sequential_impacts.hpp"
#include "rigor/contact/impact/single_collision.hpp"
#include "rigor/contact/impact/velocity_projection.hpp"
#include "rigor/contact/resting/rolling_friction.hpp"

#include <optional>

namespace rigor {

namespace {

bool has_lone_moment(const ContactSystem& system) {
  const Contact& first = system.contacts.front();
  return system.contacts.size() == 1 && (first.rolling_friction > 0 || first.torsional_friction > 0);
}

ImpactSolution resolve_lone_moment(const ContactSystem& system, double restitution, RestitutionLaw law) {
  const Contact& contact = system.contacts.front();
  const MomentOutcome outcome = resolve_rolling_friction_collision(
      {moment_response(system, 0), relative_velocities(system), relative_turning(system, 0), contact.friction,
       contact.rolling_friction, contact.torsional_friction, restitution},
      law);
  return {outcome.lambda, 0, outcome.is_resolved, 1, outcome.moment};
}

}  // namespace

ImpactSolution solve_impact(const ContactSystem& system, const std::vector<double>& restitutions,
                            RestitutionLaw collision_law, SimultaneousLaw law) {
  if (has_lone_moment(system)) return resolve_lone_moment(system, restitutions[0], collision_law);
  const ImpactProblem problem = make_impact_problem(system, restitutions);
  if (problem.count() == 1) return resolve_lone_contact(problem, collision_law);
  if (law == SimultaneousLaw::lcp) return solve_newton_impacts(problem);
  if (law == SimultaneousLaw::projection) return solve_projection(system, problem);
  if (law == SimultaneousLaw::moreau) return solve_moreau(system, problem);
  if (const std::optional<ImpactSolution> single = find_single_collision(problem, collision_law))
    return *single;
  return law == SimultaneousLaw::sequential ? solve_sequential_impacts(problem, collision_law)
                                            : solve_reflections(problem);
}

}  // namespace rigor
