// What joints hold taut swings across them, the faster the tighter. Steps that do not resolve it gain energy
// without bound.

#include "rigor/sim/penalty/penalty_stepper.hpp"
#include "rigor/sim/report/energy.hpp"
#include "sim/taut_bridges.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace rigor::penalty_taut_joints_test {
namespace {

/// Largest deviation of the energy from what it was at the beginning, as a part of the largest kinetic
/// energy.
double energy_error(const std::shared_ptr<const Model>& model, double step, double end) {
  const Environment environment(*model);
  State state = make_initial_state(*model);
  const double start = mechanical_energy(*model, environment, state).total();
  PenaltyStepper stepper(model, Method{}, step);
  double error = 0, kinetic = 0;
  for (int k = 1; k <= 50; ++k) {
    const AdvanceReport report = stepper.advance(state, k * end / 50);
    if (report.reason != StopReason::reached_end) return 1;
    const Energy energy = mechanical_energy(*model, environment, state);
    kinetic = std::max(kinetic, energy.kinetic);
    error = std::max(error, std::abs(energy.total() - start));
  }
  return error / kinetic;
}

TEST(PenaltyTautJoints, NearlyStraightBridgesKeepTheirEnergy) {
  test::Random random(18);
  for (int k = 0; k < 6; ++k) {
    SCOPED_TRACE(k);
    const std::shared_ptr<const Model> model = test::taut_bridge(random);
    EXPECT_LE(energy_error(model, random.uniform(0.002, 0.02), 0.5), 2e-3);
  }
}

}  // namespace
}  // namespace rigor::penalty_taut_joints_test
