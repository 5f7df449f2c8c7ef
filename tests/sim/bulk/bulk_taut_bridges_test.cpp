// What joints hold taut swings across them, the faster the tighter: substeps that do not resolve it gained
// energy without bound.

#include "sim/bulk/substep_energy.hpp"
#include "sim/taut_bridges.hpp"

#include <gtest/gtest.h>

#include <memory>

namespace rigor::bulk_taut_bridges_test {
namespace {

/// How far the energy rises above what it was at the beginning within a second, as a part of what gravity
/// does along a metre [1].
double energy_gain(const std::shared_ptr<const Model>& model, double step) {
  double scale = 0;
  for (const Body& body : model->bodies()) scale += body.mass * 9.81;
  return test::substep_energy_change(model, step, 1).rise / scale;
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
