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

  bool continues = observer(state, {}, auditor);
  long output = static_cast<long>(state.t / settings.output_interval);
  while (continues && state.t < settings.duration) {
    // Output times are multiples of the interval, not sums, so that they carry a single rounding.
    while (static_cast<double>(output) * settings.output_interval <= state.t) ++output;
    const double t_next = std::min(static_cast<double>(output) * settings.output_interval, settings.duration);
    const State before = state;
    const AdvanceReport report = stepper->advance(state, t_next);
    if (report.reason == StopReason::interrupted) {
      state = before;
      continues = false;
      break;
    }
    auditor.observe(state, report);
    continues = observer(state, report, auditor);
    if (report.reason != StopReason::reached_end) break;
  }
  result.was_stopped = !continues;
  result.audit = auditor.audit(state);
  result.audit.duration = settings.duration;
  result.audit.step = settings.step;
  return result;
}

}  // namespace rigor
