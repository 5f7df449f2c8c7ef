// Limits of joints in trees that share lanes.

#include "rigor/bulk/bulk_world.hpp"
#include "rigor/model/model_builder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace rigor::joint_limits_test {
namespace {

constexpr double kLower = -0.3, kUpper = 0.8;

/// Arms of a ball joint and two hinges with limits, that hang on the world and are thrown at different
/// speeds.
std::shared_ptr<const Model> arms(const std::vector<double>& speeds) {
  ModelBuilder builder;
  builder.set_gravity(Vec3(0, 0, -9.81));
  builder.add_material({"m", 1000, 0.5, 0});
  for (std::size_t k = 0; k < speeds.size(); ++k) {
    const double y = 10.0 * static_cast<double>(k);
    std::string parent = "world";
    for (int i = 0; i < 3; ++i) {
      BodyDescription link;
      link.name = "link" + std::to_string(k) + "," + std::to_string(i);
      link.p_WU = Vec3(0.5 + i, y, 0);
      link.velocity = Vec3(0, 0, speeds[k] * (i + 1));
      link.shapes.push_back({Box{Vec3(0.45, 0.1, 0.1)}, Vec3::Zero(), Quat::Identity(), "m", ""});
      builder.add_body(link);
      ModelBuilder::JointDescription joint;
      joint.name = "joint" + std::to_string(k) + "," + std::to_string(i);
      joint.type = i == 0 ? JointType::ball : JointType::hinge;
      joint.bodies = {parent, link.name};
      joint.anchors = {Vec3(i, y, 0)};
      joint.axis = Vec3::UnitY();
      if (i > 0) joint.axes = {JointAxis{.lower = kLower, .upper = kUpper}};
      builder.add_joint(joint);
      parent = link.name;
    }
  }
  return builder.build();
}

std::unique_ptr<BulkWorld> world_of(const std::vector<double>& speeds) {
  const std::shared_ptr<const Model> model = arms(speeds);
  auto world = std::make_unique<BulkWorld>(model, BulkSettings{});
  world->read(make_initial_state(*model));
  return world;
}

/// Angle of link i + 1 against link i of the first arm, about y.
double angle(const BulkWorld& world, std::size_t i) {
  const Quat q = world.bodies().q[i].conjugate() * world.bodies().q[i + 1];
  return 2 * std::atan2(q.y(), q.w());
}

/// An arm does the same, to the bit, alone and beside seven others, whose limits hold at other times.
TEST(JointLimits, AnArmDoesNotFeelWhatSharesItsLanes) {
  for (const double speed : {0.0, 0.4, -1.5, 3.0}) {
    const std::unique_ptr<BulkWorld> alone = world_of({speed});
    const std::unique_ptr<BulkWorld> among = world_of({speed, -3, 2, 0.1, -0.5, 5, 1, -2});
    double least = 0, most = 0;
    for (int k = 0; k < 120; ++k) {
      alone->step(1.0 / 60);
      among->step(1.0 / 60);
      for (std::size_t i = 0; i < 3; ++i) {
        ASSERT_EQ(alone->bodies().x[i], among->bodies().x[i]) << "speed " << speed << " step " << k;
        ASSERT_EQ(alone->bodies().q[i].coeffs(), among->bodies().q[i].coeffs())
            << "speed " << speed << " step " << k;
      }
      for (std::size_t i = 0; i < 2; ++i) {
        least = std::min(least, angle(*alone, i));
        most = std::max(most, angle(*alone, i));
      }
    }
    // The limits have held, and did hold.
    EXPECT_GT(most - least, 0.3) << speed;
    EXPECT_GE(least, kLower - 1e-3) << speed;
    EXPECT_LE(most, kUpper + 1e-3) << speed;
  }
}

/// A limb that a limit stops within one substep has turned by θ = ω h as foreseen and by nothing in the end:
/// the first correction leaves r θ²/2 of the joint's places, and the second, which a limb that stands after
/// the first one needs too, a part θ of that.
TEST(JointLimits, AFastLimbThatStopsKeepsItsJoint) {
  constexpr double r = 0.5, h = 1.0 / 60;
  for (const double spin : {20.0, 30.0, 40.0, 55.0}) {
    ModelBuilder builder;
    builder.set_gravity(Vec3::Zero());
    builder.add_material({"m", 1000, 0.5, 0});
    BodyDescription limb;
    limb.name = "limb";
    limb.p_WU = Vec3(r, 0, 0);
    limb.velocity = Vec3(0, 0, -r * spin);
    limb.angular_velocity = Vec3(0, spin, 0);
    limb.shapes.push_back({Box{Vec3(0.45, 0.1, 0.1)}, Vec3::Zero(), Quat::Identity(), "m", ""});
    builder.add_body(limb);
    ModelBuilder::JointDescription joint;
    joint.name = "joint";
    joint.type = JointType::hinge;
    joint.bodies = {"world", "limb"};
    joint.anchors = {Vec3::Zero()};
    joint.axis = Vec3::UnitY();
    joint.axes = {JointAxis{.lower = kLower, .upper = kUpper}};
    builder.add_joint(joint);
    const std::shared_ptr<const Model> model = builder.build();
    // It stops in the last substep of a step, after which the error is looked at: one substep a step.
    BulkWorld world(model, {.substeps = 1});
    world.read(make_initial_state(*model));
    const double step = h / 6, theta = spin * step;
    double worst = 0;
    for (int k = 0; k < 60; ++k) {
      world.step(step);
      const Vec3 anchor = world.bodies().x[0] + world.bodies().q[0] * Vec3(-r, 0, 0);
      worst = std::max(worst, anchor.norm());
    }
    EXPECT_LE(worst, r * theta * theta * theta) << spin;
    EXPECT_LT(world.bodies().q[0].angularDistance(Quat(Eigen::AngleAxisd(kUpper, Vec3::UnitY()))), 0.05);
  }
}

}  // namespace
}  // namespace rigor::joint_limits_test
