#pragma once

#include "rigor/solver/motion/motion_modes.hpp"

#include <optional>
#include <vector>

namespace rigor {

/// Gauss' principle of least constraint with Coulomb's law: the accelerations nearest to the free ones, in
/// the metric of the masses, that the contacts allow. Works on the sparse rows and never forms A.
///
/// Without friction it is a projection on half-spaces (solve_least_constraint). Friction makes it a sequence
/// of projections: with the slips of sliding contacts held, De Saxcé's shift μ |w_t| n makes the motions
/// allowed by the other contacts a product of cones, on which the nearest point is found by an augmented
/// Lagrangian (CoulombProximal); the shift follows the motion. What the contacts seem to do is then taken as
/// equations (sticking contacts are equalities, MotionModesSystem) and checked: forces in the cones, slip
/// against friction, nothing sinks. A contact that fails moves to the mode it asks for. `start`, the modes of
/// a similar problem before, is checked first, and without one that every contact holds: most problems are
/// solved by that.
///
/// λ is of least norm as with solve_coulomb, and so are the accelerations the same; but where redundant
/// contacts slide in different directions it is of least norm for its accelerations only. Without
/// options.least_norm redundant contacts may have any share of the load. With options.resolution proximal
/// points then solve what does not hold (proximal_points.hpp): the steps of a time-stepping scheme. Else the
/// augmented Lagrangian refines the forces to round-off itself, beginning with `forces` (3n, of a similar
/// problem; or nothing): for piles of a hundred bodies and more, whose contacts are nearly all redundant; a
/// tolerance of 1e-10 is soon reached then. Nothing if it was not solved to options.tolerance: slip of
/// changing direction and jams are left to contact space.
std::optional<CoulombSolution> solve_in_motion_space(const MotionProblem& problem,
                                                     const std::vector<ContactMode>& start = {},
                                                     const CoulombOptions& options = {},
                                                     const VecX& forces = VecX());

}  // namespace rigor
