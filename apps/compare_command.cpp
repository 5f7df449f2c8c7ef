#include "apps/commands.hpp"
#include "apps/compare_output.hpp"
#include "apps/compare_plan.hpp"
#include "apps/compare_run.hpp"
#include "apps/compare_table.hpp"
#include "apps/stop_advice.hpp"
#include "apps/terminal.hpp"
#include "rigor/core/interrupt.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/io/files/file_error.hpp"
#include "rigor/io/files/output_file.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rigor {

namespace {

/// Finds out before the runs what cannot be written; throws FileError.
void check_files(const CompareOptions& options) {
  for (const std::string& output : options.outputs) check_can_write(output);
  if (!options.json.empty() && options.json != "-") check_can_write(options.json);
}

CompareOutputs all_outputs(const CompareOptions& options) {
  CompareOutputs all;
  for (const std::string& output : options.outputs) {
    const CompareOutputs own = outputs_of(output);
    all.energies = all.energies || own.energies;
    all.page = all.page || own.page;
  }
  return all;
}

bool is_interrupted(const Comparison& comparison) {
  return comparison.runs.empty() || !comparison.not_run.empty() ||
         comparison.runs.back().end == RunEnd::interrupted;
}

std::string scene_name(const ComparePlan& plan) {
  const auto run = std::find_if(plan.runs.begin(), plan.runs.end(),
                                [](const PlannedRun& each) { return !each.is_refused(); });
  return run->scene.name;
}

Comparison run_all(ComparePlan plan, CompareRunner& runner) {
  Comparison comparison{scene_name(plan), plan.keys, {}, {}, {}};
  for (const PlannedReference& planned : plan.references) {
    if (!runner.was_interrupted()) comparison.references.push_back(runner.execute(planned));
  }
  for (PlannedRun& planned : plan.runs) {
    if (runner.was_interrupted()) {
      comparison.not_run.push_back(planned.label);
      continue;
    }
    comparison.runs.push_back(runner.execute(planned));
    // The model is no longer needed.
    planned.scene.model.reset();
  }
  return comparison;
}

void print_comparison(const CompareOptions& options, const Comparison& comparison) {
  constexpr int file_width = 100;
  const bool json_takes_stdout = options.json == "-";
  std::FILE* const stream = json_takes_stdout ? stderr : stdout;
  if (json_takes_stdout) fmt::print("{}", compare_json(comparison, true));
  const int width = is_terminal(stream) ? terminal_width(stream) : file_width;
  if (!options.is_quiet) fmt::print(stream, "{}", compare_table(comparison, width, stream));
}

/// Writes all files, even after one of them fails; how that ended.
ExitCode write_files(const CompareOptions& options, const Comparison& comparison,
                     const CompareRunner& runner) {
  ExitCode end = exit_done;
  const std::function<bool()> has_to_end = [&runner] { return runner.has_to_end_writing(); };
  const auto attempt = [&](const auto& write) {
    try {
      write();
    } catch (const FileError& error) {
      print_error(error.what());
      end = exit_file_error;
    }
  };
  for (const std::string& output : options.outputs) {
    try {
      const InterruptScope scope(has_to_end);
      attempt([&] { write_comparison(comparison, output); });
    } catch (const Interrupted&) {
      print_error(fmt::format("interrupted: {} was not written", quoted_text(output)));
      if (end == exit_done) end = exit_interrupted;
    }
  }
  if (!options.json.empty() && options.json != "-")
    attempt([&] { write_text(options.json, compare_json(comparison, true)); });
  return end;
}

/// Reports the runs that failed in some way, and returns the exit code.
ExitCode report_ends(const Comparison& comparison) {
  bool has_stopped = false, has_failed = false, has_refused = false;
  for (const ComparedRun& run : comparison.runs) {
    has_refused = has_refused || run.end == RunEnd::refused;
    if (run.end == RunEnd::refused) print_error(fmt::format("{}: refused: {}", run.label, run.refusal));
    has_stopped = has_stopped || run.end == RunEnd::stopped || run.end == RunEnd::out_of_time;
    has_failed = has_failed || run.end == RunEnd::audit_failed;
    if (run.end == RunEnd::stopped)
      print_error(fmt::format("{}: {}", run.label, stop_text(run.audit, run.end_time)));
  }
  if (comparison.runs.empty()) {
    print_error("interrupted before the first run");
    return exit_interrupted;
  }
  if (is_interrupted(comparison)) {
    const ComparedRun& last = comparison.runs.back();
    print_error(fmt::format("interrupted in run {} of {} ({}) at t = {:.9g} s; the files are closed",
                            comparison.runs.size(), comparison.runs.size() + comparison.not_run.size(),
                            last.label, last.end_time));
    return exit_interrupted;
  }
  if (has_stopped) return exit_stopped;
  if (has_refused) return exit_bad_input;
  return has_failed ? exit_audit_violated : exit_done;
}

}  // namespace

ExitCode execute(const CompareOptions& options) {
  ComparePlan plan = read_compare_plan(options);
  check_files(options);
  for (const std::string& warning : plan.warnings) print_warning(warning);
  // It stays alive while the files are written, so that an interrupt does not leave them half written.
  CompareRunner runner(all_outputs(options), plan, {options.error_bound, options.cpu_limit},
                       options.is_quiet);
  const Comparison comparison = run_all(std::move(plan), runner);
  if (comparison.runs.empty()) return report_ends(comparison);
  print_comparison(options, comparison);
  const ExitCode of_files = write_files(options, comparison, runner);
  const ExitCode end = report_ends(comparison);
  return of_files == exit_done ? end : of_files;
}

}  // namespace rigor
