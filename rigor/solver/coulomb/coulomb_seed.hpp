#pragma once

#include "rigor/solver/coulomb/coulomb_guess.hpp"
#include "rigor/solver/linear/lcp.hpp"

namespace rigor {

/// What the contacts of a problem with friction do, by a linear complementarity method: a first guess that
/// polish_coulomb makes exact.
///
/// dantzig: pivots with bounds. The normal forces first; then tangential forces between -μ λ_n and μ λ_n,
/// each driven to w_t = 0 (static friction) or to its bound, with new bounds from the new normal forces, a
/// few times. Known slips (dynamic friction) hold the friction of the round before. lemke: friction in a
/// pyramid of four sides, with the matrix of Stewart and Trinkle, of which Lemke's method always finds a
/// solution where no slip is known.
///
/// Sources: Baraff, Fast Contact Force Computation for Nonpenetrating Rigid Bodies, 1994; Stewart and
/// Trinkle, An Implicit Time-Stepping Scheme for Rigid Body Dynamics, 1996.
struct LcpSeed {
  CoulombGuess guess;
  int pivots = 0;
};
LcpSeed seed_by_lcp(const CoulombProblem& problem, LcpName name);

}  // namespace rigor
