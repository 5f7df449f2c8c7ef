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

}  // namespace
}  // namespace rigor::joint_limits_test
