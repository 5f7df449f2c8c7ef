#pragma once

#include "apps/options.hpp"
#include "apps/run_start.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rigor {

/// Whether a key ("run.step", "method.scheme") affects how a scene is computed but not what happens in it:
/// such a key of the reference has no influence on the error of a run. The laws method.impact and
/// method.simultaneous are part of what happens.
bool is_numerical_key(std::string_view key);

/// The reference for the errors of runs: a run of its own, or places that the scene knows.
struct PlannedReference {
  std::string name;  ///< "event-driven, step 0.005 s, tolerance 1e-12" or "the scene's expect".
  std::vector<ExpectedPlace> places;  ///< If not empty, there is no run.
  std::optional<Scene> scene;
  /// The same with twice the step and a coarser tolerance; the difference estimates the error of the
  /// reference.
  std::optional<Scene> rougher;
  RunStart start;
};

/// Checks --reference. Throws UsageError: `none` beside values, or a text without KEY=VALUE.
void check_reference_options(const CompareOptions& options);
/// Whether errors are requested at all: numerical keys are varied or a reference is given, and --reference is
/// not `none`.
bool wants_reference(const CompareOptions& options, const std::vector<std::string>& keys);

/// The reference of the runs that share these values "key=value" of keys that are not numerical: the one that
/// --reference chooses; otherwise the places that the scene expects, if nothing that they depend on is
/// changed; otherwise a converged event-driven run. Throws InputError if its scene is invalid.
PlannedReference plan_reference(const CompareOptions& options, const std::vector<std::string>& varied);

}  // namespace rigor
