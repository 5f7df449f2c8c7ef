#pragma once

#include "rigor/dynamics/integrator.hpp"

#include <span>
#include <vector>

namespace rigor {

/// q_WB after a torque-free step h by Strang's splitting of the kinetic energy Σ Mᵢ²/2Iᵢ: rotations for
/// h/2 about the body's first and second axis, for h about the third, for h/2 about the second and first,
/// each the exact flow of its term (angle h Mᵢ/Iᵢ). L_W is constant exactly; time-reversible, symplectic, the
/// energy error is bounded without drift. Order 2. Source: A. Dullweber, B. Leimkuhler, R. McLachlan,
/// Symplectic splitting methods for rigid body molecular dynamics, J. Chem. Phys. 107, 1997.
Quat rotate_by_splitting(const Vec3& moments, const Quat& q_WB, const Vec3& L_W, double h);

/// The same composed to order 4: Strang's step with p h, p h, (1 - 4p) h, p h, p h, p = 1/(4 - ∛4).
/// Source: M. Suzuki, Fractal decomposition of exponential operators, Phys. Lett. A 146, 1990.
Quat rotate_by_splitting4(const Vec3& moments, const Quat& q_WB, const Vec3& L_W, double h);

/// One leapfrog step of a system under forces that depend on time and configuration: half a kick of P and L;
/// x along a straight line and q by Strang's splitting for h; half a kick again. Order 2, time-reversible,
/// symplectic for forces from a potential. (Forces that depend on velocity would make it implicit; here they
/// are evaluated at the momenta before each half kick, which is of order 1.)
std::vector<BodyPhase> leapfrog_step(std::span<const BodyInertia> inertias, std::span<const BodyPhase> start,
                                     double t, double h, const WrenchField& wrenches);

/// Leapfrog composed to order 4 by Suzuki's fractions.
std::vector<BodyPhase> leapfrog4_step(std::span<const BodyInertia> inertias, std::span<const BodyPhase> start,
                                      double t, double h, const WrenchField& wrenches);

}  // namespace rigor
