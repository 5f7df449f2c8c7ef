// Motors are booked with the work that they really do, in every scheme, and their force can be read.

#include "rigor/model/model_builder.hpp"
#include "rigor/sim/audit/contact_snapshot.hpp"
#include "rigor/sim/simulation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace rigor::motor_books_test {
namespace {

using JointDescription = ModelBuilder::JointDescription;

/// A body of this mass and equal moments on a joint to the world, without gravity.
std::shared_ptr<const Model> driven(JointType type, double inertia, const JointAxis& axis,
                                    const Vec3& g_W = Vec3::Zero()) {
  ModelBuilder builder;
  builder.set_gravity(g_W);
  BodyDescription body;
  body.name = "body";
  body.inertia = GivenInertia{inertia, Vec3::Zero(), Vec3::Constant(inertia), Vec3::Zero()};
  builder.add_body(body);
  JointDescription joint;
  joint.name = "drive";
  joint.type = type;
  joint.bodies = {"world", "body"};
  joint.anchors = {Vec3::Zero()};
  joint.axis = Vec3::UnitZ();
  joint.axes = {axis};
  builder.add_joint(joint);
  return builder.build();
}

/// The schemes whose books know motors.
std::vector<Method> all_methods() {
  std::vector<Method> methods;
  for (const Scheme scheme : {Scheme::event_driven, Scheme::hybrid, Scheme::impulse_based,
                              Scheme::time_stepping, Scheme::penalty}) {
    Method method;
    method.scheme = scheme;
    methods.push_back(method);
  }
  methods.push_back(methods.back());
  methods.back().penalty = PenaltyMethod::global;
  return methods;
}

RunResult run(const std::shared_ptr<const Model>& model, const Method& method, double duration) {
  RunSettings settings;
  settings.duration = duration;
  settings.step = settings.output_interval = 0.01;
  return run_simulation(model, method, settings, std::nullopt,
                        [](const State&, const AdvanceReport&, const Auditor&) { return true; });
}

TEST(MotorBooks, AMotorAtItsLimitUnderGravityGainsNothing) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> between(0.2, 5);
  for (int k = 0; k < 6; ++k) {
    const double inertia = between(random), force = between(random);
    JointAxis axis;
    axis.motor = JointMotor{1e3 * force / inertia, force};
    const auto model =
        driven(JointType::slider, inertia, axis, Vec3(between(random), 0, k % 2 == 0 ? -9.81 : 9.81));
    for (const Method& method : all_methods()) {
      // Steps of 0.01 s that moved by the velocity at their end would gain F g h / 2 a second.
      const Audit audit = run(model, method, 0.5).audit;
      EXPECT_NEAR(audit.dissipated, 0, 1e-9 * (audit.final.kinetic + std::abs(audit.report.work)))
          << k << method_choice(method, "scheme");
      EXPECT_TRUE(audit.violations.empty()) << audit.violations.front();
    }
  }
}

TEST(MotorBooks, AMotorFarFromItsSpeedDoesTheWorkOfItsForceOverThePath) {
  std::mt19937 random(1);
  const auto between = [&](double low, double high) {
    return low * std::pow(high / low, std::uniform_real_distribution<double>()(random));
  };
  for (int k = 0; k < 6; ++k) {
    const double inertia = between(0.01, 100), force = between(0.1, 50) * inertia, duration = 0.5;
    const double friction = k % 2 == 0 ? 0 : 0.3 * force;
    JointAxis axis;
    axis.motor = JointMotor{1e3 * force / inertia, force};
    axis.friction = friction;
    const auto model = driven(k % 3 == 0 ? JointType::slider : JointType::hinge, inertia, axis);

    // The speed grows by the force that friction leaves, and the path is a parabola.
    const double acceleration = (force - friction) / inertia, path = 0.5 * acceleration * duration * duration;
    for (const Method& method : all_methods()) {
      const RunResult result = run(model, method, duration);
      const AdvanceReport& report = result.audit.report;
      // Bristles of penalty contacts stretch before friction has its whole force: the motion is off by that.
      const double share = method.scheme == Scheme::penalty ? (friction > 0 ? 0.05 : 2e-3) : 1e-9;
      EXPECT_NEAR(report.motor_work, force * path, share * force * path)
          << k << method_choice(method, "scheme");
      EXPECT_EQ(report.work, report.motor_work);
      EXPECT_NEAR(result.audit.dissipated, friction * path, share * force * path) << k;
      EXPECT_NEAR(report.friction_loss, friction * path, share * force * path) << k;
      EXPECT_TRUE(result.audit.violations.empty()) << result.audit.violations.front();
    }
  }
}

TEST(MotorBooks, AMotorAtItsSpeedPaysForDryFrictionAndNothingElse) {
  JointAxis axis;
  axis.motor = JointMotor{5, 6};
  axis.friction = 2;
  const auto model = driven(JointType::hinge, 1, axis);
  for (const Method& method : all_methods()) {
    // 4 rad/s² up to 5 rad/s after 1.25 s, then 2 N m against friction: 3.125 rad and 3.75 rad.
    const RunResult result = run(model, method, 2);
    const double share = method.scheme == Scheme::penalty ? 2e-2 : 1e-8;
    EXPECT_NEAR(result.audit.report.motor_work, 6 * 3.125 + 2 * 3.75, 26.25 * share)
        << method_choice(method, "scheme");
    EXPECT_NEAR(result.audit.dissipated, 2 * (3.125 + 3.75), 26.25 * share);
    // Its force now, at an instant, whatever the scheme.
    const JointReaction drive = joint_snapshot(*model, method, result.state).front();
    EXPECT_NEAR(drive.efforts.at(0), 2, method.scheme == Scheme::penalty ? 0.1 : 1e-9);
  }
}

TEST(MotorBooks, AMotorWithoutLimitDoesTheWorkOfTheJumpToItsSpeedOnce) {
  JointAxis axis;
  axis.motor = JointMotor{3};
  const auto model = driven(JointType::hinge, 2, axis);
  for (const Method& method : all_methods()) {
    const RunResult result = run(model, method, 0.1);
    EXPECT_NEAR(result.audit.report.motor_work, 0.5 * 2 * 9, 1e-9) << method_choice(method, "scheme");
    EXPECT_NEAR(result.audit.dissipated, 0, 1e-9);
  }
}

// What a joint takes to give bodies velocities that it allows is no work of its motor.
TEST(MotorBooks, AMotorWithoutLimitGainsNothingOfBodiesThatItsJointDoesNotLetMoveSo) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto vector = [&](double size) {
    const double x = unit(random), y = unit(random), z = unit(random);
    return Vec3(size * Vec3(x, y, z));
  };
  for (int k = 0; k < 40; ++k) {
    ModelBuilder builder;
    builder.set_gravity(Vec3::Zero());
    for (const char* const name : {"a", "b"}) {
      BodyDescription body;
      body.name = name;
      body.p_WU = vector(1);
      body.velocity = vector(3);
      body.angular_velocity = vector(4);
      body.inertia = GivenInertia{2 + unit(random), Vec3::Zero(), Vec3(0.5, 0.6, 0.7), Vec3::Zero()};
      builder.add_body(body);
    }
    JointDescription joint;
    joint.name = "drive";
    joint.type = k % 2 == 0 ? JointType::hinge : JointType::slider;
    joint.bodies = {"a", "b"};
    joint.anchors = {Vec3::Zero()};
    joint.axis = vector(1).normalized();
    JointAxis axis;
    axis.motor = JointMotor{10 * unit(random)};
    joint.axes = {axis};
    builder.add_joint(joint);
    const auto model = builder.build();
    for (const Scheme scheme :
         {Scheme::event_driven, Scheme::hybrid, Scheme::impulse_based, Scheme::time_stepping}) {
      Method method;
      method.scheme = scheme;
      const RunResult result = run(model, method, 0.02);
      EXPECT_TRUE(result.audit.violations.empty())
          << k << method_choice(method, "scheme") << result.audit.violations.front();
    }
  }
}

TEST(MotorBooks, EffortsFollowNewtonAndEuler) {
  // A motor of limited force that accelerates, and one without limit that carries a weight.
  JointAxis limited;
  limited.motor = JointMotor{100, 2};
  const auto wheel = driven(JointType::hinge, 1, limited);
  EXPECT_NEAR(joint_snapshot(*wheel, Method{}, make_initial_state(*wheel)).front().efforts.at(0), 2, 1e-12);

  ModelBuilder builder;
  builder.set_gravity(Vec3(0, 0, -9.81));
  BodyDescription lift;
  lift.name = "lift";
  lift.velocity = Vec3(0, 0, 0.5);
  lift.inertia = GivenInertia{3, Vec3::Zero(), Vec3::Constant(1), Vec3::Zero()};
  builder.add_body(lift);
  JointDescription rail;
  rail.name = "rail";
  rail.type = JointType::slider;
  rail.bodies = {"world", "lift"};
  rail.axis = Vec3::UnitZ();
  JointAxis hoist;
  hoist.motor = JointMotor{0.5};
  rail.axes = {hoist};
  builder.add_joint(rail);
  const auto model = builder.build();
  EXPECT_NEAR(joint_snapshot(*model, Method{}, make_initial_state(*model)).front().efforts.at(0), 3 * 9.81,
              1e-10);
}

// A motor that reaches its speed sooner than time resolves: what it did beyond that was booked too, up to
// 1e12 times the energy of what it turns.
TEST(MotorBooks, AMotorOfAnyStrengthDoesTheWorkThatItsBodyHasGained) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int k = 0; k < 24; ++k) {
    const double mass = std::pow(10, -4 + 5 * unit(random)), arm = 0.05 + 0.4 * unit(random);
    const double inertia = 1.01 * mass * arm * arm, speed = (k % 2 == 0 ? 1 : -1) * (2 + 20 * unit(random));
    ModelBuilder builder;
    builder.set_gravity(Vec3(0, 0, -9.81));
    BodyDescription body;
    body.name = "body";
    body.p_WU = Vec3(arm, 0, 0);
    body.inertia = GivenInertia{mass, Vec3::Zero(), Vec3::Constant(0.01 * mass * arm * arm), Vec3::Zero()};
    builder.add_body(body);
    JointDescription joint;
    joint.name = "drive";
    joint.type = JointType::hinge;
    joint.bodies = {"world", "body"};
    joint.anchors = {Vec3::Zero()};
    joint.axis = Vec3::UnitY();
    joint.axes.resize(1);
    joint.axes[0].motor = JointMotor{speed, inertia * std::pow(10, 3 + 17 * unit(random))};
    builder.add_joint(joint);
    const auto model = builder.build();
    for (const Scheme scheme : {Scheme::event_driven, Scheme::hybrid, Scheme::time_stepping}) {
      Method method;
      method.scheme = scheme;
      const RunResult result = run(model, method, 0.2);
      const Audit& audit = result.audit;
      // Steps of first order know it to a few hundredths of what moves.
      const double moved = 0.5 * inertia * speed * speed + 2 * mass * 9.81 * arm;
      EXPECT_NEAR(audit.dissipated, 0, 0.03 * moved) << k << method_choice(method, "scheme");
      EXPECT_NEAR(audit.report.motor_work, audit.final.total() - audit.initial.total(), 0.03 * moved) << k;
      EXPECT_TRUE(audit.violations.empty()) << k << ": " << audit.violations.front();
      // At its speed it carries the weight, and nothing else; fixed steps know the rate to a hundredth.
      const double moment = mass * 9.81 * result.state.position(0).x();
      EXPECT_NEAR(joint_snapshot(*model, method, result.state).front().efforts.at(0), -moment,
                  1e-9 * mass * 9.81 * arm)
          << k << method_choice(method, "scheme");
    }
  }
}

// A pendulum of two bodies with a universal joint, one of whose axes friction holds. The rates that steps
// leave there are no slip, whose whole friction would tear at the joints three times as strongly as the
// weights do.
TEST(MotorBooks, DryFrictionThatHoldsIsNotToldAsSlip) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto any = [&] { return Vec3(unit(random), unit(random), unit(random)); };
  for (int k = 0; k < 12; ++k) {
    ModelBuilder builder;
    builder.set_gravity(Vec3(0, 0, -9.81));
    for (const bool is_first : {true, false}) {
      BodyDescription body;
      body.name = is_first ? "a" : "b";
      body.p_WU = is_first ? Vec3(0.3, 0, 0) : Vec3(0.9, 0.1, 0);
      body.inertia = GivenInertia{is_first ? 1.0 : 0.5, Vec3::Zero(), Vec3(0.02, 0.03, 0.04), Vec3::Zero()};
      builder.add_body(body);
    }
    JointDescription top;
    top.name = "top";
    top.type = JointType::ball;
    top.bodies = {"world", "a"};
    top.anchors = {Vec3::Zero()};
    builder.add_joint(top);
    JointDescription cross;
    cross.name = "cross";
    cross.type = JointType::universal;
    cross.bodies = {"a", "b"};
    cross.anchors = {Vec3(0.6, 0, 0)};
    cross.axis = any();
    cross.second_axis = cross.axis.cross(any());
    cross.axes.resize(2);
    cross.axes[1].friction = 5;
    builder.add_joint(cross);
    const auto model = builder.build();

    Method by_events, by_steps;
    by_events.scheme = Scheme::event_driven;
    by_steps.scheme = Scheme::time_stepping;
    const std::vector<JointReaction> exact =
        joint_snapshot(*model, by_events, run(model, by_events, 0.1).state);
    const std::vector<JointReaction> found =
        joint_snapshot(*model, by_steps, run(model, by_steps, 0.1).state);
    for (std::size_t j = 0; j < exact.size(); ++j)
      EXPECT_LT((found[j].force_W - exact[j].force_W).norm(), 0.02 * exact[j].force_W.norm()) << k;
  }
}

}  // namespace
}  // namespace rigor::motor_books_test
