// Scenes in which meshes touch meshes.

#include "laws/scene_runs.hpp"
#include "rigor/sim/simulation.hpp"

#include <gtest/gtest.h>

namespace rigor::test {
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
  const SceneRun run = run_scene("torus_on_peg.yaml");
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

}  // namespace
}  // namespace rigor::test
