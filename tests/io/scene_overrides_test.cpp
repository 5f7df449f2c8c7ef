#include "rigor/core/input_error.hpp"
#include "rigor/io/scene/scene_reader.hpp"
#include "rigor/model/state.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace rigor::scene_overrides_test {
namespace {

TEST(Overrides, OfOneNumberOfAListThatIsMissingKeepItsDefault) {
  const std::string text =
      "rigor: 1\nworld: {gravity: [0, 0, -1]}\nbodies:\n"
      "  - {name: a, inertia: {mass: 2, moments: [1, 1, 1]}}\n"
      "  - {name: b, shapes: [{type: sphere, radius: 1}]}\n";
  const auto model_of = [&](const std::vector<std::string>& overrides) {
    return parse_scene(text, "test.yaml", ".", overrides).model;
  };
  const std::shared_ptr<const Model> model =
      model_of({"bodies.a.velocity.2=3", "bodies.a.position.0=-4", "bodies.a.orientation[1]=1",
                "bodies.a.orientation.0=0", "bodies.b.angular_velocity.1=5"});
  const State state = make_initial_state(*model);
  EXPECT_EQ(state.position(0), Vec3(-4, 0, 0));
  EXPECT_EQ(linear_velocity(*model, state, 0), Vec3(0, 0, 3));
  // An angular momentum has been made of it and divided again.
  EXPECT_NEAR(angular_velocity(*model, state, 1).y(), 5, 1e-14);
  EXPECT_NEAR(std::abs(state.orientation(0).x()), 1, 1e-15);
  try {
    model_of({"bodies.a.velocity.3=1"});
    FAIL() << "a fourth number was taken";
  } catch (const InputError& error) {
    EXPECT_EQ(error.messages().front(),
              "--set bodies.a.velocity.3=1: index 3, but the list has 3 entries (the first is 0)");
  }
}

}  // namespace
}  // namespace rigor::scene_overrides_test
