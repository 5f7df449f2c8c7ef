#pragma once

#include "rigor/math/types.hpp"

namespace rigor {

/// Outcome of a discrete Moser-Veselov step.
struct [[nodiscard]] MoserVeselovStep {
  Quat q_WB;        ///< After the step; the start if not converged.
  bool converged;   ///< False if h |ω| is too large (the increment would reach half a turn).
  double residual;  ///< |residual of the equation| / |h M|.
  int iterations;   ///< Newton steps.
};

/// One torque-free step h of the discrete Moser-Veselov equations. With M = Rᵀ L and J = ½ tr(I) 1 - I, the
/// increment F in R ← R F solves
///
///   h M~ = F J - J Fᵀ,
///
/// which for F with the unit quaternion (√(1 - |e|²), e) is h M = 2 √(1 - |e|²) I e + 2 e × I e; solved for e
/// by Newton's method to rounding. L_W is constant exactly and the energy is kept to rounding; symplectic,
/// order 2.
/// Source: J. Moser and A. P. Veselov, Discrete versions of some classical integrable systems and
/// factorization of matrix polynomials, Commun. Math. Phys. 139, 1991. Written in quaternions here.
MoserVeselovStep moser_veselov_step(const Vec3& moments, const Quat& q_WB, const Vec3& L_W, double h);

}  // namespace rigor
