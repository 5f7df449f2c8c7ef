// Penalty contacts that begin at rest, impacts that they report and forces that a snapshot shows of them.

#include "rigor/model/model_builder.hpp"
#include "rigor/sim/audit/contact_snapshot.hpp"
#include "rigor/sim/make_stepper.hpp"
#include "rigor/sim/simulation.hpp"

#include "sim/time_stepping_scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

namespace rigor::penalty_start_test {
namespace {

constexpr double g = 9.81;

Method penalty_method(PenaltyMethod form, PenaltyLaw law) {
  Method method;
  method.scheme = Scheme::penalty;
  method.penalty = form;
  method.penalty_law = law;
  return method;
}

/// `blocks` blocks of 1 kg on each other, on a slope of 20 degrees (gravity is tilted) with 1.01 times the
/// friction that holds them.
std::shared_ptr<const Model> blocks_on_slope(int blocks) {
  const double angle = 20 * std::numbers::pi / 180;
  ModelBuilder builder =
      test::stepping_builder(0, 1.01 * std::tan(angle), g * Vec3(std::sin(angle), 0, -std::cos(angle)));
  for (int k = 0; k < blocks; ++k)
    builder.add_body(test::stepping_body("block" + std::to_string(k), Box{Vec3(0.2, 0.2, 0.05)},
                                         Vec3(0, 0, 0.05 + 0.1 * k)));
  return builder.build();
}

std::shared_ptr<const Model> ball_above_floor(double height, double restitution) {
  ModelBuilder builder = test::stepping_builder(restitution, 0, Vec3(0, 0, -g));
  builder.add_body(test::stepping_body("ball", Sphere{0.1}, Vec3(0, 0, 0.1 + height)));
  return builder.build();
}

TEST(PenaltyStart, BlocksThatFrictionHoldsStayWhereTheyBegin) {
  for (const PenaltyMethod form : {PenaltyMethod::local, PenaltyMethod::global}) {
    for (const PenaltyLaw law : {PenaltyLaw::linear, PenaltyLaw::hunt_crossley}) {
      const std::shared_ptr<const Model> model = blocks_on_slope(2);
      const Method method = penalty_method(form, law);
      const RunResult run = run_simulation(
          model, method, {.duration = 0.1, .step = 0.01, .output_interval = 0.02}, std::nullopt,
          [](const State&, const AdvanceReport&, const Auditor&) { return true; });
      // Springs pressed by the forces of rest: what moves is what these are off by, some roundings.
      for (const int block : {1, 2}) {
        const Vec3 start(0, 0, 0.05 + 0.1 * (block - 1));
        EXPECT_LE((run.state.position(block) - start).norm(), 1e-12);
        EXPECT_LE(run.state.linear_momentum(block).norm(), 1e-10);
      }
      // The springs' energy comes from outside.
      double stored = 0;
      for (const ContactMemory& contact : run.state.contacts) stored += contact.energy;
      EXPECT_GT(stored, 0);
      EXPECT_NEAR(run.audit.report.work, stored, 1e-6 * stored);
      EXPECT_LE(run.audit.max_increase, 1e-6 * stored);
      EXPECT_TRUE(run.audit.violations.empty()) << run.audit.violations.front();
    }
  }
}

TEST(PenaltyStart, AStackPressesWithItsWeightFromTheFirstInstantOn) {
  const std::shared_ptr<const Model> model = blocks_on_slope(3);
  const Method method = penalty_method(PenaltyMethod::local, PenaltyLaw::linear);
  State state = make_initial_state(*model);
  const std::unique_ptr<Stepper> stepper = make_stepper(model, method, 0.01);
  EXPECT_EQ(stepper->advance(state, 1e-3).reason, StopReason::reached_end);
  Vec3 on_lowest = Vec3::Zero();
  for (const TouchingPoint& point : contact_snapshot(*model, method, state)) {
    EXPECT_EQ(point.mode, TouchingPoint::Mode::stick);
    if (point.body_A == 0) on_lowest += point.force_W;
  }
  EXPECT_LE((on_lowest + 3 * model->g_W()).norm(), 1e-9 * 3 * g);
}

TEST(PenaltyImpacts, AreReportedWhenAndWhereContactBegins) {
  const double height = 0.5, e = 0.8;
  const std::shared_ptr<const Model> model = ball_above_floor(height, e);
  const Method method = penalty_method(PenaltyMethod::local, PenaltyLaw::linear);
  State state = make_initial_state(*model);
  const AdvanceReport report = make_stepper(model, method, 0.01)->advance(state, 1.2);
  const double fall = std::sqrt(2 * height / g);
  ASSERT_EQ(report.events.size(), 2u);
  EXPECT_EQ(report.impacts, 2);
  for (std::size_t k = 0; k < 2; ++k) {
    const MotionEvent& event = report.events[k];
    EXPECT_EQ(event.kind, MotionEvent::Kind::impact);
    EXPECT_EQ(std::pair(event.body_A, event.body_B), std::pair(0, 1));
    // The first contact is found within a hundredth of 1/ω; the second is late by the first one's duration
    // (of about π d / v) and off by the 0.01 that its restitution may be wrong by.
    const double expected = fall * (k == 0 ? 1 : 1 + 2 * e);
    const double speed = std::sqrt(2 * g * height);
    const double late = k == 0 ? 0.02 * 1e-4 / speed : 2 * std::numbers::pi * 1e-4 / speed + 0.02 * fall;
    EXPECT_NEAR(event.time, expected, late);
    EXPECT_LE((event.p_W - Vec3::Zero()).norm(), 1e-5);
  }
}

TEST(PenaltySnapshot, ShowsTheForcesOfTheSprings) {
  // A spring of given stiffness, undamped, that the ball is pressing: f = k δ.
  const double k = 1e5;
  const std::shared_ptr<const Model> model = ball_above_floor(0.05, 1);
  for (const PenaltyMethod form : {PenaltyMethod::local, PenaltyMethod::global}) {
    Method method = penalty_method(form, PenaltyLaw::linear);
    method.stiffness = k;
    method.damping = 1e-9;
    State state = make_initial_state(*model);
    // A quarter of a period of the spring, √(m/k), after the first touch.
    const double end = std::sqrt(2 * 0.05 / g) + 0.5 * std::numbers::pi / std::sqrt(k);
    EXPECT_EQ(make_stepper(model, method, 1e-4)->advance(state, end).reason, StopReason::reached_end);
    const std::vector<TouchingPoint> points = contact_snapshot(*model, method, state);
    ASSERT_EQ(points.size(), 1u);
    const double depth = 0.1 - state.position(1).z();
    EXPECT_GT(depth, 1e-3);
    EXPECT_NEAR(points[0].force_W.z(), k * depth, 1e-6 * k * depth);
    EXPECT_NE(points[0].mode, TouchingPoint::Mode::open);
  }
}

}  // namespace
}  // namespace rigor::penalty_start_test
