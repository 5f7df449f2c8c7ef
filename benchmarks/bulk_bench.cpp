// `make bench-bulk`: time and quality of scenes of many bodies, ours beside Bullet's in the same run.

#include "bulk_runs.hpp"
#include "bulk_scenes.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

namespace {

using namespace rigor;
using namespace rigor::bench;

struct BenchOptions {
  std::vector<std::string> scenes;
  BulkRunOptions run;
  int substeps = 0;  ///< 0: the default.
  std::vector<int> threads = {1, 2};
  bool has_exact = false;     ///< Our exact solver too.
  bool has_measures = false;  ///< Ours once more, with the measures of an audit.
  bool has_peers = true;
  double soak_seconds = 0;  ///< Instead of the table.
  ScaleOptions scale;       ///< Instead of the table, if any grains are asked for.
  int churn = 0;            ///< Likewise: grains of which some come and go.
};

std::vector<BulkContender> contenders_of(const BenchOptions& options) {
  std::vector<BulkContender> contenders;
#ifdef RIGOR_BENCH_BULLET
  if (options.has_peers) contenders.push_back({"Bullet", make_bullet_engine});
#endif
  for (const int threads : options.threads) {
    const BulkEngineOptions with = {threads, options.substeps, false};
    contenders.push_back({fmt::format("Rigor, {} thread{}", threads, threads == 1 ? "" : "s"),
                          [with](std::shared_ptr<const Model> model) {
                            return make_bulk_world_engine(std::move(model), with);
                          }});
  }
  if (options.has_measures) {
    const BulkEngineOptions with = {options.threads.front(), options.substeps, true};
    contenders.push_back({"Rigor, measures", [with](std::shared_ptr<const Model> model) {
                            return make_bulk_world_engine(std::move(model), with);
                          }});
  }
  if (options.has_exact) contenders.push_back({"Rigor, exact", make_time_stepping_engine});
  return contenders;
}

void print_head() {
  fmt::print(
      "{:<13} {:>6} {:<16} {:>8} {:>8} {:>7} | {:>7} {:>7} {:>6} {:>6} | {:>8} {:>7} {:>7} {:>7} | {:>7} "
      "{:>7} "
      "{:>12}\n",
      "scene", "bodies", "engine", "CPU ms", "wall ms", "Bullet/", "worst", "end", "mean", ">1 cm", "rms m/s",
      "across", "down", "out", "joint", "energy", "free");
  fmt::print("{:<13} {:>6} {:<16} {:>8} {:>8} {:>7} | {:>29} | {:>8} {:>23} | {:>7} {:>7} {:>12}\n", "", "",
             "", "a step", "a step", "CPU", "overlap [mm], pairs", "", "drift [m]", "[mm]", "[%]", "[%]");
}

std::string joints_of(const Model& model, const BulkQuality& quality) {
  if (model.joints().empty()) return "";
  return fmt::format("{:>7.2f} {:>7.2f} {:>5.2f} @{:>4.2f} s", 1e3 * quality.max_joint_error,
                     100 * quality.energy_change, 100 * quality.free_energy_change, quality.free_time);
}

void print_row(const std::string& scene, const Model& model, const BulkRow& row, double peer_ms) {
  const BulkQuality& quality = row.quality;
  const std::string faster = peer_ms > 0 ? fmt::format("{:.2f}", peer_ms / row.cpu_ms) : "-";
  const bool is_pile = begins_standing(scene);
  std::string fate = !quality.is_finite ? "NOT FINITE" : !is_pile ? "" : quality.stands ? "stands" : "fell";
  if (quality.end.lost_bodies > 0) fate += fmt::format(" {} fell out", quality.end.lost_bodies);
  fmt::print(
      "{:<13} {:>6} {:<16} {:>8.3f} {:>8.3f} {:>7} | {:>7.2f} {:>7.2f} {:>6.2f} {:>6} | {:>8.5f} {:>7.4f} "
      "{:>7.4f} {:>7.4f} | {} {}\n",
      scene, model.body_count(), row.engine, row.cpu_ms, row.wall_ms, faster, 1e3 * quality.max_overlap,
      1e3 * quality.end.max_overlap, 1e3 * quality.end.mean_overlap, quality.end.deep_pairs,
      quality.end.rms_speed, quality.end.drift_across, quality.end.drift_down, quality.max_drift_out,
      joints_of(model, quality), fate);
}

/// What our last step worked on; the same with any number of threads.
void print_counts(const std::vector<BulkRow>& rows) {
  for (const BulkRow& row : rows) {
    if (row.counts.pairs == 0) continue;
    fmt::print("{:<20} at the end {} pairs of shapes, {} manifolds, {} points\n", "", row.counts.pairs,
               row.counts.manifolds, row.counts.points);
    return;
  }
}

void print_table(const BenchOptions& options) {
  fmt::print("{} steps of 1/60 s, no sleeping; times are means from step {} on\n", options.run.steps,
             options.run.first_timed);
  print_head();
  const std::vector<BulkContender> contenders = contenders_of(options);
  for (const std::string& scene : options.scenes) {
    const std::shared_ptr<const Model> model = make_bulk_scene(scene);
    const std::vector<BulkRow> rows = run_bulk_scene(model, contenders, options.run);
    const auto peer =
        std::find_if(rows.begin(), rows.end(), [](const BulkRow& row) { return row.engine == "Bullet"; });
    for (const BulkRow& row : rows) print_row(scene, *model, row, peer == rows.end() ? 0 : peer->cpu_ms);
    print_counts(rows);
    std::fflush(stdout);
  }
}

}  // namespace

int main(int argc, char** argv) {
  BenchOptions options;
  CLI::App app("Time and quality of scenes of many bodies, ours beside Bullet's.");
  app.add_option("scenes", options.scenes, "scenes of the table; all if none is named")
      ->check(CLI::IsMember(bulk_scene_names()));
  app.add_option("--steps", options.run.steps, "steps of 1/60 s")->check(CLI::Range(2, 1000000));
  app.add_option("--substeps", options.substeps, "substeps of a step, instead of the default")
      ->check(CLI::Range(1, 1000));
  app.add_option("--threads", options.threads, "numbers of threads of ours")->check(CLI::Range(1, 64));
  app.add_option("--sample", options.run.sample_interval, "steps between two looks at the quality")
      ->check(CLI::Range(1, 1000000));
  app.add_flag("--exact", options.has_exact, "time stepping with the exact solver too (small scenes)");
  app.add_flag("--measures", options.has_measures, "ours once more, with the measures of an audit");
  app.add_flag("!--no-peers", options.has_peers, "ours alone");
  app.add_option("--soak", options.soak_seconds, "instead: run each scene for so many seconds of its time")
      ->check(CLI::Range(1.0, 1e6));
  app.add_option("--scale", options.scale.most, "instead: grains in a hopper, 1000 up to so many")
      ->check(CLI::Range(1000, 1000000));
  app.add_option("--scale-from", options.scale.least, "or so many up to that")
      ->check(CLI::Range(1000, 1000000));
  app.add_option("--churn", options.churn, "instead: so many grains in a hopper, of which some come and go")
      ->check(CLI::Range(100, 1000000));
  const std::map<std::string, Grain> grains = {{"spheres", Grain::sphere}, {"hulls", Grain::hull}};
  app.add_option("--grains", options.scale.grains, "which of them: spheres, hulls")
      ->transform(CLI::CheckedTransformer(grains));
  CLI11_PARSE(app, argc, argv);
  options.scale.substeps = options.substeps;
  if (app.count("--steps") > 0) {
    options.scale.steps = options.run.steps;
    options.scale.first_timed = options.run.steps / 5;
  }
  if (options.scenes.empty()) options.scenes = bulk_scene_names();
  options.run.first_timed = std::min(options.run.first_timed, options.run.steps / 2);
  if (options.soak_seconds > 0) {
    bool is_sound = true;
    for (const std::string& scene : options.scenes) {
      is_sound = soak(scene, options.soak_seconds, options.substeps) && is_sound;
    }
    return is_sound ? 0 : 1;
  }
  if (options.churn > 0) {
    print_churn(options.churn, options.run.steps);
    return 0;
  }
  if (options.scale.most > 0) {
    print_scale(options.scale);
    return 0;
  }
  print_table(options);
  return 0;
}
