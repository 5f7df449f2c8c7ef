#pragma once

#include "rigor/sim/bulk/bulk_stepper.hpp"
#include "rigor/sim/report/energy.hpp"

#include <algorithm>
#include <limits>
#include <memory>

namespace rigor::test {

/// Of the mechanical energy against that of the beginning [J].
struct EnergyChange {
  double rise = 0;  ///< The greatest of twenty samples, at least 0.
  double last = 0;
};

/// A run of `time` [s] by the many-body path; both infinite if it ends early.
inline EnergyChange substep_energy_change(const std::shared_ptr<const Model>& model, double step,
                                          double time) {
  constexpr int samples = 20;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Environment environment(*model);
  State state = make_initial_state(*model);
  const double start = mechanical_energy(*model, environment, state).total();
  Method method;
  method.scheme = Scheme::time_stepping;
  method.solver = SolverMethod::substep;
  BulkStepper stepper(model, method, step, 1);
  EnergyChange change;
  for (int k = 1; k <= samples; ++k) {
    if (stepper.advance(state, k * time / samples).reason != StopReason::reached_end)
      return {infinity, infinity};
    change.last = mechanical_energy(*model, environment, state).total() - start;
    change.rise = std::max(change.rise, change.last);
  }
  return change;
}

}  // namespace rigor::test
