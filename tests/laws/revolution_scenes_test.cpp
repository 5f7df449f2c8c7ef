// Scenes with solids of revolution: rolling on a conical side in closed form, and whole runs against those of
// the cylinder and the cone.

#include "laws/scene_runs.hpp"

#include "rigor/math/rotation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace rigor::test::revolution_scenes_test {
namespace {

constexpr double pi = std::numbers::pi;

void expect_trusted(const SceneRun& run) {
  EXPECT_EQ(run.audit().report.reason, StopReason::reached_end) << run.audit().report.detail;
  for (const std::string& violation : run.audit().violations) ADD_FAILURE() << violation;
}

TEST(RevolutionScenes, TheCupRollsRoundTheApexOfItsSide) {
  const SceneRun run = run_scene("rolling_cup.yaml");
  expect_trusted(run);
  EXPECT_EQ(run.audit().report.impacts, 0);

  // The apex is 0.3 m below the origin of the profile; tan of half its angle is 0.015 / 0.12. The centre of
  // mass is that of two frusta.
  double volume = 0, moment = 0;
  const double profile[3][2] = {{0.03, -0.06}, {0.045, 0.06}, {0.043, 0.064}};
  for (int i = 0; i < 2; ++i) {
    const double a = profile[i][0], b = profile[i + 1][0], h = profile[i + 1][1] - profile[i][1];
    volume += h * (a * a + a * b + b * b) / 3;
    moment += h * (a * a + a * b + b * b) / 3 * profile[i][1] + h * h * (a * a + 2 * a * b + 3 * b * b) / 12;
  }
  const double from_apex = 0.3 + moment / volume, half_angle = std::atan(0.125), rate = 0.5 * pi;
  const int cup = run.body("cup");
  // The integrator's 1e-10 a step, over 400 steps.
  constexpr double tolerance = 1e-8;
  for (const State& state : run.states) {
    const Vec3 axis(std::cos(rate * state.t) * std::cos(half_angle),
                    std::sin(rate * state.t) * std::cos(half_angle), std::sin(half_angle));
    EXPECT_LE((state.position(cup) - from_apex * axis).norm(), tolerance) << state.t;
    EXPECT_LE((rotation_matrix(state.orientation(cup)).col(2) - axis).norm(), 10 * tolerance) << state.t;
    const double turning = angular_velocity(*run.scene.model, state, cup).norm();
    EXPECT_NEAR(turning, 8 * rate, 1e3 * tolerance) << state.t;
  }
}

/// A die-like throw of a round body that bounces, slides and rolls to rest on a floor with a step.
std::string thrown(const std::string& shape, const std::string& duration) {
  return "rigor: 1\nrun: {step: 0.01, output_interval: 0.05, duration: " + duration + R"(}
name: thrown
world: {gravity: [0, 0, -9.81]}
materials:
  - {name: wood, density: 700, friction: 0.4, restitution: 0.5}
bodies:
  - name: floor
    motion: static
    shapes: [{type: plane, material: wood}, {type: box, size: [0.2, 2, 0.1], position: [0.5, 0, 0], material: wood}]
  - name: piece
    position: [0, 0, 0.3]
    rpy: [20 deg, 35 deg, 10 deg]
    velocity: [1, 0.2, 0]
    angular_velocity: [3, 8, 2]
    shapes: [{material: wood, )" +
         shape + "}]\n";
}

SceneRun run_text(const std::string& text) {
  SceneRun run;
  run.scene = parse_scene(text, "thrown.yaml", ".");
  const Observer observer = [&](const State& state, const AdvanceReport& since, const Auditor&) {
    run.events.insert(run.events.end(), since.events.begin(), since.events.end());
    run.states.push_back(state);
    return true;
  };
  run.result = run_simulation(run.scene.model, run.scene.method, run.scene.run, std::nullopt, observer);
  return run;
}

void expect_same_motion(const std::string& basic, const std::string& solid, const std::string& duration) {
  const SceneRun a = run_text(thrown(basic, duration)), b = run_text(thrown(solid, duration));
  expect_trusted(a);
  expect_trusted(b);
  EXPECT_GT(a.audit().report.impacts, 2);
  EXPECT_EQ(a.audit().report.impacts, b.audit().report.impacts);
  ASSERT_EQ(a.states.size(), b.states.size());
  const int piece = a.body("piece");
  for (std::size_t i = 0; i < a.states.size(); ++i) {
    // Rounding grows by about ten at each bounce.
    EXPECT_LE((a.states[i].position(piece) - b.states[i].position(piece)).norm(), 1e-7) << i;
    EXPECT_LE((a.states[i].orientation(piece).coeffs() - b.states[i].orientation(piece).coeffs()).norm(),
              1e-6)
        << i;
  }
}

TEST(RevolutionScenes, AThrownCylinderMovesAsItsProfile) {
  expect_same_motion("type: cylinder, radius: 0.05, length: 0.14",
                     "type: revolution, profile: [[0.05, -0.07], [0.05, 0.07]]", "0.6");
}

TEST(RevolutionScenes, AThrownConeMovesAsItsProfile) {
  // Until it settles on its side: how many of the last small bounces there are rounding decides.
  expect_same_motion("type: cone, radius: 0.06, length: 0.12",
                     "type: revolution, profile: [[0.06, -0.06], [0, 0.06]]", "0.35");
}

}  // namespace
}  // namespace rigor::test::revolution_scenes_test
