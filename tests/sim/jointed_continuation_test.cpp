// What a stepper keeps of joints from question to question (rows, factors) never shows: a new stepper goes on
// from a State with the same bits.

#include "sim/time_stepping_scenes.hpp"

#include "rigor/sim/make_stepper.hpp"

#include <gtest/gtest.h>

namespace rigor::jointed_continuation_test {
namespace {

/// Two parallel rods hang from the world and carry a coupler, so that rows of their hinges say the same
/// twice. A motor of limited force drives the first up to its limit; from the coupler a rod hangs on a ball
/// joint and drags over the floor.
std::shared_ptr<const Model> driven_linkage() {
  ModelBuilder builder = test::stepping_builder(0.2, 0.4, Vec3(0, 0, -9.81));
  const Box upright{Vec3(0.03, 0.02, 0.25)};
  builder.add_body(test::stepping_body("left", upright, Vec3(0, 0, 0.75)));
  builder.add_body(test::stepping_body("right", upright, Vec3(0.6, 0, 0.75)));
  builder.add_body(test::stepping_body("coupler", Box{Vec3(0.3, 0.03, 0.02)}, Vec3(0.3, 0, 0.5)));
  builder.add_body(test::stepping_body("drag", Box{Vec3(0.24, 0.03, 0.02)}, Vec3(0.54, 0, 0.46)));
  const auto join = [&](const std::string& a, const std::string& b, JointType type, const Vec3& at,
                        const std::vector<JointAxis>& axes) {
    ModelBuilder::JointDescription joint;
    joint.name = a + "-" + b;
    joint.type = type;
    joint.bodies = {a, b};
    joint.anchors = {at};
    joint.axis = Vec3::UnitY();
    joint.axes = axes;
    builder.add_joint(joint);
  };
  JointAxis driven;
  driven.lower = -0.4;
  driven.upper = 0.35;
  driven.motor = JointMotor{3, 12};
  join("world", "left", JointType::hinge, Vec3(0, 0, 1), {driven});
  join("world", "right", JointType::hinge, Vec3(0.6, 0, 1), {});
  join("left", "coupler", JointType::hinge, Vec3(0, 0, 0.5), {});
  join("right", "coupler", JointType::hinge, Vec3(0.6, 0, 0.5), {});
  join("coupler", "drag", JointType::ball, Vec3(0.3, 0, 0.46), {});
  return builder.build();
}

class JointedContinuation : public testing::TestWithParam<Scheme> {};

TEST_P(JointedContinuation, IsTheSameBitForBit) {
  const std::shared_ptr<const Model> model = driven_linkage();
  Method method;
  method.scheme = GetParam();
  constexpr double step = 0.01, interval = 0.04;
  State state = make_initial_state(*model);
  const std::unique_ptr<Stepper> kept = make_stepper(model, method, step);
  for (int k = 1; k <= 15; ++k) {
    State copy = state;
    ASSERT_EQ(make_stepper(model, method, step)->advance(copy, interval * k).reason, StopReason::reached_end);
    ASSERT_EQ(kept->advance(state, interval * k).reason, StopReason::reached_end);
    ASSERT_EQ(state, copy) << "at t = " << state.t;
  }
}

INSTANTIATE_TEST_SUITE_P(Schemes, JointedContinuation,
                         testing::Values(Scheme::event_driven, Scheme::time_stepping, Scheme::hybrid));

}  // namespace
}  // namespace rigor::jointed_continuation_test
