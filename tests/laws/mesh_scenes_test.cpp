// Scenes in which meshes touch meshes.

#include "laws/scene_runs.hpp"
#include "rigor/sim/simulation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace rigor::test::mesh_scenes_test {
namespace {

/// The run ended as it should, and at no output time two bodies overlap by more than the tolerance.
void expect_apart(const SceneRun& run) {
  EXPECT_EQ(run.audit().report.reason, StopReason::reached_end) << run.audit().report.detail;
  for (const std::string& violation : run.audit().violations) ADD_FAILURE() << violation;
  EXPECT_LE(run.audit().max_increase, 1e-6 * run.audit().initial.total());
  for (const State& state : run.states) {
    EXPECT_TRUE(find_overlaps(*run.scene.model, state, run.scene.method.contact_tolerance).empty())
        << state.t;
  }
}

TEST(MeshScenes, TorusStaysAboutThePeg) {
  const SceneRun run = run_scene("torus_on_peg.yaml", {"run.duration=0.5"});
  expect_apart(run);
  EXPECT_GT(run.audit().report.impacts, 0);
  const Vec3 place = run.states.back().position(run.body("torus"));
  EXPECT_LT(place.head<2>().norm(), 0.12);  // The radius of the ring.
  EXPECT_LT(place.z(), 0.3);                // Below the top of the peg.
}

TEST(MeshScenes, RocksWithEarsFallWithoutOverlap) {
  const SceneRun run = run_scene("rock_pile.yaml", {"run.duration=0.2"});
  expect_apart(run);
  EXPECT_GT(run.audit().report.impacts, 0);
}

TEST(MeshScenes, PinionTakesTheWheelAlongToothByTooth) {
  const SceneRun run = run_scene("gear_pair.yaml");
  EXPECT_EQ(run.audit().report.reason, StopReason::reached_end) << run.audit().report.detail;
  for (const std::string& violation : run.audit().violations) ADD_FAILURE() << violation;
  EXPECT_GT(run.audit().report.impacts, 1);
  // 50 outputs of two bodies, and what impacts cut short: rounding of momenta that are zero makes no steps.
  EXPECT_LT(run.audit().report.steps, 400);
  const auto angle_of = [&](const State& state, const char* name) {
    const Quat q = state.orientation(run.body(name));
    return 2 * std::atan2(q.z(), q.w());
  };
  const State& start = run.states.front();
  double least_turn = 0;
  for (const State& state : run.states) {
    EXPECT_TRUE(find_overlaps(*run.scene.model, state, run.scene.method.contact_tolerance).empty())
        << state.t;
    const double pinion = angle_of(state, "pinion") - angle_of(start, "pinion");
    const double wheel =
        std::remainder(angle_of(state, "wheel") - angle_of(start, "wheel"), 2 * std::numbers::pi);
    EXPECT_NEAR(pinion, 4 * state.t, 1e-9);
    // 12 against 18 teeth; the teeth have a play of less than a tenth of the pitch to each side.
    EXPECT_NEAR(wheel, -12.0 / 18 * pinion, 0.1 * 2 * std::numbers::pi / 18) << state.t;
    least_turn = std::min(least_turn, wheel);
  }
  EXPECT_LT(least_turn, -1.2);  // More than three teeth.
}

}  // namespace
}  // namespace rigor::test::mesh_scenes_test
