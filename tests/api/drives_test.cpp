#include "api/api_scenes.hpp"
#include "random_vectors.hpp"
#include "rigor/api/simulation.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/model/model_builder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace rigor::drives_test {
namespace {

class EveryDrivenScheme : public testing::TestWithParam<const char*> {
 public:
  Scene scene(const std::string& rest, double step = 0.01) const {
    return scene_with(GetParam(), rest, step);
  }
  bool is_of_32_bits() const { return std::string(GetParam()).find("substep") != std::string::npos; }
  bool is_penalty() const { return std::string(GetParam()).find("penalty") != std::string::npos; }
  double tolerance() const { return is_of_32_bits() ? 2e-5 : 1e-9; }
};

std::string ball_under(const std::string& force) {
  return std::string(floating_ball) + "forces: [" + force + "]\n";
}

std::string wheel_with(const std::string& motor) {
  return R"(
world: {gravity: [0, 0, 0]}
bodies:
  - {name: wheel, position: [0, 0, 1], mass: 2, shapes: [{type: cylinder, radius: 0.3, length: 0.1}]}
joints:
  - {name: axle, type: hinge, bodies: [world, wheel], anchor: [0, 0, 1], axis: [0, 0, 1], motor: )" +
         motor + "}\n";
}

/// One coordinate under an acceleration, by Runge and Kutta's method with short steps: a truth of its own.
struct Oscillator {
  std::function<double(double t, double x, double v)> acceleration;
  double x = 0, v = 0;

  void advance(double t_begin, double t_end, int steps) {
    const double h = (t_end - t_begin) / steps;
    for (int k = 0; k < steps; ++k) {
      const double t = t_begin + k * h;
      const double a1 = acceleration(t, x, v), v1 = v;
      const double a2 = acceleration(t + h / 2, x + h / 2 * v1, v + h / 2 * a1), v2 = v + h / 2 * a1;
      const double a3 = acceleration(t + h / 2, x + h / 2 * v2, v + h / 2 * a2), v3 = v + h / 2 * a2;
      const double a4 = acceleration(t + h, x + h * v3, v + h * a3), v4 = v + h * a3;
      x += h / 6 * (v1 + 2 * v2 + 2 * v3 + v4);
      v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    }
  }
};

TEST(DrivenScenes, WhatLiesStillComesToRestOnce) {
  // Laws are followed step by step: a box that they do not move is not judged as one that has just been put
  // down.
  for (const char* const scheme : {"{scheme: event-driven}", "{scheme: hybrid}"}) {
    Simulation simulation(scene_with(scheme, R"(
bodies:
  - {name: floor, motion: static, shapes: [{type: plane}]}
  - {name: box, position: [0, 0, 0.1], shapes: [{type: box, size: [0.2, 0.2, 0.2]}]}
  - {name: ball, position: [1, 0, 1], mass: 1, shapes: [{type: sphere, radius: 0.1}]}
forces: [{type: constant, body: ball, force: [1, 0, 0], factor: {amplitude: 1, frequency: 2}}]
)"));
    simulation.advance_to(0.2);
    EXPECT_EQ(simulation.audit().report.resting, 1) << scheme;
    EXPECT_EQ(simulation.audit().report.separations, 0) << scheme;
    for (const TouchingPoint& contact : simulation.contacts())
      EXPECT_EQ(contact.mode, TouchingPoint::Mode::stick) << scheme;
  }
}

TEST_P(EveryDrivenScheme, AForceOfTheTimeGivesItsImpulse) {
  // ∫ (0.5 + 2 sin(2π 1.5 t + 0.3)) dt along x, at a third of it along a table in z.
  Simulation simulation(scene(
      ball_under("{type: constant, body: ball, force: [1, 0, 0], factor: {mean: 0.5, amplitude: 2, "
                 "frequency: 1.5, phase: 0.3}}, "
                 "{type: constant, body: ball, force: [0, 0, 3], factor: {table: [[0.1, 0], [0.3, 1], [0.3, "
                 "2], [0.7, 2]]}}, "
                 "{type: torque, body: ball, torque: [0, 0.001, 0], factor: {table: [[0, 0], [1, 4]]}}")));
  const double rate = 2 * std::numbers::pi * 1.5;
  for (const double t : {0.25, 0.613, 0.9}) {
    simulation.advance_to(t);
    const double along_x = 0.5 * t - 2 / rate * (std::cos(rate * t + 0.3) - std::cos(0.3));
    const double ramp = std::min(t, 0.3) - 0.1,
                 along_z = 3 * (2.5 * ramp * ramp + 2 * std::max(0.0, t - 0.3));
    EXPECT_NEAR(simulation.velocity("ball").x(), along_x, tolerance()) << t;
    EXPECT_NEAR(simulation.velocity("ball").z(), along_z, tolerance()) << t;
    EXPECT_NEAR(simulation.angular_velocity("ball").y(), 0.001 * 2 * t * t / (0.4 * 0.01), 5 * tolerance())
        << t;
  }
  // All that it has is the work of the forces.
  const Audit audit = simulation.audit();
  // Positions of the substep scheme follow the velocities at the ends of its parts: ½ h ∫F² dt / m = 0.09 J.
  EXPECT_NEAR(audit.report.work, audit.final.kinetic, is_of_32_bits() ? 0.09 : 1e-9);
  EXPECT_NEAR(audit.final.potential, 0, 1e-12);
  EXPECT_EQ(violations_of(simulation), "");
}

TEST_P(EveryDrivenScheme, AMotorFollowsARateOfTheTime) {
  Simulation simulation(scene(wheel_with("{velocity: {amplitude: 3, frequency: 0.8}}")));
  const double rate = 2 * std::numbers::pi * 0.8;
  for (const double t : {0.2, 0.55, 1.0}) {
    simulation.advance_to(t);
    // Under penalty a motor takes up its rate at the end of a step: it is a step late.
    const double late = is_penalty() ? 0.01 * 3 * std::abs(std::sin(rate * t)) + 1e-3 : 0;
    EXPECT_NEAR(simulation.joint_motion("axle").coordinates[0], 3 / rate * (1 - std::cos(rate * t)),
                late + (is_of_32_bits() ? 1e-3 : 2e-6))
        << t;
  }
  EXPECT_EQ(violations_of(simulation), "");
}

TEST_P(EveryDrivenScheme, AnEffortOfTheTimeIsATorque) {
  Simulation simulation(scene(wheel_with("{effort: {table: [[0, 0.2], [0.5, -0.1]]}}")));
  simulation.advance_to(0.4);
  const double impulse = 0.2 * 0.4 - 0.5 * 0.6 * 0.16;
  EXPECT_NEAR(simulation.joint_motion("axle").rates[0], impulse / wheel_moment, tolerance());
  EXPECT_NEAR(simulation.joint_forces("axle").efforts[0], 0.2 - 0.6 * 0.4, 1e-9);
  EXPECT_EQ(simulation.audit().joints[0].efforts.size(), 1u);
  EXPECT_EQ(violations_of(simulation), "");
}

TEST_P(EveryDrivenScheme, ALimitedServoFollowsItsLaw) {
  // I φ'' = clamp(k (aim - φ) - c φ', ± most): saturated at first, then a spring and a damper.
  test::Random random(21);
  for (int draw = 0; draw < 4; ++draw) {
    const double stiffness = random.uniform(0.5, 8), damping = random.uniform(0.1, 0.8);
    const double most = random.uniform(0.1, 0.6), aim = random.uniform(-2.5, 2.5);
    Simulation simulation(
        scene(wheel_with(fmt::format("{{position: {}, stiffness: {}, damping: {}, max_force: {}}}", aim,
                                     stiffness, damping, most)),
              0.002));
    Oscillator truth{[=](double, double x, double v) {
      return std::clamp(stiffness * (aim - x) - damping * v, -most, most) / wheel_moment;
    }};
    for (int k = 1; k <= 4; ++k) {
      simulation.advance_to(0.3 * k);
      truth.advance(0.3 * (k - 1), 0.3 * k, 3000);
      // What the first order of the judgement at each step may differ by.
      EXPECT_NEAR(simulation.joint_motion("axle").coordinates[0], truth.x, 6e-3) << draw << " " << k;
      EXPECT_LE(std::abs(simulation.joint_forces("axle").efforts[0]), 1.05 * most) << draw << " " << k;
    }
    EXPECT_EQ(violations_of(simulation), "") << draw;
  }
}

TEST_P(EveryDrivenScheme, AServoThatIsSetWhileItRunsHasALimit) {
  Simulation simulation(scene(wheel_on_hinge, 0.002));
  simulation.set_motor_position("axle", 2, 50, 2, 0, 0.09);
  simulation.advance_to(1);
  // At τ / I = 1 rad/s² it turns by half a radian.
  EXPECT_NEAR(simulation.joint_motion("axle").coordinates[0], 0.5, 2e-3);
  EXPECT_NEAR(simulation.joint_forces("axle").efforts[0], 0.09, 1e-9);
  Simulation twin = simulation.clone();
  EXPECT_EQ(twin.save(), simulation.save());
  for (Simulation* const each : {&simulation, &twin}) each->advance_to(1.5);
  EXPECT_EQ(twin.save(), simulation.save());
  simulation.release_motor("axle");
  simulation.advance_to(2);
  EXPECT_NEAR(simulation.joint_motion("axle").rates[0], 1.5, 1e-2);
  EXPECT_EQ(violations_of(simulation), "");
}

TEST_P(EveryDrivenScheme, TheAuditKnowsWhatMotorsHaveDone) {
  // Nothing but the motor acts: what it has done is the wheel's energy. At its limit all the way, and as a
  // spring alone.
  test::Random random(23);
  for (int draw = 0; draw < 3; ++draw) {
    const double most = random.uniform(0.01, 0.09), stiffness = random.uniform(0.5, 2);
    for (const std::string& motor :
         {fmt::format("{{position: 2, stiffness: 50, damping: 1, max_force: {}}}", most),
          fmt::format("{{position: {{amplitude: 1, frequency: 0.2}}, stiffness: {}}}", stiffness)}) {
      Simulation simulation(scene(wheel_with(motor), 0.004));
      simulation.advance_to(0.6);
      const Audit audit = simulation.audit();
      const double rate = simulation.joint_motion("axle").rates[0];
      const double energy = 0.5 * wheel_moment * rate * rate;
      EXPECT_GT(energy, 1e-4);
      // Implicit springs of sub-steps take some of it.
      EXPECT_NEAR(audit.report.work, energy, (is_of_32_bits() ? 3e-2 : 1e-3) * energy) << motor;
      EXPECT_NEAR(audit.report.motor_work, audit.report.work, 1e-3 * energy) << motor;
    }
  }
}

TEST_P(EveryDrivenScheme, ALimitedServoUnderGravityGainsNothing) {
  // A rod that a servo too weak for its weight lifts half way: what it has is what the servo gave.
  test::Random random(22);
  for (int draw = 0; draw < 3; ++draw) {
    const double most = random.uniform(1, 6), stiffness = random.uniform(5, 80),
                 damping = random.uniform(0.2, 3);
    Simulation simulation(scene(fmt::format(R"(
bodies:
  - {{name: rod, position: [0.5, 0, 0], mass: 1, shapes: [{{type: capsule, radius: 0.02, length: 0.96}}]}}
joints:
  - {{name: pivot, type: hinge, bodies: [world, rod], anchor: [0, 0, 0], axis: [0, 1, 0],
     motor: {{position: {{amplitude: 1, frequency: 0.7}}, stiffness: {}, damping: {}, max_force: {}}}}}
)",
                                            stiffness, damping, most),
                                0.004));
    simulation.advance_to(0.8);
    EXPECT_EQ(violations_of(simulation), "") << draw;
    EXPECT_LE(std::abs(simulation.joint_forces("pivot").efforts[0]), 1.1 * most) << draw;
  }
}

TEST_P(EveryDrivenScheme, ARunGoesOnFromItsBytes) {
  Simulation simulation(scene(
      wheel_with("{position: {amplitude: 1, frequency: 2}, stiffness: 30, damping: 1, max_force: 0.7}")));
  simulation.advance_to(0.3);
  Simulation other(simulation.scene());
  other.restore(simulation.save());
  simulation.advance_to(0.7);
  other.advance_to(0.7);
  EXPECT_EQ(simulation.save(), other.save());
}

INSTANTIATE_TEST_SUITE_P(Schemes, EveryDrivenScheme, testing::ValuesIn(all_scheme_texts), scheme_test_name);

std::string refusal_of(const std::string& rest) {
  try {
    scene_with("{scheme: event-driven}", rest);
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing";
}

TEST(Drives, MistakesAreNamed) {
  const auto has = [](const std::string& text, const char* part) {
    return text.find(part) != std::string::npos ? "" : text;
  };
  EXPECT_EQ(has(refusal_of(wheel_with("{velocity: {table: [[0, 1], [-1, 2]]}}")), "times must not descend"),
            "");
  EXPECT_EQ(has(refusal_of(wheel_with("{velocity: {amplitude: 1}}")), "frequency is missing"), "");
  EXPECT_EQ(has(refusal_of(wheel_with("{velocity: {table: [[0, 1]], mean: 1}}")), "give one of them"), "");
  EXPECT_EQ(has(refusal_of(wheel_with("{velocity: {table: [[0, 1, 2]]}}")), "must have 2"), "");
  EXPECT_EQ(has(refusal_of(wheel_with("{effort: 1, max_force: 2}")), "no meaning"), "");
  EXPECT_EQ(has(refusal_of(wheel_with("{velocity: 1, stiffness: 2}")), "no meaning"), "");
  EXPECT_EQ(has(refusal_of(wheel_with("{position: 1, stiffness: -2}")), "stiffness"), "");
  EXPECT_EQ(
      has(refusal_of(wheel_with("{velocity: {amplitude: 1e12, frequency: 1}}")), "velocity of the motor"),
      "");
  EXPECT_EQ(has(refusal_of(ball_under("{type: drag, body: ball, factor: 2}")), "factor"), "");
}

TEST(Drives, AFormulaThatLeavesTheNumbersStopsTheRun) {
  ModelBuilder builder;
  builder.add_body({.name = "ball", .mass = 1, .shapes = {{Sphere{0.1}}}});
  ModelBuilder::ForceDescription force{ModelBuilder::ForceDescription::Type::constant};
  force.bodies = {"ball"};
  force.vector = Vec3(1, 0, 0);
  force.factor = TimeFunction::Formula{"1/(0.5-t)", [](double t) { return t < 0.5 ? 1 / (0.5 - t) : NAN; }};
  builder.add_force(force);
  Simulation simulation(builder.build());
  simulation.advance_to(0.4);
  EXPECT_NEAR(simulation.velocity("ball").x(), std::log(5), 1e-4);
  try {
    simulation.advance_to(1);
    FAIL();
  } catch (const SimulationStopped& stop) {
    EXPECT_NE(std::string(stop.what()).find("function of the time"), std::string::npos) << stop.what();
  }
}

TEST(TimeFunctions, MeansAreIntegrals) {
  test::Random random(5);
  for (int draw = 0; draw < 200; ++draw) {
    TimeFunction::Table table;
    double t = random.uniform(-1, 1);
    for (int k = 0; k < 5; ++k) {
      table.points.push_back({t, random.uniform(-3, 3)});
      t += draw % 3 == 0 && k == 2 ? 0 : random.uniform(0.01, 1);
    }
    const TimeFunction functions[] = {table,
                                      TimeFunction::Sine{0.3, 2, random.uniform(0, 3), random.uniform(0, 6)}};
    for (const TimeFunction& function : functions) {
      const double from = random.uniform(-2, 4), to = from + random.uniform(0.001, 3);
      double sum = 0;
      const int parts = 20000;
      for (int k = 0; k < parts; ++k) sum += function.value(from + (to - from) * (k + 0.5) / parts);
      EXPECT_NEAR(function.mean(from, to), sum / parts, 2e-4);
      EXPECT_EQ(function.mean(from, from), function.value(from));
    }
  }
}

}  // namespace
}  // namespace rigor::drives_test
