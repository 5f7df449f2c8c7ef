#pragma once

#include "rigor/dynamics/integrator.hpp"

namespace rigor {

/// One step of the semi-implicit (symplectic) Euler method: P, L ← P + h F, L + h τ with the forces at the
/// start; then x ← x + h P/m and the attitude with ω = R I_B⁻¹ Rᵀ L of the start's R and the new L: q ← q + ½
/// h (0, ω) q, normalised, or R ← R + h ω × R, by Gram-Schmidt. Linear in between. Order 1.
SystemStep semi_implicit_euler_step(OrientationForm form, std::span<const BodyInertia> inertias,
                                    std::span<const BodyPhase> start, double t, double h,
                                    const WrenchField& wrenches);

}  // namespace rigor
