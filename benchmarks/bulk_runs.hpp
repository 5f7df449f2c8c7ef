#pragma once

#include "bulk_engines.hpp"
#include "bulk_quality.hpp"
#include "bulk_scenes.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace rigor::bench {

/// An engine of the table.
struct BulkContender {
  std::string name;
  std::function<std::unique_ptr<BulkEngine>(std::shared_ptr<const Model>)> make;
};

struct BulkRunOptions {
  int steps = 600;          ///< Of 1/60 s.
  int first_timed = 100;    ///< Time is the mean over the steps from this one on.
  int sample_interval = 0;  ///< Steps between two looks at the quality; 0: 10, or 50 in large scenes.
};

/// One row of the table.
struct BulkRow {
  std::string engine;
  double cpu_ms = 0;   ///< CPU time of the process a step [ms].
  double wall_ms = 0;  ///< [ms].
  BulkQuality quality;
  BulkCounts counts;  ///< Of the last step.
};

/// Runs all engines on a scene, a few steps of one and then of the next, so that what else the machine does
/// falls on all alike.
std::vector<BulkRow> run_bulk_scene(std::shared_ptr<const Model> model,
                                    const std::vector<BulkContender>& contenders,
                                    const BulkRunOptions& options);

/// CPU time of the process [s].
double bulk_cpu_seconds();
/// [s].
double bulk_wall_seconds();
/// Memory of the process that is in the machine's [bytes].
double resident_bytes();
/// What the allocator has given out [bytes].
double allocated_bytes();
/// Of all bits of the State.
std::uint64_t state_hash(const State& state);

/// Runs the scene for so long with one thread and with two; whether it stayed finite, had the same bits with
/// both and took no more memory at the end than after half of the time. Prints a line.
bool soak(const std::string& scene, double seconds, int substeps);
/// Grains in a hopper: powers of ten from `least` up to `most`.
struct ScaleOptions {
  int substeps = 0;  ///< 0: the default.
  int least = 1000, most = 0;
  std::vector<Grain> grains = {Grain::sphere, Grain::hull};
  int first_timed = 10, steps = 50;
};
/// Prints how memory and time grow with the number of grains.
void print_scale(const ScaleOptions& options);
/// Prints what it costs that grains come and go (BulkSimulation).
void print_churn(int grains, int steps);

}  // namespace rigor::bench
