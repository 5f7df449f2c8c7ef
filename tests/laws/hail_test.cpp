// Balls that bounce on piles that rest: what the hybrid scheme is for.

#include "laws/scene_runs.hpp"

#include <gtest/gtest.h>

namespace rigor::test::hail_test {
namespace {

TEST(Hail, TheSlabsLieStillAndEnergyNeverRises) {
  const SceneRun run = run_scene("hail.yaml", {"run.duration=0.5"});
  EXPECT_EQ(run.audit().report.reason, StopReason::reached_end) << run.audit().report.detail;
  EXPECT_EQ(run.audit().violations, std::vector<std::string>{});
  EXPECT_LE(run.audit().max_increase, 1e-9 * run.audit().initial.total());
  // A train of bounces of the slabs would be thousands.
  EXPECT_GE(run.audit().report.impacts, 12);
  EXPECT_LE(run.audit().report.impacts, 300);
  for (int column = 0; column < 4; ++column) {
    const int top = run.body("slab[" + std::to_string(column) + ",0,3]");
    EXPECT_NEAR(run.states.back().position(top).z(), 0.35, 1e-6);
  }
}

}  // namespace
}  // namespace rigor::test::hail_test
