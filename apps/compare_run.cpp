#include "apps/compare_run.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/core/interrupt.hpp"
#include "rigor/sim/fixed_steps/fixed_steps.hpp"
#include "rigor/view/page/page_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include <time.h>

namespace rigor {

namespace {

/// Processor time of the program, on all its threads [s].
double process_time() {
  timespec time{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Real and processor time since the start, without the processor time of pauses.
class RunClock {
 public:
  void pause() { paused_at_ = process_time(); }
  void go_on() { cpu_begin_ += process_time() - paused_at_; }
  double cpu_time() const { return process_time() - cpu_begin_; }
  double wall_time() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  }
  /// Whether this processor time is over [s]. It is looked at once in a millisecond: the system takes longer
  /// to tell it than many a search lasts that asks.
  bool is_over(double limit) {
    constexpr double pause = 1e-3;
    if (wall_time() < next_look_) return false;
    next_look_ = wall_time() + pause;
    return cpu_time() > limit;
  }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  double cpu_begin_ = process_time(), paused_at_ = 0, next_look_ = 0;
};

/// Scale of the energy of a run: the largest kinetic energy or change of energy.
class EnergyScale {
 public:
  void add(const Energy& energy) {
    if (!first_) first_ = energy;
    value_ = std::max({value_, energy.kinetic, std::abs(energy.total() - first_->total()),
                       std::abs(energy.potential - first_->potential)});
  }
  double value() const { return value_; }

 private:
  std::optional<Energy> first_;
  double value_ = 0;
};

/// The longest step: the target step, or the largest smaller one that divides the output interval evenly.
double step_of(const RunSettings& run) {
  return run.output_interval / static_cast<double>(FixedSteps(0, run.output_interval, run.step).count());
}

RunEnd end_of(const RunResult& result, const RunSettings& settings) {
  if (result.audit.report.reason != StopReason::reached_end) return RunEnd::stopped;
  if (result.was_stopped && result.state.t < settings.duration) return RunEnd::interrupted;
  return result.audit.violations.empty() ? RunEnd::passed : RunEnd::audit_failed;
}

/// Rise of the energy relative to its scale; zero where it is below the rounding of the energies themselves,
/// as for bodies at rest.
double relative_rise(const Audit& audit, double scale) {
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  const double largest = std::max(std::abs(audit.initial.total()), std::abs(audit.final.total()));
  return scale > 0 && audit.max_increase > 16 * epsilon * largest ? audit.max_increase / scale : 0;
}

}  // namespace

std::string_view run_end_name(RunEnd end) {
  switch (end) {
    case RunEnd::passed:
      return "ok";
    case RunEnd::audit_failed:
      return "audit failed";
    case RunEnd::stopped:
      return "stopped";
    case RunEnd::interrupted:
      return "interrupted";
    case RunEnd::out_of_time:
      return "out of time";
    case RunEnd::refused:
      return "refused";
  }
  return "";
}

std::size_t base_run(const Comparison& comparison) {
  const auto base = std::find_if(comparison.runs.begin(), comparison.runs.end(),
                                 [](const ComparedRun& run) { return run.end != RunEnd::refused; });
  return at(base - comparison.runs.begin());
}

CompareRunner::CompareRunner(const CompareOutputs& outputs, const ComparePlan& plan,
                             const CompareLimits& limits, bool is_quiet)
    : outputs_(outputs),
      run_count_(plan.runs.size()),
      most_reference_bytes_(MotionComparison::usual_most_bytes /
                            std::max<std::size_t>(1, plan.references.size())),
      limits_(limits),
      progress_line_(!is_quiet) {}

CompareRunner::RunOutcome CompareRunner::simulate(const Scene& scene, const RunStart& start,
                                                  const std::string& label, const Watch& watch) {
  progress_ = {.time = 0, .start = 0, .end = scene.run.duration, .label = label};
  RunOutcome outcome;
  EnergyScale scale;
  RunClock clock;
  const Observer observer = [&](const State& state, const AdvanceReport& since, const Auditor& auditor) {
    clock.pause();
    scale.add(auditor.energy());
    watch(state, since, auditor.energy());
    progress_.elapsed = clock.wall_time();
    show_progress(state, since, auditor);
    clock.go_on();
    return !interrupt_.is_requested();
  };
  bool is_out_of_time = false;
  const auto interrupt = [&] {
    is_out_of_time = is_out_of_time || (limits_.cpu_time && clock.is_over(*limits_.cpu_time));
    return is_out_of_time || interrupt_.is_requested();
  };
  outcome.result = run_simulation(scene.model, scene.method, scene.run, start.state, observer, interrupt);
  progress_line_.clear();
  outcome.cpu_time = clock.cpu_time();
  outcome.wall_time = clock.wall_time();
  outcome.end = end_of(outcome.result, scene.run);
  if (outcome.end == RunEnd::interrupted && is_out_of_time) outcome.end = RunEnd::out_of_time;
  outcome.energy_scale = std::max(scale.value(), std::abs(outcome.result.audit.report.work));
  return outcome;
}

ComparedReference CompareRunner::execute(const PlannedReference& planned) {
  ComparedReference told{.name = planned.name, .is_run = planned.scene.has_value()};
  Reference reference{.places = planned.places, .horizon = std::numeric_limits<double>::infinity()};
  if (!planned.scene) {
    told.own.emplace();
    for (const ExpectedPlace& place : planned.places)
      told.own->position.value = std::max(told.own->position.value, place.error);
    references_.push_back(std::move(reference));
    return told;
  }
  const Scene& scene = *planned.scene;
  told.bound = reference.bound = limits_.error_bound.value_or(default_error_bound(*scene.model));
  reference.motion = std::make_unique<MotionRecorder>(scene, most_reference_bytes_);
  const RunOutcome outcome =
      simulate(scene, planned.start,
               "reference: ", [&](const State& state, const AdvanceReport&, const Energy& energy) {
                 reference.motion->write(make_sample(*scene.model, state, energy), {});
               });
  told.cpu_time = outcome.cpu_time;
  told.end = outcome.end;
  if (!was_interrupted()) {
    ErrorOverTime own(planned.rougher->model, reference.motion->recording(), reference.bound,
                      reference.horizon);
    simulate(*planned.rougher, planned.start,
             "error of the reference: ", [&](const State& state, const AdvanceReport&, const Energy& energy) {
               own.observe(state, energy);
             });
    told.own = own.error();
    if (told.own && !told.own->is_good_throughout) reference.horizon = told.own->good_until;
  }
  references_.push_back(std::move(reference));
  return told;
}

std::unique_ptr<ErrorMeasure> CompareRunner::measure_for(const PlannedRun& planned) const {
  if (!planned.reference) return nullptr;
  const Reference& reference = references_[*planned.reference];
  const std::shared_ptr<const Model>& model = planned.scene.model;
  const double bound = limits_.error_bound.value_or(default_error_bound(*model));
  if (!reference.places.empty()) return std::make_unique<ErrorAtPlaces>(model, reference.places, bound);
  return std::make_unique<ErrorOverTime>(model, reference.motion->recording(), bound, reference.horizon);
}

ComparedRun CompareRunner::execute(const PlannedRun& planned) {
  ComparedRun run{.values = planned.values,
                  .label = planned.label,
                  .refusal = planned.refusal,
                  .reference = planned.reference};
  ++number_;
  if (planned.is_refused()) {
    run.end = RunEnd::refused;
    return run;
  }
  const Scene& scene = planned.scene;
  run.step = step_of(scene.run);
  motion_.begin(scene);
  const std::unique_ptr<ErrorMeasure> measure = measure_for(planned);
  std::optional<PageRun> page;
  if (outputs_.page && number_ <= most_drawn_runs) page.emplace(scene, planned.start.state, run.label);
  const Watch watch = [&](const State& state, const AdvanceReport& since, const Energy& energy) {
    motion_.observe(state, energy);
    if (measure) measure->observe(state, energy);
    if (page) page->add(state, since, energy);
    if (outputs_.energies) run.times.push_back(state.t), run.energies.push_back(energy.total());
  };
  RunOutcome outcome;
  try {
    outcome = simulate(scene, planned.start,
                       fmt::format("run {} of {} ({}): ", number_, run_count_, run.label), watch);
  } catch (const InputError& error) {
    run.end = RunEnd::refused;
    run.refusal = error.messages().front();
    return run;
  }
  run.cpu_time = outcome.cpu_time;
  run.end = outcome.end;
  run.end_time = outcome.result.state.t;
  run.audit = std::move(outcome.result.audit);
  run.audit.wall_time = outcome.wall_time;
  run.audit.warnings.insert(run.audit.warnings.begin(), planned.start.warnings.begin(),
                            planned.start.warnings.end());
  run.relative_rise = relative_rise(run.audit, outcome.energy_scale);
  // Without all of the work there is no balance to compare.
  if (!run.audit.knows_work)
    run.relative_rise = run.audit.dissipated = run.audit.max_increase =
        std::numeric_limits<double>::quiet_NaN();
  run.difference = motion_.finish();
  if (measure) run.error = measure->error();
  if (page) {
    const std::function<bool()> has_to_end = [this] { return has_to_end_writing(); };
    const InterruptScope scope(has_to_end);
    try {
      run.page = page->finish(run.audit);
    } catch (const Interrupted&) {
      // The page shows the other runs.
    }
  }
  return run;
}

void CompareRunner::show_progress(const State& state, const AdvanceReport& since, const Auditor& auditor) {
  progress_.time = state.t;
  progress_.impacts += since.impacts;
  progress_.resting += since.resting;
  progress_.energy_drift = auditor.max_increase();
  progress_line_.update(progress_);
}

}  // namespace rigor
