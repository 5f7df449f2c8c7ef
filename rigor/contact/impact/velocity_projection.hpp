#pragma once

#include "rigor/contact/impact/impact_problem.hpp"

namespace rigor {

/// Several impacts at one instant as a projection on velocities, in motion space (A = J M⁻¹ Jᵀ is not
/// formed): Gauss' principle of least constraint for velocities takes, of all velocities that the contacts
/// allow, those nearest to the ones before in the kinetic metric,
///
///   V⁺ = argmin ½ (V - V⁻)ᵀ M (V - V⁻)   where   J_n V ≥ c,   c = max(0, -e u_n⁻) at each contact.
///
/// These are the velocities of Newton's law on all contacts (solve_newton_impacts), which without friction
/// are unique; the multipliers are the impulses λ, of least norm where contacts are redundant. The kinetic
/// energy changes by
///
///   ΔT = ½ Σ λ_n (u_n⁻ + u_n⁺):   -½ (1 - e) λ_n |u_n⁻| of a contact that approached, ½ λ_n u_n⁻ of one that
///
/// was parting and is pressed, so that it can grow. Coulomb's friction makes it a sequence of projections
/// (solve_in_motion_space). What motion space does not solve is left to contact space.
///
/// `problem` is that of the system's contacts. Source: Redon, Kheddar and Coquillart, Gauss' Least
/// Constraints Principle and Rigid Body Simulations, ICRA 2002.
ImpactSolution solve_projection(const ContactSystem& system, const ImpactProblem& problem);

/// The projection with restitution that never adds energy, after Moreau: with P the projection on what the
/// contacts allow (c = 0),
///
///   V⁺ = V⁻ + (1 + e) (P V⁻ - V⁻).
///
/// P V⁻ is orthogonal to V⁻ - P V⁻ in the kinetic metric, as the constraints are a cone, so that without
/// friction ΔT = -(1 - e²) D with D = T(V⁻) - T(P V⁻), the energy that the projection takes. A contact that
/// was parting may approach then; the reflection 2 P - 1 is therefore repeated until none does, and the
/// impulses are blended with the plastic ones, as those of generalised reflections are
/// (blend_with_plastic): friction, unlike e, and the proof that the energy never grows are the same.
///
/// Source: Moreau, Unilateral Contact and Dry Friction in Finite Freedom Dynamics, CISM 302, 1988; the
/// repetition and the blend are ours (docs/theory/simultaneous_impacts.md).
ImpactSolution solve_moreau(const ContactSystem& system, const ImpactProblem& problem);

}  // namespace rigor
