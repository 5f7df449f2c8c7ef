#pragma once

#include "rigor/contact/impact/collision.hpp"

namespace rigor {

struct AlgebraicOutcome {
  Vec3 u = Vec3::Zero();       ///< Relative velocity of B against A after, contact frame [m/s].
  Vec3 lambda = Vec3::Zero();  ///< Impulse on B, contact frame [N s].
  double energy_change = 0;    ///< ½ λ·(u⁻ + u⁺) [J].
  /// k, the share of what brings the frictionless plastic impulse to the sticking one; 1 + e_t unless
  /// friction limits it.
  double share = 0;
  bool is_limited = false;  ///< By the friction cone.
};

/// The impact as two linear problems, without a path in between. With the impulse that stops the normal
/// motion without friction, P_I = -(u_n/κ) n, and the one that stops all, P_II = -K⁻¹ u,
///
///   λ = (1 + e) P_I + k (P_II - P_I),   k = 1 + e_t, or less so that |λ_t| ≤ μ λ_n.
///
/// e_t in [-1, 1] is a restitution of the tangential motion: -1 without friction, 0 sticks, and 1 with e = 1
/// and enough friction reverses u, as Garwin's superball does. Since P_I and P_II - P_I are orthogonal in K,
/// u_n⁺ = -e u_n⁻ exactly and the energy lost is ½ (1 - e²) P_Iᵀ K P_I + ½ k (2 - k) (P_II - P_I)ᵀ K (P_II -
/// P_I) ≥ 0. It is fast, but not Coulomb's friction at every instant. Needs K positive definite (asserted).
///
/// Source: Chatterjee and Ruina, A New Algebraic Rigid-Body Collision Law Based on Impulse Space
/// Considerations, J. Appl. Mech. 65, 1998; Garwin, Kinematics of an Ultraelastic Rough Ball, Am. J. Phys.
/// 37, 1969.
AlgebraicOutcome resolve_algebraic_impact(const Collision& collision, double tangential_restitution);

}  // namespace rigor
