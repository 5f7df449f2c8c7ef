#pragma once

#include "rigor/dynamics/environment.hpp"
#include "rigor/sim/event_driven/event_driven_stepper.hpp"
#include "rigor/sim/fixed_steps/fixed_steps.hpp"
#include "rigor/sim/fixed_steps/stepper.hpp"
#include "rigor/sim/time_stepping/time_stepper.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace rigor {

/// By how much work (AdvanceReport::effort) it is decided who carries the bodies.
struct HandoverBounds {
  /// Work that a second of simulated time pays for [1/s]: about ten seconds of processor time, as much as the
  /// bound by which `auto` chooses a scheme at the start (a unit takes 5 to 12 µs: docs/theory/handover.md).
  double paid_by_events = 1e6;
  /// What may be owed beyond it: single impacts of large groups are worth their time.
  double most_owed = 2e5;
  /// While steps carry the bodies, time pays for less [1/s]: who comes back is well within the bound.
  double paid_by_steps = 0.25e6;
};

/// `auto` during a run: from event to event where events are few, by time stepping where they crowd.
///
/// Events crowd when they have cost more work than the simulated time since has paid for; steps hand back
/// when what happens in them would have cost little enough for the debt to be paid. The work is counted, not
/// timed, and what is owed is in the State: the same scene is handed over at the same times on every machine,
/// whether it runs through or is resumed. docs/theory/handover.md.
class AutoStepper : public Stepper {
 public:
  /// events: the event-driven or hybrid scheme at work. method: of the steps, which go with the model.
  /// target_step H > 0 [s]. threads >= 1, of the steps.
  AutoStepper(std::shared_ptr<const Model> model, std::unique_ptr<EventDrivenStepper> events,
              const Method& method, Scheme scheme_of_events, double target_step, int threads = 1,
              const HandoverBounds& bounds = {});
  double time_rounding() const override { return FixedSteps::rounding * target_step_; }
  std::optional<std::vector<TouchingPoint>> contacts_of(const State& state) const override {
    return last_ ? last_->contacts_of(state) : std::nullopt;
  }

 protected:
  AdvanceReport advance_span(State& state, double t_end) override { return pass(state, t_end, t_end); }
  AdvanceReport look_span(State& state, double t_end, double t) override { return pass(state, t_end, t); }
  double time_reached() const override { return t_; }

 private:
  AdvanceReport pass(State& state, double t_end, double t_look);
  AdvanceReport go_by_events(State& state, double t_end);
  AdvanceReport go_by_steps(State& state, double t_end, double t_look);
  TimeStepper& steps();
  void enter_span(Scheme scheme, double begin, const State& state, std::string end_cause,
                  AdvanceReport& report) const;

  std::shared_ptr<const Model> model_;
  Environment environment_;
  std::unique_ptr<EventDrivenStepper> events_;
  std::unique_ptr<TimeStepper> steps_;  ///< Made where events first hand over: most runs never do.
  Method method_of_steps_;
  Scheme scheme_of_events_;
  double target_step_;
  int threads_;
  HandoverBounds bounds_;
  HandoverMemory memory_;          ///< Of the State, while its schemes are at work.
  const Stepper* last_ = nullptr;  ///< Which scheme has left the State.
  double t_ = 0;
};

}  // namespace rigor
