#pragma once

#include "rigor/sim/audit/audit.hpp"
#include "rigor/sim/method/run_settings.hpp"

#include <functional>
#include <memory>
#include <optional>

namespace rigor {

/// Called at each output time with the state there and what happened since the last one. Returns whether the
/// run continues.
using Observer = std::function<bool(const State& state, const AdvanceReport& since, const Auditor& auditor)>;

/// How a run ended.
struct RunResult {
  State state;  ///< At the end of the run.
  Audit audit;
  /// From where a resumed run goes on as if this one had not ended, with the audit so far: the last output.
  State resumable;
  Audit resumable_audit;
  bool was_stopped = false;  ///< By the observer or the interrupt.
};

/// Runs a scene from the start state (the model's own if none is given) until `settings.duration` after t =
/// 0. The observer sees the start and every output time k · output_interval; the result does not depend on
/// whether it looks, nor on when the run ends. The run ends early when the stepper cannot continue:
/// audit.report.reason says why. The interrupt is asked at every event or step; if it returns true, the run
/// ends as it was at the last output time. earlier: the audit of a run that is resumed from `start`.
RunResult run_simulation(std::shared_ptr<const Model> model, const Method& method,
                         const RunSettings& settings, const std::optional<State>& start,
                         const Observer& observer, const std::function<bool()>& interrupt = {},
                         const std::optional<Audit>& earlier = std::nullopt);

/// Two bodies that overlap by more than the tolerance.
struct Overlap {
  int body_A, body_B;
  double depth;  ///< [m].
};
/// All overlaps deeper than the tolerance, by body indices.
std::vector<Overlap> find_overlaps(const Model& model, const State& state, double tolerance);

/// Pushes overlapping bodies apart by translations, lighter ones farther, puts joints back, and anchors the
/// bodies there. Returns the overlaps that are still deeper than the tolerance; empty if it succeeded.
std::vector<Overlap> apply_separation(const Model& model, double tolerance, State& state);

}  // namespace rigor
