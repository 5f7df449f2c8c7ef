#include "rigor/sim/handover/auto_stepper.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/sim/report/energy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace rigor {

namespace {

using Carrier = HandoverMemory::Carrier;

/// What is owed after time that pays so much a second.
double left_of(double owed, double rate, double duration) {
  return std::max(0.0, owed - rate * duration);
}

/// After how many steps it is asked whether events may go on.
constexpr long steps_between_questions = 8;

/// Whether the scheme gave up where equal steps may go on.
bool is_out_of_its_depth(StopReason reason) {
  return reason == StopReason::events_accumulate || reason == StopReason::impact_unsolved;
}

/// Whether the scheme lost a motion that a coarser one may keep: its steps became too short, or its numbers
/// too large.
bool is_lost(StopReason reason) {
  return reason == StopReason::unresolved || reason == StopReason::not_finite;
}

/// Whether a stop leaves no State but that of before.
bool leaves_nothing(StopReason reason) {
  return reason == StopReason::not_finite || reason == StopReason::broken_promise ||
         reason == StopReason::unresolved || reason == StopReason::interrupted;
}

/// Where that happened, and who goes on from the State before.
std::string lost_by(const char* who, const AdvanceReport& report, double begin) {
  return fmt::format("{} by {}: {}; steps went on from t = {:.9g} s, the State before",
                     report.reason == StopReason::unresolved ? "unresolved" : "not finite", who,
                     report.detail, begin);
}

/// The end of the next few of the equal steps to t_end.
double end_of_steps(double t, double t_end, double target_step) {
  const FixedSteps steps(t, t_end, target_step);
  return steps.end(std::min(steps.count(), steps_between_questions) - 1);
}

}  // namespace

AutoStepper::AutoStepper(std::shared_ptr<const Model> model, std::unique_ptr<EventDrivenStepper> events,
                         const ResolvedMethod& choice, double target_step, int threads,
                         const HandoverBounds& bounds)
    : model_(std::move(model)),
      environment_(*model_),
      events_(std::move(events)),
      choice_(choice),
      target_step_(target_step),
      threads_(threads),
      bounds_(bounds) {
  RIGOR_ASSERT(target_step > 0);
  if (events_) events_->set_interrupt([this] { return is_interrupted(); });
}

TimeStepper& AutoStepper::steps() {
  if (!steps_) {
    const Method& method = choice_.steps ? *choice_.steps : choice_.method;
    steps_ = std::make_unique<TimeStepper>(model_, method, target_step_, threads_);
    steps_->set_interrupt([this] { return is_interrupted(); });
  }
  return *steps_;
}

BulkStepper& AutoStepper::soft_steps() {
  if (!soft_steps_) {
    soft_steps_ = std::make_unique<BulkStepper>(model_, *choice_.soft_steps, target_step_, threads_);
    soft_steps_->set_interrupt([this] { return is_interrupted(); });
  }
  return *soft_steps_;
}

AdvanceReport AutoStepper::pass(State& state, double t_end, double t_look) {
  RIGOR_ASSERT(t_end >= t_look && t_look >= state.t);
  const State before = state;
  // The schemes see a State without memory, so that each finds the one that it left.
  memory_ = std::exchange(state.handover, {});
  // A run without events begins with steps; and a checkpoint may name a carrier that this run has not.
  const bool is_missing = (memory_.carrier == Carrier::events && !events_) ||
                          (memory_.carrier == Carrier::soft_steps && !choice_.soft_steps);
  if (is_missing) memory_ = {.carrier = Carrier::steps};
  t_ = state.t;
  AdvanceReport report;
  const auto is_left = [&] {
    return t_look - t_ > (memory_.carrier == Carrier::events ? 0 : time_rounding());
  };
  while (report.reason == StopReason::reached_end && is_left()) {
    switch (memory_.carrier) {
      case Carrier::events:
        report.add(go_by_events(state, t_look));
        break;
      case Carrier::steps:
        report.add(go_by_steps(state, t_end, t_look));
        break;
      case Carrier::soft_steps:
        report.add(go_by_soft_steps(state, t_end, t_look));
        break;
    }
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
  events_->set_budget(
      {.rate = bounds_.paid_by_events, .most = bounds_.most_owed, .owed = memory_.owed, .t = begin});
  AdvanceReport report = events_->advance(state, t_end);
  // What events cannot follow, equal steps may. The State is that of before.
  const bool has_lost = is_lost(report.reason);
  if (!has_lost && leaves_nothing(report.reason)) return report;

  // What is owed now; where it is too much, or the scheme has given up, steps take over.
  WorkBudget budget = events_->budget();
  if (!has_lost) {
    budget.charge(0, state.t);
    memory_.owed = budget.owed;
  }
  memory_.owed_by_steps = left_of(memory_.owed_by_steps, bounds_.paid_to_steps, state.t - begin);
  std::string cause;
  if (is_out_of_its_depth(report.reason)) {
    cause = report.detail;
  } else if (has_lost) {
    cause = lost_by("events", report, begin);
  } else if (budget.is_exceeded()) {
    cause = fmt::format(
        "events crowd: {} contact problems for {} impacts within {:.3g} s; the work that time has not paid "
        "for, {:.3g}, is above {:.3g}",
        report.problems, report.impacts, state.t - begin, budget.owed, bounds_.most_owed);
  }
  if (!cause.empty()) {
    report.reason = StopReason::reached_end;
    report.detail.clear();
    report.bodies.clear();
    // By impacts alone: what comes to rest or parts in between is part of what they cost.
    memory_ = {.carrier = Carrier::steps,
               .owed = std::max(memory_.owed, bounds_.most_owed),
               .price = report.effort / static_cast<double>(std::max(1L, report.impacts)),
               .owed_by_steps = memory_.owed_by_steps};
  }
  enter_span(choice_.method, begin, state, std::move(cause), report);
  return report;
}

AdvanceReport AutoStepper::go_by_steps(State& state, double t_end, double t_look) {
  const double begin = state.t, end = end_of_steps(begin, t_end, target_step_);
  last_ = &steps();
  // A step that alone costs too much is given up: the State is that before it.
  if (choice_.soft_steps) {
    const double paid = bounds_.paid_to_steps * (end - begin);
    steps().set_work_limit(bounds_.most_owed_by_steps + paid - memory_.owed_by_steps);
  }
  AdvanceReport report =
      end > t_look + time_rounding() ? steps().look(state, end, t_look) : steps().advance(state, end);
  const bool is_given_up = report.reason == StopReason::interrupted && steps().is_beyond_work_limit();
  if (is_given_up) report.reason = StopReason::reached_end;
  // What exact steps cannot follow, soft steps may.
  const bool has_lost = is_lost(report.reason) && choice_.soft_steps;
  if (!has_lost && leaves_nothing(report.reason)) return report;
  std::string lost;
  if (has_lost) {
    lost = lost_by("exact steps", report, begin);
    report = {};
  }

  std::string cause = reason_to_return(begin, state.t, report);
  std::string soften = has_lost ? std::move(lost) : reason_to_soften(begin, state.t, report);
  RIGOR_ASSERT(!is_given_up || !soften.empty());
  if (!soften.empty()) {
    memory_ = {.carrier = Carrier::soft_steps, .soft_step = soft_step_from(state)};
    cause = std::move(soften);
  } else if (!cause.empty()) {
    memory_ = {.owed_by_steps = memory_.owed_by_steps};
  }
  enter_span(choice_.steps ? *choice_.steps : choice_.method, begin, state, std::move(cause), report);
  return report;
}

/// Why events may go on after these steps, or empty.
std::string AutoStepper::reason_to_return(double begin, double now, const AdvanceReport& report) {
  if (!events_) return {};
  // What events would owe: each costs what an impact did when steps took over.
  const double cost =
      memory_.price * static_cast<double>(report.impacts + report.resting + report.separations);
  memory_.owed = left_of(memory_.owed + cost, bounds_.paid_by_steps, now - begin);
  if (memory_.owed > 0) return {};
  return fmt::format("events are few: at {:.3g} units of work for each, nothing would be owed",
                     memory_.price);
}

/// Why soft steps have to go on after these, or empty.
std::string AutoStepper::reason_to_soften(double begin, double now, const AdvanceReport& report) {
  memory_.owed_by_steps =
      left_of(memory_.owed_by_steps + report.step_work, bounds_.paid_to_steps, now - begin);
  if (!choice_.soft_steps || memory_.owed_by_steps <= bounds_.most_owed_by_steps) return {};
  return fmt::format(
      "exact steps take too long: {:.3g} operations for {:.3g} s; what time has not paid for, {:.3g}, is "
      "above {:.3g} (method.last_resort=none goes on by them all the same)",
      report.step_work, now - begin, memory_.owed_by_steps, bounds_.most_owed_by_steps);
}

/// How long soft steps may be from this State on [s]. What they stop goes deep by what it travels in about
/// two sub-steps: in a step of six it goes no farther than a quarter of a body's thickness, as fast as it is
/// or would be at the foot of the scene, so that it stops within a tenth. Springs of another step would have
/// another energy in the same overlaps: the length stays for the rest of the run.
double AutoStepper::soft_step_from(const State& state) const {
  constexpr double share = 0.25, least = 1.0 / 16;
  double foot = -std::numeric_limits<double>::infinity();
  for (int i = 0; i < model_->body_count(); ++i) foot = std::max(foot, model_->g_W().dot(state.position(i)));
  double shortest = target_step_;
  for (int i = 0; i < model_->body_count(); ++i) {
    const Body& body = model_->body(i);
    if (body.motion != MotionType::dynamic || !(body.thickness > 0)) continue;
    const double v = linear_velocity(*model_, state, i).norm(),
                 falls = foot - model_->g_W().dot(state.position(i)),
                 speed = std::sqrt(v * v + 2 * falls) +
                         body.bounding_radius * angular_velocity(*model_, state, i).norm();
    if (speed * shortest > share * body.thickness) shortest = share * body.thickness / speed;
  }
  return std::max(shortest, least * target_step_);
}

AdvanceReport AutoStepper::go_by_soft_steps(State& state, double t_end, double t_look) {
  const double begin = state.t;
  last_ = &soft_steps();
  soft_steps().set_longest_step(std::min(memory_.soft_step, target_step_));
  AdvanceReport report = t_end > t_look + time_rounding() ? soft_steps().look(state, t_end, t_look)
                                                          : soft_steps().advance(state, t_end);
  if (leaves_nothing(report.reason)) return report;
  enter_span(*choice_.soft_steps, begin, state, {}, report);
  return report;
}

void AutoStepper::enter_span(const Method& method, double begin, const State& state, std::string end_cause,
                             AdvanceReport& report) const {
  report.note_span({.scheme = method.scheme,
                    .solver = method.solver,
                    .begin = begin,
                    .end = state.t,
                    .energy = mechanical_energy(*model_, environment_, state).total(),
                    .work = report.work,
                    .impacts = report.impacts,
                    .end_cause = std::move(end_cause)});
}

}  // namespace rigor
