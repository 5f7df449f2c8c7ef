#pragma once

#include <algorithm>
#include <limits>

namespace rigor {

/// Work that a scheme has done beyond what simulated time pays for: a leaking bucket. The work is counted
/// (AdvanceReport::effort) and not timed, so that it is the same on every machine.
struct WorkBudget {
  double rate = 0;                                        ///< What a second of simulated time pays for [1/s].
  double most = std::numeric_limits<double>::infinity();  ///< Who owes more does not go on.
  double owed = 0;
  double t = 0;  ///< Until when time has paid [s].

  /// Enters work done at the time now >= t [s].
  void charge(double effort, double now) {
    owed = std::max(0.0, owed - rate * (now - t)) + effort;
    t = now;
  }
  bool is_exceeded() const { return owed > most; }
};

}  // namespace rigor
