#pragma once

#include "rigor/sim/audit/audit.hpp"
#include "rigor/sim/make_stepper.hpp"

#include <memory>
#include <string>

namespace rigor::test {

/// How a scheme came through a scene.
struct FuzzOutcome {
  bool took_too_long = false;  ///< It was ended after `most_polls` questions whether it should end.
  std::string trouble;         ///< What it should not have done; empty if nothing.
  double energy_rise = 0;      ///< That no work explains [J].
  State state;                 ///< At the end.
};

/// Runs the model in ten parts. Trouble is a stop, a state that is no number, or whatever the audit of the
/// scheme does not allow: a rise of the energy, an error of a momentum, an overlap, a joint that is off.
inline FuzzOutcome fuzz_run(const std::shared_ptr<const Model>& model, const Method& method, double duration,
                            long most_polls) {
  constexpr int parts = 10;
  FuzzOutcome outcome;
  outcome.state = make_initial_state(*model);
  State& state = outcome.state;
  Auditor auditor(model, method, state);
  const std::unique_ptr<Stepper> stepper = make_stepper(model, method, 0.01);
  long polls = 0;
  stepper->set_interrupt([&] { return ++polls > most_polls; });
  for (int k = 1; k <= parts && outcome.trouble.empty() && !outcome.took_too_long; ++k) {
    const AdvanceReport report = stepper->advance(state, k * duration / parts);
    auditor.observe(state, report);
    outcome.took_too_long = report.reason == StopReason::interrupted;
    if (!outcome.took_too_long && report.reason != StopReason::reached_end)
      outcome.trouble = "stopped: " + report.detail;
    for (int i = 0; i < model->body_count(); ++i) {
      if (!state.position(i).allFinite() || !state.orientation(i).coeffs().allFinite() ||
          !state.linear_momentum(i).allFinite() || !state.angular_momentum(i).allFinite())
        outcome.trouble = "not finite: " + model->body(i).name;
    }
  }
  const Audit audit = auditor.audit(state);
  outcome.energy_rise = audit.max_increase;
  for (const std::string& violation : audit.violations) {
    const bool is_pressed = method.scheme == Scheme::penalty && violation.starts_with("penetration");
    if (outcome.trouble.empty() && !is_pressed) outcome.trouble = violation;
  }
  return outcome;
}

}  // namespace rigor::test
