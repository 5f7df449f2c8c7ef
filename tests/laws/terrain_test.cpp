// Bodies on height fields.

#include "laws/scene_runs.hpp"
#include "rigor/sim/simulation.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <cstddef>
#include <string>

namespace rigor::test::terrain_test {
namespace {

/// A run of the scene of that text, its files in the folder.
SceneRun run_text(const std::string& text, const std::string& folder = ".") {
  SceneRun run;
  run.scene = parse_scene(text, "text.yaml", folder);
  const Observer observer = [&](const State& state, const AdvanceReport&, const Auditor&) {
    run.states.push_back(state);
    return true;
  };
  run.result = run_simulation(run.scene.model, run.scene.method, run.scene.run, std::nullopt, observer);
  return run;
}

/// A grid of that many cells of height 0 along each side, as a shape of 2 m by 2 m.
std::string flat_field(int cells) {
  std::string row = "[0";
  for (int i = 0; i < cells; ++i) row += ", 0";
  row += "]";
  std::string rows = row;
  for (int i = 0; i < cells; ++i) rows += ", " + row;
  return "{type: heightfield, heights: [" + rows + "], size: [2, 2]}";
}

std::string sliding_scene(const std::string& ground, const std::string& body) {
  return "rigor: 1\nworld: {gravity: [0, 0, -9.81]}\nrun: {duration: 0.4, step: 0.01, output_interval: "
         "0.05}\n"
         "materials: [{name: default, friction: 0.2, restitution: 0}]\n"
         "bodies:\n  - {name: ground, motion: static, shapes: [" +
         ground + "]}\n  - {name: mover, " + body + "}\n";
}

/// Runs the body on a plane and on a flat height field and compares the motions. Contacts at the edges of
/// cells would stop or turn it.
void expect_same_as_on_a_plane(const std::string& body) {
  const SceneRun plane = run_text(sliding_scene("{type: plane}", body));
  const SceneRun field = run_text(sliding_scene(flat_field(30), body));
  ASSERT_EQ(plane.audit().report.reason, StopReason::reached_end) << plane.audit().report.detail;
  ASSERT_EQ(field.audit().report.reason, StopReason::reached_end) << field.audit().report.detail;
  ASSERT_EQ(plane.states.size(), field.states.size());
  const int mover = plane.body("mover");
  for (std::size_t i = 0; i < plane.states.size(); ++i) {
    EXPECT_LT((plane.states[i].position(mover) - field.states[i].position(mover)).norm(), 1e-9);
    EXPECT_LT(plane.states[i].orientation(mover).angularDistance(field.states[i].orientation(mover)), 1e-9);
  }
  // It crossed many cells of 1/15 m.
  EXPECT_GT(plane.states.back().position(mover).x() - plane.states.front().position(mover).x(), 0.3);
}

TEST(Terrain, ABoxSlidesOverAFlatHeightFieldAsOverAPlane) {
  expect_same_as_on_a_plane(
      "position: [-0.5, 0.03, 0.05], rpy: [0, 0, 0.3], velocity: [1.5, 0.2, 0], "
      "shapes: [{type: box, size: [0.3, 0.2, 0.1]}]");
}

TEST(Terrain, ABallSlidesAndRollsOverAFlatHeightFieldAsOverAPlane) {
  expect_same_as_on_a_plane(
      "position: [-0.5, 0.03, 0.1], velocity: [1.5, 0.2, 0], shapes: [{type: sphere, radius: 0.1}]");
}

/// The run ended as it should, and energy never rose.
void expect_sound(const SceneRun& run) {
  EXPECT_EQ(run.audit().report.reason, StopReason::reached_end) << run.audit().report.detail;
  for (const std::string& violation : run.audit().violations) ADD_FAILURE() << violation;
  EXPECT_LE(run.audit().max_increase, 1e-6 * run.audit().initial.total());
}

TEST(Terrain, BallsAndBoxesFallOnHillsWithoutOverlap) {
  const SceneRun run = run_scene("terrain.yaml", {"run.duration=0.28"});
  expect_sound(run);
  EXPECT_GT(run.audit().report.impacts, 0);
  for (const State& state : run.states) {
    EXPECT_TRUE(find_overlaps(*run.scene.model, state, run.scene.method.contact_tolerance).empty())
        << state.t;
  }
}

TEST(Terrain, ABallBetweenTwoFacesComesToRestAfterFewBounces) {
  const SceneRun run = run_text(
      "rigor: 1\nworld: {gravity: [0, 0, -9.81]}\nrun: {duration: 3, step: 0.01, output_interval: 1}\n"
      "materials: [{name: default, density: 800, friction: 0.5, restitution: 0.2}]\n"
      "bodies:\n  - {name: valley, motion: static, shapes: [{type: heightfield, size: [2, 2], heights: "
      "[[0.134, 0, 0.134], [0.134, 0, 0.134], [0.134, 0, 0.134]]}]}\n"
      "  - {name: ball, position: [0, 0, 0.4], shapes: [{type: sphere, radius: 0.15}]}\n");
  expect_sound(run);
  // On slopes ± s the centre is r √(1 + s²) above the line in which they meet.
  const double r = 0.15, rest = r * std::sqrt(1 + 0.134 * 0.134);
  const int ball = run.body("ball");
  const double tolerance = run.scene.method.contact_tolerance;
  EXPECT_LT((run.states.back().position(ball) - Vec3(0, 0, rest)).norm(), 2 * tolerance);
  EXPECT_EQ(run.states.back().linear_momentum(ball), Vec3::Zero());
  // The speeds of the bounces are v0, e v0, e² v0, ... until one is below the resting velocity; each is an
  // impact on either face at most.
  const double v0 = std::sqrt(2 * 9.81 * (0.4 - rest));
  const double bounces = 1 + std::ceil(std::log(run.scene.method.resting_velocity / v0) / std::log(0.2));
  EXPECT_LE(static_cast<double>(run.audit().report.impacts), 2 * bounces);
}

// The red ball of the scene alone.
TEST(Terrain, ABallLiesInItsHollowOnFourPlanarCells) {
  const std::string scenes = std::string(RIGOR_SOURCE_DIR) + "/scenes";
  const SceneRun run = run_text(
      "rigor: 1\nworld: {gravity: [0, 0, -9.81]}\nrun: {duration: 0.5, step: 0.01, output_interval: 0.1}\n"
      "method: {contact_tolerance: 1e-7}\n"
      "materials: [{name: default, density: 800, friction: 0.5, restitution: 0.2}]\n"
      "bodies:\n  - {name: hills, motion: static, shapes: [{type: heightfield, file: heights/hills.csv, "
      "size: [2.4, 2.4], base: 0.1}]}\n"
      "  - {name: red, position: [-0.6, -0.6, 0.4], shapes: [{type: sphere, radius: 0.15}]}\n",
      scenes);
  expect_sound(run);

  // The planes through the lowest point are z = ± s x ± s y; a ball that touches all has its centre at
  // r √(1 + 2 s²) above it, up to the tolerance of contacts.
  const double s = 0.013397 / 0.1, r = 0.15, tolerance = run.scene.method.contact_tolerance;
  const Vec3 expected(-0.6, -0.6, r * std::sqrt(1 + 2 * s * s));
  const int red = run.body("red");
  EXPECT_LT((run.states.back().position(red) - expected).norm(), 2 * tolerance);
  EXPECT_EQ(run.states.back().linear_momentum(red), Vec3::Zero());
}

}  // namespace
}  // namespace rigor::test::terrain_test
