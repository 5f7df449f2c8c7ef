#pragma once

#include "rigor/dynamics/body_phase.hpp"
#include "rigor/dynamics/environment.hpp"

namespace rigor {

/// Phase after h [s] under a drag, and a force and a torque about the centre of mass that are constant over
/// it (in W): the flow that exponential integrators take for the linear part, so that no drag bounds a step.
///
/// Translation is exact: with γ the rate of the drag, z = γ h, φ₁ = (1 - e⁻ᶻ)/z and φ₂ = (1 - φ₁)/z,
///
///   P⁺ = e⁻ᶻ P + h φ₁ f,    x⁺ = x + (h φ₁ P + h² φ₂ f)/m.
///
/// So is rotation without torque if all three rates c/I_k + angular damping agree, since Euler's equations
/// are homogeneous of degree 2: L decays by e^(-λ t), and the attitude is that of the free rotation at the
/// time (1 - e^(-λ t))/λ. What the rates differ by, and torques, act in halves before and after it (order 2).
///
/// Source of the φ functions: M. Hochbruck, A. Ostermann, Exponential integrators, Acta Numerica 19, 2010.
BodyPhase drag_flow(const BodyInertia& inertia, const Environment::DragRates& drag, const Wrench& force,
                    const BodyPhase& start, double h);

}  // namespace rigor
