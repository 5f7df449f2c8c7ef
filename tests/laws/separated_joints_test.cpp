// Bodies that overlap at t = 0 and hang on joints: pushing them apart leaves every joint whole.

#include "rigor/io/scene/scene_reader.hpp"
#include "rigor/sim/simulation.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <random>
#include <string>
#include <vector>

namespace rigor::test::separated_joints_test {
namespace {

struct Row {
  std::string text;
  std::vector<std::array<Vec3, 2>> anchors;  ///< Of each string: in the world, and on its ball.
};

/// Balls in a row on two strings each, beside their centres, that overlap by up to a tenth of their size.
Row hanging_row(unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  constexpr int count = 5;
  constexpr double pitch = 0.04, string = 0.2;
  Row row{
      "rigor: 1\nname: row\nrun: {duration: 0.1, step: 0.005}\n"
      "materials: [{name: steel, density: 7800, friction: 0.1, restitution: 0.9}]\nbodies:\n",
      {}};
  for (int k = 0; k < count; ++k) {
    const double x = pitch * (k + 0.05 * uniform(generator)),
                 radius = 0.5 * pitch * (1 + 0.05 * uniform(generator));
    row.text += fmt::format(
        "  - {{name: b{}, position: [{}, 0, 0], shapes: [{{type: sphere, radius: {}, material: steel}}]}}\n",
        k, x, radius);
    for (const double side : {-1.0, 1.0}) {
      const Vec3 held(x + 0.2 * pitch * uniform(generator), 0.2 * pitch * uniform(generator), 0);
      row.anchors.push_back({Vec3(pitch * k, side * 0.1, string), held});
    }
  }
  row.text += "joints:\n";
  for (std::size_t i = 0; i < row.anchors.size(); ++i) {
    const auto& [from, to] = row.anchors[i];
    row.text += fmt::format(
        "  - {{name: s{}, type: distance, bodies: [world, b{}], anchors: [[{}, {}, {}], [{}, {}, {}]]}}\n", i,
        i / 2, from.x(), from.y(), from.z(), to.x(), to.y(), to.z());
  }
  return row;
}

TEST(SeparatedJoints, StayWholeAndTheRunPasses) {
  int overlapping = 0;
  for (unsigned seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(seed);
    const Row row = hanging_row(seed);
    const Scene scene = parse_scene(row.text, "row.yaml", ".");
    const double tolerance = scene.method.contact_tolerance;
    State state = make_initial_state(*scene.model);
    const State before = state;
    if (!find_overlaps(*scene.model, state, tolerance).empty()) ++overlapping;
    ASSERT_TRUE(apply_separation(*scene.model, tolerance, state).empty());

    // Each string is as long as it was.
    for (std::size_t i = 0; i < row.anchors.size(); ++i) {
      const auto& [from, to] = row.anchors[i];
      const int ball = static_cast<int>(i / 2);
      const Vec3 own = before.orientation(ball).conjugate() * (to - before.position(ball));
      const Vec3 there = state.position(ball) + state.orientation(ball) * own;
      EXPECT_NEAR((there - from).norm(), (to - from).norm(), 1e-12);
    }
    const RunResult result =
        run_simulation(scene.model, scene.method, scene.run, state,
                       [](const State&, const AdvanceReport&, const Auditor&) { return true; });
    for (const std::string& violation : result.audit.violations) ADD_FAILURE() << violation;
  }
  EXPECT_GT(overlapping, 8);
}

}  // namespace
}  // namespace rigor::test::separated_joints_test
