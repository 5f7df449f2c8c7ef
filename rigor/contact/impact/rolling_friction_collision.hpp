#pragma once

#include "rigor/contact/impact/collision.hpp"

namespace rigor {

/// A contact at an instant of impact that resists rolling and spinning too. All in the contact frame; the
/// relative motion of B against A is (u, ω), the impulse on B (λ, l), and (Δu, Δω) = K (λ, l).
struct RollingFrictionCollision {
  Mat6 K;                   ///< Symmetric, positive semidefinite; its first block is CollisionMatrix::K.
  Vec3 u;                   ///< [m/s].
  Vec3 w;                   ///< Relative angular velocity [rad/s]: rolling about t1 and t2, spinning about n.
  double mu;                ///< Sliding: |λ_t| ≤ μ λ_n.
  double rolling_friction;  ///< Rolling: |l_t| ≤ ρ λ_n [m].
  double torsional_friction;  ///< Spinning: |l_n| ≤ σ λ_n [m].
  double restitution = 0;
};

struct RollingFrictionOutcome {
  Vec3 u, w;             ///< After.
  Vec3 lambda, moment;   ///< Impulse [N s] and angular impulse [N m s] on B.
  double energy_change;  ///< ½ (λ·(u⁻ + u⁺) + l·(ω⁻ + ω⁺)) [J].
  bool is_resolved;
};

/// The impact of resolve_collision with three independent frictions (sliding, rolling, spinning), each
/// opposed to its own motion with its greatest value, or holding it at rest with less. With dp = dλ_n:
///
///   d(u, ω)/dp = K (-μ û, 1, -ρ ŵ_t, -σ sign ω_n).
///
/// Integrated with Dormand and Prince's method of order 5 between the instants at which one of the three
/// stops or starts; errors below 1e-9 of the velocities. What starts and what stays at rest is the solution
/// of least energy rate (unique, a convex problem). Source: the three frictions as dissipation in discs and
/// an interval: Leine and Glocker, A Set-Valued Force Law for Spatial Coulomb-Contensou Friction, Eur. J.
/// Mech. A/Solids 22, 2003, without the coupling of sliding and spinning there.
RollingFrictionOutcome resolve_rolling_friction_collision(const RollingFrictionCollision& collision,
                                                          RestitutionLaw law);

}  // namespace rigor
