#include "rigor/sim/bulk/bulk_stepper.hpp"

#include "rigor/bulk/bulk_world.hpp"
#include "rigor/sim/make_stepper.hpp"
#include "rigor/sim/method/scheme_check.hpp"
#include "sim/time_stepping_scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace rigor::bulk_stepper_test {
namespace {

constexpr double g = 9.81, kStep = 1.0 / 60;

Method substep_method() {
  Method method;
  method.scheme = Scheme::time_stepping;
  method.solver = SolverMethod::substep;
  return method;
}

/// Boxes and balls that fall on a floor and on each other, turning.
std::shared_ptr<const Model> falling_heap() {
  ModelBuilder builder = test::stepping_builder(0, 0.5, Vec3(0, 0, -g));
  const Shape box = Box{Vec3(0.5, 0.3, 0.4)}, ball = Sphere{0.4};
  for (int i = 0; i < 12; ++i) {
    const Vec3 place(0.7 * (i % 2) + 0.03 * i, 0.8 * (i / 2 % 2), 0.7 + 1.1 * (i / 4));
    BodyDescription body = test::stepping_body("b" + std::to_string(i), i % 3 == 0 ? ball : box, place);
    body.angular_velocity = Vec3(0.3 * i, 1, -0.5);
    builder.add_body(body);
  }
  return builder.build();
}

TEST(BulkStepper, BodyInFreeFlightFallsAsGravitySaysForAnyNumberOfSubsteps) {
  // v = -g t, z = z₀ - ½ g t²; rounding of 32-bit velocities.
  ModelBuilder builder = test::stepping_builder(0, 0.5, Vec3(0, 0, -g));
  builder.add_body(test::stepping_body("ball", Sphere{0.1}, Vec3(0, 0, 100)));
  const std::shared_ptr<const Model> model = builder.build();
  for (const double substeps : {0.0, 1.0, 10.0}) {
    Method method = substep_method();
    method.substeps = substeps;
    State state = make_initial_state(*model);
    const AdvanceReport report = BulkStepper(model, method, kStep, 1).advance(state, 2);
    EXPECT_EQ(report.reason, StopReason::reached_end);
    EXPECT_EQ(report.steps, 120);
    EXPECT_EQ(state.t, 2);
    const double tau = kStep / (substeps > 0 ? substeps : BulkSettings{}.substeps);
    // Each substep rounds velocities below 32 m/s to half of 2⁻¹⁹.
    const double rounding = 2 / tau * std::ldexp(1, -20);
    EXPECT_NEAR(state.position(1).z(), 100 - 0.5 * g * 2 * 2, 2 * rounding);
    EXPECT_NEAR(state.linear_momentum(1).z(), -2 * g, rounding);
  }
}

TEST(BulkStepper, BoxAtRestStaysAndPressesWithItsWeight) {
  ModelBuilder builder = test::stepping_builder(0, 0.5, Vec3(0, 0, -g));
  builder.add_body(test::stepping_body("box", Box{Vec3(0.5, 0.5, 0.5)}, Vec3(0, 0, 0.5)));
  const std::shared_ptr<const Model> model = builder.build();
  State state = make_initial_state(*model);
  const AdvanceReport report = BulkStepper(model, substep_method(), kStep, 1).advance(state, 3);
  EXPECT_LT((state.position(1) - Vec3(0, 0, 0.5)).norm(), 2e-3);
  EXPECT_LT(state.linear_momentum(1).norm(), 1e-3);
  EXPECT_LT(report.max_penetration, 2e-3);
  // The impulses of a substep carry the weight: m g τ.
  ASSERT_EQ(state.manifolds.size(), 1u);
  double carried = 0;
  for (int i = 0; i < state.manifolds[0].point_count; ++i)
    carried += state.manifolds[0].normal_impulse[static_cast<std::size_t>(i)];
  const double weight = g * kStep / BulkSettings{}.substeps;
  EXPECT_NEAR(carried, weight, 0.02 * weight);
}

TEST(BulkStepper, FreshStepperGoesOnBitForBitAlsoFromBytesAndOnOtherThreads) {
  const std::shared_ptr<const Model> model = falling_heap();
  State once = make_initial_state(*model);
  BulkStepper whole(model, substep_method(), kStep, 1);
  State pieces = once;
  for (int k = 1; k <= 60; ++k) {
    const double t = k * kStep;
    whole.advance(once, t);
    pieces = deserialise(serialise(pieces));
    BulkStepper(model, substep_method(), kStep, 1 + k % 3).advance(pieces, t);
    ASSERT_EQ(pieces, once) << "step " << k;
  }
  EXPECT_GT(once.manifolds.size(), 5u);
}

TEST(BulkStepper, AdvanceIsCutAtItsEndIntoEqualStepsNotAboveTheTarget) {
  const std::shared_ptr<const Model> model = falling_heap();
  State state = make_initial_state(*model);
  BulkStepper stepper(model, substep_method(), kStep, 1);
  EXPECT_EQ(stepper.advance(state, 0.1).steps, 6);
  EXPECT_EQ(stepper.advance(state, 0.11).steps, 1);
  EXPECT_EQ(state.t, 0.11);
  EXPECT_EQ(stepper.advance(state, 0.11).steps, 0);
}

TEST(BulkStepper, InterruptEndsItAtAStep) {
  const std::shared_ptr<const Model> model = falling_heap();
  State state = make_initial_state(*model);
  BulkStepper stepper(model, substep_method(), kStep, 1);
  int asked = 0;
  // Within a step it may be asked too; that step is not taken.
  stepper.set_interrupt([&] { return ++asked > 60; });
  const AdvanceReport report = stepper.advance(state, 1);
  EXPECT_EQ(report.reason, StopReason::interrupted);
  EXPECT_GT(report.steps, 0);
  EXPECT_LT(report.steps, 60);
  EXPECT_NEAR(state.t, static_cast<double>(report.steps) * kStep, 1e-15);
}

TEST(BulkStepper, ReportNamesTheWorstOverlap) {
  ModelBuilder builder = test::stepping_builder(0, 0.5, Vec3(0, 0, -g));
  const Shape ball = Sphere{0.5};
  builder.add_body(test::stepping_body("a", ball, Vec3(0, 0, 5)));
  builder.add_body(test::stepping_body("b", ball, Vec3(0.9, 0, 5)));
  builder.add_body(test::stepping_body("c", ball, Vec3(5, 0, 0.45)));
  const std::shared_ptr<const Model> model = builder.build();
  State state = make_initial_state(*model);
  const AdvanceReport report = BulkStepper(model, substep_method(), kStep, 1).advance(state, 0.2);
  EXPECT_NEAR(report.max_penetration, 0.1, 1e-6);
  EXPECT_EQ(report.penetration_A, 1);
  EXPECT_EQ(report.penetration_B, 2);
  EXPECT_EQ(report.penetration_time, 0);
}

TEST(BulkStepper, StateThatIsNotFiniteEndsItAndNamesTheBody) {
  const std::shared_ptr<const Model> model = falling_heap();
  State state = make_initial_state(*model);
  state.P[3 * 4] = std::numeric_limits<double>::infinity();
  const AdvanceReport report = BulkStepper(model, substep_method(), kStep, 1).advance(state, 1);
  EXPECT_EQ(report.reason, StopReason::not_finite);
  EXPECT_FALSE(report.bodies.empty());
}

TEST(BulkStepper, KinematicBodiesAreWhereTheirPathsTakeThem) {
  ModelBuilder builder = test::stepping_builder(0, 0.5, Vec3(0, 0, -g));
  BodyDescription lift;
  lift.name = "lift";
  lift.motion = MotionType::kinematic;
  const Quat turned(std::cos(0.3), 0, 0, std::sin(0.3));
  lift.path = {
      {0, Vec3(0, 0, 1), Quat::Identity()}, {1, Vec3(0, 0, 1.5), turned}, {2, Vec3(0.4, 0, 1.5), turned}};
  const Shape plate = Box{Vec3(1, 1, 0.1)};
  lift.shapes.push_back({plate, Vec3::Zero(), Quat::Identity(), "m", ""});
  builder.add_body(lift);
  builder.add_body(test::stepping_body("box", Box{Vec3(0.2, 0.2, 0.2)}, Vec3(0, 0, 1.3)));
  const std::shared_ptr<const Model> model = builder.build();
  State state = make_initial_state(*model);
  BulkStepper stepper(model, substep_method(), kStep, 1);
  for (const double t : {0.7, 1.0, 2.0, 2.5}) {
    stepper.advance(state, t);
    const PrescribedMotion motion = prescribed_motion(model->body(1), t);
    EXPECT_EQ(state.position(1), motion.p_WB);
    EXPECT_EQ(state.orientation(1).coeffs(), motion.q_WB.coeffs());
  }
  // The box rode along: up by 0.5 m, turned, and by 0.4 m to the side; but where the lift stops it flies on
  // for 2 v / g = 0.1 s, in which the lift goes 0.04 m aside and the box turns by 0.06.
  EXPECT_LT((state.position(2) - Vec3(0.4, 0, 1.8)).norm(), 0.05);
  EXPECT_NEAR(2 * std::acos(std::abs(state.orientation(2).w())), 0.6, 0.08);
}

TEST(BulkStepper, MakeStepperChoosesItAndWhatItCannotDoIsRefused) {
  const std::shared_ptr<const Model> model = falling_heap();
  const std::unique_ptr<Stepper> stepper = make_stepper(model, substep_method(), kStep, 2);
  EXPECT_NE(dynamic_cast<BulkStepper*>(stepper.get()), nullptr);
  EXPECT_TRUE(check_scheme(*model, substep_method()).empty());
  Method method = substep_method();
  method.substeps = 2.5;
  EXPECT_EQ(
      check_scheme(*model, method),
      (std::vector<std::string>{"substeps is 2.5, must be a whole number up to 1000 with solver 'substep'"}));
}

}  // namespace
}  // namespace rigor::bulk_stepper_test
