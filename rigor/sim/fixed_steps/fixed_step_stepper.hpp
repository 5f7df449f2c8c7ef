#pragma once

#include "rigor/model/model.hpp"
#include "rigor/sim/fixed_steps/fixed_steps.hpp"
#include "rigor/sim/fixed_steps/stepper.hpp"
#include "rigor/sim/witness/passage_witness.hpp"

#include <memory>
#include <span>
#include <vector>

namespace rigor {

/// The loop that all schemes of fixed steps share: it divides the span into equal steps (FixedSteps) and asks
/// the scheme to take them one by one, until the end is reached, the scheme stops, or the caller interrupts.
/// A scheme supplies what happens before the first step, in a step, and after the last one.
class FixedStepStepper : public Stepper {
 public:
  double time_rounding() const final { return FixedSteps::rounding * target_step_; }

 protected:
  /// target_step > 0 [s].
  FixedStepStepper(std::shared_ptr<const Model> model, double target_step);
  /// Of the model of another stepper, with which it shares what is known of its shapes.
  FixedStepStepper(const FixedStepStepper& other, double target_step);

  /// No fixed step is longer [s].
  virtual double longest_step() const { return target_step_; }
  /// Whether fixed steps are divided where the legs of paths end.
  virtual bool ends_at_legs() const { return true; }
  /// Takes over the State before the first step, which ends at this time [s].
  virtual void begin_span(double first_end, State& state) = 0;
  /// Moves from t towards the end of a fixed step. Returns the time reached [s]: a scheme may divide the
  /// step, and is then asked again. If it cannot continue, `report_.reason` says why.
  virtual double step_towards(double t_end, double t, State& state) = 0;
  /// Of each body the group in which it was watched in the last part of a step; -1 for those that were
  /// watched in each group. Empty where the scheme watched nothing by itself.
  virtual std::span<const int> watched_groups() const { return {}; }
  /// Brings the State to the time reached, where the scheme keeps its bodies elsewhere during a span.
  virtual void show_step([[maybe_unused]] double t, [[maybe_unused]] State& state) {}
  /// Completes the State at the time reached [s], also after a stop.
  virtual void end_span(double t, State& state) = 0;

  /// Shows the witness the State that a scheme brings to the time reached within a step that it takes in
  /// parts by itself.
  void watch_part(const State& state) { witness_.watch(state, report_); }
  /// From now on the witness watches these bodies alone.
  void watch_only(const std::vector<bool>& is_here) { witness_.watch_only(is_here); }
  /// The length of the whole step of which step_towards() takes a part, or all [s].
  double whole_step() const { return whole_step_; }
  /// Puts kinematic and fixed bodies where they are at the State's time.
  void write_prescribed_bodies(State& state) const;

  AdvanceReport advance_span(State& state, double t_end) final { return pass(state, t_end, t_end); }
  /// The steps are those of advance(state, t_end); the last one is as much of such a step as is left.
  AdvanceReport look_span(State& state, double t_end, double t) final { return pass(state, t_end, t); }
  double time_reached() const final { return t_; }

  std::shared_ptr<const Model> model_;
  double target_step_;
  AdvanceReport report_;

 private:
  AdvanceReport pass(State& state, double t_end, double t_look);
  double end_of_part(double t, double end) const;

  PassageWitness witness_;
  std::vector<double> leg_ends_;  ///< Of the paths of all bodies, ascending [s].
  double t_ = 0;
  double whole_step_ = 0;
};

}  // namespace rigor
