#pragma once

#include "rigor/solver/coulomb/coulomb_problem.hpp"

#include <functional>

namespace rigor {

/// Friction with two coefficients: what sticks may be held with up to μ_s λ_n, what slips is braked with μ
/// λ_n.
struct StaticFriction {
  std::vector<double> mu;         ///< Of sliding, one per contact.
  std::vector<double> mu_static;  ///< Of sticking, ≥ mu.
  std::vector<bool> sticks;       ///< Whether the contact stuck before (at the start of the step).
};

struct StaticFrictionSolution {
  CoulombSolution solution;
  std::vector<double> mu;  ///< The coefficient that each contact has in it.
  int rounds;              ///< Problems that were solved.
};

/// Coulomb's problem with these coefficients; `solve` solves it with one coefficient per contact. Contacts
/// that stuck before get μ_s at first, the others μ. A contact that slips though it has μ_s has broken loose:
/// it gets μ, and the problem is solved again, until none does; so there are at most n + 1 rounds. In the end
/// every slipping contact has μ, and every one with μ_s sticks (or is open). A contact that slipped before
/// needs no more than μ to come to rest and may take μ_s only in the next step.
StaticFrictionSolution solve_static_friction(
    const StaticFriction& friction,
    const std::function<CoulombSolution(const std::vector<double>& mu)>& solve);

}  // namespace rigor
