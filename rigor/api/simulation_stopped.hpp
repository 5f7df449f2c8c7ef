#pragma once

#include "rigor/sim/report/advance_report.hpp"

#include <stdexcept>
#include <string>

namespace rigor {

/// A simulation could not continue: what() says when and why. The simulation stands where it stopped, or
/// where the last call of advance_to() began if there is no valid state beyond; it can be changed, restored
/// and tried again.
class SimulationStopped : public std::runtime_error {
 public:
  /// Why, and what was concerned.
  SimulationStopped(StopReason reason, const std::string& message)
      : std::runtime_error(message), reason_(reason) {}
  /// Why.
  StopReason reason() const { return reason_; }

 private:
  StopReason reason_;
};

}  // namespace rigor
