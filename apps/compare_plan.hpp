#pragma once

#include "apps/compare_reference.hpp"
#include "apps/variation.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace rigor {

/// Runs of one comparison, and of one page or plot: as many as its colours tell apart.
inline constexpr std::size_t most_compared_runs = 64, most_drawn_runs = 8;

/// A run of a comparison before it begins.
struct PlannedRun {
  Combination values;  ///< One of each varied key.
  std::string label;   ///< "method.toi=ratio".
  Scene scene;         ///< Without a model if the run is refused.
  RunStart start;
  std::string refusal;                     ///< Why the method does not go with this scene; empty: it does.
  std::optional<std::size_t> reference{};  ///< What its error is measured against.

  bool is_refused() const { return !refusal.empty(); }
};

/// All runs of a comparison, read and checked; the others are compared with the first that is not refused.
struct ComparePlan {
  std::vector<std::string> keys;  ///< That are varied.
  std::vector<PlannedRun> runs;
  std::vector<PlannedReference> references;
  std::vector<std::string> warnings;  ///< Of the scenes, each once.
};

/// Reads and checks the scene with every combination of values. A combination that is wrong by its choices of
/// `method` alone, which exist but do not go with the rest, is a refused run. Throws UsageError, and
/// InputError with the mistakes of all other combinations: each once, with the values that make it unless all
/// do.
ComparePlan read_compare_plan(const CompareOptions& options);

}  // namespace rigor
