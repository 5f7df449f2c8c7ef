#pragma once

#include "random_vectors.hpp"
#include "rigor/geometry/shape/convex_hull.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/model/model_builder.hpp"

#include <memory>
#include <string>
#include <vector>

namespace rigor::test {

/// A small scene of random bodies, all that a seed can make: shapes and masses of many kinds, a floor and
/// walls, any friction and restitution, springs, drag and joints. Nothing overlaps at the start. The same
/// seed gives the same scene.
class RandomScene {
 public:
  explicit RandomScene(unsigned seed, int most_bodies = 5) : random_(seed), most_bodies_(most_bodies) {}

  std::shared_ptr<const Model> build() {
    builder_.set_gravity(one_in(6) ? 9 * random_.vector() : Vec3(0, 0, -9.81));
    Material material{"m"};
    material.friction = one_in(5) ? 0 : random_.uniform(0, 1.5);
    material.restitution = one_in(3) ? 0 : one_in(4) ? 1 : random_.uniform(0, 1);
    if (one_in(6)) material.rolling_friction = random_.uniform(0, 0.02);
    if (one_in(6)) material.torsional_friction = random_.uniform(0, 0.02);
    builder_.add_material(material);
    add_surroundings();
    const int count = random_count(1, most_bodies_);
    for (int k = 0; k < count; ++k) add_body(k);
    if (count > 1 && one_in(4)) add_joint();
    if (one_in(5)) add_spring();
    return builder_.build();
  }

 private:
  bool one_in(int count) { return random_.uniform(0, count) < 1; }
  int random_count(int least, int most) { return static_cast<int>(random_.uniform(least, most + 0.999)); }

  void add_fixed(const std::string& name, const Shape& shape, const Vec3& position) {
    BodyDescription body;
    body.name = name;
    body.motion = MotionType::fixed;
    body.p_WU = position;
    body.shapes.push_back({shape, Vec3::Zero(), Quat::Identity(), "m", ""});
    builder_.add_body(body);
  }

  void add_surroundings() {
    const Vec3 normal =
        one_in(3) ? Vec3(0.3 * random_.number(), 0.3 * random_.number(), 1).normalized() : Vec3(0, 0, 1);
    if (one_in(3)) {
      add_fixed("floor", Box{Vec3(3, 3, 0.25)}, Vec3(0, 0, -0.25));
    } else {
      add_fixed("floor", HalfSpace{normal, -0.6 * (1 - normal.z())}, Vec3::Zero());
    }
    if (one_in(3)) add_fixed("wall", Box{Vec3(0.05, 2, 2)}, Vec3(-1.3, 0, 0.5));
  }

  /// Of a bounding radius of at most `size`.
  Shape random_shape(double size) {
    const double a = random_.uniform(0.3, 0.57) * size, b = random_.uniform(0.2, 0.5) * size,
                 c = random_.uniform(0.1, 0.5) * size;
    switch (random_count(0, 6)) {
      case 0:
        return Box{Vec3(a, b, c)};
      case 1:
        return Sphere{a};
      case 2:
        return Capsule{c, b};
      case 3:
        return Cylinder{a, b};
      case 4:
        return Cone{a, b};
      case 5:
        return Ellipsoid{Vec3(a, b, c)};
      default: {
        std::vector<Vec3> corners;
        for (int k = 0; k < 9; ++k) corners.push_back(0.57 * size * random_.vector());
        return Convex{std::make_shared<const ConvexHull>(std::get<ConvexHull>(make_convex_hull(corners)))};
      }
    }
  }

  void add_body(int k) {
    // Cells of 0.5 m: bodies of 0.24 m about their origins do not meet.
    const Vec3 cell(0.5 * (k % 2) - 0.25, 0.5 * (k / 2 % 2) - 0.25, 0.5 * (k / 4));
    BodyDescription body;
    body.name = "b" + std::to_string(k);
    body.p_WU = cell + Vec3(0, 0, 0.5);
    body.q_WU = one_in(4) ? Quat::Identity() : rotation_exp(3 * random_.vector()).normalized();
    body.mass = std::pow(10.0, 2 * random_.number());
    body.velocity = one_in(4) ? Vec3::Zero() : Vec3(3 * random_.vector());
    body.angular_velocity = one_in(4) ? Vec3::Zero() : Vec3(8 * random_.vector());
    if (one_in(8)) body.linear_drag = random_.uniform(0, 1);
    body.shapes.push_back({random_shape(0.24), Vec3::Zero(), Quat::Identity(), "m", ""});
    builder_.add_body(body);
  }

  void add_joint() {
    ModelBuilder::JointDescription joint;
    joint.name = "joint";
    const JointType types[] = {JointType::hinge, JointType::ball,      JointType::slider,
                               JointType::fixed, JointType::universal, JointType::cylindrical};
    joint.type = types[random_count(0, 5)];
    joint.bodies = {one_in(3) ? "world" : "b1", "b0"};
    joint.anchors = {Vec3(0, -0.25, 0.5) + 0.2 * random_.vector()};
    joint.axis = random_.vector() + Vec3(0, 0, 1.5);
    if (joint.type == JointType::universal) joint.second_axis = joint.axis.cross(Vec3(1, 0, 0));
    builder_.add_joint(joint);
  }

  void add_spring() {
    ModelBuilder::ForceDescription spring{ModelBuilder::ForceDescription::Type::spring};
    spring.bodies = {"world", "b0"};
    spring.points = {Vec3(0, 0, 1), Vec3::Zero()};
    spring.stiffness = std::pow(10.0, random_.uniform(0, 3));
    spring.damping = one_in(2) ? 0 : random_.uniform(0, 5);
    builder_.add_force(spring);
  }

  Random random_;
  int most_bodies_;
  ModelBuilder builder_;
};

}  // namespace rigor::test
