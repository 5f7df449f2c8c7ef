#pragma once

#include "rigor/bulk/contacts/contact_measures.hpp"
#include "rigor/bulk/state/bulk_bodies.hpp"
#include "rigor/bulk/state/held_bodies.hpp"

namespace rigor {

/// Whether a manifold has points that bounce: they met in the step faster than they may rest, and were
/// pressed.
bool bounces(const SolvedManifold& manifold);

/// Energy that the normal impulses of a manifold took from its bodies in a step, at least 0 [J]:
///
///   -½ Σ λ (u⁻ + u)
///
/// λ: impulses of the step, u⁻ and u: normal velocities of the points when they met and now. Arms and normals
/// stay for the whole step, so that ½ Σ λ (u⁻ + u) over all that acts is the change of the kinetic energy.
/// `accelerations`: by forces, of each body.
double energy_taken(const SolvedManifold& manifold, const std::vector<MotionRow>& accelerations,
                    const BulkBodies& bodies);

/// Lets the points of a manifold that bounce part at e times the speed at which they met (Newton), as far as
/// that costs no more than the energy `most` [J]; other points that were pressed are held. Friction is that
/// of the whole impact: with all normal impulses, those of the step and those of the bounce, it stops as much
/// of the slip as they bear (Coulomb). The energy is that of the bodies in their present orientations, less
/// the work of one that moves as it must. Changes velocities of its bodies, and strikes held ones, off which
/// others bounce as off what moves as it must; returns the impulses that it adds [N s, N m s].
///
/// Source: Pfeiffer and Glocker, Multibody Dynamics with Unilateral Contacts, 1996, chapter 8, for Newton's
/// law with several points; the bound of the energy is ours.
ManifoldImpulses bounce(const Model& model, const SolvedManifold& manifold, double most,
                        const std::vector<MotionRow>& accelerations, HeldBodies& held, BulkBodies& bodies);

}  // namespace rigor
