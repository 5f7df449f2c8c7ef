// What the audit says of the many-body path.

#include "rigor/bulk/bulk_world.hpp"
#include "rigor/sim/bulk/bulk_promises.hpp"
#include "rigor/sim/simulation.hpp"
#include "sim/time_stepping_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace rigor::bulk_audit_test {
namespace {

constexpr double g = 9.81;

ModelBuilder with_floor(double restitution) {
  return test::stepping_builder(restitution, 0.5, Vec3(0, 0, -g));
}

Audit audit_of(const std::shared_ptr<const Model>& model, double duration, bool sleeping = false) {
  Method method;
  method.scheme = Scheme::time_stepping;
  method.solver = SolverMethod::substep;
  method.sleeping = sleeping;
  RunSettings settings;
  settings.duration = duration;
  settings.step = 1.0 / 60;
  settings.output_interval = 0.1;
  const auto go_on = [](const State&, const AdvanceReport&, const Auditor&) { return true; };
  return run_simulation(model, method, settings, std::nullopt, go_on).audit;
}

std::shared_ptr<const Model> pyramid(int rows) {
  ModelBuilder builder = with_floor(0);
  for (int row = 0; row < rows; ++row) {
    for (int i = 0; i < rows - row; ++i) {
      const Vec3 place(1.05 * (i - 0.5 * (rows - 1 - row)), 0, 0.5 + row);
      BodyDescription cube =
          test::stepping_body(std::to_string(row) + "," + std::to_string(i), Box{Vec3(0.5, 0.5, 0.5)}, place);
      cube.mass = 1000;
      builder.add_body(cube);
    }
  }
  return builder.build();
}

TEST(BulkAudit, SpringsOfContactsHoldHalfOfWhatSinkingGives) {
  // At rest a weight W lowers a spring by s = W / k and gives W s, of which the spring holds ½ k s²; the
  // other half is dissipated. What slides apart under the pressure while it settles gives a little more.
  const Audit audit = audit_of(pyramid(8), 5);
  EXPECT_EQ(audit.violations, std::vector<std::string>{});
  const double sunk = audit.initial.potential - audit.final.potential;
  EXPECT_GT(sunk, 10);
  EXPECT_NEAR(audit.final.elastic, 0.5 * sunk, 0.015 * sunk);
  // What sweeps have not solved yet lets it sink too far and come up again, by a little.
  EXPECT_LT(audit.max_increase, 0.05 * sunk);
  EXPECT_EQ(audit.report.max_iterations, 2 * BulkSettings{}.substeps);
}

/// Whether the run is said to gain energy.
bool gains(const Audit& audit) {
  return std::count(audit.broken.begin(), audit.broken.end(), Audit::Promise::energy) != 0;
}

TEST(BulkAudit, ATenthAsMuchEnergyMayRiseWhereNothingSwings) {
  const auto share = [](ModelBuilder builder) { return bulk_promises(*builder.build()).energy_share; };
  ModelBuilder plain = with_floor(0);
  plain.add_body(test::stepping_body("a", Sphere{0.5}, Vec3(0, 0, 2)));
  EXPECT_EQ(share(std::move(plain)), 1e-4);
  ModelBuilder jointed = with_floor(0);
  jointed.add_body(test::stepping_body("a", Sphere{0.5}, Vec3(0, 0, 2)));
  ModelBuilder::JointDescription joint;
  joint.name = "j";
  joint.type = JointType::ball;
  joint.bodies = {"world", "a"};
  joint.anchors = {Vec3(0, 0, 3)};
  jointed.add_joint(joint);
  EXPECT_EQ(share(std::move(jointed)), 1e-3);
}

TEST(BulkAudit, WhatFallsForAMinuteGainsNoEnergy) {
  // At 500 m/s gravity was rounded by a thousandth in each substep, always to the same side.
  ModelBuilder builder;
  builder.set_gravity(Vec3(0, 0, -g));
  builder.add_material({.name = "m"});
  for (int i = 0; i < 5; ++i)
    builder.add_body(test::stepping_body("b" + std::to_string(i), Sphere{0.5}, Vec3(2.0 * i, 0.1 * i, 0)));
  const std::shared_ptr<const Model> model = builder.build();
  const Audit audit = audit_of(model, 60);
  EXPECT_FALSE(gains(audit));
  // Steps by Euler's method take ½ m (g h)² each.
  EXPECT_LE(audit.max_increase, 1e-6 * -audit.final.potential);
  EXPECT_LE(audit.linear_momentum_error, 1e-6 * 5 * model->body(0).mass * 60 * g);
}

TEST(BulkAudit, ImpactsAreCountedOnceEach) {
  // A ball that bounces with e = 0.5 from 1 m: its k-th flight has the speed 0.5ᵏ √(2 g), which is above
  // 1 cm/s up to k = 8. Speeds that gravity adds within a step (16 cm/s) let the last ones be lost.
  ModelBuilder builder = with_floor(0.5);
  builder.add_body(test::stepping_body("ball", Sphere{0.5}, Vec3(0, 0, 1.5)));
  const Audit audit = audit_of(builder.build(), 5);
  EXPECT_GE(audit.report.impacts, 4);
  EXPECT_LE(audit.report.impacts, 9);
  EXPECT_EQ(audit.violations, std::vector<std::string>{});
}

TEST(BulkAudit, ImpactsAreEventsWithTheirImpulses) {
  // A cube of 1 kg that falls flat from 1 m, e = 0: one impact, which takes m √(2 g) and what gravity gives
  // in the rest of its step.
  ModelBuilder builder = with_floor(0);
  builder.add_body(test::stepping_body("cube", Box{Vec3(0.5, 0.5, 0.5)}, Vec3(0, 0, 1.5)));
  const std::shared_ptr<const Model> model = builder.build();
  Method method;
  method.scheme = Scheme::time_stepping;
  method.solver = SolverMethod::substep;
  RunSettings settings;
  settings.duration = 1;
  settings.step = 1.0 / 60;
  settings.output_interval = 0.1;
  std::vector<MotionEvent> events;
  const auto note = [&](const State&, const AdvanceReport& since, const Auditor&) {
    events.insert(events.end(), since.events.begin(), since.events.end());
    return true;
  };
  run_simulation(model, method, settings, std::nullopt, note);
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(events[0].kind, MotionEvent::Kind::impact);
  EXPECT_NEAR(events[0].time, std::sqrt(2 / g), 1.0 / 60);
  EXPECT_EQ(events[0].body_A, 0);
  EXPECT_EQ(events[0].body_B, 1);
  EXPECT_GT(events[0].j_W.z(), 0.5 * std::sqrt(2 * g));
  EXPECT_LT(events[0].j_W.z(), std::sqrt(2 * g) + g / 60);
  EXPECT_LT(events[0].p_W.head<2>().norm(), 1e-5);
}

TEST(BulkAudit, RoundingsOfWhatRestsOrRollsPassHoweverLongItDoes) {
  // The same rounding in every step, to the same side.
  for (int k = 0; k < 6; ++k) {
    ModelBuilder builder = with_floor(0);
    double z = 0;
    for (int i = 0; i < 4 + k; ++i) {
      const double half = 0.011 * (3 + (7 * i + 3 * k) % 5);
      const Vec3 place(0.003 * ((i + k) % 3), 0.002 * (i % 4), z + half);
      builder.add_body(
          test::stepping_body("b" + std::to_string(i), Box{Vec3(0.1 + 0.02 * k, 0.12, half)}, place));
      z += 2 * half;
    }
    BodyDescription ball = test::stepping_body("ball", Sphere{0.3}, Vec3(2, 0, 0.3));
    ball.velocity = Vec3(1 + 0.37 * k, 0.2, 0);
    builder.add_body(ball);
    const Audit audit = audit_of(builder.build(), 40);
    EXPECT_EQ(audit.violations, std::vector<std::string>{}) << k;
    EXPECT_LT(audit.linear_momentum_error, 8e-7 * audit.report.rounded_momentum) << k;
  }
}

TEST(BulkAudit, MomentumIsThatOfGravityAndTheFloorToTheRoundingsOf32Bits) {
  ModelBuilder builder = with_floor(0);
  for (int i = 0; i < 30; ++i) {
    const Vec3 place(0.7 * (i % 3) + 0.01 * i, 0.7 * (i / 3 % 3), 0.5 + 0.8 * (i / 9));
    builder.add_body(test::stepping_body("b" + std::to_string(i), Box{Vec3(0.3, 0.25, 0.2)}, place));
  }
  const Audit audit = audit_of(builder.build(), 4);
  EXPECT_GT(audit.linear_momentum_error, 0);
  // 30 kg at up to 7 m/s; a forgotten impulse of one substep of one body is 0.02 kg m/s.
  EXPECT_LT(audit.linear_momentum_error, 0.01);
  for (const std::string& violation : audit.violations)
    EXPECT_EQ(violation.find("momentum"), std::string::npos) << violation;
}

TEST(BulkAudit, WorkOfALiftIsKnownAndThatOfAMotorIsNot) {
  ModelBuilder builder = with_floor(0);
  BodyDescription lift = test::stepping_body("lift", Box{Vec3(0.5, 0.5, 0.05)}, Vec3(0, 0, 1));
  lift.motion = MotionType::kinematic;
  lift.mass.reset();
  lift.p_WU = Vec3::Zero();
  lift.path = {{1, Vec3(0, 0, 1), Quat::Identity()}, {3, Vec3(0, 0, 3), Quat::Identity()}};
  builder.add_body(lift);
  builder.add_body(test::stepping_body("load", Box{Vec3(0.2, 0.2, 0.2)}, Vec3(0, 0, 1.25)));
  const Audit audit = audit_of(builder.build(), 4);
  EXPECT_EQ(audit.violations, std::vector<std::string>{});
  // m g 2 m, and ½ m v² at the start and once more lost there, when it is taken along at 1 m/s.
  EXPECT_NEAR(audit.report.work, 2 * g + 1, 0.2);
  EXPECT_NEAR(audit.final.total() - audit.initial.total(), 2 * g, 0.2);
  EXPECT_LT(audit.max_increase, 0.02);
}

TEST(BulkAudit, SaysHowManySleep) {
  const Audit audit = audit_of(pyramid(4), 5, true);
  EXPECT_EQ(audit.sleeping_count, 10);
  EXPECT_EQ(audit.violations, std::vector<std::string>{});
  EXPECT_EQ(audit_of(pyramid(4), 1, false).sleeping_count, 0);
}

}  // namespace
}  // namespace rigor::bulk_audit_test
