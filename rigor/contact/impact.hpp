#pragma once

#include "rigor/contact/collision.hpp"
#include "rigor/contact/impact_problem.hpp"

#include <vector>

namespace rigor {

/// How several impacts at one instant are resolved.
enum class SimultaneousLaw {
  reflections,  ///< Generalised reflections blended with the plastic impact: symmetric, never gains energy.
  lcp,  ///< Newton's law on all contacts at once: may gain energy and transmits too little through chains.
  sequential,  ///< One after the other, the fastest first.
};

/// Impulses that end the approach of all contacts of a connected system.
///
/// restitutions: e of each contact, as it is to be used here. One contact collides by `collision_law`,
/// whatever the SimultaneousLaw. So does a patch of points of one pair of bodies, or a contact whose
/// collision makes no other approach (single_collision.hpp), but under `lcp`, which takes all contacts of a
/// system at once. Rolling and torsional friction count where a contact collides alone
/// (moment_collision.hpp). Else `law` decides (reflections.hpp, newton_impacts.hpp, sequential_impacts.hpp).
ImpactSolution solve_impact(const ContactSystem& system, const std::vector<double>& restitutions,
                            RestitutionLaw collision_law, SimultaneousLaw law);

}  // namespace rigor
