// Fast and small bodies against thin walls on the many-body path.

#include "rigor/bulk/bulk_world.hpp"
#include "rigor/model/model_builder.hpp"

#include "random_vectors.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

namespace rigor::bulk_tunnelling_test {
namespace {

constexpr double step = 1.0 / 60;

BodyDescription tunnelling_body(const std::string& name, const Shape& shape, const Vec3& p_W) {
  BodyDescription body;
  body.name = name;
  body.p_WU = p_W;
  body.shapes.push_back({shape, Vec3::Zero(), Quat::Identity(), "m", ""});
  return body;
}

/// A body of 1 kg that flies along x at `speed` against a wall at x = 1, turning at `spin` about y.
std::shared_ptr<const Model> wall_model(const Shape& shape, double wall, double speed, double spin) {
  ModelBuilder builder;
  builder.set_gravity(Vec3::Zero());
  builder.add_material({"m", 1000, 0.3, 0.5});
  BodyDescription plate = tunnelling_body("wall", Box{Vec3(0.5 * wall, 2, 2)}, Vec3(1, 0, 0));
  plate.motion = MotionType::fixed;
  builder.add_body(plate);
  BodyDescription body = tunnelling_body("body", shape, Vec3::Zero());
  body.mass = 1;
  body.velocity = Vec3(speed, 0, 0);
  body.angular_velocity = Vec3(0, spin, 0.3 * spin);
  builder.add_body(body);
  return builder.build();
}

/// Where a body was while it flew against the wall.
struct Flight {
  double farthest = 0;    ///< Largest x at a step's end [m].
  double last_speed = 0;  ///< Along x [m/s].
};

/// Until it would be 0.2 m behind the wall, and two steps more.
Flight fly(const std::shared_ptr<const Model>& model, double speed) {
  State state = make_initial_state(*model);
  BulkWorld world(model, BulkSettings{});
  world.read(state);
  Flight flight;
  while (world.time() < 1.2 / speed + 2 * step) {
    world.step(step);
    world.write(state);
    // A position that is no number would pass every comparison below.
    const bool is_finite = state.position(1).allFinite() && state.linear_momentum(1).allFinite();
    EXPECT_TRUE(is_finite) << "at " << world.time() << " s";
    if (!is_finite) break;
    flight.farthest = std::max(flight.farthest, state.position(1).x());
  }
  flight.last_speed = linear_velocity(*model, state, 1).x();
  return flight;
}

TEST(BulkTunnelling, NothingPassesAThinWallAndNothingStopsBeforeIt) {
  int cases = 0;
  for (const Shape& shape :
       {Shape{Sphere{0.05}}, Shape{Box{Vec3(0.05, 0.05, 0.05)}}, Shape{Capsule{0.01, 0.2}},
        Shape{Cylinder{0.05, 0.02}}, Shape{Box{Vec3(0.2, 0.005, 0.01)}}}) {
    for (const double wall : {1e-3, 0.02, 0.1}) {
      for (const double speed : {5.0, 20.0, 100.0, 400.0}) {
        for (const double spin : {0.0, 50.0}) {
          ++cases;
          SCOPED_TRACE("case " + std::to_string(cases));
          const Flight flight = fly(wall_model(shape, wall, speed, spin), speed);
          EXPECT_LT(flight.farthest, 1);
          EXPECT_GT(flight.farthest, 0);
          EXPECT_LT(flight.last_speed, 0.9 * speed);
        }
      }
    }
  }
  EXPECT_EQ(cases, 120);
}

TEST(BulkTunnelling, BallsThatFlyAtEachOtherDoNotPass) {
  for (const double speed : {5.0, 20.0, 100.0, 400.0}) {
    ModelBuilder builder;
    builder.set_gravity(Vec3::Zero());
    builder.add_material({"m", 1000, 0.3, 1});
    for (const double side : {-1.0, 1.0}) {
      BodyDescription ball = tunnelling_body(side < 0 ? "left" : "right", Sphere{0.02}, Vec3(side, 0, 0));
      ball.velocity = Vec3(-side * speed, 0, 0);
      builder.add_body(ball);
    }
    const std::shared_ptr<const Model> model = builder.build();
    State state = make_initial_state(*model);
    BulkWorld world(model, BulkSettings{});
    world.read(state);
    while (world.time() < 2 / speed + 2 * step) {
      world.step(step);
      world.write(state);
      ASSERT_LT(state.position(0).x(), state.position(1).x()) << speed;
    }
    // They have met, and turned back as they came: e = 1.
    EXPECT_NEAR(linear_velocity(*model, state, 0).x(), -speed, 1e-4 * speed) << speed;
  }
}

TEST(BulkTunnelling, ABallDoesNotPassAThinPlateThatIsFree) {
  for (const double speed : {5.0, 100.0, 400.0}) {
    ModelBuilder builder;
    builder.set_gravity(Vec3::Zero());
    builder.add_material({"m", 1000, 0.3, 0});
    BodyDescription plate = tunnelling_body("plate", Box{Vec3(0.001, 1, 1)}, Vec3(1, 0, 0));
    builder.add_body(plate);
    BodyDescription ball = tunnelling_body("ball", Sphere{0.02}, Vec3::Zero());
    ball.velocity = Vec3(speed, 0, 0);
    builder.add_body(ball);
    const std::shared_ptr<const Model> model = builder.build();
    State state = make_initial_state(*model);
    const Vec3 P = state.linear_momentum(1);
    BulkWorld world(model, BulkSettings{});
    world.read(state);
    while (world.time() < 1.2 / speed + 2 * step) {
      world.step(step);
      world.write(state);
      ASSERT_LT(state.position(1).x(), state.position(0).x()) << speed;
    }
    // They go on together: all momentum is there, in 32 bits.
    const Vec3 after = state.linear_momentum(0) + state.linear_momentum(1);
    EXPECT_LT((after - P).norm(), 1e-5 * P.norm()) << speed;
    EXPECT_LT(linear_velocity(*model, state, 1).x(), 0.9 * speed) << speed;
  }
}

/// Balls that a turning blade strikes stay on its face or fly off: one that slides outward on it sinks into
/// it by no more than its contacts give way, whatever the blade's speed and the step are.
TEST(BulkTunnelling, BallsThatSlideAlongATurningBladeStayOnItsFace) {
  test::Random random(5);
  for (int k = 0; k < 40; ++k) {
    const double half = random.uniform(5e-4, 1.5e-3), radius = random.uniform(0.01, 0.05);
    const double spin = std::pow(10, random.uniform(1.5, 3)), place = random.uniform(0.2, 0.5);
    const double H = std::pow(10, random.uniform(-3, -1.8)), angle = random.uniform(0.4, 2.7);
    ModelBuilder builder;
    builder.set_gravity(Vec3::Zero());
    builder.add_material({"m", 3000, k % 2 * 0.3, k % 3 == 0 ? 0.5 : 0.0});
    BodyDescription blade = tunnelling_body("blade", Box{Vec3(0.8, half, 0.06)}, Vec3::Zero());
    blade.motion = MotionType::kinematic;
    blade.angular_velocity = Vec3(0, 0, spin);
    builder.add_body(blade);
    builder.add_body(tunnelling_body("ball", Sphere{radius},
                                     Vec3(place * std::cos(angle), place * std::sin(angle), 0.3 * radius)));
    const std::shared_ptr<const Model> model = builder.build();
    BulkWorld world(model, BulkSettings{});
    world.read(make_initial_state(*model));
    double overlap = 0;
    while (world.time() < 4.5 / spin) overlap = std::max(overlap, world.step(H).max_overlap);
    EXPECT_LT(overlap, 0.25 * 2 * half) << k << ": " << spin << " rad/s, step " << H;
  }
}

/// A strike in a tiny part of a step is no force that a longer part makes larger: what the next part would
/// begin with, thousands of times the impulse, would leave its rounding in the ball's momentum.
TEST(BulkTunnelling, AStrikeInATinyPartLeavesNoMomentumBehind) {
  test::Random random(11);
  for (int k = 0; k < 300; ++k) {
    const double half = random.uniform(5e-4, 1.5e-3), radius = random.uniform(0.005, 0.05);
    const double speed = std::pow(10, random.uniform(1.5, 3.5)), gap = random.uniform(0, 0.6 * speed * step);
    ModelBuilder builder;
    builder.set_gravity(Vec3::Zero());
    builder.add_material({"m", 700, k % 2 * 0.3, 0});
    BodyDescription blade = tunnelling_body("blade", Box{Vec3(0.9, half, 0.04)}, Vec3::Zero());
    blade.motion = MotionType::kinematic;
    blade.velocity = Vec3(0, speed, 0);
    builder.add_body(blade);
    builder.add_body(tunnelling_body("ball", Sphere{radius},
                                     Vec3(random.uniform(-0.5, 0.5), half + radius + gap, 0.3 * radius)));
    const std::shared_ptr<const Model> model = builder.build();
    BulkSettings settings;
    settings.measures = true;
    BulkWorld world(model, settings);
    world.read(make_initial_state(*model));
    for (int n = 0; n < 3; ++n) {
      const BulkStepReport report = world.step(step);
      // Two roundings of 32 bits in each of the two sweeps of a substep.
      EXPECT_LE(report.momentum_error.norm(), 4 * 0x1p-24 * settings.substeps * report.rounded_momentum)
          << k << ": " << speed << " m/s, gap " << gap << ", step " << n;
    }
  }
}

}  // namespace
}  // namespace rigor::bulk_tunnelling_test
