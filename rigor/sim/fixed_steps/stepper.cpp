#include "rigor/sim/fixed_steps/stepper.hpp"

#include "rigor/core/broken_promise.hpp"
#include "rigor/core/index.hpp"
#include "rigor/core/interrupt.hpp"
#include "rigor/sim/report/unresolved.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

namespace rigor {

namespace {

/// A body whose position or momenta are not finite, or whose energy is not; -1 if there is none.
int broken_body(const State& state) {
  for (int body = 0; body < state.body_count(); ++body) {
    const double squares = state.position(body).squaredNorm() + state.linear_momentum(body).squaredNorm() +
                           state.angular_momentum(body).squaredNorm() +
                           state.orientation(body).coeffs().squaredNorm();
    if (!std::isfinite(squares)) return body;
  }
  return -1;
}

AdvanceReport stop(StopReason reason, std::string detail) {
  AdvanceReport report;
  report.reason = reason;
  report.detail = std::move(detail);
  return report;
}

}  // namespace

AdvanceReport Stepper::advance(State& state, double t_end) {
  return guarded(state, [&] { return advance_span(state, t_end); });
}

AdvanceReport Stepper::look(State& state, double t_end, double t) {
  return guarded(state, [&] { return look_span(state, t_end, t); });
}

/// What the span reports, if it leaves a valid State; else the State of before, and why.
AdvanceReport Stepper::guarded(State& state, const std::function<AdvanceReport()>& span) {
  const State before = state;
  AdvanceReport report;
  try {
    const InterruptScope scope(interrupt_);
    report = span();
  } catch (const Interrupted&) {
    report = stop(StopReason::interrupted, {});
    state = before;
  } catch (const BrokenPromise& broken) {
    report =
        stop(StopReason::broken_promise, fmt::format("{}, at t = {:.17g} s", broken.what(), time_reached()));
    state = before;
  } catch (const Unresolved& unresolved) {
    report =
        stop(StopReason::unresolved, fmt::format("{}, at t = {:.9g} s", unresolved.what(), time_reached()));
    report.bodies = unresolved.bodies();
    state = before;
  }
  // Overflow that the scheme did not notice itself.
  const int body = broken_body(state);
  if (body >= 0 && report.reason != StopReason::not_finite) {
    report = stop(StopReason::not_finite, fmt::format("the motion of a body at t = {:.17g} s", state.t));
    report.bodies = {body};
  }
  if (report.reason == StopReason::not_finite) {
    AdvanceReport why = stop(StopReason::not_finite, std::move(report.detail));
    why.bodies = std::move(report.bodies);
    report = std::move(why);
    state = before;
  }
  if (report.reason == StopReason::reached_end)
    report.contacts = [this](const State& left) { return contacts_of(left); };
  return report;
}

}  // namespace rigor
