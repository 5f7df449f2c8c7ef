#pragma once

#include "rigor/solver/coulomb_problem.hpp"

#include <optional>

namespace rigor {

/// The problem with its b changed by the least that lets the contacts which hold in `solution` hold together;
/// nothing if an entry would change by more than `limit`, or if they can already.
///
/// Redundant contacts can hold together only if no force that does nothing, A x = 0, asks for a motion, xᵀ b
/// = 0. Where b is known to a limit only (gaps over the step, turns of second order), such contacts
/// contradict each other by rounding, and what solves Coulomb's law exactly is full of slips of that size.
/// `hold`: λ_n > 0 or w_n ≤ limit; with all three rows if the slip is slower than the limit, else with the
/// normal one.
std::optional<CoulombProblem> with_possible_rates(const CoulombProblem& problem,
                                                  const CoulombSolution& solution, double limit);

}  // namespace rigor
