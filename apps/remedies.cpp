#include "apps/remedies.hpp"

#include "rigor/core/quoted.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rigor {

namespace {

const char* const equal_steps =
    "equal steps need no event for each impact and solve all contacts of a step together; impacts are known "
    "to "
    "a step";

bool has_fixed_order(IntegratorMethod integrator) {
  return integrator != IntegratorMethod::exact && integrator != IntegratorMethod::dopri5 &&
         integrator != IntegratorMethod::dop853;
}

bool is_substep(const Method& method) {
  return method.scheme == Scheme::time_stepping && method.solver == SolverMethod::substep;
}

Remedy exact_integrator() {
  return {"method.integrator=exact",
          "closed forms in flight, steps that control their error elsewhere, implicit ones where forces are "
          "stiff; costs as many steps as the error asks for"};
}

Remedy exact_solver() {
  return {"method.solver=exact",
          "solves the contacts of a step to rounding, in 64 bits; costs more for many bodies"};
}

Remedy shorter_step(const Audit& audit, double factor) {
  return {fmt::format("run.step={:.6g}", audit.step / factor),
          fmt::format("costs {:g} times as much", factor)};
}

Remedy time_stepping() {
  return {"method.scheme=time-stepping", equal_steps};
}

Remedy event_driven() {
  return {"method.scheme=event-driven",
          "each impact at its own time, forces at contacts that last; costs by the number of events"};
}

/// Of a run that could not continue.
std::vector<Remedy> after_stop(const Audit& audit) {
  const Method& method = audit.method;
  switch (audit.report.reason) {
    case StopReason::reached_end:
    case StopReason::interrupted:
      return {};
    case StopReason::events_accumulate:
    case StopReason::impact_unsolved:
      if (method.scheme == Scheme::impulse_based) return {time_stepping(), event_driven()};
      return {time_stepping()};
    case StopReason::unresolved:
      return {shorter_step(audit, 100)};
    case StopReason::broken_promise:  // The motion was one that the promise had not foreseen: a shorter step
                                      // may.
    case StopReason::not_finite:
      break;
  }
  if (has_fixed_order(method.integrator)) return {exact_integrator()};
  if (is_substep(method)) return {exact_solver(), shorter_step(audit, 4)};
  if (method.scheme == Scheme::penalty) return {time_stepping()};
  return {shorter_step(audit, 8), time_stepping()};
}

/// Of a run that gained energy or lost momenta.
std::vector<Remedy> after_wrong_motion(const Audit& audit) {
  const Method& method = audit.method;
  if (method.integrator != IntegratorMethod::exact && has_fixed_order(method.integrator))
    return {exact_integrator(), shorter_step(audit, 8)};
  if (is_substep(method)) return {exact_solver(), shorter_step(audit, 4)};
  if (method.scheme == Scheme::time_stepping && method.solver == SolverMethod::pgs) return {exact_solver()};
  if (method.scheme == Scheme::penalty && method.penalty == PenaltyMethod::global)
    return {{"method.penalty=local", "sub-steps that resolve every spring; costs by the stiffest one"},
            time_stepping()};
  if (method.scheme == Scheme::penalty) return {shorter_step(audit, 4), time_stepping()};
  if (method.scheme == Scheme::time_stepping) return {shorter_step(audit, 4), event_driven()};
  return {time_stepping(), shorter_step(audit, 4)};
}

/// Of a run in which bodies overlapped too deep.
std::vector<Remedy> after_overlap(const Audit& audit) {
  const Method& method = audit.method;
  if (method.scheme == Scheme::penalty && method.stiffness > 0)
    return {{"method.stiffness=0", "springs as stiff as each impact needs; costs shorter sub-steps"}};
  if (method.scheme == Scheme::penalty)
    return {time_stepping(),
            {fmt::format("method.penalty_depth={:.6g}", method.penalty_depth / 4), "costs twice as much"}};
  if (is_substep(method)) return {exact_solver(), shorter_step(audit, 4)};
  if (method.scheme == Scheme::time_stepping && method.solver == SolverMethod::pgs) return {exact_solver()};
  if (method.scheme == Scheme::time_stepping) return {shorter_step(audit, 4), event_driven()};
  return {time_stepping(), shorter_step(audit, 4)};
}

bool broke(const Audit& audit, Audit::Promise promise) {
  return std::find(audit.broken.begin(), audit.broken.end(), promise) != audit.broken.end();
}

}  // namespace

std::vector<Remedy> remedies_of(const Audit& audit) {
  if (audit.report.reason != StopReason::reached_end) return after_stop(audit);
  if (broke(audit, Audit::Promise::energy) || broke(audit, Audit::Promise::momentum))
    return after_wrong_motion(audit);
  if (broke(audit, Audit::Promise::overlap) || broke(audit, Audit::Promise::joints))
    return after_overlap(audit);
  return {};
}

std::string remedies_text(const Audit& audit) {
  std::string text;
  const bool has_failed = !audit.broken.empty() || (audit.report.reason != StopReason::reached_end &&
                                                    audit.report.reason != StopReason::interrupted);
  for (const Audit::JointEnd& joint : audit.joints) {
    if (has_failed && joint.has_unbounded_motor)
      text += fmt::format(
          "  give the motor of joint {} a max_force: without one it takes whatever force its speed asks "
          "for\n",
          quoted_text(joint.name));
  }
  for (const Remedy& remedy : remedies_of(audit))
    text += fmt::format("  try --set {}: {}\n", remedy.setting, remedy.meaning);
  return text;
}

}  // namespace rigor
