#include "rigor/sim/simulation.hpp"

#include "rigor/dynamics/environment.hpp"
#include "rigor/sim/make_stepper.hpp"
#include "rigor/sim/report/energy.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace rigor {

namespace {

/// A run under way: the State and its books at the last output.
class ActiveRun {
 public:
  ActiveRun(std::shared_ptr<const Model> model, std::unique_ptr<Stepper> stepper, State start,
            Auditor auditor, const Observer& observer)
      : model_(std::move(model)),
        environment_(*model_),
        stepper_(std::move(stepper)),
        state_(std::move(start)),
        auditor_(std::move(auditor)),
        observer_(observer) {}

  /// Goes through the outputs until the run ends.
  RunResult run(const RunSettings& settings) {
    continues_ = observer_(state_, {}, auditor_);
    const double rounding = stepper_->time_rounding();
    long output = static_cast<long>(state_.t / settings.output_interval);
    while (continues_ && !has_stopped_ && state_.t < settings.duration - rounding) {
      // Output times are multiples of the interval, not sums, so that they carry a single rounding.
      while (static_cast<double>(output) * settings.output_interval <= state_.t + rounding) ++output;
      const double t_output = static_cast<double>(output) * settings.output_interval;
      if (t_output > settings.duration + rounding) return end_before(t_output, settings.duration);
      advance(t_output);
    }
    const Audit audit = auditor_.audit(state_);
    return {state_, audit, state_, audit, !continues_};
  }

 private:
  void advance(double t_output) {
    const State before = state_;
    const AdvanceReport report = without_overflow(stepper_->advance(state_, t_output), before, state_);
    if (report.reason == StopReason::interrupted) {
      state_ = before;
      continues_ = false;
      return;
    }
    auditor_.observe(state_, report);
    // A stop without a valid State leaves that of the last output, which has been seen.
    if (state_.t > before.t) continues_ = observer_(state_, report, auditor_);
    has_stopped_ = report.reason != StopReason::reached_end;
  }

  /// The last part of a run that ends between two outputs: a look at the bodies on their way to the next one.
  RunResult end_before(double t_output, double t) {
    State shown = state_;
    Auditor auditor = auditor_;
    const AdvanceReport report = without_overflow(stepper_->look(shown, t_output, t), state_, shown);
    if (report.reason == StopReason::interrupted) {
      shown = state_;
      continues_ = false;
    } else {
      auditor.observe(shown, report);
      if (shown.t > state_.t) continues_ = observer_(shown, report, auditor);
    }
    return {shown, auditor.audit(shown), state_, auditor_.audit(state_), !continues_};
  }

  /// Momenta whose energy overflows are no numbers for those who read the outputs.
  AdvanceReport without_overflow(AdvanceReport report, const State& before, State& state) const {
    if (std::isfinite(mechanical_energy(*model_, environment_, state).total())) return report;
    AdvanceReport why;
    why.reason = StopReason::not_finite;
    why.detail = fmt::format("the energy overflows before t = {:.17g} s", state.t);
    state = before;
    return why;
  }

  std::shared_ptr<const Model> model_;
  Environment environment_;
  std::unique_ptr<Stepper> stepper_;
  State state_;
  Auditor auditor_;
  const Observer& observer_;
  bool continues_ = true;     ///< The observer and the interrupt let it.
  bool has_stopped_ = false;  ///< The stepper could not continue.
};

}  // namespace

// NOLINTNEXTLINE(readability-function-size): what a run is made of, from where it begins, and who watches it.
RunResult run_simulation(std::shared_ptr<const Model> model, const Method& method,
                         const RunSettings& settings, const std::optional<State>& start,
                         const Observer& observer, const std::function<bool()>& interrupt,
                         const std::optional<Audit>& earlier) {
  State state = start ? *start : make_initial_state(*model);
  const ResolvedMethod choice = resolve_scheme(*model, method);
  std::unique_ptr<Stepper> stepper = make_stepper(model, choice, settings.step, settings.threads);
  stepper->set_interrupt(interrupt);
  Auditor auditor = earlier ? Auditor(model, choice, state, *earlier) : Auditor(model, choice, state);
  RunResult result =
      ActiveRun(std::move(model), std::move(stepper), std::move(state), std::move(auditor), observer)
          .run(settings);
  for (Audit* audit : {&result.audit, &result.resumable_audit}) {
    audit->duration = settings.duration;
    audit->step = settings.step;
  }
  return result;
}

}  // namespace rigor
