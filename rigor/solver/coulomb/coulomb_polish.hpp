#pragma once

#include "rigor/solver/coulomb/coulomb_guess.hpp"

namespace rigor {

/// Refines a guess to round-off: fixes what the contacts do (open, stick, slide), solves the then smooth
/// equations with Newton's method (the slip directions are unknowns), checks signs and cones, moves contacts
/// that break them to the mode they ask for, a bounded number of times, and returns the best point met. If
/// the guess had the right modes the result is a solution to round-off, with the forces of least norm among
/// those in the cones that give the same w.
CoulombSolution polish_coulomb(const CoulombProblem& problem, const CoulombGuess& guess, double tolerance);

}  // namespace rigor
