#pragma once

#include "apps/compare_reference.hpp"
#include "apps/variation.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace rigor {

/// Largest numbers of runs of a comparison, and of a page or plot: as many as its colours distinguish.
inline constexpr std::size_t most_compared_runs = 64, most_drawn_runs = 8;

/// A run of a comparison before it begins.
struct PlannedRun {
  Combination values;  ///< One value for each varied key.
  std::string label;   ///< "method.toi=ratio".
  Scene scene;         ///< Without a model if the run is refused.
  RunStart start;
  std::string refusal;                     ///< Why the method does not suit this scene; empty if it does.
  std::optional<std::size_t> reference{};  ///< Index of the reference for its error.

  bool is_refused() const { return !refusal.empty(); }
};

/// All runs of a comparison, read and checked; they are compared with the first one that is not refused.
struct ComparePlan {
  std::vector<std::string> keys;  ///< The varied keys.
  std::vector<PlannedRun> runs;
  std::vector<PlannedReference> references;
  std::vector<std::string> warnings;  ///< Warnings of the scenes, each once.
};

/// Reads and checks the scene with every combination of values. A combination that is invalid only because of
/// its choices of `method`, which exist but do not go together, is a refused run. Throws UsageError, and
/// InputError with the errors of all other combinations: each once, with the values that cause it unless all
/// do.
ComparePlan read_compare_plan(const CompareOptions& options);

}  // namespace rigor
