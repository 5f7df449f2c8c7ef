#pragma once

#include "rigor/contact/impact/impact_problem.hpp"

#include <functional>

namespace rigor {

/// Several impacts at one instant by generalised reflections with restitution and friction:
///
///   λ_P  plastic impulses: Coulomb's law with e = 0 on all contacts, exact cones;
///   λ_R  elastic impulses: u is reflected about all contacts that approach, until none does;
///   λ    λ_P + e (λ_R - λ_P), contact by contact; different e move towards the smallest where they would
///   give
///        back more energy than Σ e_i of what each contact's compression took;
///        then friction: of all tangential impulses |λ_t| ≤ μ λ_n those that leave the least energy;
///        then a plastic impact of the contacts that friction made approach.
///
/// Nothing approaches afterwards, momentum is exact, impulses are in the cones, and the energy never grows:
/// it is a convex function of λ that is at most its value before at λ_P and λ_R (docs/theory/
/// simultaneous_impacts.md has the proofs). At e = 0 this is λ_P, without friction and with one e it is the
/// blend of reflections. Does not depend on the order of contacts beyond round-off.
///
/// Source: Smith, Kaufman, Vouga, Tamstorf and Grinspun, Reflections on Simultaneous Impact, ACM Trans.
/// Graph. 31(4), 2012, for λ_R; the rest is ours.
ImpactSolution solve_reflections(const ImpactProblem& problem);

/// What solve_reflections does with λ_R, for any normal impulses that keep the energy: λ_P + e (λ_R - λ_P),
/// friction, and a plastic impact of what still approaches. `elastic` gives λ_R; it is asked only where a
/// contact has restitution.
ImpactSolution blend_with_plastic(const ImpactProblem& problem, const std::function<VecX()>& elastic);

/// λ_R (3n): normal impulses that keep the energy.
VecX generalised_reflections(const ImpactProblem& problem);

/// Replaces the tangential impulses by those of least energy within |λ_t| ≤ μ λ_n, λ_n held. Returns the
/// relative residual of this convex problem.
double add_friction(const ImpactProblem& problem, VecX& lambda);

}  // namespace rigor
