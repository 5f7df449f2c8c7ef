#pragma once

#include "rigor/dynamics/environment.hpp"
#include "rigor/sim/bulk/bulk_stepper.hpp"
#include "rigor/sim/event_driven/event_driven_stepper.hpp"
#include "rigor/sim/fixed_steps/fixed_steps.hpp"
#include "rigor/sim/fixed_steps/stepper.hpp"
#include "rigor/sim/method/scheme_choice.hpp"
#include "rigor/sim/time_stepping/time_stepper.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace rigor {

/// By how much work it is decided who carries the bodies: AdvanceReport::effort of events, step_work of
/// steps.
struct HandoverBounds {
  /// Work of events that a second of simulated time pays for [1/s]: about two and a half seconds of processor
  /// time (a unit takes 5 to 15 µs: docs/theory/handover.md).
  double paid_by_events = 2.5e5;
  /// What may be owed beyond it: single impacts of large groups are worth their time.
  double most_owed = 2e5;
  /// While steps carry the bodies, time pays for less [1/s]: who comes back is well within the bound.
  double paid_by_steps = 1e5;
  /// Operations of exact steps that a second of simulated time pays for [1/s]: about ten seconds of processor
  /// time (an operation takes 50 to 100 ns).
  double paid_to_steps = 1e8;
  /// What steps may owe beyond it.
  double most_owed_by_steps = 1e8;
};

/// `auto` during a run: from event to event where events are few, by exact time stepping where they crowd,
/// and by soft sub-steps where exact steps cost more than time pays for.
///
/// Events crowd when they have cost more work than the simulated time since has paid for; steps hand back
/// when what happens in them would have cost little enough for the debt to be paid. Steps are too dear when
/// their problems have taken more operations than time pays for; soft steps then go on to the end of the run,
/// since bodies that overlap softly are no start for exact steps. The work is counted, not
/// timed, and what is owed is in the State: the same scene is handed over at the same times on every machine,
/// whether it runs through or is resumed. docs/theory/handover.md.
class AutoStepper : public Stepper {
 public:
  /// events: the event-driven or hybrid scheme at work; null: the run begins with steps. choice: by
  /// resolve_scheme(), for the model. target_step H > 0 [s]. threads >= 1, of the steps.
  AutoStepper(std::shared_ptr<const Model> model, std::unique_ptr<EventDrivenStepper> events,
              const ResolvedMethod& choice, double target_step, int threads = 1,
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
  AdvanceReport go_by_soft_steps(State& state, double t_end, double t_look);
  double soft_step_from(const State& state) const;
  std::string reason_to_return(double begin, double now, const AdvanceReport& report);
  std::string reason_to_soften(double begin, double now, const AdvanceReport& report);
  TimeStepper& steps();
  BulkStepper& soft_steps();
  void enter_span(const Method& method, double begin, const State& state, std::string end_cause,
                  AdvanceReport& report) const;

  std::shared_ptr<const Model> model_;
  Environment environment_;
  std::unique_ptr<EventDrivenStepper> events_;
  std::unique_ptr<TimeStepper> steps_;  ///< Made where events first hand over: most runs never do.
  std::unique_ptr<BulkStepper> soft_steps_;
  ResolvedMethod choice_;
  double target_step_;
  int threads_;
  HandoverBounds bounds_;
  HandoverMemory memory_;          ///< Of the State, while its schemes are at work.
  const Stepper* last_ = nullptr;  ///< Which scheme has left the State.
  double t_ = 0;
};

}  // namespace rigor
