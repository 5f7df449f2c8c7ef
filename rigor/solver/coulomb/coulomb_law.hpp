#pragma once

#include "rigor/solver/coulomb/coulomb_guess.hpp"

namespace rigor {

/// Part of the largest term below which a w counts as zero, and a sign as undecided.
inline constexpr double kZeroMotion = 1e-13;

// What Coulomb's law says of forces and motions, however these were found. `laws` is a problem of which A is
// not read; `diagonal` (3n) is that of A.

/// coulomb_residual, given the size of the largest term.
double law_residual(const CoulombProblem& laws, const VecX& diagonal, double size, const VecX& lambda,
                    const VecX& w);

/// The modes that a solution's motion allows: every contact with w_n = 0 may push, every one with w = 0 may
/// stick. A slip direction is that of the friction force, which is known better than that of a slow w.
ContactModes modes_of_motion(const CoulombProblem& laws, const VecX& lambda, const VecX& w, double zero);

/// Moves each contact that breaks Coulomb's law to the mode it asks for: one that pulls opens, an open one
/// that sinks closes, one that slides backwards sticks, one that sticks outside its cone slides. `zero` is
/// the largest w that counts as none.
void move_contacts(const CoulombProblem& laws, const VecX& diagonal, const VecX& w, double zero,
                   CoulombGuess& guess);

}  // namespace rigor
