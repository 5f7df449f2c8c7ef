#pragma once

#include "rigor/contact/impact/collision.hpp"

namespace rigor {

/// An impact whose contact is a spring along the normal and one along the tangent plane, k_t/k_n = `ratio`,
/// so that slip can end and reverse before the bodies part: what a superball does.
struct CompliantCollision {
  Collision collision;
  double ratio = 1;  ///< k_t/k_n > 0.
};

/// A change of the contact during a compliant impact.
struct SlipChange {
  double phase;   ///< ω_n t from the beginning of contact; compression ends at π/2 [rad].
  int direction;  ///< From then on the contact slips along u_t⁻ (1) or against it (-1), or sticks (0).
  double lambda_n = 0;  ///< Normal impulse so far [N s].
};

struct CompliantOutcome {
  CollisionPoint end;
  CollisionPoint compression;  ///< At the end of compression.
  double energy_change = 0;    ///< ½ λ·(u⁻ + u⁺) [J].
  /// False if slip and stick followed each other too often: the rest means nothing then.
  bool is_resolved = true;
  /// The first is what the contact begins with. Empty if the bodies do not approach.
  std::vector<SlipChange> changes;
};

/// What keeps the law from the impact, or empty: normal and tangential motion must be uncoupled, K_tn = 0,
/// and u_t must be an eigenvector of M = K_tt (as of any direction where two balls meet): then the motion
/// stays in a plane.
std::string check_compliant_collision(const CompliantCollision& compliant);

/// The impact of a linear contact spring with dry friction, to rounding. In units of the compression's time
/// 1/ω_n, ω_n² = κ k_n, with y = ω_n t - π/2 the normal force is
///
///   cos y in compression (y < 0),  cos(y/e) in restitution (y from 0 to e π/2),
///
/// for a restitution e in energy: unloading is stiffer by 1/e². The spring of the tangent plane (deflection
/// x, force -k_t x on B) keeps its stiffness. While the contact sticks x moves with the bodies, ẋ = u_t, and
/// is harmonic; it slips where k_t |x| would exceed μ f_n, with the force μ f_n against its slip u_t - ẋ,
/// until that comes to zero. All pieces are closed forms; where sticking ends is searched by steps that
/// cannot pass it. Needs check_compliant_collision to be empty.
///
/// Source: Maw, Barber and Fawcett, The Oblique Impact of Elastic Spheres, Wear 38, 1976, for the effect;
/// Stronge, Impact Mechanics, Cambridge University Press, 2000, for the model of two springs.
CompliantOutcome resolve_compliant_collision(const CompliantCollision& compliant,
                                             std::vector<CollisionPoint>* path = nullptr);

}  // namespace rigor
