#pragma once

#include "rigor/contact/impact/impact_problem.hpp"

namespace rigor {

/// Newton's law with Coulomb friction on all contacts at once, one complementarity problem:
///
///   w = u⁺ + e min(0, u_n⁻) n,   0 ≤ λ_n ⊥ w_n ≥ 0,   λ in the cones, friction against u_t⁺.
///
/// The bound is max(0, -e u_n⁻): what parted before may not approach afterwards. Where such a contact is
/// pressed, and with friction, the energy can grow; and a chain of touching balls moves off as one block.
/// Source: Glocker and Pfeiffer, Multiple Impacts with Friction in Rigid Multibody Systems, Nonlinear
/// Dynamics 7, 1995.
ImpactSolution solve_newton_impacts(const ImpactProblem& problem);

}  // namespace rigor
