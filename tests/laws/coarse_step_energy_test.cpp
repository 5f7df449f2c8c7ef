// Energy of bodies whose contacts force steps of first order, where joints or springs tie them: motors do the
// work that they are booked with, springs give back what they hold, and nothing else adds to it.

#include "rigor/io/scene/scene_reader.hpp"
#include "rigor/sim/simulation.hpp"

#include <gtest/gtest.h>

namespace rigor::coarse_step_energy_test {
namespace {

TEST(CoarseStepEnergy, OfACarWhoseWheelsGoFromSlipToRollingDoesNotRise) {
  const Scene scene = read_scene(RIGOR_SOURCE_DIR "/tests/data/mechanisms/rolling_car.yaml", {});
  for (const double step : {0.01, 0.008}) {
    RunSettings settings = scene.run;
    settings.step = step;
    const RunResult result =
        run_simulation(scene.model, scene.method, settings, std::nullopt,
                       [](const State&, const AdvanceReport&, const Auditor&) { return true; });
    EXPECT_LT(result.audit.report.motor_work, -30) << step;  // They brake.
    // The promise of event-driven runs: 1e-9 of what moves.
    EXPECT_LE(result.audit.max_increase, 1e-9 * result.audit.initial.kinetic) << step;
  }
}

TEST(CoarseStepEnergy, OfBodiesOnSpringsDoesNotRise) {
  // Springs of 17 to 10,000 N/m; each restitution is another run.
  for (const char* const restitution : {"0", "0.05", "0.3"}) {
    const Scene scene = read_scene(RIGOR_SOURCE_DIR "/tests/data/mechanisms/sprung_row.yaml",
                                   {std::string("materials.m.restitution=") + restitution});
    Method method = scene.method;
    method.scheme = Scheme::event_driven;
    const RunResult result =
        run_simulation(scene.model, method, scene.run, std::nullopt,
                       [](const State&, const AdvanceReport&, const Auditor&) { return true; });
    EXPECT_GT(result.audit.report.coarse_steps, 0) << restitution;
    EXPECT_EQ(result.audit.violations, std::vector<std::string>{}) << restitution;
  }
}

}  // namespace
}  // namespace rigor::coarse_step_energy_test
