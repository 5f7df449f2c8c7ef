// Angular momentum of jointed bodies whose contacts force steps of first order.

#include "rigor/io/scene/scene_reader.hpp"
#include "rigor/sim/simulation.hpp"

#include <gtest/gtest.h>

namespace rigor::jointed_momenta_test {
namespace {

TEST(JointedMomenta, JointsPutBackAfterCoarseStepsExertNoMoment) {
  // A tree of joints, grounded by a hinge, with limits and a motor, whose bodies touch and stick and slip.
  const Scene scene = read_scene(RIGOR_SOURCE_DIR "/tests/data/mechanisms/coarse_tree.json", {});
  for (const double step : {0.01, 0.004}) {
    RunSettings settings = scene.run;
    settings.step = step;
    double largest = 0;
    const RunResult result =
        run_simulation(scene.model, scene.method, settings, std::nullopt,
                       [&](const State& state, const AdvanceReport& since, const Auditor&) {
                         largest = std::max(largest, total_momentum(*scene.model, state).angular.norm());
                         for (const MotionEvent& event : since.events)
                           largest = std::max(largest, event.p_W.cross(event.j_W).norm());
                         return true;
                       });
    EXPECT_GT(result.audit.report.coarse_steps, 0);
    EXPECT_GT(result.audit.report.max_joint_projection, 1e-9);
    EXPECT_LE(result.audit.angular_momentum_error, 1e-9 * largest) << step;
    EXPECT_LE(result.audit.linear_momentum_error, 1e-9 * largest) << step;
  }
}

}  // namespace
}  // namespace rigor::jointed_momenta_test
