#pragma once

#include "rigor/model/model.hpp"
#include "rigor/sim/fixed_steps/stepper.hpp"
#include "rigor/sim/witness/passage_witness.hpp"

#include <memory>

namespace rigor {

/// The loop that all schemes of fixed steps share: it divides the span into equal steps (FixedSteps) and asks
/// the scheme to take them one by one, until the end is reached, the scheme stops, or the caller interrupts.
/// A scheme supplies what happens before the first step, in a step, and after the last one.
class FixedStepStepper : public Stepper {
 protected:
  /// target_step > 0 [s].
  FixedStepStepper(std::shared_ptr<const Model> model, double target_step);

  /// No fixed step is longer [s].
  virtual double longest_step() const { return target_step_; }
  /// Takes over the State before the first step, which ends at this time [s].
  virtual void begin_span(double first_end, State& state) = 0;
  /// Moves from t towards the end of a fixed step. Returns the time reached [s]: a scheme may divide the
  /// step, and is then asked again. If it cannot continue, `report_.reason` says why.
  virtual double step_towards(double t_end, double t, State& state) = 0;
  /// Brings the State to the time reached, where the scheme keeps its bodies elsewhere during a span.
  virtual void show_step([[maybe_unused]] double t, [[maybe_unused]] State& state) {}
  /// Completes the State at the time reached [s], also after a stop.
  virtual void end_span(double t, State& state) = 0;

  /// Puts kinematic and fixed bodies where they are at the State's time.
  void write_prescribed_bodies(State& state) const;

  AdvanceReport advance_span(State& state, double t_end) final;
  double time_reached() const final { return t_; }

  std::shared_ptr<const Model> model_;
  double target_step_;
  AdvanceReport report_;

 private:
  PassageWitness witness_;
  double t_ = 0;
};

}  // namespace rigor
