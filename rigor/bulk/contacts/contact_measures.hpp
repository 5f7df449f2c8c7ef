#pragma once

#include "rigor/bulk/contacts/solved_manifold.hpp"
#include "rigor/bulk/state/bulk_bodies.hpp"

namespace rigor {

/// The centre of a manifold from that of body A, in W [m], where it was found: without the turn of its arm by
/// BulkBodies::tilts.
Vec3 found_arm(const SolvedManifold& manifold, const BulkBodies& bodies);

/// All that a manifold did to body B in a step: the impulse at its centre [N s] and the moment of it about
/// the centre [N m s], in W. Body A has got the opposite.
struct ManifoldWrench {
  Vec3 impulse, moment;
};
ManifoldWrench total_wrench(const SolvedManifold& manifold);

/// Work of a manifold on the dynamic one of its bodies, if the other moves as it must [J]; else 0. Velocities
/// of that and arms are constant in a step.
double work_of_mover(const SolvedManifold& manifold, const BulkBodies& bodies);

/// The fastest approach of its points at the beginning of the step [m/s], >= 0, of points that were pressed
/// in it; 0 if none was.
double approach_speed(const SolvedManifold& manifold);

}  // namespace rigor
