#include "rigor/contact/impact/impact.hpp"

#include "rigor/contact/impact/newton_impacts.hpp"
#include "rigor/contact/impact/reflections.hpp"
#include "rigor/contact/impact/rolling_friction_collision.hpp"
#include "rigor/contact/impact/sequential_impacts.hpp"
#include "rigor/contact/impact/single_collision.hpp"
#include "rigor/contact/impact/velocity_projection.hpp"
#include "rigor/contact/resting/rolling_friction.hpp"
#include "rigor/core/index.hpp"

#include <array>
#include <cstddef>
#include <optional>

namespace rigor {

namespace {

ImpactSolution reflected(const ContactSystem&, const ImpactProblem& problem, RestitutionLaw) {
  return solve_reflections(problem);
}
ImpactSolution by_newton_on_all(const ContactSystem&, const ImpactProblem& problem, RestitutionLaw) {
  return solve_newton_impacts(problem);
}
ImpactSolution in_sequence(const ContactSystem&, const ImpactProblem& problem, RestitutionLaw collision_law) {
  return solve_sequential_impacts(problem, collision_law);
}
ImpactSolution projected(const ContactSystem& system, const ImpactProblem& problem, RestitutionLaw) {
  return solve_projection(system, problem);
}
ImpactSolution by_moreau(const ContactSystem& system, const ImpactProblem& problem, RestitutionLaw) {
  return solve_moreau(system, problem);
}

/// A new law is one more row here.
constexpr std::array simultaneous_table = {
    SimultaneousRule{SimultaneousLaw::reflections, "reflections",
                     "repeated reflections until nothing approaches",
                     "Smith, Kaufman, Vouga, Tamstorf and Grinspun, Reflections on Simultaneous Impact, 2012",
                     true, reflected},
    SimultaneousRule{SimultaneousLaw::lcp, "lcp", "all impacts of an instant in one complementarity problem",
                     "Glocker and Pfeiffer, Multiple Impacts with Friction in Rigid Multibody Systems, 1995",
                     false, by_newton_on_all},
    SimultaneousRule{SimultaneousLaw::sequential, "sequential",
                     "one impact after the other, the fastest first",
                     "Hahn, Realistic Animation of Rigid Bodies, 1988", true, in_sequence},
    SimultaneousRule{SimultaneousLaw::projection, "projection",
                     "nearest admissible velocities, Newton's -e u_n at each contact; can gain energy",
                     "Redon, Kheddar and Coquillart, Gauss' Least Constraints Principle and Rigid Body "
                     "Simulations, 2002",
                     false, projected},
    SimultaneousRule{SimultaneousLaw::moreau, "moreau",
                     "projection on velocities, passed beyond by e; the energy never grows",
                     "Moreau, Unilateral Contact and Dry Friction in Finite Freedom Dynamics, 1988", false,
                     by_moreau},
};

constexpr bool simultaneous_table_is_in_order() {
  for (std::size_t i = 0; i < simultaneous_table.size(); ++i) {
    if (at(simultaneous_table[i].law) != i) return false;
  }
  return true;
}
static_assert(simultaneous_table.size() == at(SimultaneousLaw::count), "every SimultaneousLaw needs one row");
static_assert(simultaneous_table_is_in_order(), "the rows stand in the order of the enumerators");

ImpactSolution resolve_rolling_contact(const ContactSystem& system, double restitution, RestitutionLaw law) {
  const Contact& contact = system.contacts.front();
  const RollingFrictionOutcome outcome =
      resolve_rolling_friction_collision({rolling_friction_delassus(system, 0), relative_velocities(system),
                                          relative_angular_velocity(system, 0), contact.friction,
                                          contact.rolling_friction, contact.torsional_friction, restitution},
                                         law);
  return {outcome.lambda, 0, outcome.is_resolved, 1, outcome.moment};
}

}  // namespace

std::span<const SimultaneousRule> simultaneous_rules() {
  return simultaneous_table;
}

ImpactSolution solve_impact(const ContactSystem& system, const std::vector<double>& restitutions,
                            RestitutionLaw collision_law, SimultaneousLaw law) {
  // A contact that is alone is one collision, with rolling friction where its materials have it.
  if (system.contacts.size() == 1 && resists_rotation(system.contacts.front()))
    return resolve_rolling_contact(system, restitutions[0], collision_law);
  const ImpactProblem problem = make_impact_problem(system, restitutions);
  if (problem.count() == 1) return resolve_lone_contact(problem, collision_law);

  // Several contacts are one collision where a patch of them carries it all; else the law for several
  // decides.
  const SimultaneousRule& rule = simultaneous_table[at(law)];
  if (rule.joins_contacts) {
    if (const std::optional<ImpactSolution> single = find_single_collision(problem, collision_law))
      return *single;
  }
  return rule.solve(system, problem, collision_law);
}

}  // namespace rigor
