#pragma once

#include "rigor/solver/runge_kutta.hpp"

namespace rigor {

/// One step of RODAS, a linearly implicit method of order 4 for stiff equations ẏ = f(t, y): six stages with
/// one matrix,
///
///   (1/(γ h) - J) uᵢ = f(t + αᵢ h, y + Σ aᵢⱼ uⱼ) + Σ cᵢⱼ uⱼ / h + γᵢ h f_t,    J = ∂f/∂y,
///
/// L-stable and stiffly accurate: what decays faster than the step resolves has decayed at its end. The last
/// stage is its error of order 3; the continuous extension is a cubic. J may be approximate, which costs
/// order only. f_t: ∂f/∂t at (t, y).
///
/// Source: E. Hairer and G. Wanner, Solving Ordinary Differential Equations II, 2nd ed. 1996, IV.7 and VI.4
/// with the coefficients of their method RODAS.
RungeKuttaStep rodas_step(const OdeFunction& f, const MatX& J, const VecX& f_t, double t, const VecX& y,
                          double h);
inline constexpr int rodas_order = 4;

}  // namespace rigor
