#pragma once

#include "model/body_samples.hpp"

#include "rigor/math/rotation.hpp"

#include <string>
#include <vector>

namespace rigor::samples {

using JointDescription = ModelBuilder::JointDescription;

/// Two turned dynamic bodies `a` and `b` whose centres of mass are not at their origins, and a fixed `wall`.
inline ModelBuilder jointed_bodies() {
  ModelBuilder builder;
  for (const char* const name : {"a", "b"}) {
    BodyDescription body;
    body.name = name;
    body.p_WU = name[0] == 'a' ? Vec3(1, 2, 3) : Vec3(-2, 0.5, 1);
    body.q_WU = rotation_exp(Vec3(0.3, -0.7, name[0] == 'a' ? 0.2 : 1.1));
    body.inertia = GivenInertia{2, Vec3(0.1, 0.2, -0.3), Vec3(1, 1.5, 2), Vec3(0.1, 0, 0.2)};
    builder.add_body(body);
  }
  BodyDescription wall = body_of(Box{Vec3(1, 1, 1)}, "wall");
  wall.motion = MotionType::fixed;
  wall.p_WU = Vec3(0, 0, -5);
  builder.add_body(wall);
  return builder;
}

/// A joint of a and b at (1, 1, 1).
inline JointDescription joint_of(JointType type) {
  JointDescription joint;
  joint.name = "j";
  joint.type = type;
  joint.bodies = {"a", "b"};
  joint.anchors = {Vec3(1, 1, 1)};
  if (type == JointType::distance) joint.anchors.push_back(Vec3(4, 5, 1));
  if (type == JointType::universal) joint.second_axis = Vec3(1, 0, 0);
  if (type == JointType::screw) joint.parameter = 0.1;
  return joint;
}

/// All messages of the sample bodies with this joint, each with its line end.
inline std::string errors_of(const JointDescription& joint) {
  ModelBuilder builder = jointed_bodies();
  builder.add_joint(joint);
  std::string text;
  for (const std::string& message : builder.check()) text += message + "\n";
  return text;
}

}  // namespace rigor::samples
