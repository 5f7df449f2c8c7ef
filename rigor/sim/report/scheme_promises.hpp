#pragma once

#include <limits>

namespace rigor {

/// What a scheme guarantees of any run in a scene: each room of a scheme says it of its own, and the Auditor
/// compares. The defaults are those of schemes that solve their problems to rounding and integrate to a
/// tolerance: a millionth is what no method that deserves its name exceeds.
struct SchemePromises {
  /// Forces act as impulses of whole steps: of what they hand over and contacts take back in one, a body at
  /// rest shows nothing but its rounding.
  bool acts_in_steps = true;
  /// Whether all work done from outside is in the report; if not, nothing is promised about the energy.
  bool knows_work = true;
  /// Unexplained rise of the energy, relative to the energies of the run and `energy_floor`.
  double energy_share = 1e-6;
  double energy_floor = 0;  ///< [J].
  /// Error of the momenta, relative to those of the run.
  double momentum_share = 1e-6;
  /// The same of the linear momentum where velocities are rounded in every sweep over the contacts, relative
  /// to what was rounded (AdvanceReport::rounded_momentum). A body that rests or rolls is rounded to the same
  /// side in every step. 0: they are not.
  double rounding_share = 0;
  /// Error of the momenta besides, relative to the impulse Σ m g T that the weights of all bodies give in a
  /// run of T: bodies that joints and contacts hold at rest show no momentum, but in each step h the weight
  /// gives m g h and what holds takes it back. Each of the operations in between rounds by at most u
  /// = 1.1e-16 of m g h, always to the same side at rest, so that any number of steps leaves their count
  /// times u of m g T. The default is for 90 of them; bodies on bodies round what they hand down, too.
  double weight_share = 1e-14;
  /// How well contact forces determine accelerations, as a share of those of the bodies' weights.
  double force_uncertainty = 0.1;
  double joint_drift = 0;                                        ///< Of any joint [m or rad].
  double penetration = std::numeric_limits<double>::infinity();  ///< Of any pair of bodies [m].
  /// The same as a share of the thickness of the thinner body: deeper overlaps have lost their sides.
  double penetration_share = 0.1;
};

/// What a run can promise of which each of the two has carried a part: the weaker of both, one by one.
SchemePromises weaker_of(const SchemePromises& a, const SchemePromises& b);

}  // namespace rigor
