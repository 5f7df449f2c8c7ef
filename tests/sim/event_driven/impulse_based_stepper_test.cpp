#include "rigor/sim/event_driven/impulse_based_stepper.hpp"

#include "rigor/model/model_builder.hpp"
#include "rigor/sim/report/energy.hpp"

#include "sim/time_stepping_scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rigor::impulse_based_stepper_test {
namespace {

constexpr double g = 9.81;

/// Cubes of 0.2 m on top of each other.
std::shared_ptr<const Model> stack_of(int cubes) {
  ModelBuilder builder = test::stepping_builder(0, 0.5, Vec3(0, 0, -g));
  for (int k = 0; k < cubes; ++k)
    builder.add_body(
        test::stepping_body("cube" + std::to_string(k), Box{Vec3(0.1, 0.1, 0.1)}, Vec3(0, 0, 0.1 + 0.2 * k)));
  return builder.build();
}

/// A block on a slope of 20 degrees (gravity is tilted) with 1.01 times the friction that holds it.
std::shared_ptr<const Model> block_on_slope() {
  const double angle = 20 * std::acos(-1.0) / 180;
  ModelBuilder builder =
      test::stepping_builder(0, 1.01 * std::tan(angle), g * Vec3(std::sin(angle), 0, -std::cos(angle)));
  builder.add_body(test::stepping_body("block", Box{Vec3(0.2, 0.2, 0.1)}, Vec3(0, 0, 0.1)));
  return builder.build();
}

double creep_in(MicroCollisionMethod micro_collisions, double duration) {
  const std::shared_ptr<const Model> model = block_on_slope();
  Method method;
  method.micro_collisions = micro_collisions;
  ImpulseBasedStepper stepper(model, method, 0.01);
  State state = make_initial_state(*model);
  EXPECT_EQ(stepper.advance(state, duration).reason, StopReason::reached_end);
  return state.position(1).x();
}

long impacts_of_stack(int cubes, double time) {
  const std::shared_ptr<const Model> model = stack_of(cubes);
  ImpulseBasedStepper stepper(model, Method{}, 0.01);
  State state = make_initial_state(*model);
  const AdvanceReport report = stepper.advance(state, time);
  EXPECT_EQ(report.reason, StopReason::reached_end);
  return report.impacts;
}

TEST(ImpulseBasedStepper, BallOfRestitutionOneKeepsItsEnergyAndItsTimes) {
  ModelBuilder builder = test::stepping_builder(1, 0, Vec3(0, 0, -g));
  builder.add_body(test::stepping_body("ball", Sphere{0.1}, Vec3(0, 0, 1.1)));
  const std::shared_ptr<const Model> model = builder.build();
  const Method method;
  ImpulseBasedStepper stepper(model, method, 0.01);
  State state = make_initial_state(*model);
  const AdvanceReport report = stepper.advance(state, 5);
  // It falls from 1 m to half the contact tolerance below the plane.
  const double fall = std::sqrt(2 * (1 + 0.5 * method.contact_tolerance) / g);
  ASSERT_EQ(report.events.size(), 6u);
  for (std::size_t k = 0; k < 6; ++k)
    EXPECT_NEAR(report.events[k].time, (2 * static_cast<double>(k) + 1) * fall, 1e-12);
  EXPECT_LE(report.impact_loss + report.impact_gain, 1e-13);
}

TEST(ImpulseBasedStepper, FreshStepperContinuesBitForBit) {
  const std::shared_ptr<const Model> model = stack_of(2);
  State state = make_initial_state(*model);
  ImpulseBasedStepper stepper(model, Method{}, 0.01);
  for (int k = 1; k <= 20; ++k) {
    State copy = state;
    ImpulseBasedStepper fresh(model, Method{}, 0.01);
    fresh.advance(copy, 0.005 * k);
    EXPECT_EQ(stepper.advance(state, 0.005 * k).reason, StopReason::reached_end);
    ASSERT_EQ(state, copy) << "at t = " << state.t;
  }
}

TEST(ImpulseBasedStepper, SupportedBoxHoversInTheEnvelopeAndLosesNothing) {
  const std::shared_ptr<const Model> model = stack_of(1);
  const Method method;
  ImpulseBasedStepper stepper(model, method, 0.01);
  State state = make_initial_state(*model);
  const AdvanceReport report = stepper.advance(state, 1);
  EXPECT_LE(report.max_penetration, method.contact_tolerance);
  EXPECT_NEAR(state.position(1).z(), 0.1, method.contact_tolerance);
  EXPECT_LE(report.impact_gain + report.impact_loss, 1e-12);
  // The impulses carry the weight: what is missing is the momentum of one bounce.
  double impulse = 0;
  for (const MotionEvent& event : report.events) impulse += event.j_W.z();
  EXPECT_NEAR(impulse, g, 2 * std::sqrt(g * method.contact_tolerance));
  // It falls half the envelope and is thrown back, in 2 √(ε / g).
  EXPECT_NEAR(static_cast<double>(report.impacts), 0.5 * std::sqrt(g / method.contact_tolerance), 2);
}

TEST(ImpulseBasedStepper, PatchedSlowCollisionsDoNotCreepButPlainOnesDo) {
  // Between bounces the block gains g sin α of speed; a one-sided impact takes it too late.
  EXPECT_LE(std::abs(creep_in(MicroCollisionMethod::patched, 0.2)), 2e-7);
  EXPECT_GE(creep_in(MicroCollisionMethod::plain, 0.2), 2e-6);
}

TEST(ImpulseBasedStepper, SlidingBlockKeepsTheAccelerationOfCoulombsLaw) {
  // 0.99 times the friction that holds it: a = g (sin α - μ cos α), a hundredth of the pull.
  const double angle = 20 * std::acos(-1.0) / 180, mu = 0.99 * std::tan(angle), duration = 0.5;
  ModelBuilder builder = test::stepping_builder(0, mu, g * Vec3(std::sin(angle), 0, -std::cos(angle)));
  builder.add_body(test::stepping_body("block", Box{Vec3(0.2, 0.2, 0.1)}, Vec3(0, 0, 0.1)));
  const std::shared_ptr<const Model> model = builder.build();
  ImpulseBasedStepper stepper(model, Method{}, 0.01);
  State state = make_initial_state(*model);
  EXPECT_EQ(stepper.advance(state, duration).reason, StopReason::reached_end);
  const double expected = 0.5 * g * (std::sin(angle) - mu * std::cos(angle)) * duration * duration;
  // No friction is left unused; what remains is the way within one bounce and tilt, of the envelope's size.
  EXPECT_NEAR(state.position(1).x(), expected, 5e-6);
}

TEST(ImpulseBasedStepper, StacksNeedMoreImpactsForEachCubeTheHigherTheyAre) {
  const long one = impacts_of_stack(1, 0.1), four = impacts_of_stack(4, 0.1);
  EXPECT_GT(one, 100);
  EXPECT_GT(four, 6 * one);
}

TEST(ImpulseBasedStepper, MomentaAreExactWhereBodiesRub) {
  ModelBuilder builder = test::stepping_builder(0.5, 0.4, Vec3(0, 0, -g));
  BodyDescription cube = test::stepping_body("cube", Box{Vec3(0.1, 0.1, 0.1)}, Vec3(0, 0, 0.4));
  cube.q_WU = Quat(0.9, 0.3, -0.2, 0.1).normalized();
  cube.velocity = Vec3(1, 0.5, 0);
  builder.add_body(cube);
  const std::shared_ptr<const Model> model = builder.build();
  ImpulseBasedStepper stepper(model, Method{}, 0.01);
  State state = make_initial_state(*model);
  const Environment environment(*model);
  const double before = mechanical_energy(*model, environment, state).total();
  const AdvanceReport report = stepper.advance(state, 0.5);
  EXPECT_LE(report.momentum_error.norm(), 1e-13);
  EXPECT_LE(report.angular_momentum_error.norm(), 1e-13);
  const double after = mechanical_energy(*model, environment, state).total();
  EXPECT_NEAR(before - after, report.impact_loss - report.impact_gain, 1e-12);
  EXPECT_GT(report.impact_loss, 0.5);
}

TEST(ImpulseBasedStepper, JointsHoldWhileWhatHangsOnThemCollides) {
  ModelBuilder builder = test::stepping_builder(0.5, 0.3, Vec3(0, 0, -g));
  builder.add_body(test::stepping_body("bob", Sphere{0.1}, Vec3(1, 0, 0.6)));
  ModelBuilder::JointDescription hinge;
  hinge.name = "hinge";
  hinge.type = JointType::hinge;
  hinge.bodies = {"world", "bob"};
  hinge.anchors = {Vec3(0, 0, 0.6)};
  hinge.axis = Vec3(0, 1, 0);
  builder.add_joint(hinge);
  const std::shared_ptr<const Model> model = builder.build();
  ImpulseBasedStepper stepper(model, Method{}, 0.01);
  State state = make_initial_state(*model);
  const AdvanceReport report = stepper.advance(state, 2);
  EXPECT_EQ(report.reason, StopReason::reached_end);
  EXPECT_GE(report.impacts, 1);
  EXPECT_LE(report.max_joint_drift, 1e-9);
  EXPECT_NEAR((state.position(1) - Vec3(0, 0, 0.6)).norm(), 1, 1e-9);
}

TEST(FindReversal, TurnsTheWholeVelocityRoundIfTheImpulseLiesInTheCone) {
  ImpactProblem problem;
  problem.contacts.push_back({0, 1, Mat3::Identity(), 0.5, 0, 0});
  Mat3 K;
  K << 2, 0.1, 0.2, 0.1, 3, -0.1, 0.2, -0.1, 1;
  problem.A = MatX(K);
  problem.u = Vec3(0.1, -0.1, -1);
  const std::optional<ImpactSolution> reversal = find_reversal(problem);
  ASSERT_TRUE(reversal);
  const Vec3 expected = -2 * K.inverse() * Vec3(problem.u);
  EXPECT_LE((reversal->lambda - expected).norm(), 1e-12);
  EXPECT_NEAR(energy_change(problem, reversal->lambda), 0, 1e-13);
}

TEST(FindReversal, SlidingContactsGetTheFrictionOfTheirWholeNormalImpulseAndAddNoEnergy) {
  ImpactProblem problem;
  problem.contacts.push_back({0, 1, Mat3::Identity(), 0.5, 0, 0});
  problem.A = MatX(Mat3::Identity());
  // The normal velocity turns round by an impulse of 2; friction of up to 1 slows a slip of 3 and turns one
  // of 0.8 round, where an impact that ends its friction with the slip would leave none.
  for (const double slip : {3.0, 0.8}) {
    problem.u = Vec3(slip, 0, -1);
    const std::optional<ImpactSolution> reversal = find_reversal(problem);
    ASSERT_TRUE(reversal);
    EXPECT_LE((reversal->lambda - Vec3(-1, 0, 2)).norm(), 1e-12);
    // -2 μ λ_n |w_t|, with the plastic impact's λ_n = 1 and w_t = slip - 1/2.
    EXPECT_NEAR(energy_change(problem, reversal->lambda), -(slip - 0.5), 1e-12);
  }
}

}  // namespace
}  // namespace rigor::impulse_based_stepper_test
