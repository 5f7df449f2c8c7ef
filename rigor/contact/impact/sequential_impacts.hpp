#pragma once

#include "rigor/contact/impact/collision.hpp"
#include "rigor/contact/impact/impact_problem.hpp"

namespace rigor {

/// One impact after the other at the same instant: always the contact that closes fastest, by its own
/// collision, until none approaches. Contacts that close equally fast (relative 1e-12) and act on one another
/// collide together: as one patch if they are one, else by reflections; so neither order nor names matter.
/// After a thousand impacts for each contact the rest ends in a plastic impact.
/// Source: Hahn, Realistic Animation of Rigid Bodies, SIGGRAPH 1988; the order and the ties are ours.
ImpactSolution solve_sequential_impacts(const ImpactProblem& problem, RestitutionLaw law);

}  // namespace rigor
