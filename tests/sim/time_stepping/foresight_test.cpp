// Motions that are guessed before the first try of a step.

#include "rigor/sim/time_stepping/time_stepper.hpp"
#include "sim/time_stepping_scenes.hpp"

#include <gtest/gtest.h>

namespace rigor::foresight_test {
namespace {

/// A block slides against a curb and stops; a ball flies over the curb past the block, through where this
/// would be if it went on. Where the curb is far away, it strikes the side of the block.
std::shared_ptr<const Model> block_and_ball(double curb, double restitution = 0) {
  ModelBuilder builder = test::stepping_builder(restitution, 0, Vec3::Zero());
  BodyDescription block = test::stepping_body("block", Box{Vec3::Constant(0.05)}, Vec3(0, -0.05, 0.05));
  block.velocity = Vec3(0, 8, 0);
  builder.add_body(block);
  BodyDescription wall = test::stepping_body("curb", Box{Vec3(0.5, 0.1, 0.03)}, Vec3(0, curb + 0.1, 0.03));
  wall.motion = MotionType::fixed;
  wall.mass = {};
  builder.add_body(wall);
  BodyDescription ball = test::stepping_body("ball", Sphere{0.02}, Vec3(0.1, 0.05, 0.085));
  ball.velocity = Vec3(-4, 0, 0);
  builder.add_body(ball);
  return builder.build();
}

/// The velocities of block and ball after one step of 10 ms.
std::pair<Vec3, Vec3> after_a_step(const std::shared_ptr<const Model>& model) {
  Method method;
  method.scheme = Scheme::time_stepping;
  State state = make_initial_state(*model);
  TimeStepper stepper(model, method, 0.01);
  stepper.advance(state, 0.01);
  return {linear_velocity(*model, state, 1), linear_velocity(*model, state, 3)};
}

TEST(Foresight, OfWhatDoesNotComeIsTakenBack) {
  const auto [block, ball] = after_a_step(block_and_ball(0.01));
  // The block comes to the curb by the end of the step.
  EXPECT_LE((block - Vec3(0, 1, 0)).norm(), 1e-9);
  EXPECT_LE((ball - Vec3(-4, 0, 0)).norm(), 1e-12);
}

TEST(Foresight, NothingBouncesOffWhatDoesNotCome) {
  // A try shows that the block meets the curb first. It bounces back, and the ball is where it never comes:
  // it lost more than half of its speed at nothing.
  const auto [block, ball] = after_a_step(block_and_ball(0.01, 0.5));
  EXPECT_LE((block - Vec3(0, -4, 0)).norm(), 1e-9);
  EXPECT_LE((ball - Vec3(-4, 0, 0)).norm(), 1e-12);
}

TEST(Foresight, OfWhatALimitStopsIsTakenBack) {
  // The same without curb and floor: a slider holds the block, up to where its limit stops it.
  ModelBuilder builder;
  builder.add_material({"m", 1000, 0, 0});
  BodyDescription block = test::stepping_body("block", Box{Vec3::Constant(0.05)}, Vec3(0, -0.05, 0.05));
  block.velocity = Vec3(0, 8, 0);
  builder.add_body(test::stepping_body("far", Sphere{0.02}, Vec3(5, 5, 5)));
  builder.add_body(block);
  BodyDescription ball = test::stepping_body("ball", Sphere{0.02}, Vec3(0.1, 0.05, 0.085));
  ball.velocity = Vec3(-4, 0, 0);
  builder.add_joint({.name = "slider",
                     .type = JointType::slider,
                     .bodies = {"world", "block"},
                     .anchors = {Vec3(0, -0.05, 0.05)},
                     .axis = Vec3::UnitY(),
                     .axes = {JointAxis{.upper = 0.01}}});
  builder.add_body(test::stepping_body("other", Sphere{0.02}, Vec3(-5, 5, 5)));
  builder.add_body(ball);
  const auto [stopped, passed] = after_a_step(builder.build());
  EXPECT_LE((stopped - Vec3(0, 1, 0)).norm(), 1e-9);
  EXPECT_LE((passed - Vec3(-4, 0, 0)).norm(), 1e-12);
}

TEST(Foresight, OfWhatComesStays) {
  const auto [block, ball] = after_a_step(block_and_ball(1));
  EXPECT_GT(ball.x(), -3.5);
  EXPECT_LT(block.x(), -0.5);
}

}  // namespace
}  // namespace rigor::foresight_test
