// Where events cannot follow a motion any more, auto goes on by steps.

#include "sim/handover/falling_heaps.hpp"

#include "rigor/sim/audit/audit.hpp"
#include "rigor/sim/event_driven/event_driven_stepper.hpp"
#include "rigor/sim/handover/auto_stepper.hpp"
#include "rigor/sim/method/scheme_choice.hpp"
#include "rigor/sim/report/unresolved.hpp"
#include "rigor/sim/simulation.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace rigor::handover_test {
namespace {

/// Events that cannot follow a motion from some time on.
class EventsLostFrom : public EventDrivenStepper {
 public:
  EventsLostFrom(std::shared_ptr<const Model> model, const Method& method, double lost_from)
      : EventDrivenStepper(std::move(model), method, step), lost_from_(lost_from) {}

 private:
  bool apply_impulses(Cluster& part) override {
    if (part.t >= lost_from_) throw Unresolved({1}, "body 'body0' turns too fast");
    return EventDrivenStepper::apply_impulses(part);
  }
  double lost_from_;
};

TEST(LostEvents, WhatEventsCannotFollowIsLeftToSteps) {
  for (unsigned seed = 0; seed < 8; ++seed) {
    SCOPED_TRACE(seed);
    const std::shared_ptr<const Model> model = heap(seed);
    const ResolvedMethod resolved = resolve_scheme(*model, automatic());
    const double lost_from = 0.1 + 0.02 * seed;
    const auto lost = [&] {
      return AutoStepper(model, std::make_unique<EventsLostFrom>(model, resolved.method, lost_from), resolved,
                         step);
    };
    State state = make_initial_state(*model);
    Auditor auditor(model, automatic(), state);
    AutoStepper stepper = lost();
    std::vector<State> states;
    for (int k = 1; k <= 30; ++k) {
      const AdvanceReport report = stepper.advance(state, k * interval);
      ASSERT_EQ(report.reason, StopReason::reached_end) << report.detail;
      auditor.observe(state, report);
      states.push_back(state);
    }

    // From the last State before, and the audit says why; its promises are kept.
    const Audit audit = auditor.audit(state);
    EXPECT_EQ(audit.violations, std::vector<std::string>{});
    ASSERT_EQ(audit.spans.size(), 2u);
    const SchemeSpan &events = audit.spans[0].of, &steps = audit.spans[1].of;
    EXPECT_EQ(events.scheme, resolved.method.scheme);
    EXPECT_EQ(steps.scheme, Scheme::time_stepping);
    EXPECT_GE(events.end, lost_from - interval);
    EXPECT_NE(events.end_cause.find("body 'body0' turns too fast, at t = "), std::string::npos);
    EXPECT_NE(events.end_cause.find(fmt::format("went on from t = {:.9g} s", events.end)), std::string::npos);

    // A resumed run goes the same way, and a scheme that is named stops.
    for (const std::size_t place : {1u, 4u, 20u}) {
      State resumed = deserialise(serialise(states[place]));
      AutoStepper fresh = lost();
      for (std::size_t i = place + 1; i < 30; ++i) {
        fresh.advance(resumed, static_cast<double>(i + 1) * interval);
        ASSERT_EQ(resumed, states[i]) << "at t = " << resumed.t;
      }
    }
    State named = make_initial_state(*model);
    EXPECT_EQ(EventsLostFrom(model, resolved.method, lost_from).advance(named, 0.6).reason,
              StopReason::unresolved);
    EXPECT_EQ(named, make_initial_state(*model));
  }
}

TEST(LostEvents, EventsThatAreLostOnceAreTriedAgain) {
  // In the first call already: steps go on from the beginning, and events are asked again two seconds later.
  const std::shared_ptr<const Model> model = heap(0);
  const ResolvedMethod resolved = resolve_scheme(*model, automatic());
  State state = make_initial_state(*model);
  AutoStepper stepper(model, std::make_unique<EventsLostFrom>(model, resolved.method, 0), resolved, step);
  const AdvanceReport report = stepper.advance(state, 2.5);
  ASSERT_EQ(report.reason, StopReason::reached_end) << report.detail;
  ASSERT_GE(report.spans.size(), 2u);
  EXPECT_EQ(report.spans[0].begin, report.spans[0].end);
  EXPECT_EQ(report.spans[1].begin, 0);
  EXPECT_EQ(report.spans[1].scheme, Scheme::time_stepping);
  EXPECT_NEAR(report.spans[1].end, 2, 0.1);
}

}  // namespace
}  // namespace rigor::handover_test
