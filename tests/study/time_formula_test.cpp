#include "rigor/study/formula/time_formula.hpp"

#include "rigor/core/input_error.hpp"
#include "rigor/io/scene/scene_reader.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace rigor::time_formula_test {
namespace {

std::string scene_with_rate(const std::string& rate) {
  return R"(
rigor: 1
bodies:
  - {name: wheel, mass: 2, shapes: [{type: sphere, radius: 0.3}]}
joints:
  - {name: axle, type: hinge, bodies: [world, wheel], anchor: [0, 0, 0], axis: [0, 0, 1], motor: {velocity: )" +
         rate + "}}\n";
}

TEST(TimeFormula, ScenesHoldFormulas) {
  use_time_formulas();
  const Scene scene = parse_scene(scene_with_rate("\"t < 1 ? 2*sin(3*t) : pi\""), "test.yaml", ".");
  ASSERT_EQ(scene.model->drives().joints.size(), 1u);
  const TimeFunction& aim = scene.model->drives().joints[0].aim;
  EXPECT_DOUBLE_EQ(aim.value(0.5), 2 * std::sin(1.5));
  EXPECT_DOUBLE_EQ(aim.value(2), std::numbers::pi);
  EXPECT_NEAR(aim.mean(0.2, 0.21), 2.0 / 3 * (std::cos(0.6) - std::cos(0.63)) / 0.01, 1e-12);
}

TEST(TimeFormula, MistakesHaveTheirPlace) {
  use_time_formulas();
  for (const char* const wrong : {"\"2*sin(x)\"", "\"2*\"", "\"1/t\""}) {
    try {
      parse_scene(scene_with_rate(wrong), "test.yaml", ".");
      ADD_FAILURE() << wrong;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("test.yaml:"), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace rigor::time_formula_test
