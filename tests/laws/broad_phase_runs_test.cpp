// The broad phase is a matter of cost only: runs are the same bit for bit.

#include "laws/scene_runs.hpp"

#include <gtest/gtest.h>

namespace rigor::test::broad_phase_runs_test {
namespace {

TEST(BroadPhaseRuns, AreTheSameBitForBitUnderBothMethods) {
  for (const char* scene : {"billiards.yaml", "dominoes.yaml", "cradle.yaml", "gas.yaml"}) {
    const std::string duration = "run.duration=0.3";
    const SceneRun tree = run_scene(scene, {duration, "method.broad_phase=tree"});
    const SceneRun sweep = run_scene(scene, {duration, "method.broad_phase=sweep-and-prune"});
    ASSERT_EQ(tree.states.size(), sweep.states.size()) << scene;
    for (std::size_t k = 0; k < tree.states.size(); ++k) {
      EXPECT_EQ(tree.states[k], sweep.states[k]) << scene;
    }
    EXPECT_EQ(tree.result.audit.report.impacts, sweep.result.audit.report.impacts) << scene;
  }
}

}  // namespace
}  // namespace rigor::test::broad_phase_runs_test
