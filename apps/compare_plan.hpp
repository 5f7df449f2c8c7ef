#pragma once

#include "apps/options.hpp"
#include "apps/run_start.hpp"
#include "apps/variation.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace rigor {

/// Runs of one comparison, and of one page or plot: as many as its colours tell apart.
inline constexpr std::size_t most_compared_runs = 64, most_drawn_runs = 8;

/// A run of a comparison before it begins.
struct PlannedRun {
  Combination values;  ///< One of each varied key.
  std::string label;   ///< "method.toi=ratio".
  Scene scene;
  RunStart start;
};

/// All runs of a comparison, read and checked; the others are compared with the first.
struct ComparePlan {
  std::vector<std::string> keys;  ///< That are varied.
  std::vector<PlannedRun> runs;
  std::vector<std::string> warnings;  ///< Of the scenes, each once.
};

/// Reads and checks the scene with every combination of values. Throws UsageError, and InputError with the
/// mistakes of all combinations: each once, with the values that make it unless all do.
ComparePlan read_compare_plan(const CompareOptions& options);

}  // namespace rigor
