#include "apps/audit_text.hpp"
#include "apps/commands.hpp"
#include "apps/overlap_text.hpp"
#include "apps/run_recorder.hpp"
#include "apps/stop_advice.hpp"
#include "apps/terminal.hpp"
#include "apps/usage_error.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/io/audit_json.hpp"
#include "rigor/io/fingerprint.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rigor {

namespace {

/// Where a run begins.
struct Start {
  State state;
  std::optional<Audit> earlier;  ///< Books of the run that is resumed.
  std::vector<std::string> warnings;
};

Start resumed(const RunOptions& options, const Scene& scene) {
  const Checkpoint checkpoint =
      read_checkpoint(options.resume, fingerprint(*scene.model, scene.method, scene.run.step));
  if (checkpoint.state.t >= scene.run.duration) {
    throw UsageError(
        fmt::format("the checkpoint is at t = {:g} s, and the run ends at {:g} s; give a longer --duration",
                    checkpoint.state.t, scene.run.duration));
  }
  return {checkpoint.state, checkpoint.audit, {}};
}

/// How far the bodies were pushed, as a warning; none if nothing moved.
std::vector<std::string> separation_warning(const State& before, const State& after) {
  int moved = 0;
  double farthest = 0;
  for (int i = 0; i < after.body_count(); ++i) {
    const double distance = (after.position(i) - before.position(i)).norm();
    if (distance > 0) ++moved;
    farthest = std::max(farthest, distance);
  }
  if (moved == 0) return {};
  return {
      fmt::format("bodies overlapped at t = 0: {} were pushed apart, by {:.3g} m at most", moved, farthest)};
}

Start begun(const RunOptions& options, const Scene& scene) {
  const double tolerance = scene.method.contact_tolerance;
  const Model& model = *scene.model;
  Start start{make_initial_state(model), std::nullopt, {}};
  std::vector<Overlap> overlaps = find_overlaps(model, start.state, tolerance);
  if (!overlaps.empty() && options.separate) {
    const State as_described = start.state;
    overlaps = apply_separation(model, tolerance, start.state);
    start.warnings = separation_warning(as_described, start.state);
  }
  if (overlaps.empty()) return start;
  std::vector<std::string> messages = overlap_messages(options.scene, model, overlaps, tolerance);
  if (options.separate) {
    messages.back() =
        fmt::format("{}: --separate could not push these bodies apart; move them", options.scene);
  }
  throw InputError(std::move(messages));
}

void print_audit(const RunOptions& options, const Audit& audit) {
  const bool json_takes_stdout = options.json == "-";
  std::FILE* const stream = json_takes_stdout ? stderr : stdout;
  if (json_takes_stdout) fmt::print("{}\n", audit_json(audit));
  if (!options.is_quiet) fmt::print(stream, "{}", audit_text(audit, stream));
}

/// Plots in the terminal, for a user who sits before one.
void print_course(const RunOptions& options, const RunCourse& course) {
  if (options.is_quiet || !is_terminal(stderr)) return;
  std::fflush(stdout);
  fmt::print(stderr, "{}", course.text(terminal_width(stderr), !speaks_utf8()));
}

/// Says why a run is not what it should be, and tells the caller.
ExitCode report_end(const RunResult& result, const RunRecorder& recorder, const Audit& audit) {
  if (!recorder.file_error().empty()) {
    print_error(recorder.file_error());
    return exit_file_error;
  }
  const AdvanceReport& report = result.audit.report;
  if (report.reason != StopReason::reached_end) {
    std::vector<std::string> names;
    for (const int body : report.bodies) names.push_back(audit.bodies[static_cast<std::size_t>(body)].name);
    print_error(stop_text(report, result.state.t, names));
    return exit_stopped;
  }
  if (result.was_stopped && recorder.was_interrupted()) {
    print_error(fmt::format("interrupted at t = {:.17g} s; the files are closed", result.state.t));
    return exit_interrupted;
  }
  return audit.violations.empty() ? exit_done : exit_audit_violated;
}

}  // namespace

ExitCode execute(const RunOptions& options) {
  Scene scene = read_scene(options.scene, options.overrides);
  if (options.duration) scene.run.duration = *options.duration;
  for (const std::string& warning : scene.warnings) print_warning(warning);
  const Start start = options.resume.empty() ? begun(options, scene) : resumed(options, scene);
  for (const std::string& warning : start.warnings) print_warning(warning);

  RunRecorder recorder(options, scene, start.state.t, start.earlier);
  const Observer observer = [&recorder](const State& state, const AdvanceReport& since,
                                        const Auditor& auditor) {
    return recorder.observe(state, since, auditor);
  };
  const RunResult result = run_simulation(scene.model, scene.method, scene.run, start.state, observer,
                                          [&recorder] { return recorder.was_interrupted(); });
  const Audit audit = recorder.finish(result, start.warnings);
  print_audit(options, audit);
  print_course(options, recorder.course());
  return report_end(result, recorder, audit);
}

}  // namespace rigor
