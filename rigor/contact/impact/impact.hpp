#pragma once

#include "rigor/contact/impact/collision.hpp"
#include "rigor/contact/impact/impact_problem.hpp"

#include <vector>

namespace rigor {

/// How several impacts at one instant are resolved.
enum class SimultaneousLaw {
  reflections,  ///< Generalised reflections blended with the plastic impact: symmetric, never gains energy.
  lcp,  ///< Newton's law on all contacts at once: may gain energy and transmits too little through chains.
  sequential,  ///< One after the other, the fastest first.
  projection,  ///< The velocities of lcp as the nearest that the contacts allow, in motion space.
  moreau,      ///< The same projection, passed beyond by e: never gains energy.
};

/// Impulses that end the approach of all contacts of a connected system.
///
/// restitutions: e of each contact, as it is to be used here. One contact collides by `collision_law`,
/// whatever the law for several (Newton's can gain energy with friction). So does, under `reflections` and
/// `sequential`, what is one collision among several contacts (find_single_collision). Else `law` decides:
/// solve_reflections, solve_newton_impacts, solve_sequential_impacts, solve_projection, solve_moreau. Rolling
/// and torsional friction count where a contact is alone in its system (moment_collision.hpp).
/// docs/theory/simultaneous_impacts.md compares them.
ImpactSolution solve_impact(const ContactSystem& system, const std::vector<double>& restitutions,
                            RestitutionLaw collision_law, SimultaneousLaw law);

}  // namespace rigor
