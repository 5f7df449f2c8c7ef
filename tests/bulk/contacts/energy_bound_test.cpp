// Dissipative scenes never gain energy: heaps, stacks and bricks with mass ratios up to 1e6.

#include "bulk/random_bodies.hpp"
#include "rigor/bulk/bulk_world.hpp"

#include <gtest/gtest.h>

namespace rigor::energy_bound_test {
namespace {

using random_bodies_test::Draw;
using random_bodies_test::kinetic_energy_of;
using random_bodies_test::random_body;
using random_bodies_test::random_shape;

BodyDescription box_of(const std::string& name, const Vec3& half, const Vec3& p_W, double mass) {
  BodyDescription body = random_body(name, Box{half}, p_W);
  body.mass = mass;
  return body;
}

void add_floor(ModelBuilder& builder) {
  BodyDescription floor = random_body("floor", HalfSpace{Vec3::UnitZ(), 0}, Vec3::Zero());
  floor.motion = MotionType::fixed;
  builder.add_body(floor);
}

std::shared_ptr<const Model> heap(Draw& draw) {
  ModelBuilder builder;
  builder.set_gravity(Vec3(0, 0, -9.81));
  builder.add_material({"m", 1000, draw.between(0, 0.8), draw.below(2) == 0 ? 0 : draw.between(0, 1)});
  add_floor(builder);
  const double size = draw.spread(0.05, 1), ratio = draw.spread(1, 1e6);
  for (int k = 0; k < 12; ++k) {
    const Vec3 place(1.2 * (k % 2), 1.2 * (k / 2 % 2), 0.8 + 1.25 * (k / 4));
    BodyDescription body = random_body("b" + std::to_string(k), random_shape(draw, 0.6 * size), size * place);
    body.q_WU = draw.orientation();
    body.velocity = 2 * draw.direction();
    body.angular_velocity = 8 * draw.direction();
    body.mass = draw.spread(1, ratio);
    builder.add_body(body);
  }
  return builder.build();
}

/// Bricks in a running bond that a heavy ball hits.
std::shared_ptr<const Model> bricks(Draw& draw) {
  ModelBuilder builder;
  builder.set_gravity(Vec3(0, 0, -9.81));
  builder.add_material({"m", 1000, 0.5, draw.below(2) == 0 ? 0 : 0.3});
  add_floor(builder);
  for (int k = 0; k < 6; ++k) {
    const Vec3 p_W(0.205 * (k % 3) + (k / 3 == 1 ? 0.1025 : 0), 0, 0.05 + 0.1 * (k / 3));
    builder.add_body(box_of("b" + std::to_string(k), Vec3(0.1, 0.05, 0.05), p_W, 2));
  }
  const double speed = draw.between(2, 40), radius = 0.1;
  BodyDescription ball = random_body("ball", Sphere{radius}, Vec3(draw.between(0, 0.5), -1, radius));
  ball.mass = 2 * draw.spread(1, 1e6);
  ball.velocity = Vec3(0, speed, 0);
  ball.angular_velocity = Vec3(-speed / radius, 0, 0);
  builder.add_body(ball);
  return builder.build();
}

/// A stack at rest, the topmost of any mass.
std::shared_ptr<const Model> stack(Draw& draw) {
  ModelBuilder builder;
  builder.set_gravity(Vec3(0, 0, -9.81));
  builder.add_material({"m", 1000, 0.5, 0});
  add_floor(builder);
  const int count = 2 + draw.below(29);
  for (int k = 0; k < count; ++k) {
    builder.add_body(box_of("b" + std::to_string(k), Vec3(0.07, 0.09, 0.05), Vec3(0, 0, 0.05 + 0.1 * k),
                            count < 8 && k + 1 == count ? draw.spread(1, 1e6) : 1));
  }
  return builder.build();
}

struct Energies {
  double kinetic, total;  ///< [J].
};
/// With the potential over the floor and what the springs of contacts hold.
Energies energies(const Model& model, const State& state) {
  Energies sum{kinetic_energy_of(model, state), 0};
  sum.total = sum.kinetic;
  for (int i = 1; i < model.body_count(); ++i)
    sum.total -= model.body(i).mass * model.g_W().dot(state.position(i));
  for (const ManifoldMemory& manifold : state.manifolds) sum.total += static_cast<double>(manifold.energy);
  return sum;
}

/// The largest rise of the energy above an earlier value, as a part of what there is: the largest kinetic
/// energy, and what lies between the floor and the highest places.
double largest_rise(const std::shared_ptr<const Model>& model, double step) {
  BulkSettings settings;
  settings.measures = true;
  BulkWorld world(model, settings);
  State state = make_initial_state(*model);
  world.read(state);
  const Energies begin = energies(*model, state);
  double lowest = begin.total, rise = 0, kinetic = begin.kinetic;
  while (world.time() < 0.8) {
    world.step(step);
    world.write(state);
    const Energies now = energies(*model, state);
    rise = std::max(rise, now.total - lowest);
    lowest = std::min(lowest, now.total);
    kinetic = std::max(kinetic, now.kinetic);
  }
  return rise / (kinetic + begin.total - begin.kinetic);
}

TEST(EnergyBound, NoDissipativeSceneGainsEnergy) {
  Draw draw(3);
  for (int k = 0; k < 10; ++k) {
    const double step = draw.spread(0.005, 1.0 / 60);
    EXPECT_LE(largest_rise(heap(draw), step), 1e-4) << "heap " << k;
    EXPECT_LE(largest_rise(bricks(draw), step), 1e-4) << "bricks " << k;
    EXPECT_LE(largest_rise(stack(draw), step), 1e-4) << "stack " << k;
  }
}

/// A heap under strong gravity and long steps: bodies go deep into each other where they meet, and what then
/// lifts them out of it comes to rest at once.
std::shared_ptr<const Model> heavy_heap(Draw& draw) {
  ModelBuilder builder;
  builder.set_gravity(Vec3(0, 0, -50));
  builder.add_material({"m", 1000, draw.between(0, 1), draw.below(2) == 0 ? 0 : draw.between(0, 1)});
  add_floor(builder);
  const double size = draw.spread(0.02, 0.1);
  for (int k = 0; k < 8; ++k) {
    const Vec3 place(1.2 * (k % 2), 1.2 * (k / 2 % 2), 0.8 + 1.25 * (k / 4));
    BodyDescription body = random_body("b" + std::to_string(k), random_shape(draw, 0.6 * size), size * place);
    body.q_WU = draw.orientation();
    body.angular_velocity = 8 * draw.direction();
    builder.add_body(body);
  }
  return builder.build();
}

TEST(EnergyBound, WhatIsLiftedOutOfAnOverlapIsPaidFor) {
  Draw draw(5);
  for (int k = 0; k < 12; ++k) EXPECT_LE(largest_rise(heavy_heap(draw), 1.0 / 60), 1e-5) << "heap " << k;
}

/// A column of small cylinders of any densities that a fast ball hits: some go so far into each other that
/// they cannot get away, step after step.
std::shared_ptr<const Model> struck_column(Draw& draw) {
  ModelBuilder builder;
  builder.set_gravity(Vec3(0, 0, -draw.between(1, 10)));
  builder.add_material({"m", 1000, draw.between(0.3, 1.2), draw.below(2) == 0 ? 0 : 0.8});
  add_floor(builder);
  const double size = draw.spread(0.01, 0.02), radius = size * draw.between(0.3, 1);
  double top = 0;
  for (int k = 0; k < 11; ++k) {
    const double height = size * draw.between(0.3, 1);
    BodyDescription body =
        random_body("b" + std::to_string(k), Cylinder{radius, 0.5 * height}, Vec3(0, 0, top + 0.5 * height));
    body.mass = height * radius * radius * draw.spread(3, 3e6);
    builder.add_body(body);
    top += height;
  }
  BodyDescription ball =
      random_body("ball", Sphere{0.7 * size}, Vec3(-4 * size, 0, 0.7 * size + draw.between(0, 1) * top));
  ball.mass = size * size * size * draw.spread(3, 3e6);
  ball.velocity = Vec3(draw.between(0, 10), 0, 0);
  builder.add_body(ball);
  return builder.build();
}

TEST(EnergyBound, WhatCannotGetAwayDoesNotFallForNothing) {
  Draw draw(7);
  for (int k = 0; k < 6; ++k) {
    const double step = draw.spread(0.004, 0.01);
    const std::shared_ptr<const Model> model = struck_column(draw);
    if (k < 4) continue;  // It happens in few of them: in the last of these.
    EXPECT_LE(largest_rise(model, step), 1e-4) << "column " << k;
  }
}

TEST(EnergyBound, ALightBodyCarriesAHeavyOne) {
  for (double ratio = 10; ratio < 2e11; ratio *= 10) {
    ModelBuilder builder;
    builder.set_gravity(Vec3(0, 0, -9.81));
    builder.add_material({"m", 1000, 0.5, 0});
    add_floor(builder);
    builder.add_body(box_of("light", Vec3::Constant(0.15), Vec3(0, 0, 0.15), 1));
    builder.add_body(box_of("heavy", Vec3::Constant(0.15), Vec3(0, 0, 0.45), ratio));
    const std::shared_ptr<const Model> model = builder.build();
    BulkWorld world(model, {});
    world.read(make_initial_state(*model));
    for (int k = 0; k < 60; ++k) world.step(1.0 / 60);
    EXPECT_NEAR(world.bodies().x[2].z(), 0.45, 1e-4) << ratio;
  }
}

}  // namespace
}  // namespace rigor::energy_bound_test
