// Springs, dampers and drag that no explicit step follows, forces and motors beyond all measure: a run ends
// soon, with books that are right, or says what to change.

#include "contracts/program.hpp"
#include "rigor/math/types.hpp"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <random>
#include <string>

namespace rigor::stiff_scenes_test {
namespace {

const char* const schemes[] = {"event-driven", "hybrid", "time-stepping"};

constexpr const char* head = "rigor: 1\nrun: {duration: 0.1, step: 0.005, output_interval: 0.02}\nbodies:\n";

class Draw {
 public:
  explicit Draw(int seed) : engine_(static_cast<std::uint64_t>(seed)) {}
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  /// 10 to the power of a number between these.
  double power(double low, double high) { return std::pow(10, between(low, high)); }

 private:
  std::mt19937_64 engine_;
};

ProgramResult run_by(const ProgramFolder& folder, const std::string& scene, const std::string& scheme) {
  folder.write("a.yaml", scene);
  return folder.run({"run", "a.yaml", "--set", "method.scheme=" + scheme, "-o", "a.csv"});
}

void expect_passed(const ProgramResult& result, const std::string& scene) {
  EXPECT_EQ(result.code, 0) << scene << result.out << result.error;
}

TEST(StiffScenes, ABodyInAnyDragKeepsItsBooks) {
  const ProgramFolder folder;
  for (int seed = 0; seed < 6; ++seed) {
    Draw draw(seed);
    const std::string scene =
        head + fmt::format(
                   "  - {{name: a, position: [3, 1, 2], mass: {:.6g}, velocity: [1, -2, {:.6g}], "
                   "angular_velocity: [5, {:.6g}, 1], linear_drag: {:.6g}, angular_drag: {:.6g}, "
                   "angular_damping: {:.6g}, shapes: [{{type: box, size: [0.2, 0.3, 0.1]}}]}}\n",
                   draw.power(-6, 6), draw.between(-3, 3), draw.between(-9, 9), draw.power(0, 15),
                   draw.power(0, 15), draw.power(-2, 12));
    for (const char* const scheme : schemes) expect_passed(run_by(folder, scene, scheme), scene);
  }
}

// Light bodies that hang still in the air are hit: an explicit step at velocity level that is long for the
// drag turned their motion round and fed it, 19 J from 2e-6 J.
TEST(StiffScenes, WhatHitsABodyInAnyDragGainsNothing) {
  const ProgramFolder folder;
  for (int seed = 0; seed < 3; ++seed) {
    Draw draw(seed);
    const double linear = draw.power(-1, 1), angular = draw.power(-7, -3);
    const double friction = draw.between(0, 1.2), x = draw.between(0, 0.001);
    const std::string scene = fmt::format(
        "rigor: 1\nrun: {{duration: 0.03, step: 0.001}}\n"
        "materials: [{{name: default, density: 30, friction: {:.6g}, restitution: 0}}]\nbodies:\n"
        "  - {{name: a, position: [0, 0, 0.04], linear_drag: {:.6g}, angular_drag: {:.6g}, shapes: [{{type: "
        "ellipsoid, radii: [0.006, 0.0055, 0.003]}}]}}\n"
        "  - {{name: b, position: [{:.6g}, 0, 0.05], velocity: [0, 0, -0.8], rpy: [1, 0.3, 2], shapes: "
        "[{{type: ellipsoid, radii: [0.0057, 0.0038, 0.0021]}}]}}\n",
        friction, linear, angular, x);
    expect_passed(run_by(folder, scene, "event-driven"), scene);
  }
}

// Steps at velocity level take springs and dampers as they are at their beginning: longer than those allow,
// they gained up to 1e5 J.
TEST(StiffScenes, BodiesOnAStiffDamperLandWithoutGain) {
  const ProgramFolder folder;
  for (int seed = 0; seed < 6; ++seed) {
    Draw draw(seed);
    const auto tilt = [&] { return draw.between(-1, 1); };
    const double density = draw.power(1.5, 2.5), stiffness = draw.power(3, 6), damping = draw.power(4, 6);
    const double roll_a = tilt(), pitch_a = tilt(), roll_b = tilt(), pitch_b = tilt();
    const std::string scene = fmt::format(
        "rigor: 1\nrun: {{duration: 0.03, step: 0.005}}\n"
        "materials: [{{name: default, density: {:.6g}, friction: 0.4, restitution: 0}}]\nbodies:\n"
        "  - {{name: floor, motion: static, shapes: [{{type: plane}}]}}\n"
        "  - {{name: a, position: [0, 0, 0.16], velocity: [0, 0, -4], rpy: [{:.6g}, {:.6g}, 0], shapes: "
        "[{{type: cylinder, radius: 0.1, length: 0.2}}]}}\n"
        "  - {{name: b, position: [0.02, 0, 0.5], velocity: [0, 0, -4], rpy: [{:.6g}, {:.6g}, 0], shapes: "
        "[{{type: ellipsoid, radii: [0.1, 0.06, 0.15]}}]}}\n"
        "forces:\n  - {{type: spring, between: [a, b], points: [[0, 0, 0], [0, 0, 0]], length: 0.35, "
        "stiffness: {:.6g}, damping: {:.6g}}}\n",
        density, roll_a, pitch_a, roll_b, pitch_b, stiffness, damping);
    expect_passed(run_by(folder, scene, "event-driven"), scene);
  }
}

TEST(StiffScenes, ABallOnASpringOfAnyStiffnessComesToRestInItsBooks) {
  const ProgramFolder folder;
  for (const double stiffness : {1e13, 3e14, 1e15}) {
    for (const double mass : {1e-3, 2e-6}) {
      const std::string scene =
          head +
          fmt::format(
              "  - {{name: a, position: [0, 0, 2], mass: {}, shapes: [{{type: sphere, radius: 0.1}}]}}\n"
              "forces:\n  - {{type: spring, between: [world, a], points: [[0, 0, 3], [0, 0, 0]], "
              "stiffness: {}, length: 0.6}}\n",
              mass, stiffness);
      for (const char* const scheme : schemes) expect_passed(run_by(folder, scene, scheme), scene);
    }
  }
}

/// The steps that a run took, of its JSON.
long steps_of(const std::string& json) {
  const std::size_t at = json.find("\"steps\":");
  return at == std::string::npos ? -1 : std::stol(json.substr(at + 8));
}

// A light ball that falls beside a heavy one at a damped joint: slopes of one-sided differences moved it
// across the joint, so that no step was short enough, and runs took 28 steps a millisecond or were given up.
TEST(StiffScenes, JointsOfAnyStiffnessFallInFewSteps) {
  const ProgramFolder folder;
  for (int seed = 0; seed < 8; ++seed) {
    Draw draw(seed);
    const Vec3 first(draw.between(-0.3, 0.3), draw.between(-0.3, 0.3), 0.5);
    const Vec3 second =
        first + 0.3 * Vec3(draw.between(-1, 1), draw.between(-1, 1), draw.between(-1, 1)).normalized();
    const auto text = [](const Vec3& v) {
      return fmt::format("[{:.12g}, {:.12g}, {:.12g}]", v.x(), v.y(), v.z());
    };
    const double light = draw.power(-6, -3), heavy = draw.power(-1, 1), stiffness = draw.power(9, 11);
    const std::string scene =
        head + fmt::format(
                   "  - {{name: a, position: {0}, mass: {2:.6g}, shapes: [{{type: sphere, radius: 0.1}}]}}\n"
                   "  - {{name: b, position: {1}, mass: {3:.6g}, shapes: [{{type: sphere, radius: 0.1}}]}}\n"
                   "joints:\n  - {{name: s, type: distance, bodies: [a, b], anchors: [{0}, {1}], "
                   "limits: [0.2, 0.5], stiffness: {4:.6g}, damping: {5:.6g}}}\n",
                   text(first), text(second), light, heavy, stiffness, 1e-3 * stiffness);
    folder.write("a.yaml", scene);
    expect_passed(folder.run({"run", "a.yaml", "--json", "a.json"}), scene);
    EXPECT_LE(steps_of(folder.read("a.json")), 400) << scene;
  }
}

TEST(StiffScenes, WhatTurnsTooFastStopsSoonWithItsName) {
  const ProgramFolder folder;
  const std::string body =
      "  - {name: rotor, position: [0, 0, 1], shapes: [{type: box, size: [0.2, 0.2, 0.2]}]}\n";
  const std::string torque = head + body + "forces:\n  - {type: torque, body: rotor, torque: [0, 1e15, 0]}\n";
  const std::string motor =
      head + body +
      "joints:\n  - {name: j, type: hinge, bodies: [world, rotor], anchor: [0.3, 0, 1], "
      "axis: [0, 1, 0], motor: {velocity: 1e8}}\n";
  for (const std::string& scene : {torque, motor}) {
    for (const char* const scheme : schemes) {
      const ProgramResult result = run_by(folder, scene, scheme);
      EXPECT_EQ(result.code, 4) << scene;
      expect_contains(result.error, "(unresolved): body 'rotor' turns at ");
      expect_contains(result.error, "run.step");
    }
  }
}

TEST(StiffScenes, AMotorWithoutABoundThatALoopHoldsIsNamed) {
  const ProgramFolder folder;
  // Arms of 3.5 and 1.5 between points 5 apart: stretched out, they cannot turn.
  const std::string scene =
      std::string(head) +
      "  - {name: a, position: [0, 0, 3], shapes: [{type: sphere, radius: 0.1}]}\n"
      "  - {name: b, position: [0.3, 0, 3], shapes: [{type: sphere, radius: 0.1}]}\njoints:\n"
      "  - {name: drive, type: hinge, bodies: [world, a], anchor: [-0.2, 0, 3], axis: [0, 1, 0], "
      "motor: {velocity: 20}}\n"
      "  - {name: rod, type: hinge, bodies: [a, b], anchor: [0.15, 0, 3], axis: [0, 1, 0]}\n"
      "  - {name: hold, type: hinge, bodies: [world, b], anchor: [0.3, 0, 3], axis: [0, 1, 0]}\n";
  for (const char* const scheme : schemes) {
    const ProgramResult result = run_by(folder, scene, scheme);
    EXPECT_EQ(result.code, 4) << result.out;
    expect_contains(result.error, "the motor of joint 'drive' has no max_force");
  }
}

// A ball that slides along a blade which turns by a quarter of a radian in a step gained 2e-5 of its energy.
TEST(StiffScenes, ABallUnderABladeThatTurnsGainsNoEnergyByTimeStepping) {
  const ProgramFolder folder;
  for (int seed = 0; seed < 8; ++seed) {
    Draw draw(seed);
    const double spin = draw.between(45, 75), step = draw.between(0.003, 0.005);
    const std::string scene = fmt::format(
        "rigor: 1\nworld: {{gravity: [0, 0, 0]}}\nrun: {{duration: 0.11, step: {0:.6g}, output_interval: "
        "{0:.6g}}}\n"
        "materials: [{{name: default, density: 430, friction: 0, restitution: 0}}]\nbodies:\n"
        "  - {{name: blade, motion: kinematic, angular_velocity: [0, 0, {1:.6g}], shapes: [{{type: box, "
        "size: [0.6, "
        "0.003, 0.116]}}]}}\n"
        "  - {{name: ball, position: [{2:.6g}, {3:.6g}, 0.0017], shapes: [{{type: sphere, radius: "
        "0.029}}]}}\n",
        step, -spin, draw.between(-0.06, -0.05), draw.between(0.13, 0.16));
    folder.write("a.yaml", scene);
    expect_passed(folder.run({"run", "a.yaml", "--set", "method.scheme=time-stepping"}), scene);
  }
}

}  // namespace
}  // namespace rigor::stiff_scenes_test
