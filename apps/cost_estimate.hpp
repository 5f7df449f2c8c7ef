#pragma once

#include <functional>
#include <string>
#include <vector>

namespace rigor {

/// What a scene's run would cost with one scheme.
struct SchemeCost {
  std::string scheme;        ///< As a scene file says it, or "as written".
  double cpu_time;           ///< Of the whole run [s].
  bool is_at_least = false;  ///< Whether some moment was too costly to be measured: it takes this or more.
  std::string note = {};     ///< How it was found, if not by a whole run.
};

/// The costs of a run, with the pilot run from which they were measured.
struct CostEstimate {
  double duration;                  ///< Of the run [s].
  double pilot_duration;            ///< How far the pilot run came [s].
  std::vector<SchemeCost> schemes;  ///< The scene's own method first.
};

/// CPU times that an estimate may take [s].
struct EstimateBudget {
  double pilot = 4;     ///< The pilot run.
  double start = 1.5;   ///< Each scheme, from the start of the run.
  double moment = 0.3;  ///< Each scheme, at each of four moments.
};

/// Estimates the CPU time that the run of a scene takes with its own method, and with each other scheme that
/// does not refuse it. Each scheme runs from the start for a second or two; what ends within it is measured.
/// Else, since the cost depends on what touches at the time, a pilot run by `solver: substep`, which is quick
/// for any scene, finds the rest of the motion approximately, and the scheme runs for a part of a second from
/// states along it. Such figures are of this machine, and foresee the order of magnitude: they are too high
/// for event-driven where bodies come to rest. It takes some twenty seconds of CPU time at
/// most. `tell` is
/// told what is being measured. `interrupt` is asked at each event or step; if it returns true, the schemes
/// so far are returned. Throws InputError as read_scene does.
CostEstimate estimate_costs(const std::string& scene_file,
                            const std::function<void(const std::string& what)>& tell,
                            const std::function<bool()>& interrupt, const EstimateBudget& budget = {});

/// A table of the estimate, two columns after an indent of two.
std::string estimate_text(const CostEstimate& estimate);

}  // namespace rigor
