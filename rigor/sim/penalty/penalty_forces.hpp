#pragma once

#include "rigor/sim/penalty/penalty_touching.hpp"

#include <vector>

namespace rigor {

/// Forces of all penalty contacts in their frames, 3 per contact, at the velocities of the system [N].
VecX penalty_forces(const Touching& touching);

/// Moments of rolling and torsional friction.
struct PenaltyMoments {
  std::vector<Wrench> wrenches;    ///< One per body of the system; torques only.
  double power_taken = 0;          ///< From the relative rotation of the bodies [W].
  double power_of_prescribed = 0;  ///< Supplied by kinematic bodies [W].
  Vec3 external_W = Vec3::Zero();  ///< Sum of what prescribed bodies exert [N m].
};
PenaltyMoments penalty_moments(const Touching& touching, const VecX& forces);

/// The moments in steps that do not resolve bristles of angles: what stops the relative rotation within h
/// [s], up to the same limits at these forces. A body under a constant torque creeps.
PenaltyMoments stopping_moments(const Touching& touching, const VecX& forces, double h);

/// Moves the bristles with the contacts for a time h [s].
void move_bristles(double h, Touching& touching);
/// Lets the sliders slip until the bristles hold no more than friction does at the present velocities.
void slide_bristles(Touching& touching);

/// Energy in the springs [J].
struct ElasticEnergies {
  double normal = 0, bristles = 0;
};
ElasticEnergies elastic_energies(const Touching& touching);

}  // namespace rigor
