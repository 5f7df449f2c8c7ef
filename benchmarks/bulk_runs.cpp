// Time and quality of engines on a scene of many bodies.

#include "bulk_runs.hpp"

#include <malloc.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>

namespace rigor::bench {

namespace {

double clock_seconds(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// An engine under way.
struct Lane {
  std::unique_ptr<BulkEngine> engine;
  BulkJudge judge;
  double cpu = 0, wall = 0;  ///< Of the timed steps [s].
};

void take_steps(int count, bool is_timed, Lane& lane) {
  const double cpu = bulk_cpu_seconds(), wall = bulk_wall_seconds();
  for (int k = 0; k < count; ++k) lane.engine->step(1.0 / 60);
  if (!is_timed) return;
  lane.cpu += bulk_cpu_seconds() - cpu;
  lane.wall += bulk_wall_seconds() - wall;
}

int sample_interval_of(const Model& model, const BulkRunOptions& options) {
  if (options.sample_interval > 0) return options.sample_interval;
  const bool has_hulls = std::holds_alternative<Convex>(model.bodies().back().shapes.front().shape);
  return model.body_count() > 4000 || has_hulls ? 50 : 10;
}

}  // namespace

std::vector<BulkRow> run_bulk_scene(std::shared_ptr<const Model> model,
                                    const std::vector<BulkContender>& contenders,
                                    const BulkRunOptions& options) {
  std::vector<Lane> lanes;
  for (const BulkContender& contender : contenders) {
    lanes.push_back(Lane{contender.make(model), BulkJudge(*model)});
  }
  const int interval = sample_interval_of(*model, options);
  int timed = 0;
  for (int step = 0; step < options.steps;) {
    const bool is_timed = step >= options.first_timed;
    const int end = is_timed ? options.steps : std::min(options.first_timed, options.steps);
    const int count = std::min(interval, end - step);
    for (Lane& lane : lanes) {
      // Velocities follow from two looks, a step apart.
      take_steps(count - 1, is_timed, lane);
      const bool is_seen = step + count >= options.first_timed;
      const BulkPoses before = is_seen ? poses_of(lane.engine->state()) : BulkPoses{};
      take_steps(1, is_timed, lane);
      if (is_seen) lane.judge.look(before, poses_of(lane.engine->state()));
    }
    step += count;
    if (is_timed) timed += count;
  }
  std::vector<BulkRow> rows;
  for (std::size_t i = 0; i < lanes.size(); ++i) {
    rows.push_back({contenders[i].name, 1e3 * lanes[i].cpu / timed, 1e3 * lanes[i].wall / timed,
                    lanes[i].judge.quality(), lanes[i].engine->counts()});
  }
  return rows;
}

double bulk_cpu_seconds() {
  return clock_seconds(CLOCK_PROCESS_CPUTIME_ID);
}

double bulk_wall_seconds() {
  return clock_seconds(CLOCK_MONOTONIC);
}

double resident_bytes() {
  std::ifstream statm("/proc/self/statm");
  double total = 0, resident = 0;
  statm >> total >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

double allocated_bytes() {
  const struct mallinfo2 given = mallinfo2();
  return static_cast<double>(given.uordblks) + static_cast<double>(given.hblkhd);
}

/// FNV-1a.
std::uint64_t state_hash(const State& state) {
  std::uint64_t hash = 14695981039346656037u;
  for (const unsigned char byte : serialise(state)) hash = (hash ^ byte) * 1099511628211u;
  return hash;
}

}  // namespace rigor::bench
