#include "apps/audit_text.hpp"
#include "apps/commands.hpp"
#include "apps/run_recorder.hpp"
#include "apps/run_start.hpp"
#include "apps/singular_warning.hpp"
#include "apps/slow_warning.hpp"
#include "apps/stop_advice.hpp"
#include "apps/terminal.hpp"
#include "apps/usage_error.hpp"
#include "rigor/core/interrupt.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/io/trajectory/audit_json.hpp"
#include "rigor/io/trajectory/fingerprint.hpp"

#include <fmt/format.h>

#include <ctime>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rigor {

namespace {

/// Where a run begins.
struct Start {
  State state;
  std::optional<Audit> earlier;  ///< Audit of the resumed run.
  std::vector<std::string> warnings;
};

Start resumed(const RunOptions& options, const Scene& scene) {
  const Checkpoint checkpoint =
      read_checkpoint(options.resume, fingerprint(*scene.model, scene.method, scene.run.step), *scene.model);
  if (checkpoint.state.t >= scene.run.duration) {
    throw UsageError(
        fmt::format("the checkpoint is at t = {:g} s, and the run ends at {:g} s; give a longer --duration",
                    checkpoint.state.t, scene.run.duration));
  }
  return {checkpoint.state, checkpoint.audit, {}};
}

Start begun(const RunOptions& options, const Scene& scene) {
  RunStart start = make_run_start(options.scene, scene, options.separate);
  return {std::move(start.state), std::nullopt, std::move(start.warnings)};
}

void print_audit(const RunOptions& options, const Audit& audit) {
  const bool json_takes_stdout = options.json == "-";
  std::FILE* const stream = json_takes_stdout ? stderr : stdout;
  if (json_takes_stdout) fmt::print("{}\n", audit_json(audit));
  if (!options.is_quiet) fmt::print(stream, "{}", audit_text(audit, stream));
}

/// Plots in the terminal, for an interactive user.
void print_sparkline(const RunOptions& options, const RunSparkline& course) {
  if (options.is_quiet || !is_terminal(stderr)) return;
  std::fflush(stdout);
  fmt::print(stderr, "{}", course.text(terminal_width(stderr), !speaks_utf8()));
}

/// Ends a run that takes more processor time, of all its threads, than it may. Steps are often shorter than
/// the system takes to tell the time, so it is asked seldom.
class CpuLimit {
 public:
  explicit CpuLimit(std::optional<double> limit) : limit_(limit) {}

  bool ends_run() {
    is_over_ = is_over_ || (limit_ && ++calls_ % 16 == 0 && time() > *limit_);
    return is_over_;
  }
  /// How the run ended.
  std::string text(double t) const {
    return fmt::format(
        "out of time: --cpu-limit {:g} ended the run after {:.3g} s of processor time at t = {:.9g} s; the "
        "files are closed",
        *limit_, time(), t);
  }

 private:
  double time() const { return static_cast<double>(std::clock() - begin_) / CLOCKS_PER_SEC; }

  std::optional<double> limit_;
  std::clock_t begin_ = std::clock();
  long calls_ = 0;
  bool is_over_ = false;
};

/// Reports why a run failed, and returns the exit code. out_of_time: empty, or how its limit ended it.
ExitCode report_end(const RunResult& result, const RunRecorder& recorder, const Audit& audit,
                    const std::string& out_of_time) {
  for (const std::string& name : recorder.given_up())
    print_error(fmt::format("interrupted: {} was not written", quoted_text(name)));
  if (!recorder.file_error().empty()) {
    print_error(recorder.file_error());
    return exit_file_error;
  }
  if (result.audit.report.reason != StopReason::reached_end) {
    print_error(stop_text(result.audit, result.state.t));
    return exit_stopped;
  }
  if (!out_of_time.empty()) {
    print_error(out_of_time);
    return exit_stopped;
  }
  if (recorder.was_interrupted() && (result.was_stopped || !recorder.given_up().empty())) {
    print_error(fmt::format("interrupted at t = {:.9g} s; the files are closed", result.state.t));
    return exit_interrupted;
  }
  return audit.violations.empty() ? exit_done : exit_audit_violated;
}

/// Warnings of what the run will meet. A signal ends the search for them; the run then ends where it begins.
void print_foresight(const Scene& scene, const State& start, const RunRecorder& recorder) {
  const std::function<bool()> has_to_end = [&] { return recorder.was_interrupted(); };
  const InterruptScope scope(has_to_end);
  try {
    for (const std::string& warning : {singular_warning(scene, start), slow_warning(scene, start)})
      if (!warning.empty()) print_warning(warning);
  } catch (const Interrupted&) {
    return;
  }
}

}  // namespace

ExitCode execute(const RunOptions& options) {
  Scene scene = read_scene(options.scene, options.overrides);
  if (options.duration) scene.run.duration = *options.duration;
  scene.run.threads = options.threads;
  for (const std::string& warning : scene.warnings) print_warning(warning);
  const Start start = options.resume.empty() ? begun(options, scene) : resumed(options, scene);
  for (const std::string& warning : start.warnings) print_warning(warning);

  RunRecorder recorder(options, scene, start.state.t, start.earlier ? start.earlier->wall_time : 0);
  print_foresight(scene, start.state, recorder);
  const Observer observer = [&recorder](const State& state, const AdvanceReport& since,
                                        const Auditor& auditor) {
    return recorder.observe(state, since, auditor);
  };
  CpuLimit limit(options.cpu_limit);
  const RunResult result = run_simulation(
      scene.model, scene.method, scene.run, start.state, observer,
      [&] { return recorder.was_interrupted() || limit.ends_run(); }, start.earlier);
  std::vector<std::string> warnings = start.warnings;
  const bool is_out_of_time = result.was_stopped && limit.ends_run() && !recorder.was_interrupted();
  const std::string out_of_time = is_out_of_time ? limit.text(result.state.t) : "";
  if (is_out_of_time) warnings.push_back(out_of_time);
  const Audit audit = recorder.finish(result, warnings);
  print_audit(options, audit);
  print_sparkline(options, recorder.course());
  return report_end(result, recorder, audit, out_of_time);
}

}  // namespace rigor
