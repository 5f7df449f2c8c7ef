#pragma once

#include "rigor/sim/event_driven/event_driven_stepper.hpp"

namespace rigor {

/// Impulses for contact in transition, constraints for contact that lasts and for joints.
///
/// A contact is in transition as long as the bodies bounce: then an event is the collision of one pair,
/// whatever else its bodies touch, and collisions at one instant follow one another, the fastest first. It
/// lasts from the impact on that ends its bounces (docs/theory/events.md), if the acceleration problem with
/// the contact active finds a force that presses; then it is a constraint with the others of its group, as in
/// the event-driven scheme, until its force ends. What an impact reaches is the group of lasting contacts of
/// the two bodies; bodies that only pass by are not in it. In that impact contacts that last are constraints
/// as joints are: they do not bounce, unless their restitution is 1.
///
/// Source: Mirtich, Hybrid Simulation: Combining Constraints and Impulses, First Workshop on Simulation and
/// Interaction in Virtual Environments, 1995; the admission by forces and the end of the bounces are ours
/// (docs/theory/hybrid.md).
class HybridStepper : public EventDrivenStepper {
 public:
  /// target_step H > 0 [s]: the longest step of bodies whose motion has no closed form.
  HybridStepper(std::shared_ptr<const Model> model, const Method& method, double target_step);

 protected:
  bool is_in_transition(const std::vector<Contact>& contacts) const override;
  bool apply_impulses(Cluster& part) override;

 private:
  void hold_lasting(const std::pair<int, int>& pair, Cluster& part);
  void collide(const std::pair<int, int>& pair, Cluster& part);

  RestitutionLaw law_;
  double resting_velocity_;
};

}  // namespace rigor
