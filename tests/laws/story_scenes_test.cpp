// The scenes that `make run` shows give the numbers of their headers: quarters of a pendulum's period in
// closed form.

#include "laws/scene_runs.hpp"

#include "rigor/math/rotation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace rigor::test::story_scenes_test {
namespace {

constexpr double g = 9.81;

void expect_trusted(const SceneRun& run) {
  EXPECT_EQ(run.audit().report.reason, StopReason::reached_end) << run.audit().report.detail;
  for (const std::string& violation : run.audit().violations) ADD_FAILURE() << violation;
}

double first_impact(const SceneRun& run) {
  const auto impact = std::ranges::find(run.events, MotionEvent::Kind::impact, &MotionEvent::kind);
  return impact == run.events.end() ? -1 : impact->time;
}

/// Time from rest at the angle `lift` to the lowest point: √(l/g) K(sin(lift/2)).
double quarter_period(double length, double lift) {
  return std::sqrt(length / g) * std::comp_ellint_1(std::sin(lift / 2));
}

TEST(StoryScenes, NewtonsCradleHandsTheBallOnUnderGravity) {
  const SceneRun run = run_scene("newtons_cradle.yaml");
  expect_trusted(run);
  const double length = 0.2, lift = 40 * M_PI / 180, gap = 1e-4, height = length * (1 - std::cos(lift));
  // The gap is passed near the lowest point at full speed; neglected is its square, (gap/length)².
  const double expected = quarter_period(length, lift) + gap / std::sqrt(2 * g * height);
  EXPECT_NEAR(first_impact(run), expected, 1e-9);
  double highest = 0;
  for (const State& state : run.states) highest = std::max(highest, state.position(run.body("ball5")).z());
  EXPECT_NEAR(highest / height, 1, 1e-3);
  EXPECT_NEAR(run.audit().final.total(), run.audit().initial.total(), 1e-12);
}

TEST(StoryScenes, TheSwingStrikesAfterAQuarterOfItsPeriod) {
  const SceneRun run = run_scene("chain_reaction.yaml", {"run.duration=0.3"});
  expect_trusted(run);
  EXPECT_NEAR(first_impact(run), quarter_period(0.28, M_PI / 3), 1e-9);
}

TEST(StoryScenes, TheChainReactionRunsToItsEnd) {
  // The story does not hang on the scheme: the quickest one tells it, too.
  const SceneRun run =
      run_scene("chain_reaction.yaml", {"method.scheme=time-stepping", "method.solver=substep"});
  expect_trusted(run);
  // A fallen domino lies or leans on the next: its long axis is more than 30 degrees from upright.
  const State& end = run.result.state;
  for (int i = 1; i <= 13; ++i) {
    const std::string name = "domino" + std::to_string(i);
    EXPECT_LT(rotation_matrix(end.orientation(run.body(name)))(2, 2), std::cos(M_PI / 6)) << name;
  }
  // The uppermost cube began 0.325 m above the ground, which is at -0.3 m.
  EXPECT_LT(run.end_of("cube14").position.z(), -0.3 + 0.15);
}

}  // namespace
}  // namespace rigor::test::story_scenes_test
