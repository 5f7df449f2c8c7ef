// What the audit of whole runs says, as a line of CSV a scene: energy, overlap, contact problems, CPU time.
// tools/measure_piles.py calls it for the random piles. usage: rigor_scene_runs --help

#include "rigor/core/input_error.hpp"
#include "rigor/io/scene/scene_reader.hpp"
#include "rigor/sim/simulation.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include <time.h>

namespace {

using namespace rigor;

/// Overlap is told for the whole run and for its last second, in which piles rest.
constexpr double last_part = 1;

/// Processor time of the program [s].
double process_time() {
  timespec time{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// What is seen of a run at its output times.
struct Course {
  double last_overlap = 0;  ///< Deepest in the last second [m].
  double square_sum = 0;    ///< Of the energy errors, less the work from outside [J²].
  long outputs = 0;
};

const char* end_name(const RunResult& result) {
  if (result.was_stopped) return "out of time";
  if (result.audit.report.reason != StopReason::reached_end) return "stopped";
  return result.audit.violations.empty() ? "ok" : "audit failed";
}

void run(const std::string& path, const std::vector<std::string>& overrides, double cpu_limit) {
  const Scene scene = read_scene(path, overrides);
  const double begin = process_time();
  const auto is_over = [&] { return process_time() - begin > cpu_limit; };
  Course course;
  double initial = 0, work = 0;
  const Observer observer = [&](const State& state, const AdvanceReport& since, const Auditor& auditor) {
    const double energy = auditor.energy().total();
    if (state.t == 0) initial = energy;
    work += since.work;
    const double error = energy - initial - work;
    course.square_sum += error * error;
    ++course.outputs;
    if (state.t > scene.run.duration - last_part)
      course.last_overlap = std::max(course.last_overlap, since.max_penetration);
    return !is_over();
  };
  const RunResult result =
      run_simulation(scene.model, scene.method, scene.run, std::nullopt, observer, is_over);
  const AdvanceReport& report = result.audit.report;
  fmt::print("{},{},{},{:.4g},{:.3g},{:.3g},{:.3g},{:.3g},{},{},{:.3g},{},{},{:.2f}\n",
             std::filesystem::path(path).stem().string(), method_choice(result.audit.method, "scheme"),
             end_name(result), result.state.t, result.audit.max_increase / std::abs(initial),
             course.square_sum / static_cast<double>(course.outputs), report.max_penetration,
             course.last_overlap, report.fallbacks, report.coarse_steps, report.max_residual, report.impacts,
             report.steps, process_time() - begin);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("A line of CSV a scene: what the audit of its run says.");
  std::vector<std::string> scenes, overrides;
  double cpu_limit = 600;
  app.add_option("scene", scenes, "scene files");
  app.add_option("--set", overrides, "KEY=VALUE, as of rigor run");
  app.add_option("--cpu-limit", cpu_limit, "processor time after which a run is ended [s]");
  CLI11_PARSE(app, argc, argv);
  fmt::print(
      "scene,scheme,end,end_time,relative_rise,mean_square_energy_error,overlap,last_overlap,fallbacks,"
      "coarse_"
      "steps,residual,impacts,steps,cpu_time\n");
  try {
    for (const std::string& scene : scenes) run(scene, overrides, cpu_limit);
  } catch (const InputError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
  return 0;
}
