#pragma once

#include "rigor/contact/impact/restitution_law.hpp"
#include "rigor/contact/impact/slip_flow.hpp"

#include <string>
#include <vector>

namespace rigor {

/// A point of an impact path.
struct CollisionPoint {
  Vec3 u = Vec3::Zero();       ///< Relative velocity of B against A, contact frame [m/s].
  Vec3 lambda = Vec3::Zero();  ///< Impulse on B so far, contact frame [N s].
  double work = 0;             ///< W = ∫ u_n dp, work of the normal impulse [J]; negative in compression.
};

/// How one frictional impact went.
struct CollisionOutcome {
  CollisionPoint end;
  /// At the end of (the first) compression.
  CollisionPoint compression;
  double energy_change = 0;  ///< Of the kinetic energy, ½ λ·(u⁻ + u⁺) [J].
  /// What happened, in order: S slides, K sticks (to the end), U starts to slip again after it stopped, |
  /// ends a compression, r compresses again during restitution, ; begins anew (Newton's and Poisson's laws
  /// can end while the bodies still approach). Sliding that continues after | is written again.
  std::string phases;
  /// False where the normal velocity cannot be changed (K_nn = 0, singular K): nothing is applied then.
  bool is_resolved = true;
};

/// One contact at an instant of impact.
struct Collision {
  CollisionMatrix matrix;
  Vec3 u;                  ///< Relative velocity of B against A before, contact frame [m/s].
  double restitution = 0;  ///< e in [0, 1].
};

/// Integrates the impact in the normal impulse: Coulomb friction at every instant, sliding whose direction
/// rotates, stopping, sticking or starting again, compression and restitution. Nothing happens to a contact
/// that does not approach (u_n ≥ 0), except where u_n = 0 and sliding presses the bodies together (a jam).
///
/// Errors are those of rounding, about 1e-14 of the velocities times the condition of the problem: slip is
/// followed by power series (slip_power_series.hpp, asymptotic_slip.hpp), all else in closed form. If `path`
/// is given, points of the impact path are added to it: the first, and eight of each piece.
///
/// Source: Routh, Dynamics of a System of Rigid Bodies, 1905; Keller, 1986; Bhatt and Koechling, 1995;
/// Stronge, Rigid Body Collisions with Friction, Proc. R. Soc. A 431, 1990. Recompression and the jam after
/// docs/theory/impact.md.
CollisionOutcome resolve_collision(const Collision& collision, RestitutionLaw law,
                                   std::vector<CollisionPoint>* path = nullptr);

}  // namespace rigor
