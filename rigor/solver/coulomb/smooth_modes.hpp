#pragma once

#include "rigor/solver/coulomb/coulomb_guess.hpp"

namespace rigor {

/// Newton's method for fixed modes: w = 0 where a contact sticks; w_n = 0, λ_t = -μ λ_n û and û parallel to
/// w_t where it slides; λ = 0 where it is open. Unknowns are the forces and the directions û of the `cone`
/// rows that slide. Steps of least norm, so redundant contacts stay near the guess. Signs and cones are not
/// checked. Returns the point of smallest error met.
CoulombGuess solve_smooth_modes(const CoulombProblem& problem, CoulombGuess guess);

/// The largest term of the sums w = A λ + b, max(|b|, |A| |λ|): what round-off of w is measured by.
double largest_term(const CoulombProblem& problem, const VecX& lambda);

}  // namespace rigor
