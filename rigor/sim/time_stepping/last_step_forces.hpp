#pragma once

#include "rigor/contact/system/contact_system.hpp"
#include "rigor/sim/pairs/touching_points.hpp"

#include <vector>

namespace rigor {

/// The contact forces of the last step, from which the solver of the next one begins: those of bodies at rest
/// stay the same.
class LastStepForces {
 public:
  /// In any order; those that are not known are left out.
  void remember(std::vector<ContactForce> forces);
  /// As they were remembered, in the order of their contacts.
  const std::vector<ContactForce>& all() const { return forces_; }
  /// The impulses that these forces give over h [s] to the contacts of a system, in their frames (3n) [N s]:
  /// each to its contact, or, where other features meet now, to the nearest one of its pair. Of faces whose
  /// edges lie on each other rounding decides which features meet. Empty if no pair has a force.
  VecX impulses(double h, const ContactSystem& system) const;

 private:
  std::vector<ContactForce> forces_;
};

}  // namespace rigor
