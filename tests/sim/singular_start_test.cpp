#include "rigor/sim/islands/singular_start.hpp"

#include "random_vectors.hpp"
#include "rigor/model/model_builder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace rigor::singular_start_test {
namespace {

/// Rods through these corners (x, z), a joint of this type at each, the first and the last tied to the world.
std::shared_ptr<const Model> closed_chain(const std::vector<Vec3>& corners, JointType type,
                                          const Vec3& gravity = Vec3(0, 0, -9.81)) {
  ModelBuilder builder;
  builder.set_gravity(gravity);
  builder.add_material({"m", 1000, 0.5, 0});
  const std::size_t rods = corners.size() - 1;
  for (std::size_t i = 0; i < rods; ++i) {
    const Vec3 along = corners[i + 1] - corners[i];
    BodyDescription rod;
    rod.name = "rod" + std::to_string(i);
    rod.p_WU = 0.5 * (corners[i] + corners[i + 1]);
    rod.q_WU = Quat::FromTwoVectors(Vec3::UnitX(), along);
    rod.shapes.push_back(
        {Box{Vec3(0.45 * along.norm(), 0.1, 0.02)}, Vec3::Zero(), Quat::Identity(), "m", ""});
    builder.add_body(rod);
  }
  const auto name_of = [rods](std::size_t i) { return i < rods ? "rod" + std::to_string(i) : "world"; };
  for (std::size_t i = 0; i <= rods; ++i) {
    ModelBuilder::JointDescription joint;
    joint.type = type;
    joint.name = "joint" + std::to_string(i);
    joint.bodies = {i == 0 ? "world" : name_of(i - 1), name_of(i)};
    joint.anchors = {corners[i]};
    if (type == JointType::hinge) joint.axis = Vec3::UnitY();
    builder.add_joint(joint);
  }
  return builder.build();
}

std::vector<Vec3> bridge(int rods, double sag) {
  std::vector<Vec3> corners;
  for (int i = 0; i <= rods; ++i) corners.emplace_back(0.3 * i, 0, 1 - sag * std::sin(M_PI * i / rods));
  return corners;
}

bool is_singular(const std::shared_ptr<const Model>& model) {
  return singular_joint(*model, make_initial_state(*model)).has_value();
}

TEST(SingularStart, IsAChainStretchedBetweenWallsButNotASlackOne) {
  for (const JointType type : {JointType::ball, JointType::hinge}) {
    for (const int rods : {2, 5, 9}) {
      EXPECT_TRUE(is_singular(closed_chain(bridge(rods, 0), type))) << rods;
      EXPECT_FALSE(is_singular(closed_chain(bridge(rods, 0.05), type))) << rods;
    }
  }
}

TEST(SingularStart, IsNoMechanismWithRedundantEquations) {
  // A four-bar linkage of hinges: three of its equations follow from the others wherever it is.
  const std::vector<Vec3> four_bar = {Vec3(0, 0, 0), Vec3(0.1, 0, 0.4), Vec3(0.7, 0, 0.6), Vec3(0.9, 0, 0)};
  EXPECT_FALSE(is_singular(closed_chain(four_bar, JointType::hinge)));
}

TEST(SingularStart, WithoutGravityVelocitiesTell) {
  const auto still = closed_chain(bridge(4, 0), JointType::hinge, Vec3::Zero());
  EXPECT_FALSE(is_singular(still));
  State pushed = make_initial_state(*still);
  for (int i = 0; i < still->body_count(); ++i)
    pushed.set_body(i, pushed.position(i), pushed.orientation(i), Vec3(0, 0, 1.0 + i), Vec3::Zero());
  EXPECT_TRUE(singular_joint(*still, pushed).has_value());
}

TEST(SingularStart, JointsWhoseOnlyEquationIsThatOfTheirMotorHaveNoneWithoutIt) {
  // A distance joint with room between its limits leaves its length free; a motor without a bound sets the
  // rate.
  for (const bool is_at_limit : {false, true}) {
    ModelBuilder builder;
    builder.add_material({"m", 1000, 0.5, 0});
    for (const int i : {0, 1}) {
      BodyDescription ball;
      ball.name = "ball" + std::to_string(i);
      ball.p_WU = Vec3(0.3 * i, 0, 3);
      ball.shapes.push_back({Sphere{0.05}, Vec3::Zero(), Quat::Identity(), "m", ""});
      builder.add_body(ball);
    }
    for (const int i : {0, 1}) {
      ModelBuilder::JointDescription joint;
      joint.type = JointType::distance;
      joint.name = "joint" + std::to_string(i);
      joint.bodies = {i == 0 ? "world" : "ball0", "ball" + std::to_string(i)};
      joint.anchors = {Vec3(0.3 * i - 0.3, 0, 3), Vec3(0.3 * i, 0, 3)};
      joint.axes.resize(1);
      joint.axes[0].lower = is_at_limit ? 0.3 : 0.2;
      joint.axes[0].upper = 0.5;
      joint.axes[0].motor = JointMotor{.velocity = 3};
      builder.add_joint(joint);
    }
    EXPECT_FALSE(is_singular(builder.build())) << is_at_limit;
  }
}

// What joints carry whole leaves rounding of velocities, and the rounding of their squares contradicted
// itself: a door on two hinges was warned of as stretched out.
TEST(SingularStart, IsNothingThatJointsCarryWhole) {
  test::Random random(3);
  for (int k = 0; k < 40; ++k) {
    const Vec3 up = random.vector().normalized();
    ModelBuilder builder;
    builder.set_gravity(-9.81 * up);
    builder.add_material({"m", 1000, 0.5, 0});
    BodyDescription door;
    door.name = "door";
    door.p_WU = random.vector();
    door.shapes.push_back({Box{Vec3(0.4, 0.02, 1)}, Vec3::Zero(), Quat::Identity(), "m", ""});
    builder.add_body(door);
    const Vec3 foot = random.vector();
    for (const int i : {0, 1}) {
      ModelBuilder::JointDescription joint;
      joint.type = k % 2 == 0 ? JointType::hinge : JointType::fixed;
      joint.name = "joint" + std::to_string(i);
      joint.bodies = {"world", "door"};
      joint.anchors = {foot + random.uniform(0.1, 1) * i * up};
      if (k % 2 == 0) joint.axis = up;
      builder.add_joint(joint);
    }
    EXPECT_FALSE(is_singular(builder.build())) << k;
  }
}

}  // namespace
}  // namespace rigor::singular_start_test
