#pragma once

#include "geometry/random_pairs.hpp"
#include "rigor/bulk/state/bulk_bodies.hpp"
#include "rigor/model/model_builder.hpp"

#include <memory>

namespace rigor::test {

/// Two shapes where they are.
struct PlacedPair {
  Shape a, b;
  Pose X_WA, X_WB;
};

/// What rings and ellipsoids touch, in this order: a capsule, a ball, a box, a hull, a half-space.
inline Shape draw_plain_shape(Draw& draw, int kind) {
  switch (kind) {
    case 0:
      return Capsule{draw.uniform(0.1, 0.5), draw.uniform(0.05, 0.6)};
    case 1:
      return Sphere{draw.uniform(0.1, 0.5)};
    case 2:
      return Box{Vec3(draw.uniform(0.1, 0.5), draw.uniform(0.1, 0.5), draw.uniform(0.1, 0.5))};
    case 3:
      return draw.hull(24);
    default:
      return HalfSpace{draw.direction(), 0};
  }
}

/// A fixed body a and a kinematic body b.
inline std::shared_ptr<const Model> model_of(const PlacedPair& pair) {
  ModelBuilder builder;
  for (const Shape* shape : {&pair.a, &pair.b}) {
    BodyDescription body;
    body.name = shape == &pair.a ? "a" : "b";
    body.motion = shape == &pair.a ? MotionType::fixed : MotionType::kinematic;
    body.shapes.push_back({*shape});
    builder.add_body(body);
  }
  return builder.build();
}

/// The two bodies of that model where the shapes are.
inline BulkBodies bodies_of(const PlacedPair& pair) {
  BulkBodies bodies;
  bodies.x = {pair.X_WA.p, pair.X_WB.p};
  bodies.q = {Quat(pair.X_WA.R), Quat(pair.X_WB.R)};
  bodies.motion.resize(2);
  bodies.inertia.resize(2);
  return bodies;
}

}  // namespace rigor::test
