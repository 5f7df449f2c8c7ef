#pragma once

#include "rigor/model/model_builder.hpp"

#include <memory>
#include <string>

namespace rigor::test {

/// A builder with a floor at z = 0 and one material "m".
inline ModelBuilder stepping_builder(double restitution, double friction, const Vec3& g_W) {
  ModelBuilder builder;
  builder.set_gravity(g_W);
  builder.add_material({"m", 1000, friction, restitution});
  BodyDescription floor;
  floor.name = "floor";
  floor.motion = MotionType::fixed;
  floor.shapes.push_back({HalfSpace{Vec3::UnitZ(), 0}, Vec3::Zero(), Quat::Identity(), "m", ""});
  builder.add_body(floor);
  return builder;
}

/// A body of one shape and 1 kg.
inline BodyDescription stepping_body(const std::string& name, const Shape& shape, const Vec3& x) {
  BodyDescription body;
  body.name = name;
  body.p_WU = x;
  body.mass = 1;
  body.shapes.push_back({shape, Vec3::Zero(), Quat::Identity(), "m", ""});
  return body;
}

/// A cube that tumbles, bounces and slides: all lengths times `length`, all times times `time`.
inline std::shared_ptr<const Model> stepping_cube(double length, double time) {
  ModelBuilder builder = stepping_builder(0.6, 0.4, Vec3(0, 0, -9.81 * length / (time * time)));
  BodyDescription cube = stepping_body("cube", Box{length * Vec3(0.1, 0.1, 0.1)}, length * Vec3(0, 0, 0.5));
  cube.q_WU = Quat(0.9, 0.3, -0.2, 0.1).normalized();
  cube.velocity = length / time * Vec3(0.5, 0.2, 0);
  cube.angular_velocity = Vec3(3, -2, 1) / time;
  builder.add_body(cube);
  return builder.build();
}

}  // namespace rigor::test
