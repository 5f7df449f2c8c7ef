#pragma once

#include "rigor/solver/coulomb/coulomb_problem.hpp"
#include "rigor/solver/coulomb/known_modes.hpp"

namespace rigor {

/// An approximate solution: forces in their cones, and what the contacts seem to do.
struct CoulombGuess {
  VecX lambda;         ///< 3n.
  ContactModes modes;  ///< slips: opposite to the friction force.
};

/// Unit vector opposite to the friction force of λ (3); `fallback` where there is none.
Vec2 slip_of_force(const Vec3& lambda, const Vec2& fallback);

/// Whether a contact slides with friction in a direction that is to be found.
bool has_unknown_slips(const CoulombProblem& laws, const ContactModes& modes);

/// Everything open.
CoulombGuess open_guess(const CoulombProblem& problem);

/// These forces and modes, the slips of cones opposite to the friction.
CoulombGuess guess_of_forces(const CoulombProblem& problem, const VecX& lambda,
                             const std::vector<ContactMode>& modes);

/// λ with the force of each contact clamped to its cone (or, for slide rows, to its known friction
/// direction).
VecX clamp_to_cones(const CoulombProblem& problem, const VecX& lambda);

/// The solution record of forces: w, residual and whether that is small enough.
CoulombSolution make_solution(const CoulombProblem& problem, const VecX& lambda,
                              const std::vector<ContactMode>& modes, double tolerance);

}  // namespace rigor
