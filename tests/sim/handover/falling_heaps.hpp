#pragma once

#include "random_vectors.hpp"
#include "rigor/core/index.hpp"
#include "rigor/model/model_builder.hpp"
#include "rigor/sim/method/method.hpp"

#include <memory>
#include <string>

namespace rigor::handover_test {

inline constexpr double step = 0.01, interval = 0.02;

inline Method automatic() {
  Method method;
  method.scheme = Scheme::automatic;
  return method;
}

/// A few boxes and balls that fall askew on a floor, or a row of balls that one hits. The same seed gives the
/// same.
inline ModelBuilder heap_builder(unsigned seed) {
  test::Random random(seed);
  ModelBuilder builder;
  builder.set_gravity(Vec3(0, 0, -9.81));
  Material material{"m", 1000, 0.5, 0};
  material.restitution = seed % 3 == 0 ? 0 : random.uniform(0, 0.7);
  builder.add_material(material);
  const auto add = [&](const std::string& name, const Shape& shape, const Vec3& x, const Quat& q,
                       const Vec3& v) {
    BodyDescription body;
    body.name = name;
    body.p_WU = x;
    body.q_WU = q;
    body.velocity = v;
    if (is_unbounded(shape)) body.motion = MotionType::fixed;
    body.shapes.push_back({shape, Vec3::Zero(), Quat::Identity(), "m", ""});
    builder.add_body(body);
  };
  add("floor", HalfSpace{Vec3::UnitZ(), 0}, Vec3::Zero(), Quat::Identity(), Vec3::Zero());
  if (seed % 4 == 3) {
    // A row that rests on the floor is hit.
    for (int k = 0; k < 4; ++k)
      add("ball" + std::to_string(k), Sphere{0.1}, Vec3(0.2 * k, 0, 0.1), Quat::Identity(), Vec3::Zero());
    add("striker", Sphere{0.1}, Vec3(-0.5, 0.02, 0.1), Quat::Identity(), Vec3(3, 0, 0));
    return builder;
  }
  for (int k = 0; k < 3; ++k) {
    const Vec3 place(0.03 * random.uniform(-1, 1), 0.03 * random.uniform(-1, 1), 0.12 + 0.26 * k);
    const Quat turn =
        Quat(1, 0.3 * random.uniform(-1, 1), 0.3 * random.uniform(-1, 1), random.uniform(-1, 1)).normalized();
    const Shape shape = (seed + at(k)) % 3 == 2 ? Shape(Sphere{0.07}) : Shape(Box{Vec3(0.08, 0.06, 0.05)});
    add("body" + std::to_string(k), shape, place, turn, Vec3(0, 0, -1));
  }
  return builder;
}

inline std::shared_ptr<const Model> heap(unsigned seed) {
  return heap_builder(seed).build();
}

}  // namespace rigor::handover_test
