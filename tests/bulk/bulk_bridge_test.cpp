#include "rigor/bulk/bulk_world.hpp"
#include "rigor/model/model_builder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace rigor::bulk_bridge_test {
namespace {

constexpr double kStep = 1.0 / 60;

/// Planks of 0.5 m x 2 m between two banks, held to each other and to the banks by balls at both ends; crates
/// fall on them.
std::shared_ptr<const Model> loaded_bridge(int planks, int crates) {
  ModelBuilder builder;
  builder.set_gravity(Vec3(0, 0, -9.81));
  builder.add_material({"wood", 600, 0.6, 0});
  const double slope = 0.2, length = 0.5;
  const auto point = [&](int i) {
    const int down = std::min(i, planks - i);
    return Vec3(length * std::cos(slope) * (i - 0.5 * planks), 0, -length * std::sin(slope) * down);
  };
  const auto box = [](const Vec3& half) {
    return ShapeDescription{Box{half}, Vec3::Zero(), Quat::Identity(), "wood", ""};
  };
  for (int i = 0; i < planks; ++i) {
    BodyDescription plank;
    plank.name = "plank" + std::to_string(i);
    plank.p_WU = 0.5 * (point(i) + point(i + 1));
    const double turn = 2 * i < planks ? slope : -slope;
    plank.q_WU = Quat(std::cos(turn / 2), 0, std::sin(turn / 2), 0);
    plank.shapes = {box(Vec3(0.23, 1, 0.05))};
    plank.linear_drag = 40;  // So that it comes to rest.
    plank.angular_drag = 10;
    builder.add_body(plank);
  }
  for (int i = 0; i <= planks; ++i) {
    for (const double side : {-1.0, 1.0}) {
      ModelBuilder::JointDescription joint;
      joint.name = "j" + std::to_string(i) + (side > 0 ? "l" : "r");
      joint.type = JointType::ball;
      joint.bodies = {i == 0 ? "world" : "plank" + std::to_string(i - 1),
                      i == planks ? "world" : "plank" + std::to_string(i)};
      joint.anchors = {point(i) + Vec3(0, side, 0)};
      builder.add_joint(joint);
    }
  }
  for (int i = 0; i < crates; ++i) {
    BodyDescription crate;
    crate.name = "crate" + std::to_string(i);
    const double x = 0.7 * (i - 0.5 * (crates - 1));
    const double plank_height = -std::tan(slope) * (0.5 * planks * length * std::cos(slope) - std::abs(x));
    crate.p_WU = Vec3(x, 0.2 * (i % 3 - 1), plank_height + 0.45);
    crate.shapes = {box(Vec3(0.25, 0.25, 0.25))};
    builder.add_body(crate);
  }
  return builder.build();
}

/// Kinetic energy and that of the weight [J].
double energy_of(const Model& model, const BulkBodies& bodies) {
  double sum = 0;
  for (int i = 0; i < bodies.count(); ++i) {
    const std::size_t k = static_cast<std::size_t>(i);
    const Body& body = model.body(i);
    const Vec3 v(bodies.motion[k].v[0], bodies.motion[k].v[1], bodies.motion[k].v[2]);
    const Vec3 w_B =
        bodies.q[k].conjugate() * Vec3(bodies.motion[k].w[0], bodies.motion[k].w[1], bodies.motion[k].w[2]);
    sum += 0.5 * body.mass * v.squaredNorm() + 0.5 * w_B.dot(Vec3(body.moments.cwiseProduct(w_B))) -
           body.mass * model.g_W().dot(bodies.x[k]);
  }
  return sum;
}

/// Largest speed of a body [m/s].
double fastest(const BulkBodies& bodies) {
  double speed = 0;
  for (const MotionRecord& motion : bodies.motion) {
    speed = std::max(speed, Vec3(motion.v[0], motion.v[1], motion.v[2]).norm());
  }
  return speed;
}

TEST(BulkBridge, OfPlanksCarriesTenCratesAndComesToRest) {
  const std::shared_ptr<const Model> model = loaded_bridge(40, 10);
  BulkSettings settings;
  settings.measures = true;
  BulkWorld world(model, settings);
  world.read(make_initial_state(*model));
  double lowest = energy_of(*model, world.bodies()), rise = 0, joint_error = 0;
  for (int i = 0; i < 1200; ++i) {
    joint_error = std::max(joint_error, world.step(kStep).max_joint_error);
    const double energy = energy_of(*model, world.bodies());
    ASSERT_TRUE(std::isfinite(energy)) << i;
    rise = std::max(rise, energy - lowest);
    lowest = std::min(lowest, energy);
  }
  EXPECT_LE(joint_error, 1e-3);
  // What the springs of contacts give back: ten crates of 75 kg, by a centimetre.
  EXPECT_LE(rise, 10 * 75 * 9.81 * 0.01);
  EXPECT_LE(fastest(world.bodies()), 0.02);
  // Nothing has fallen through: its lowest plank is 2 m below the banks.
  for (int i = 0; i < model->body_count(); ++i) {
    EXPECT_GE(world.bodies().x[static_cast<std::size_t>(i)].z(), -3) << model->body(i).name;
  }
}

TEST(BulkBridge, GoesOnBitForBitFromItsStateOnAnyNumberOfThreads) {
  const std::shared_ptr<const Model> model = loaded_bridge(12, 3);
  State whole = make_initial_state(*model), pieces = whole;
  BulkWorld world(model, {});
  world.read(whole);
  for (int i = 0; i < 60; ++i) {
    world.step(kStep);
    BulkSettings settings;
    settings.threads = 1 + i % 3;
    BulkWorld fresh(model, settings);
    fresh.read(deserialise(serialise(pieces)));
    fresh.step(kStep);
    fresh.write(pieces);
    world.write(whole);
    ASSERT_EQ(pieces, whole) << i;
  }
  EXPECT_GE(whole.manifolds.size(), 3U);
}

}  // namespace
}  // namespace rigor::bulk_bridge_test
