#include "rigor/sim/handover/auto_stepper.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/sim/report/energy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace rigor {

namespace {

/// After how many steps it is asked whether events may go on.
constexpr long steps_between_questions = 8;

/// Whether the scheme gave up where equal steps may go on.
bool is_out_of_its_depth(StopReason reason) {
  return reason == StopReason::events_accumulate || reason == StopReason::impact_unsolved;
}

/// Whether a stop leaves no State to go on from.
bool leaves_nothing(StopReason reason) {
  return reason == StopReason::not_finite || reason == StopReason::broken_promise ||
         reason == StopReason::unresolved || reason == StopReason::interrupted;
}

/// The end of the next few of the equal steps to t_end.
double end_of_steps(double t, double t_end, double target_step) {
  const FixedSteps steps(t, t_end, target_step);
  return steps.end(std::min(steps.count(), steps_between_questions) - 1);
}

}  // namespace

AutoStepper::AutoStepper(std::shared_ptr<const Model> model, std::unique_ptr<EventDrivenStepper> events,
                         const Method& method, Scheme scheme_of_events, double target_step, int threads,
                         const HandoverBounds& bounds)
    : model_(std::move(model)),
      environment_(*model_),
      events_(std::move(events)),
      method_of_steps_(method),
      scheme_of_events_(scheme_of_events),
      target_step_(target_step),
      threads_(threads),
      bounds_(bounds) {
  RIGOR_ASSERT(target_step > 0);
  events_->set_interrupt([this] { return is_interrupted(); });
}

TimeStepper& AutoStepper::steps() {
  if (!steps_) {
    steps_ = std::make_unique<TimeStepper>(model_, method_of_steps_, target_step_, threads_);
    steps_->set_interrupt([this] { return is_interrupted(); });
  }
  return *steps_;
}

AdvanceReport AutoStepper::pass(State& state, double t_end, double t_look) {
  RIGOR_ASSERT(t_end >= t_look && t_look >= state.t);
  const State before = state;
  // The schemes see a State without memory, so that each finds the one that it left.
  memory_ = std::exchange(state.handover, {});
  t_ = state.t;
  AdvanceReport report;
  const auto left = [&] { return t_look - t_; };
  while (report.reason == StopReason::reached_end && left() > (memory_.is_in_steps ? time_rounding() : 0)) {
    report.add(memory_.is_in_steps ? go_by_steps(state, t_end, t_look) : go_by_events(state, t_look));
    t_ = state.t;
  }
  state.handover = memory_;

  // Where no State is left, nothing has happened.
  if (leaves_nothing(report.reason)) {
    AdvanceReport why;
    why.reason = report.reason;
    why.detail = std::move(report.detail);
    why.bodies = std::move(report.bodies);
    state = before;
    return why;
  }
  return report;
}

AdvanceReport AutoStepper::go_by_events(State& state, double t_end) {
  const double begin = state.t;
  last_ = events_.get();
  events_->set_debt(
      {.rate = bounds_.paid_by_events, .most = bounds_.most_owed, .owed = memory_.owed, .t = begin});
  AdvanceReport report = events_->advance(state, t_end);
  if (leaves_nothing(report.reason)) return report;

  // What is owed now; where it is too much, or the scheme has given up, steps take over.
  EffortDebt debt = events_->debt();
  debt.charge(0, state.t);
  memory_.owed = debt.owed;
  std::string cause;
  if (is_out_of_its_depth(report.reason)) {
    cause = report.detail;
  } else if (events_->debt().is_exceeded()) {
    cause = fmt::format(
        "events crowd: {} contact problems for {} impacts within {:.3g} s; the work that time has not paid "
        "for, {:.3g}, is above {:.3g}",
        report.problems, report.impacts, state.t - begin, events_->debt().owed, bounds_.most_owed);
  }
  if (!cause.empty()) {
    report.reason = StopReason::reached_end;
    report.detail.clear();
    report.bodies.clear();
    // Impacts alone: which pairs came to rest and parted, a fresh stepper counts otherwise.
    memory_ = {.is_in_steps = true,
               .owed = std::max(memory_.owed, bounds_.most_owed),
               .price = report.effort / static_cast<double>(std::max(1L, report.impacts))};
  }
  enter_span(scheme_of_events_, begin, state, std::move(cause), report);
  return report;
}

AdvanceReport AutoStepper::go_by_steps(State& state, double t_end, double t_look) {
  const double begin = state.t, end = end_of_steps(begin, t_end, target_step_);
  last_ = &steps();
  AdvanceReport report =
      end > t_look + time_rounding() ? steps().look(state, end, t_look) : steps().advance(state, end);
  if (leaves_nothing(report.reason)) return report;

  // What events would owe: each costs what an impact did when steps took over.
  const double cost =
      memory_.price * static_cast<double>(report.impacts + report.resting + report.separations);
  memory_.owed = std::max(0.0, memory_.owed + cost - bounds_.paid_by_steps * (state.t - begin));
  std::string cause;
  if (memory_.owed == 0) {
    cause =
        fmt::format("events are few: at {:.3g} units of work for each, nothing would be owed", memory_.price);
    memory_ = {};
  }
  enter_span(Scheme::time_stepping, begin, state, std::move(cause), report);
  return report;
}

void AutoStepper::enter_span(Scheme scheme, double begin, const State& state, std::string end_cause,
                             AdvanceReport& report) const {
  report.note_span({.scheme = scheme,
                    .begin = begin,
                    .end = state.t,
                    .energy = mechanical_energy(*model_, environment_, state).total(),
                    .work = report.work,
                    .impacts = report.impacts,
                    .end_cause = std::move(end_cause)});
}

}  // namespace rigor
