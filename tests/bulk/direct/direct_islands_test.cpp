#include "rigor/bulk/bulk_world.hpp"
#include "rigor/model/model_builder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace rigor::direct_islands_test {
namespace {

constexpr double g = 9.81;
constexpr double h = 1.0 / 60;

/// A floor with a tower of unit cubes, the topmost with this many times the mass of the others.
std::shared_ptr<const Model> tower(int height, double ratio, double friction = 0.5, double tilt = 0) {
  ModelBuilder builder;
  builder.set_gravity(Vec3(g * std::sin(tilt), 0, -g * std::cos(tilt)));
  Material stone;
  stone.name = "stone";
  stone.friction = friction;
  builder.add_material(stone);
  BodyDescription floor;
  floor.name = "floor";
  floor.motion = MotionType::fixed;
  floor.shapes.emplace_back().shape = HalfSpace{Vec3::UnitZ(), 0};
  floor.shapes[0].material = "stone";
  builder.add_body(floor);
  for (int i = 0; i < height; ++i) {
    const double mass = i + 1 == height ? 1000 * ratio : 1000;
    BodyDescription cube;
    cube.name = "cube" + std::to_string(i);
    cube.p_WU = Vec3(0, 0, 0.5 + i);
    cube.inertia = GivenInertia{mass, Vec3::Zero(), Vec3::Constant(mass / 6), Vec3::Zero()};
    cube.shapes.emplace_back().shape = Box{Vec3::Constant(0.5)};
    cube.shapes[0].material = "stone";
    builder.add_body(cube);
  }
  return builder.build();
}

/// How far any body is from where it began [m].
double farthest(const Model& model, const BulkWorld& world) {
  double most = 0;
  for (int i = 0; i < model.body_count(); ++i)
    most = std::max(
        most, (world.bodies().x[static_cast<std::size_t>(i)] - make_initial_state(model).position(i)).norm());
  return most;
}

/// Sum of the normal impulses of a pair in a substep, as a force [N].
double force_between(const BulkWorld& world, int a, int b, int substeps) {
  double force = 0;
  for (const ManifoldMemory& memory : world.memory()) {
    if (memory.body_A != a || memory.body_B != b) continue;
    for (const float impulse : memory.normal_impulse) force += static_cast<double>(impulse) * substeps / h;
  }
  return force;
}

/// Sweeps alone let it come down within four seconds.
TEST(DirectIslands, ATowerOfTwentyUnderAHundredfoldTopStands) {
  const std::shared_ptr<const Model> model = tower(20, 100);
  BulkWorld world(model, {});
  world.read(make_initial_state(*model));
  for (int k = 0; k < 600; ++k) EXPECT_EQ(world.step(h).direct_islands, 1);
  // Gaps are rounded to 1e-6 of the lengths in a pair, and overlaps below 1e-5 of the scene stay: 2e-5 a
  // cube.
  EXPECT_LE(farthest(*model, world), 20 * 2e-5);
  // The weight of all above, to the rounding of 32 bits of the memory and of the solution.
  for (int i = 1; i < 20; ++i) {
    const double weight = 1000 * g * (100 + 19 - i);
    EXPECT_NEAR(force_between(world, i, i + 1, BulkSettings{}.substeps), weight, 1e-5 * weight) << i;
  }
}

TEST(DirectIslands, FrictionHoldsUnderItsAngleAndGivesWayOverIt) {
  constexpr double friction = 0.3;
  for (const double factor : {0.99, 1.01}) {
    const double tilt = std::atan(factor * friction);
    const std::shared_ptr<const Model> model = tower(2, 50, friction, tilt);
    BulkWorld world(model, {});
    world.read(make_initial_state(*model));
    for (int k = 0; k < 120; ++k) EXPECT_EQ(world.step(h).direct_islands, 1);
    const double way = world.bodies().x[2].x();
    // Steps of implicit Euler: a t (t + h) / 2.
    const double a = g * std::max(0.0, std::sin(tilt) - friction * std::cos(tilt));
    EXPECT_NEAR(way, 0.5 * a * 2 * (2 + h), 1e-4) << factor;
  }
}

TEST(DirectIslands, EqualMassesAreLeftToTheSweeps) {
  const std::shared_ptr<const Model> model = tower(3, 9);
  BulkWorld world(model, {});
  world.read(make_initial_state(*model));
  for (int k = 0; k < 10; ++k) EXPECT_EQ(world.step(h).direct_islands, 0);
}

TEST(DirectIslands, AStepFromARestoredStateHasTheSameBits) {
  const std::shared_ptr<const Model> model = tower(6, 100, 0.5, 0.05);
  BulkWorld world(model, {});
  world.read(make_initial_state(*model));
  for (int k = 0; k < 20; ++k) world.step(h);
  State state = make_initial_state(*model);
  world.write(state);
  BulkSettings settings;
  settings.threads = 3;
  BulkWorld restored(model, settings);
  restored.read(deserialise(serialise(state)));
  for (int k = 0; k < 20; ++k) {
    world.step(h);
    restored.step(h);
  }
  State a = state, b = state;
  world.write(a);
  restored.write(b);
  EXPECT_EQ(serialise(a), serialise(b));
}

}  // namespace
}  // namespace rigor::direct_islands_test
