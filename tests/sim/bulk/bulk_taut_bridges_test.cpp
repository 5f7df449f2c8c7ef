// What joints hold taut swings across them, the faster the tighter: substeps that do not resolve it gained
// energy without bound.

#include "rigor/sim/bulk/bulk_stepper.hpp"
#include "rigor/sim/report/energy.hpp"
#include "sim/taut_bridges.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace rigor::bulk_taut_bridges_test {
namespace {

/// How far the energy rises above what it was at the beginning within a second, as a part of what gravity
/// does along a metre [1].
double energy_gain(const std::shared_ptr<const Model>& model, double step) {
  const Environment environment(*model);
  State state = make_initial_state(*model);
  const double start = mechanical_energy(*model, environment, state).total();
  Method method;
  method.scheme = Scheme::time_stepping;
  method.solver = SolverMethod::substep;
  BulkStepper stepper(model, method, step, 1);
  double gain = 0, scale = 0;
  for (const Body& body : model->bodies()) scale += body.mass * 9.81;
  for (int k = 1; k <= 20; ++k) {
    if (stepper.advance(state, k / 20.0).reason != StopReason::reached_end) return 1;
    gain = std::max(gain, mechanical_energy(*model, environment, state).total() - start);
  }
  return gain / scale;
}

TEST(BulkTautBridges, NearlyStraightBridgesGainNoEnergy) {
  test::Random random(20);
  for (int k = 0; k < 20; ++k) {
    SCOPED_TRACE(k);
    const std::shared_ptr<const Model> model = test::taut_bridge(
        random,
        {.least_count = 8, .most_count = 24, .least_sag = 0.004, .most_sag = 0.015, .has_load = true});
    EXPECT_LE(energy_gain(model, random.uniform(0.005, 0.017)), 1e-3);
  }
}

}  // namespace
}  // namespace rigor::bulk_taut_bridges_test
