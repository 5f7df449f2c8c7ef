// Long runs of the many-body path, and how it grows with the number of bodies.

#include "bulk_runs.hpp"
#include "bulk_scenes.hpp"

#include "rigor/core/input_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace rigor::bench {

namespace {

constexpr double mebi = 1024.0 * 1024.0;

/// What a run holds, and the most manifolds that it had so far.
struct Held {
  double bytes = 0;
  int manifolds = 0;
};

/// Lists grow with what happens (pyramids that fall have other neighbours in each step); what is lost in
/// every step shows in the second half of a run too.
bool is_flat(const Held& half, const Held& end) {
  return end.bytes <= 1.02 * half.bytes + 0.25 * mebi;
}

struct ScaleRow {
  double build = 0, start = 0;  ///< Of the Model, of the world [s].
  double model_bytes = 0;       ///< A body.
  double world_bytes = 0;       ///< A body, State included, after the last step.
  double ms = 0;                ///< CPU time a step.
  int bodies = 0;
  double pairs = 0, manifolds = 0;  ///< A body, in the last step.
  std::uint64_t hash = 0;           ///< Of the State at the end.
};

/// Timed from `untimed` steps on.
ScaleRow measure_scale(int count, Grain grain, int untimed, int steps, const BulkEngineOptions& options) {
  ScaleRow row;
  const double before = allocated_bytes();
  double begin = bulk_cpu_seconds();
  const std::shared_ptr<const Model> model = make_hopper(count, grain);
  row.build = bulk_cpu_seconds() - begin;
  const double with_model = allocated_bytes();
  begin = bulk_cpu_seconds();
  const std::unique_ptr<BulkEngine> engine = make_bulk_world_engine(model, options);
  row.start = bulk_cpu_seconds() - begin;
  for (int k = 0; k < steps; ++k) {
    if (k == untimed) begin = bulk_cpu_seconds();
    engine->step(1.0 / 60);
  }
  row.ms = 1e3 * (bulk_cpu_seconds() - begin) / (steps - untimed);
  row.bodies = model->body_count();
  row.model_bytes = (with_model - before) / row.bodies;
  row.world_bytes = (allocated_bytes() - with_model) / row.bodies;
  row.pairs = static_cast<double>(engine->counts().pairs) / row.bodies;
  row.manifolds = static_cast<double>(engine->counts().manifolds) / row.bodies;
  row.hash = state_hash(engine->state());
  return row;
}

void print_scale_row(Grain grain, const ScaleRow& row) {
  fmt::print(
      "{:<8} {:>8} {:>8.2f} {:>8.3f} {:>6.2f} {:>9.2f} {:>12.0f} {:>12.0f} {:>10.3f} {:>12.3f}  {:016x}\n",
      grain == Grain::sphere ? "spheres" : "hulls", row.bodies, row.build, row.start, row.pairs,
      row.manifolds, row.model_bytes, row.world_bytes, row.ms, 1e3 * row.ms / row.bodies, row.hash);
}

}  // namespace

bool soak(const std::string& scene, double seconds, int substeps) {
  const std::shared_ptr<const Model> model = make_bulk_scene(scene);
  const State start = make_initial_state(*model);
  std::array<std::unique_ptr<BulkEngine>, 2> engines;
  for (int i = 0; i < 2; ++i) {
    engines[static_cast<std::size_t>(i)] = make_bulk_world_engine(model, {i + 1, substeps});
  }
  const int rounds = std::max(1, static_cast<int>(std::lround(seconds)));
  double differs_at = -1;
  Held held, tenth, half;
  BulkPoses before;  // Of the step before the last.
  bool finite = true;
  const double wall = bulk_wall_seconds();
  for (int round = 1; round <= rounds && finite; ++round) {
    std::array<std::uint64_t, 2> hashes{};
    for (std::size_t i = 0; i < 2; ++i) {
      for (int k = 0; k < 59; ++k) engines[i]->step(1.0 / 60);
      if (i == 0) before = poses_of(engines[i]->state());
      engines[i]->step(1.0 / 60);
      const State state = engines[i]->state();
      hashes[i] = state_hash(state);
      finite = finite && VecX::Map(state.x.data(), static_cast<Eigen::Index>(state.x.size())).allFinite() &&
               VecX::Map(state.P.data(), static_cast<Eigen::Index>(state.P.size())).allFinite();
    }
    if (hashes[0] != hashes[1] && differs_at < 0) differs_at = round;
    held.bytes = resident_bytes();
    held.manifolds = std::max(held.manifolds, engines[0]->counts().manifolds);
    if (round == (rounds + 9) / 10) tenth = held;
    if (round == (rounds + 1) / 2) half = held;
  }
  const State state = engines[0]->state();
  const BulkFigures figures = bulk_figures(*model, poses_of(start), before, poses_of(state));
  const bool flat = is_flat(half, held);
  fmt::print(
      "{:<13} {:>6.0f} s  finite {:<3}  same bits {:<12}  memory {:.1f}, {:.1f}, {:.1f} MiB flat {:<3} of "
      "{}, {}, {} "
      "manifolds  overlap {:>6.2f} mm  speed {:>8.5f} m/s  hash {:016x}  took {:.0f} s\n",
      scene, state.t, finite ? "yes" : "NO", differs_at < 0 ? "yes" : fmt::format("NO ({} s)", differs_at),
      tenth.bytes / mebi, half.bytes / mebi, held.bytes / mebi, flat ? "yes" : "NO", tenth.manifolds,
      half.manifolds, held.manifolds, 1e3 * figures.max_overlap, figures.rms_speed, state_hash(state),
      bulk_wall_seconds() - wall);
  std::fflush(stdout);
  return finite && flat && differs_at < 0;
}

void print_scale(const ScaleOptions& options) {
  fmt::print("\nGrains of 0.25 m in a hopper, one thread, steps {} to {}\n", options.first_timed,
             options.steps);
  fmt::print("{:<8} {:>8} {:>8} {:>8} {:>6} {:>9} {:>12} {:>12} {:>10} {:>12}  {}\n", "grain", "bodies",
             "build s", "start s", "pairs", "manifolds", "model B/body", "world B/body", "ms a step",
             "us step+body", "hash");
  for (const Grain grain : options.grains) {
    for (const int count : {1000, 10000, 100000, 1000000}) {
      if (count < options.least || count > options.most) continue;
      try {
        print_scale_row(
            grain, measure_scale(count, grain, options.first_timed, options.steps, {1, options.substeps}));
      } catch (const InputError& error) {
        fmt::print("{} bodies: {}\n", count, error.what());
      }
      std::fflush(stdout);
    }
  }
}

}  // namespace rigor::bench
