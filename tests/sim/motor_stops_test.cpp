// Motors without a limit of force at the limits of their coordinates, in every scheme.

#include "rigor/model/model_builder.hpp"
#include "rigor/sim/audit/contact_snapshot.hpp"
#include "rigor/sim/simulation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace rigor::motor_stops_test {
namespace {

/// A bar on a hinge, or a block on a slider, that its motor drives against a limit.
std::shared_ptr<const Model> driven(JointType type, const JointAxis& axis, double mass, double rate = 0) {
  ModelBuilder builder;
  builder.set_gravity(Vec3(0, 0, -9.81));
  BodyDescription arm;
  arm.name = "arm";
  arm.p_WU = Vec3(0.5, 0, 0);
  arm.velocity = Vec3(0, 0, -0.5 * rate);
  arm.angular_velocity = Vec3(0, rate, 0);
  arm.inertia = GivenInertia{mass, Vec3::Zero(), mass * Vec3(0.01, 0.1, 0.1), Vec3::Zero()};
  builder.add_body(arm);
  ModelBuilder::JointDescription joint;
  joint.name = "drive";
  joint.type = type;
  joint.bodies = {"world", "arm"};
  joint.anchors = {Vec3::Zero()};
  joint.axis = Vec3(0, 1, 0);
  joint.axes = {axis};
  builder.add_joint(joint);
  return builder.build();
}

TEST(MotorStops, AnUnlimitedMotorRunsToItsLimitAndStandsThere) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int k = 0; k < 4; ++k) {
    JointAxis axis;
    axis.lower = -0.1 - 0.4 * unit(random);
    axis.upper = 0.1 + 0.4 * unit(random);
    const double speed = (k % 2 == 0 ? 1 : -1) * (2 + 10 * unit(random));
    axis.motor = JointMotor{speed};
    const double limit = speed > 0 ? axis.upper : axis.lower;
    const auto model =
        driven(k < 2 ? JointType::hinge : JointType::slider, axis, std::pow(10, 4 * unit(random) - 2));
    for (const Scheme scheme : {Scheme::event_driven, Scheme::hybrid, Scheme::impulse_based,
                                Scheme::time_stepping, Scheme::penalty}) {
      Method method;
      method.scheme = scheme;
      RunSettings settings;
      settings.duration = 0.5;
      settings.step = 0.01;
      settings.output_interval = 0.005;
      double beyond = 0, before = 0;
      const RunResult result =
          run_simulation(model, method, settings, std::nullopt,
                         [&](const State& state, const AdvanceReport&, const Auditor&) {
                           const double value = joint_motions(*model, state).front().coordinates[0];
                           beyond = std::max({beyond, value - axis.upper, axis.lower - value});
                           // Two steps away from the limit it has the speed of the motor.
                           if (state.t > 0 && state.t <= limit / speed - 0.02)
                             before = std::max(before, std::abs(value - speed * state.t));
                           return true;
                         });
      const JointReaction end = joint_snapshot(*model, method, result.state).front();
      EXPECT_EQ(result.audit.report.reason, StopReason::reached_end) << result.audit.report.detail;
      EXPECT_LE(beyond, 1e-9) << method_choice(method, "scheme");
      EXPECT_LE(before, scheme == Scheme::penalty ? std::abs(speed) * 0.006 : 1e-9);
      EXPECT_NEAR(end.coordinates[0], limit, 1e-6);
      EXPECT_NEAR(end.rates[0], 0, 1e-6);
      // What it did is what the arm has gained: the motor stops it as it set it in motion.
      EXPECT_NEAR(result.audit.dissipated, 0,
                  scheme == Scheme::penalty ? 0.02 * std::abs(result.audit.report.work) + 0.01 : 1e-9);
    }
  }
}

TEST(MotorStops, WhatComesAndGoesBetweenTwoOutputsMovedAllTheSame) {
  // The arm is at its limit a microsecond after its start: the outputs see a body that never moved, but its
  // momenta are known to the rounding of what it had.
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int k = 0; k < 20; ++k) {
    JointAxis axis;
    axis.lower = -0.05 * (1 + unit(random));
    axis.upper = 0.05 * (1 + unit(random));
    axis.motor = JointMotor{(k % 2 == 0 ? 1 : -1) * std::pow(10, 3 + 4 * unit(random))};
    const auto model =
        driven(k < 10 ? JointType::hinge : JointType::slider, axis, std::pow(10, 4 * unit(random) - 2));
    RunSettings settings;
    settings.duration = 0.1;
    settings.step = 0.005;
    settings.output_interval = 0.02;
    const RunResult result =
        run_simulation(model, Method{}, settings, std::nullopt,
                       [](const State&, const AdvanceReport&, const Auditor&) { return true; });
    EXPECT_TRUE(result.audit.violations.empty()) << k << ": " << result.audit.violations.front();
  }
}

// Motors with a bound are contacts of their islands: these took steps of order 5, in a governor four times as
// many as without the bound, though their forces are as smooth.
TEST(BoundedMotors, TakeNoMoreStepsThanWithoutABound) {
  for (const double speed : {5.0, 9.0, 14.0}) {
    long steps[2];
    Vec3 ends[2];
    for (const bool is_bounded : {false, true}) {
      // A shaft with a ball on an arm that swings out as it turns.
      ModelBuilder builder;
      builder.set_gravity(Vec3(0, 0, -9.81));
      const auto add = [&](const char* name, const Vec3& x, const Vec3& v, double mass) {
        BodyDescription body;
        body.name = name;
        body.p_WU = x;
        body.velocity = v;
        body.angular_velocity = Vec3(0, 0, speed);
        body.inertia = GivenInertia{mass, Vec3::Zero(), mass * Vec3(0.01, 0.01, 0.001), Vec3::Zero()};
        builder.add_body(body);
      };
      add("shaft", Vec3::Zero(), Vec3::Zero(), 1);
      add("ball", Vec3(0.2, 0, -0.3), Vec3(0, 0.2 * speed, 0), 2);
      ModelBuilder::JointDescription drive;
      drive.name = "drive";
      drive.type = JointType::hinge;
      drive.bodies = {"world", "shaft"};
      drive.anchors = {Vec3::Zero()};
      drive.axis = Vec3::UnitZ();
      JointAxis axis;
      axis.motor = JointMotor{.velocity = speed};
      if (is_bounded) axis.motor->max_force = 500;
      drive.axes = {axis};
      builder.add_joint(drive);
      ModelBuilder::JointDescription arm;
      arm.name = "arm";
      arm.type = JointType::hinge;
      arm.bodies = {"shaft", "ball"};
      arm.anchors = {Vec3::Zero()};
      arm.axis = Vec3::UnitY();
      builder.add_joint(arm);
      RunSettings settings;
      settings.duration = 2;
      settings.step = settings.output_interval = 0.02;
      const RunResult result =
          run_simulation(builder.build(), Method{}, settings, std::nullopt,
                         [](const State&, const AdvanceReport&, const Auditor&) { return true; });
      EXPECT_TRUE(result.audit.violations.empty()) << speed;
      steps[is_bounded] = result.audit.report.steps;
      ends[is_bounded] = result.audit.bodies[1].position;
    }
    EXPECT_LE(steps[1], 1.1 * static_cast<double>(steps[0])) << speed;
    EXPECT_LE((ends[1] - ends[0]).norm(), 1e-7) << speed;
  }
}

// An arm that first swings away from the limit to which its motor throws it within microseconds: the step
// takes a chord, and its motor's work is that along the chord. It was told along the mean of the velocities
// before and after, so that a motor of 1,515 N m on 0.2 g did -1.55 J in place of 18.3 J, and the audit
// failed by that.
TEST(MotorStops, StrongMotorsThrowWhatSwingsAwayAgainstTheirLimits) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int k = 0; k < 24; ++k) {
    const double mass = std::pow(10, 4 * unit(random) - 4), torque = std::pow(10, 2 + 2 * unit(random));
    JointAxis axis;
    axis.lower = -0.01 - 0.04 * unit(random);
    axis.upper = 0.01 + 0.04 * unit(random);
    axis.motor = JointMotor{.velocity = std::pow(10, 3 + 2 * unit(random)), .max_force = torque};
    const auto model = driven(JointType::hinge, axis, mass, -5 - 10 * unit(random));
    Method method;
    method.scheme = Scheme::time_stepping;
    RunSettings settings;
    settings.duration = settings.output_interval = 0.1;
    settings.step = k % 2 == 0 ? 0.01 : 1.0 / 60;
    const RunResult result =
        run_simulation(model, method, settings, std::nullopt,
                       [](const State&, const AdvanceReport&, const Auditor&) { return true; });
    EXPECT_TRUE(result.audit.violations.empty()) << k << ": " << result.audit.violations.front();
    // Each step that presses on the limit takes it to be as far away as the solver tells speeds apart.
    EXPECT_NEAR(result.audit.report.motor_work / (torque * axis.upper), 1, 0.05) << k;
  }
}

}  // namespace
}  // namespace rigor::motor_stops_test
