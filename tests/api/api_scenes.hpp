#pragma once

#include "rigor/api/simulation.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>

namespace rigor {

/// The schemes, as `method:` of a scene file.
inline constexpr std::array all_scheme_texts{
    "{scheme: event-driven}", "{scheme: impulse-based}",           "{scheme: hybrid}",
    "{scheme: auto}",         "{scheme: time-stepping}",           "{scheme: time-stepping, solver: substep}",
    "{scheme: penalty}",      "{scheme: penalty, penalty: global}"};

/// Their letters, as names of tests.
inline std::string scheme_test_name(const testing::TestParamInfo<const char*>& scheme) {
  std::string name;
  for (const char c : std::string(scheme.param)) {
    if ((c >= 'a' && c <= 'z')) name.push_back(c);
  }
  return name;
}

inline Scene scene_with(const std::string& method, const std::string& rest, double step = 0.01) {
  return parse_scene("rigor: 1\nmethod: " + method + "\nrun: {duration: 1, step: " + std::to_string(step) +
                         ", output_interval: 0.01}\n" + rest,
                     "test.yaml", ".");
}

/// What is wrong with a simulation so far, in a text.
inline std::string violations_of(const Simulation& simulation) {
  std::string text;
  for (const std::string& violation : simulation.audit().violations) text += violation + "\n";
  return text;
}

/// A ball of 1 kg that floats freely: a force is all there is.
inline const char* const floating_ball = R"(
world: {gravity: [0, 0, 0]}
bodies:
  - {name: ball, position: [1, 2, 3], mass: 1, shapes: [{type: sphere, radius: 0.1}]}
)";

/// Balls and a box that fall, bounce and roll, and a wheel on a hinge with a motor.
inline const char* const busy_scene = R"(
materials: [{name: rubber, density: 1000, friction: 0.4, restitution: 0.6}]
bodies:
  - {name: floor, motion: static, shapes: [{type: plane, normal: [0, 0, 1], offset: 0, material: rubber}]}
  - {name: ball, position: [0, 0, 0.4], velocity: [1, 0, 0], shapes: [{type: sphere, radius: 0.1, material: rubber}]}
  - {name: box, position: [1, 0, 0.3], angular_velocity: [1, 2, 3], shapes: [{type: box, size: [0.2, 0.3, 0.4], material: rubber}]}
  - {name: wheel, position: [0, 2, 1], mass: 2, shapes: [{type: cylinder, radius: 0.3, length: 0.1, material: rubber}]}
  - {name: cart, motion: kinematic, position: [0, -2, 1], shapes: [{type: box, size: [0.2, 0.2, 0.2], material: rubber}]}
joints:
  - {name: axle, type: hinge, bodies: [world, wheel], anchor: [0, 2, 1], axis: [0, 0, 1], motor: {velocity: 1, max_force: 0.05}}
)";

/// A wheel of 2 kg and radius 0.3 m on a hinge along z without gravity: its moment of inertia is 0.09 kg m².
inline const char* const wheel_on_hinge = R"(
world: {gravity: [0, 0, 0]}
bodies:
  - {name: wheel, position: [0, 2, 1], mass: 2, shapes: [{type: cylinder, radius: 0.3, length: 0.1}]}
joints:
  - {name: axle, type: hinge, bodies: [world, wheel], anchor: [0, 2, 1], axis: [0, 0, 1]}
)";
inline constexpr double wheel_moment = 0.09;

}  // namespace rigor
