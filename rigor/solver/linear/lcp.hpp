#pragma once

#include "rigor/math/types.hpp"

namespace rigor {

/// The two methods by name.
enum class LcpName { dantzig, lemke };

/// Solution of the linear complementarity problem  w = M z + q,  0 ≤ z ⊥ w ≥ 0.
struct LcpSolution {
  VecX z;
  VecX w;           ///< M z + q.
  double residual;  ///< Largest |min(z_i M_ii, w_i)|, relative to the largest term max(|q|, |M| |z|).
                    ///< Dimensionless.
  int pivots;
  bool converged;  ///< residual ≤ solved_residual.
};

/// Dantzig's principal pivoting for a symmetric positive semidefinite M, as in Baraff 1994 (resting contacts
/// without friction): one index at a time is driven to w_i = 0 while the others keep complementarity. M may
/// be singular (redundant contacts): w is unique then, z one of many. Not converged: there is no solution (q
/// points out of the range), or round-off made the pivots cycle. An unsymmetric M (contacts that slide) is
/// tried alike, without a promise: the pivots may run into one another or find no end.
LcpSolution lcp_dantzig(const MatX& M, const VecX& q);

/// Lemke's method with lexicographic ratio test for any square M; solves every P-matrix and every
/// copositive-plus problem that has a solution. Not converged: it ended on a secondary ray (for slipping
/// contacts: Painlevé's paradox).
LcpSolution lcp_lemke(const MatX& M, const VecX& q);

}  // namespace rigor
