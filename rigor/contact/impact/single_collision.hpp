#pragma once

#include "rigor/contact/impact/collision.hpp"
#include "rigor/contact/impact/impact_problem.hpp"

#include <optional>

namespace rigor {

/// Exactly one contact: resolve_collision with its block of the Delassus operator.
ImpactSolution resolve_lone_contact(const ImpactProblem& problem, RestitutionLaw law);

/// The impact as one collision, where it is one: all that approaches is one contact, or a patch of contacts
/// of one pair of bodies with one normal, one μ and one e (a box that lands on an edge or a face).
///
/// A patch collides at its centre of pressure q = Σ λ_i p_i / Σ λ_i of the plastic impact (e = 0, friction as
/// Coulomb has it): u and K there are Σ w_i u_i and Σ w_i w_k A_ik with w_i = λ_i / Σ λ, since the velocity
/// of a rigid body is affine in the point. The impulse j at q acts as w_i j at the points: the same force, no
/// moment about q, every part in its cone.
///
/// Nothing is returned where the impact is several: where something approaches afterwards (by more than 1e-10
/// of the approach before), and where the points of a patch slip differently (by more than half the slip at
/// q), since one collision knows no friction against spin.
std::optional<ImpactSolution> find_single_collision(const ImpactProblem& problem, RestitutionLaw law);

}  // namespace rigor
