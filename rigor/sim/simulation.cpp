#include "rigor/sim/simulation.hpp"

#include "rigor/dynamics/environment.hpp"
#include "rigor/sim/make_stepper.hpp"
#include "rigor/sim/report/energy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace rigor {

RunResult run_simulation(std::shared_ptr<const Model> model, const Method& method,
                         const RunSettings& settings, const std::optional<State>& start,
                         const Observer& observer, const std::function<bool()>& interrupt) {
  RunResult result;
  result.state = start ? *start : make_initial_state(*model);
  State& state = result.state;
  const std::unique_ptr<Stepper> stepper = make_stepper(model, method, settings.step, settings.threads);
  stepper->set_interrupt(interrupt);
  Auditor auditor(model, method, state);
  const Environment environment(*model);

  bool continues = observer(state, {}, auditor);
  long output = static_cast<long>(state.t / settings.output_interval);
  while (continues && state.t < settings.duration) {
    // Output times are multiples of the interval, not sums, so that they carry a single rounding.
    while (static_cast<double>(output) * settings.output_interval <= state.t) ++output;
    const double t_next = std::min(static_cast<double>(output) * settings.output_interval, settings.duration);
    const State before = state;
    AdvanceReport report = stepper->advance(state, t_next);
    if (report.reason == StopReason::interrupted) {
      state = before;
      continues = false;
      break;
    }
    // Momenta whose energy overflows are no numbers for those who read the outputs.
    if (!std::isfinite(mechanical_energy(*model, environment, state).total())) {
      report = {};
      report.reason = StopReason::not_finite;
      report.detail = fmt::format("the energy overflows before t = {:.17g} s", state.t);
      state = before;
    }
    auditor.observe(state, report);
    // A stop without a valid State leaves that of the last output, which has been seen.
    if (state.t > before.t) continues = observer(state, report, auditor);
    if (report.reason != StopReason::reached_end) break;
  }
  result.was_stopped = !continues;
  result.audit = auditor.audit(state);
  return result;
}

}  // namespace rigor
