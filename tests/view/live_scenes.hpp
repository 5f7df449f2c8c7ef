#pragma once

#include "rigor/io/scene/scene_reader.hpp"

#include <string>

namespace rigor::test {

/// A ball of 1 kg above a floor; outputs each 0.01 s.
inline const std::string live_ball = R"(rigor: 1
name: live ball
world: {gravity: [0, 0, -10]}
run: {duration: 1, output_interval: 0.01}
materials: [{name: rubber, restitution: 0.5, friction: 0.2}]
bodies:
  - {name: floor, motion: static, shapes: [{type: plane, normal: [0, 0, 1], offset: 0, material: rubber}]}
  - {name: ball, position: [0, 0, 1], mass: 1, shapes: [{type: sphere, radius: 0.1, material: rubber}]}
)";
inline constexpr int floor_index = 0, ball_index = 1;

inline Scene live_scene(const std::string& text = live_ball) {
  return parse_scene(text, "live.yaml", ".");
}

}  // namespace rigor::test
