#include "rigor/bulk/bulk_world.hpp"
#include "rigor/model/model_builder.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rigor::convergence_test {
namespace {

constexpr double g = 9.81;
constexpr double friction = 0.3;
constexpr double speed = 4;
constexpr double duration = 2;

BodyDescription floor_body() {
  BodyDescription floor;
  floor.name = "floor";
  floor.motion = MotionType::fixed;
  floor.shapes.emplace_back().shape = HalfSpace{Vec3::UnitZ(), 0};
  floor.shapes[0].material = "wood";
  return floor;
}

BodyDescription thrown(const Shape& shape, double height) {
  BodyDescription body;
  body.name = "thrown";
  body.p_WU = Vec3(0, 0, height);
  body.velocity = Vec3(speed, 0, 0);
  body.shapes.emplace_back().shape = shape;
  body.shapes[0].material = "wood";
  return body;
}

/// How far it gets with so many substeps of steps of 1/60 s.
double way_of(const BodyDescription& body, int substeps) {
  ModelBuilder builder;
  builder.set_gravity(Vec3(0, 0, -g));
  Material wood;
  wood.name = "wood";
  wood.friction = friction;
  builder.add_material(wood);
  builder.add_body(floor_body());
  builder.add_body(body);
  const std::shared_ptr<const Model> model = builder.build();
  BulkSettings settings;
  settings.substeps = substeps;
  BulkWorld world(model, settings);
  world.read(make_initial_state(*model));
  for (int k = 0; k < static_cast<int>(60 * duration); ++k) world.step(1.0 / 60);
  return world.bodies().x[1].x();
}

/// Of first order in the substep, but for the step in which the contact begins to carry: the error falls by
/// more than half with each four times as many, down to the rounding of velocities of 32 bits.
void expect_convergence(const BodyDescription& body, double exact) {
  constexpr double rounding = duration * 60 * 64 * 6e-8;
  double before = 0;
  for (const int substeps : {4, 16, 64}) {
    const double error = std::abs(way_of(body, substeps) - exact);
    EXPECT_LE(error, speed / 60 / substeps) << substeps;
    if (substeps > 4) {
      EXPECT_LE(error, 0.5 * before + rounding) << substeps;
    }
    before = error;
  }
}

TEST(BulkConvergence, ABlockSlidesToItsStopAsCoulombHasIt) {
  expect_convergence(thrown(Box{Vec3(0.5, 0.5, 0.1)}, 0.1), speed * speed / (2 * friction * g));
}

/// It slides until the friction has given it the turning of a rolling ball, at 5/7 of its speed.
TEST(BulkConvergence, ABallSlidesIntoRolling) {
  const double until = 2 * speed / (7 * friction * g);
  const double way =
      speed * until - 0.5 * friction * g * until * until + 5.0 / 7 * speed * (duration - until);
  expect_convergence(thrown(Sphere{0.25}, 0.25), way);
}

}  // namespace
}  // namespace rigor::convergence_test
