#include "rigor/sim/simulation.hpp"

#include "rigor/sim/make_stepper.hpp"

#include <algorithm>
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

  bool goes_on = observer(state, {}, auditor);
  long output = static_cast<long>(state.t / settings.output_interval);
  while (goes_on && state.t < settings.duration) {
    // Multiples of the interval, not sums: output times carry one rounding.
    while (static_cast<double>(output) * settings.output_interval <= state.t) ++output;
    const double t_next = std::min(static_cast<double>(output) * settings.output_interval, settings.duration);
    const State before = state;
    const AdvanceReport report = stepper->advance(state, t_next);
    if (report.reason == StopReason::interrupted) {
      state = before;
      goes_on = false;
      break;
    }
    auditor.observe(state, report);
    goes_on = observer(state, report, auditor);
    if (report.reason != StopReason::reached_end) break;
  }
  result.was_stopped = !goes_on;
  result.audit = auditor.audit(state);
  return result;
}

}  // namespace rigor
