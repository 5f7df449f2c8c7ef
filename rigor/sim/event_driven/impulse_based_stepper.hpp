#pragma once

#include "rigor/sim/event_driven/event_driven_stepper.hpp"
#include "rigor/sim/event_driven/micro_collision.hpp"

namespace rigor {

/// Contact as trains of micro-collisions: bodies are always in flight, and one that lies on another bounces
/// on it inside the collision envelope. There are no contact forces and no lasting contacts; each event is
/// one collision of one pair. Times of impact wait in the event-driven scheme's queue; the windows of its
/// Trajectories are the lower bounds after which a pair is looked at again.
///
/// The envelope is the contact tolerance ε: bodies collide half of it deep, so that one that was put down at
/// gap 0 falls ε/2, is thrown back and hovers in between. Joints, their limits, motors and friction are held
/// as in the event-driven scheme: impulses at contacts cannot hold them.
///
/// Source: Mirtich and Canny, Impulse-based Simulation of Rigid Bodies, Symposium on Interactive 3D Graphics,
/// 1995; Mirtich, Impulse-based Dynamic Simulation of Rigid Body Systems, thesis, 1996.
class ImpulseBasedStepper : public EventDrivenStepper {
 public:
  /// target_step H > 0 [s]: the longest step of bodies whose motion has no closed form.
  ImpulseBasedStepper(const std::shared_ptr<const Model>& model, const Method& method, double target_step);

 protected:
  bool keeps_contacts() const override { return false; }
  bool takes_part(int a, int b) const override;
  bool apply_impulses(Cluster& part) override;

 private:
  MicroCollision micro_collision_;
};

}  // namespace rigor
