#include "rigor/api/simulation.hpp"

#include "api/api_scenes.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/sim/simulation.hpp"

#include <gtest/gtest.h>

namespace rigor::simulation_test {
namespace {

class EveryScheme : public testing::TestWithParam<const char*> {
 public:
  Scene scene(const char* rest, double step = 0.01) const { return scene_with(GetParam(), rest, step); }
  bool is_of_32_bits() const { return std::string(GetParam()).find("substep") != std::string::npos; }
  bool is_impulse_based() const { return std::string(GetParam()).find("impulse") != std::string::npos; }
};

std::vector<double> numbers_of(const Simulation& simulation) {
  std::vector<double> all;
  const auto append = [&all](const auto& rows) {
    all.insert(all.end(), rows.data(), rows.data() + rows.size());
  };
  append(simulation.positions());
  append(simulation.orientations());
  append(simulation.velocities());
  append(simulation.angular_velocities());
  return all;
}

TEST_P(EveryScheme, AtTheOutputsOfARunTheBitsAreThoseOfTheRun) {
  const Scene own = scene(busy_scene);
  Simulation simulation(own);
  int outputs = 0;
  RunSettings settings = own.run;
  settings.duration = 0.5;
  run_simulation(own.model, own.method, settings, std::nullopt,
                 [&](const State& state, const AdvanceReport&, const Auditor&) {
                   simulation.advance_to(state.t);
                   for (int i = 0; i < own.model->body_count(); ++i) {
                     const Pose X_WU = Pose{rotation_matrix(state.orientation(i)), state.position(i)} *
                                       own.model->body(i).X_BU;
                     EXPECT_EQ(simulation.position(BodyHandle{i}), X_WU.p) << i << " at " << state.t;
                     EXPECT_EQ(simulation.velocity(BodyHandle{i}), linear_velocity(*own.model, state, i));
                   }
                   ++outputs;
                   return true;
                 });
  EXPECT_EQ(outputs, 51);
  EXPECT_GT(simulation.audit().report.impacts, 0);
}

TEST_P(EveryScheme, AConstantForceDoesTheWorkThatItsBodyGains) {
  Simulation simulation(scene(floating_ball));
  // F t = 2 N · 1 s on 1 kg: 2 m/s after 1 m, and 2 J.
  for (int k = 0; k < 100; ++k) {
    simulation.apply_force("ball", Vec3(2, 0, 0));
    simulation.step();
  }
  const double tolerance = is_of_32_bits() ? 2e-5 : 1e-12;
  EXPECT_NEAR(simulation.time(), 1, 1e-12);
  EXPECT_NEAR(simulation.velocity("ball").x(), 2, tolerance);
  // Symplectic schemes are ahead by half a step.
  EXPECT_NEAR(simulation.position("ball").x(), 2, 0.011);
  // The force ends with the step, in the books too.
  simulation.advance_to(1.5);
  EXPECT_NEAR(simulation.velocity("ball").x(), 2, tolerance);
  const Audit audit = simulation.audit();
  EXPECT_NEAR(audit.report.work, 2, 0.03);
  EXPECT_NEAR(audit.final.total(), 2, 4 * tolerance);
  EXPECT_EQ(violations_of(simulation), "");
}

TEST_P(EveryScheme, AForceAtAPointTurnsTheBodyToo) {
  Simulation simulation(scene(floating_ball, 0.001));
  // τ = r F = 0.1 m · 1 N for 0.05 s; I = 2/5 m r² = 0.004 kg m².
  for (int k = 0; k < 50; ++k) {
    simulation.apply_force("ball", Vec3(0, 1, 0), simulation.position("ball") + Vec3(0.1, 0, 0));
    simulation.step();
  }
  EXPECT_NEAR(simulation.velocity("ball").y(), 0.05, 1e-6);
  EXPECT_NEAR(simulation.angular_velocity("ball").z(), 0.1 * 0.05 / 0.004, 1e-5);
  EXPECT_EQ(violations_of(simulation), "");
}

TEST_P(EveryScheme, WhatActsAtOnceIsBookedAsWork) {
  Simulation simulation(scene(floating_ball));
  simulation.advance_to(0.1);
  simulation.apply_impulse("ball", Vec3(0, 3, 0));
  EXPECT_NEAR(simulation.audit().report.work, 4.5, 1e-12);
  simulation.advance_to(0.2);
  simulation.set_velocity("ball", Vec3(1, 0, 0), Vec3::Zero());
  simulation.advance_to(0.3);
  const Audit audit = simulation.audit();
  EXPECT_NEAR(audit.report.work, 0.5, 1e-6);
  EXPECT_NEAR(simulation.position("ball").x(), 1.1, 1e-6);
  EXPECT_NEAR(simulation.position("ball").y(), 2.3, 1e-6);
  EXPECT_EQ(violations_of(simulation), "");
}

TEST_P(EveryScheme, SavedBytesContinueWithTheSameBits) {
  const auto act = [](Simulation& simulation) {
    simulation.apply_force("ball", Vec3(0, 0.3, 0));
    simulation.apply_torque("box", Vec3(0, 0, 0.01 * simulation.time()));
    simulation.set_motor_velocity("axle", std::sin(5 * simulation.time()), 0.2);
  };
  Simulation one(scene(busy_scene));
  one.set_controller(act, 0.02);
  one.move_to("cart", {Mat3::Identity(), Vec3(1, -2, 1)}, 0.5);
  one.set_friction("rubber", 0.3);
  one.advance_to(0.25);
  one.apply_force("box", Vec3(1, 0, 0));

  Simulation other(scene(busy_scene));
  other.set_controller(act, 0.02);
  other.restore(one.save());
  EXPECT_EQ(numbers_of(other), numbers_of(one));
  for (const double t : {0.26, 0.3, 0.4}) {
    one.advance_to(t);
    other.advance_to(t);
    ASSERT_EQ(numbers_of(other), numbers_of(one)) << t;
  }
  EXPECT_NEAR(one.position("cart").x(), 0.8, 1e-6);
  EXPECT_EQ(other.audit().report.work, one.audit().report.work);
  EXPECT_EQ(other.audit().books.energy_scale, one.audit().books.energy_scale);
}

TEST_P(EveryScheme, WhoLooksChangesNothing) {
  Simulation watched(scene(busy_scene)), alone(scene(busy_scene));
  for (int k = 0; k < 30; ++k) {
    watched.apply_force("ball", Vec3(0, 0, 0.1 * k));
    alone.apply_force("ball", Vec3(0, 0, 0.1 * k));
    watched.contacts();
    watched.joint_forces();
    watched.audit();
    watched.save();
    watched.clone().step();
    EXPECT_TRUE(watched.queries().first_hit({Vec3(3, 3, 5), Vec3(0, 0, -1)}));
    watched.step();
    alone.step();
  }
  EXPECT_EQ(numbers_of(watched), numbers_of(alone));
}

TEST_P(EveryScheme, ContactsCarryTheWeight) {
  // There contacts are trains of collisions: at most moments nothing presses.
  if (is_impulse_based()) GTEST_SKIP();
  Simulation simulation(scene(R"(
bodies:
  - {name: floor, motion: static, shapes: [{type: plane, normal: [0, 0, 1], offset: 0}]}
  - {name: box, position: [0, 0, 0.1], mass: 3, shapes: [{type: box, size: [0.2, 0.2, 0.2]}]}
)"));
  simulation.advance_to(1);
  Vec3 force = Vec3::Zero();
  for (const TouchingPoint& point : simulation.contacts()) {
    EXPECT_EQ(simulation.name(BodyHandle{point.body_B}), "box");
    force += point.force_W;
  }
  // Springs and 32-bit steps have not quite settled.
  EXPECT_NEAR(force.z(), 3 * 9.80665, 0.02 * 3 * 9.80665);
}

TEST_P(EveryScheme, APushIsFeltWhereItIsCarried) {
  if (is_impulse_based()) GTEST_SKIP();
  Simulation simulation(scene(R"(
bodies:
  - {name: floor, motion: static, shapes: [{type: plane, normal: [0, 0, 1], offset: 0}]}
  - {name: box, position: [0, 0, 0.1], mass: 3, shapes: [{type: box, size: [0.2, 0.2, 0.2]}]}
)"));
  for (int k = 0; k < 100; ++k) {
    simulation.apply_force("box", Vec3(0, 0, -20));
    simulation.step();
  }
  double force = 0;
  for (const TouchingPoint& point : simulation.contacts()) force += point.force_W.z();
  EXPECT_NEAR(force, 3 * 9.80665 + 20, 0.03 * 50);
}

TEST_P(EveryScheme, EventsAreThoseSinceTheLastCall) {
  Simulation simulation(scene(R"(
materials: [{name: rubber, density: 1000, friction: 0, restitution: 0.8}]
bodies:
  - {name: floor, motion: static, shapes: [{type: plane, normal: [0, 0, 1], offset: 0, material: rubber}]}
  - {name: ball, position: [0, 0, 1], mass: 1, shapes: [{type: sphere, radius: 0.1, material: rubber}]}
)"));
  // It falls 0.9 m: √(2 · 0.9 / g) = 0.4284 s.
  simulation.advance_to(0.4);
  EXPECT_TRUE(simulation.take_events().empty());
  simulation.advance_to(0.5);
  const std::vector<MotionEvent> events = simulation.take_events();
  ASSERT_FALSE(events.empty());
  EXPECT_EQ(events.front().kind, MotionEvent::Kind::impact);
  EXPECT_NEAR(events.front().time, std::sqrt(1.8 / 9.80665), 0.011);
  EXPECT_TRUE(simulation.take_events().empty());
}

TEST_P(EveryScheme, AResetIsTheBeginning) {
  Simulation simulation(scene(busy_scene)), fresh(scene(busy_scene));
  simulation.move_to("cart", {Mat3::Identity(), Vec3(1, -2, 1)}, 0.1);
  simulation.apply_force("ball", Vec3(1, 2, 3));
  simulation.advance_to(0.2);
  simulation.reset();
  EXPECT_EQ(numbers_of(simulation), numbers_of(fresh));
  simulation.advance_to(0.2);
  fresh.advance_to(0.2);
  EXPECT_EQ(numbers_of(simulation), numbers_of(fresh));
}

INSTANTIATE_TEST_SUITE_P(Schemes, EveryScheme, testing::ValuesIn(all_scheme_texts), scheme_test_name);

}  // namespace
}  // namespace rigor::simulation_test
