#pragma once

#include "rigor/solver/linear/contact_motion.hpp"

#include <vector>

namespace rigor {

/// Friction whose bounds are known.
struct BoundedFriction {
  VecX lambda;      ///< 3n tangential impulses, |λ_t| ≤ bound; normal entries are zero.
  double residual;  ///< Of the natural map λ_t - proj(λ_t - ρ w_t), as a speed, relative to the largest term.
  int iterations;  ///< Proximal points.
};

/// Of all tangential impulses with |λ_t,i| ≤ bounds_i [N s] those that leave the least energy: friction where
/// the normal impulses are known. `u` (3n): the relative velocities [m/s] without friction, of which the
/// tangential ones count; `motion` says how contacts answer, with joints. The motion is unique. Of the shares
/// that redundant contacts may have it is the one to which proximal points from no friction lead, which
/// follows the symmetry of the problem and not the order of its contacts.
///
/// The problem is convex: minimise λ·(u + ½ A λ) over a product of disks. It is solved in its dual, over
/// motions v, by the augmented Lagrangian: with λ⁰ the impulses so far,
///   v = argmin ½ vᵀM v + Σ ψ_i(λ⁰_i - ρ_i (J_i v + u_i)) / ρ_i,   λ = proj(λ⁰ - ρ (J v + u)),
/// ψ_i(x) = ½ |x|² inside the disk and r_i |x| - ½ r_i² beyond it, whose gradient is the projection. The
/// Newton matrix M + Jᵀ D J is always definite, however redundant the contacts.
///
/// Source: Rockafellar, Augmented Lagrangians and Applications of the Proximal Point Algorithm in Convex
/// Programming, Math. Oper. Res. 1(2), 1976.
BoundedFriction solve_bounded_friction(const ContactMotion& motion, const VecX& u,
                                       const std::vector<double>& bounds);

}  // namespace rigor
