#include "rigor/model/model_builder.hpp"
#include "rigor/sim/audit/contact_snapshot.hpp"
#include "rigor/sim/event_driven/event_driven_stepper.hpp"
#include "rigor/sim/report/energy.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace rigor::joint_axes_test {
namespace {

constexpr double g = 9.81;
constexpr double pi = std::numbers::pi;
using JointDescription = ModelBuilder::JointDescription;

ModelBuilder scene_with_gravity(const Vec3& g_W) {
  ModelBuilder builder;
  builder.set_gravity(g_W);
  return builder;
}

/// 2 kg, moments (1, 2, 3) kg m².
BodyDescription block(const std::string& name, const Vec3& x) {
  BodyDescription body;
  body.name = name;
  body.p_WU = x;
  body.inertia = GivenInertia{2, Vec3::Zero(), Vec3(1, 2, 3), Vec3::Zero()};
  return body;
}

JointDescription to_world(JointType type, const Vec3& anchor, const Vec3& axis, const JointAxis& coordinate) {
  JointDescription joint;
  joint.name = "joint";
  joint.type = type;
  joint.bodies = {"world", "block"};
  joint.anchors = {anchor};
  joint.axis = axis;
  joint.axes = {coordinate};
  return joint;
}

struct Outcome {
  std::shared_ptr<const Model> model;
  State state;
  AdvanceReport report;

  JointReaction joint() const { return joint_snapshot(*model, Method{}, state).front(); }
  double energy() const { return mechanical_energy(*model, Environment(*model), state).total(); }
};

Outcome simulate(const ModelBuilder& builder, double duration) {
  Outcome run{builder.build(), {}, {}};
  EventDrivenStepper stepper(run.model, Method{}, 0.01);
  run.state = make_initial_state(*run.model);
  run.report = stepper.advance(run.state, duration);
  EXPECT_EQ(run.report.reason, StopReason::reached_end) << run.report.detail;
  EXPECT_EQ(run.report.fallbacks, 0);
  EXPECT_EQ(run.report.coarse_steps, 0);
  return run;
}

TEST(JointAxes, ASliderFallsOnItsLimitAndBouncesThereLikeABall) {
  ModelBuilder builder = scene_with_gravity(Vec3(0, 0, -g));
  builder.add_body(block("block", Vec3(0, 0, 1)));
  builder.add_joint(
      to_world(JointType::slider, Vec3(0, 0, 1), Vec3::UnitZ(), {.lower = -1, .restitution = 0.5}));
  // Impacts at √(2/g), then flights of 2 e^k √(2/g): at 1 s it is in the second of them.
  const double first = std::sqrt(2 / g);
  const double v2 = 0.25 * g * first, t2 = 2 * first;
  const double t = 1;
  const Outcome run = simulate(builder, t);
  EXPECT_EQ(run.report.impacts, 2);
  EXPECT_NEAR(run.joint().coordinates[0], -1 + v2 * (t - t2) - 0.5 * g * (t - t2) * (t - t2), 1e-9);
  EXPECT_NEAR(run.joint().rates[0], v2 - g * (t - t2), 1e-9);
  EXPECT_NEAR(run.report.work + 2 * g - run.report.impact_loss, run.energy(), 1e-10);
}

TEST(JointAxes, ASliderComesToRestOnItsLimitWhichCarriesIt) {
  ModelBuilder builder = scene_with_gravity(Vec3(0, 0, -g));
  builder.add_body(block("block", Vec3(0, 0, 1)));
  builder.add_joint(
      to_world(JointType::slider, Vec3(0, 0, 1), Vec3::UnitZ(), {.lower = -1, .restitution = 0.5}));
  const Outcome run = simulate(builder, 3);
  EXPECT_NEAR(run.joint().coordinates[0], -1, 1e-6);
  EXPECT_EQ(run.joint().rates[0], 0);
}

TEST(JointAxes, AHingeHitsItsLimitWithTheLawOfImpact) {
  ModelBuilder builder = scene_with_gravity(Vec3::Zero());
  BodyDescription body = block("block", Vec3(0.5, 0, 0));
  body.angular_velocity = Vec3(0, 0, 2);
  body.velocity = Vec3(0, 1, 0);
  builder.add_body(body);
  builder.add_joint(
      to_world(JointType::hinge, Vec3::Zero(), Vec3::UnitZ(), {.upper = 0.5, .restitution = 0.8}));
  const Outcome run = simulate(builder, 0.5);
  EXPECT_EQ(run.report.impacts, 1);
  EXPECT_NEAR(run.joint().rates[0], -1.6, 1e-9);
  EXPECT_NEAR(run.joint().coordinates[0], 0.5 - 1.6 * 0.25, 1e-9);
  // I about the axis: 3 + 2 × 0.25.
  EXPECT_NEAR(run.report.impact_loss, 0.5 * 3.5 * (4 - 1.6 * 1.6), 1e-9);
}

TEST(JointAxes, ARopeTurnsTautAndHoldsTheWeight) {
  ModelBuilder builder = scene_with_gravity(Vec3(0, 0, -g));
  builder.add_body(block("block", Vec3(0, 0, -0.5)));
  JointDescription rope = to_world(JointType::distance, Vec3::Zero(), Vec3::UnitZ(), {.upper = 1});
  rope.anchors = {Vec3::Zero(), Vec3(0, 0, -0.5)};
  builder.add_joint(rope);
  const Outcome run = simulate(builder, 1);
  EXPECT_EQ(run.report.impacts, 1);
  EXPECT_NEAR(run.state.position(0).z(), -1, 1e-6);
  EXPECT_NEAR(run.report.impact_loss, 2 * g * 0.5, 1e-6);
}

TEST(JointAxes, DryFrictionHoldsUpToItsForceAndThenTakesIt) {
  for (const double friction : {19.7, 15.0}) {  // Weight 19.62 N.
    ModelBuilder builder = scene_with_gravity(Vec3(0, 0, -g));
    builder.add_body(block("block", Vec3::Zero()));
    builder.add_joint(to_world(JointType::slider, Vec3::Zero(), Vec3::UnitZ(), {.friction = friction}));
    const Outcome run = simulate(builder, 2);
    const double acceleration = std::max(0.0, g - friction / 2);
    EXPECT_NEAR(run.state.position(0).z(), -0.5 * acceleration * 4, 1e-12);
  }
}

TEST(JointAxes, DryFrictionStopsAWheel) {
  ModelBuilder builder = scene_with_gravity(Vec3::Zero());
  BodyDescription wheel = block("block", Vec3::Zero());
  wheel.angular_velocity = Vec3(0, 0, 4);
  builder.add_body(wheel);
  builder.add_joint(to_world(JointType::hinge, Vec3::Zero(), Vec3::UnitZ(), {.friction = 6}));
  const Outcome run = simulate(builder, 5);
  // ω̇ = -2 rad/s²: two seconds, 4 rad; angles are counted from -π to π.
  EXPECT_NEAR(run.joint().coordinates[0], 4 - 2 * pi, 1e-9);
  EXPECT_EQ(run.joint().rates[0], 0);
  EXPECT_EQ(run.report.slip_to_stick, 1);
}

TEST(JointAxes, AMotorReachesItsVelocityWithItsForceAndHoldsIt) {
  ModelBuilder builder = scene_with_gravity(Vec3::Zero());
  builder.add_body(block("block", Vec3::Zero()));
  builder.add_joint(to_world(JointType::hinge, Vec3::Zero(), Vec3::UnitZ(), {.motor = JointMotor{5, 6}}));
  const Outcome run = simulate(builder, 4);
  // 2 rad/s² for 2.5 s, then 5 rad/s: 6.25 + 7.5 rad.
  EXPECT_NEAR(run.joint().rates[0], 5, 1e-12);
  EXPECT_NEAR(run.joint().coordinates[0], 13.75 - 4 * pi, 1e-9);
  // Its torque over the angle: all of it is in the wheel, ½ 3 5² J.
  EXPECT_NEAR(run.report.work, 6 * 6.25, 1e-8);
}

TEST(JointAxes, AMotorWithoutLimitHoldsItsVelocityFromTheStartAgainstAnything) {
  ModelBuilder builder = scene_with_gravity(Vec3(0, -g, 0));
  builder.add_body(block("block", Vec3(1, 0, 0)));
  builder.add_joint(to_world(JointType::hinge, Vec3::Zero(), Vec3::UnitZ(), {.motor = JointMotor{pi / 2}}));
  const Outcome run = simulate(builder, 1);
  EXPECT_NEAR(run.joint().coordinates[0], pi / 2, 1e-9);
  // Kinetic and potential energy that it has now: ½ (3 + 2) ω² + m g h.
  EXPECT_NEAR(run.report.projection_loss, 0, 1e-14);
  EXPECT_NEAR(run.report.work, 0.5 * 5 * pi * pi / 4 + 2 * g, 1e-7);
}

TEST(JointAxes, ATorsionSpringSwingsWithItsPeriod) {
  ModelBuilder builder = scene_with_gravity(Vec3::Zero());
  BodyDescription body = block("block", Vec3::Zero());
  body.angular_velocity = Vec3(0, 0, 1);
  builder.add_body(body);
  builder.add_joint(to_world(JointType::hinge, Vec3::Zero(), Vec3::UnitZ(), {.stiffness = 12}));
  const Outcome run = simulate(builder, 1);
  EXPECT_NEAR(run.joint().coordinates[0], 0.5 * std::sin(2), 1e-9);
  EXPECT_NEAR(run.energy(), 1.5, 1e-9);
}

TEST(JointAxes, TheReactionOfAFixedJointCarriesTheWeightOfWhatItHolds) {
  ModelBuilder fixed = scene_with_gravity(Vec3(0, 0, -g));
  fixed.add_body(block("block", Vec3(0.5, 0, 0)));
  JointDescription weld = to_world(JointType::fixed, Vec3::Zero(), Vec3::UnitZ(), {});
  weld.axes.clear();
  fixed.add_joint(weld);
  const Outcome run = simulate(fixed, 0.1);
  EXPECT_TRUE(run.joint().force_W.isApprox(Vec3(0, 0, 2 * g), 1e-12));
  EXPECT_TRUE(run.joint().torque_W.isApprox(Vec3(0, -g, 0), 1e-12));
  EXPECT_EQ((run.state.position(0) - Vec3(0.5, 0, 0)).norm(), 0);
}

}  // namespace
}  // namespace rigor::joint_axes_test
