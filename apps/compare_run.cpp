#include "apps/compare_run.hpp"

#include "rigor/sim/simulation.hpp"
#include "rigor/view/page_run.hpp"

#include <fmt/format.h>

#include <chrono>

#include <time.h>

namespace rigor {

namespace {

/// Processor time of this thread [s].
double thread_time() {
  timespec time{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Real and processor time since it began, less the processor time of pauses.
class RunClock {
 public:
  void pause() { paused_at_ = thread_time(); }
  void go_on() { cpu_begin_ += thread_time() - paused_at_; }
  double cpu_time() const { return thread_time() - cpu_begin_; }
  double wall_time() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  double cpu_begin_ = thread_time(), paused_at_ = 0;
};

RunEnd end_of(const RunResult& result, const RunSettings& settings) {
  if (result.audit.report.reason != StopReason::reached_end) return RunEnd::stopped;
  if (result.was_stopped && result.state.t < settings.duration) return RunEnd::interrupted;
  return result.audit.violations.empty() ? RunEnd::passed : RunEnd::audit_failed;
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
  }
  return "";
}

ComparedRun CompareRunner::execute(const PlannedRun& planned) {
  const Scene& scene = planned.scene;
  ComparedRun run{.values = planned.values, .label = planned.label};
  ++number_;
  progress_ = {.time = 0,
               .start = 0,
               .end = scene.run.duration,
               .label = fmt::format("run {} of {} ({}): ", number_, run_count_, run.label)};
  motion_.begin(scene);
  std::optional<PageRun> page;
  if (wishes_.page) page.emplace(scene, planned.start.state, run.label);
  RunClock clock;
  const Observer observer = [&](const State& state, const AdvanceReport& since, const Auditor& auditor) {
    clock.pause();
    motion_.observe(state, auditor.energy());
    if (page) page->add(state, since, auditor.energy());
    if (wishes_.energies) run.times.push_back(state.t), run.energies.push_back(auditor.energy().total());
    progress_.elapsed = clock.wall_time();
    show_progress(state, since, auditor);
    clock.go_on();
    return !interrupt_.is_requested();
  };
  const RunResult result = run_simulation(scene.model, scene.method, scene.run, planned.start.state, observer,
                                          [this] { return interrupt_.is_requested(); });
  progress_line_.clear();
  run.cpu_time = clock.cpu_time();
  run.end = end_of(result, scene.run);
  run.end_time = result.state.t;
  run.audit = result.audit;
  run.audit.wall_time = clock.wall_time();
  run.audit.warnings.insert(run.audit.warnings.begin(), planned.start.warnings.begin(),
                            planned.start.warnings.end());
  run.difference = motion_.finish();
  if (page) run.page = page->finish(run.audit);
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
