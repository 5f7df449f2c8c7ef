#pragma once

#include "rigor/model/model.hpp"
#include "rigor/model/state.hpp"
#include "rigor/sim/method/method.hpp"
#include "rigor/sim/method/run_settings.hpp"

#include <memory>

namespace rigor {

/// What a run will ask of a scheme whose work grows with what lies on each other.
struct WorkEstimate {
  /// How often `impulse-based` asks whether to go on, at each collision and in each search; of `penalty`
  /// sub-steps times the bodies that they move. Of the whole run.
  double amount = 0;
  double seconds = 0;  ///< Processor time, to a factor of a few.
};

/// Foresees the work of `impulse-based` and `penalty: local`; nothing of other schemes, whose steps are few
/// or which `auto` leaves where events crowd, nor of scenes with drives. Of jointed bodies the equations of
/// the joints count.
///
/// A pilot run by `solver: substep`, which is quick for any scene, gives states along the run. From each the
/// scheme itself goes on for some hundredths of a second of simulated time, or until it has asked often.
/// Nothing is timed: work is counted, and so are the lengths of pilot and trials, so that the answer is the
/// same on every machine. It takes some milliseconds of a scene that is small or scattered, up to two seconds
/// of a crowd. Throws Interrupted if the scope of this thread asks for an end.
WorkEstimate estimate_work(const std::shared_ptr<const Model>& model, const Method& method,
                           const RunSettings& settings, const State& start);

}  // namespace rigor
