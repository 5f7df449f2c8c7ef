#pragma once

#include "rigor/contact/impact/collision.hpp"
#include "rigor/contact/impact/impact_problem.hpp"
#include "rigor/contact/impact/simultaneous_law.hpp"

#include <vector>

namespace rigor {

/// Impulses that end the approach of all contacts of a connected system.
///
/// restitutions: e of each contact, as it is to be used here. A contact that is alone collides by
/// `collision_law`, whatever the law for several (Newton's can gain energy with friction). The same holds,
/// under `reflections` and `sequential`, for several contacts that make one collision
/// (find_single_collision). Otherwise `law` decides (simultaneous_rules). Rolling and torsional
/// friction count where a contact is alone in its system (rolling_friction_collision.hpp).
/// docs/theory/simultaneous_impacts.md compares the laws.
ImpactSolution solve_impact(const ContactSystem& system, const std::vector<double>& restitutions,
                            RestitutionLaw collision_law, SimultaneousLaw law);

}  // namespace rigor
