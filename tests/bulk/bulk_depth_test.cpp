// Small worlds of any masses, sizes and steps: no contact gets as deep as an audit does not allow.

#include "bulk/random_bodies.hpp"
#include "rigor/bulk/bulk_world.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>

namespace rigor::bulk_depth_test {
namespace {

using random_bodies_test::Draw;
using random_bodies_test::random_body;
using random_bodies_test::random_shape;

enum class Family { column, heap };

struct Scene {
  std::shared_ptr<const Model> model;
  double step;  ///< [s].
};

Scene random_scene(Family family, unsigned seed) {
  Draw draw(seed);
  ModelBuilder builder;
  const double gravities[] = {1.6, 9.81, 50}, steps[] = {1.0 / 60, 0.01, 0.004},
               restitutions[] = {0, 0.3, 0.8};
  builder.set_gravity(Vec3(0, 0, -gravities[draw.below(3)]));
  builder.add_material({"m", 1000, draw.between(0, 1.2), restitutions[draw.below(3)]});
  BodyDescription floor = random_body("floor", HalfSpace{Vec3::UnitZ(), 0}, Vec3::Zero());
  floor.motion = MotionType::fixed;
  builder.add_body(floor);
  // Masses over none to six decades, beside those of the sizes.
  const double size = draw.spread(0.01, 0.1), ratio = std::pow(10, 2 * draw.below(4));
  const auto add = [&](BodyDescription body, double volume) {
    body.mass = 1000 * volume * draw.spread(1 / std::sqrt(ratio), std::sqrt(ratio));
    builder.add_body(body);
  };
  const int count = 4 + draw.below(9);
  double top = 0, radius = size * draw.between(0.3, 1);
  for (int k = 0; k < count; ++k) {
    const std::string name = "b" + std::to_string(k);
    if (family == Family::column) {
      const double height = size * draw.between(0.3, 1);
      const Vec3 place(0.05 * radius * draw.between(-1, 1), 0.05 * radius * draw.between(-1, 1),
                       top + 0.5 * height);
      add(random_body(name, Cylinder{radius, 0.5 * height}, place), height * radius * radius * 3);
      top += height;
    } else {
      const Vec3 place(1.1 * (k % 2), 1.1 * (k / 2 % 2), 0.6 + 1.1 * (k / 4));
      BodyDescription body = random_body(name, random_shape(draw, size * draw.between(0.4, 1)), size * place);
      body.q_WU = draw.orientation();
      body.velocity = 2 * draw.direction();
      body.angular_velocity = 10 * draw.direction();
      add(body, size * size * size / 4);
    }
  }
  return {builder.build(), steps[draw.below(3)]};
}

/// The deepest that contacts of a part of a step begin, as a part of the thinner body's thickness.
double deepest_share(const Scene& scene) {
  BulkSettings settings;
  settings.measures = true;
  BulkWorld world(scene.model, settings);
  world.read(make_initial_state(*scene.model));
  double deepest = 0;
  while (world.time() < 1.5) deepest = std::max(deepest, world.step(scene.step).worst_share);
  return deepest;
}

// A quarter is what an audit allows. Islands of heavy bodies on light ones were left to the sweeps where they
// bounced, springs gave way by centimetres in long steps, and the passing guard let bodies creep into others.
TEST(BulkDepth, SmallWorldsStayOutOfEachOther) {
  for (const Family family : {Family::column, Family::heap}) {
    for (unsigned seed = 0; seed < 25; ++seed)
      EXPECT_LT(deepest_share(random_scene(family, seed)), 0.25)
          << (family == Family::column ? "column " : "heap ") << seed;
  }
}

}  // namespace
}  // namespace rigor::bulk_depth_test
