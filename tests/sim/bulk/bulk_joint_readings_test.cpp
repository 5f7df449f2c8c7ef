// What a BulkSimulation tells of its joints, against what the accelerations of the exact schemes require, and
// closed forms of what acts along coordinates.

#include "bulk/random_bodies.hpp"
#include "rigor/model/model_builder.hpp"
#include "rigor/model/state.hpp"
#include "rigor/sim/audit/contact_snapshot.hpp"
#include "rigor/sim/bulk/bulk_simulation.hpp"
#include "rigor/sim/method/method.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace rigor::bulk_joint_readings_test {
namespace {

using random_bodies_test::Draw;

constexpr double g = 9.81;

Vec3 row(const std::vector<double>& rows, std::size_t i) {
  return Vec3(rows[3 * i], rows[3 * i + 1], rows[3 * i + 2]);
}

/// Three bodies in a row that joints of one type hold to each other and to the world, moving at random.
std::shared_ptr<const Model> random_chain(JointType type, Draw& draw) {
  ModelBuilder builder;
  builder.set_gravity(Vec3(0, 0, -g));
  std::string before = "world";
  for (int i = 0; i < 3; ++i) {
    BodyDescription body;
    body.name = "b" + std::to_string(i);
    body.p_WU = Vec3(i, 0, 0);
    body.q_WU = draw.orientation();
    body.inertia =
        GivenInertia{.mass = draw.between(0.5, 3), .moments = Vec3(0.2, 0.25, 0.3) * draw.between(0.5, 2)};
    builder.add_body(body);
    ModelBuilder::JointDescription joint;
    joint.name = before + body.name;
    joint.type = type;
    joint.bodies = {before, body.name};
    const Vec3 anchor = Vec3(i - 0.5, 0, 0) + 0.2 * draw.direction();
    joint.anchors = {anchor};
    if (type == JointType::distance) joint.anchors = {anchor, Vec3(i, 0, 0) + 0.2 * draw.direction()};
    joint.axis = draw.direction();
    if (type == JointType::universal) joint.second_axis = joint.axis.cross(draw.direction());
    if (type == JointType::screw) joint.parameter = draw.between(0.2, 1);
    builder.add_joint(joint);
    before = body.name;
  }
  return builder.build();
}

class JointReadings : public testing::TestWithParam<JointType> {};

TEST_P(JointReadings, AreTheForcesThatTheMotionRequires) {
  for (unsigned seed = 0; seed < 6; ++seed) {
    Draw draw(seed);
    const std::shared_ptr<const Model> model = random_chain(GetParam(), draw);
    // Substeps of 1/6 ms: forces are those of a substep before, and velocities have 24 bits.
    BulkSimulation simulation(model, {.step = 1e-3, .sleeping = false});
    double weight = 0;
    for (const Body& body : model->bodies()) weight += body.mass * g;
    for (int k = 0; k < 300; ++k) {
      simulation.step();
      if (k % 60 != 59) continue;
      const JointArrays all = simulation.joint_arrays();
      const std::vector<JointReaction> exact = joint_snapshot(*model, Method{}, simulation.state());
      double largest = weight;
      for (const JointReaction& joint : exact)
        largest = std::max({largest, joint.force_W.norm(), joint.torque_W.norm()});
      for (std::size_t i = 0; i < exact.size(); ++i) {
        SCOPED_TRACE("seed " + std::to_string(seed) + ", step " + std::to_string(k) + ", joint " +
                     std::to_string(i));
        EXPECT_LT((row(all.force, i) - exact[i].force_W).norm(), 0.01 * largest);
        EXPECT_LT((row(all.torque, i) - exact[i].torque_W).norm(), 0.01 * largest);
        for (std::size_t c = 0; c < exact[i].coordinates.size(); ++c) {
          EXPECT_NEAR(all.value[3 * i + c], exact[i].coordinates[c], 1e-9);
          EXPECT_NEAR(all.rate[3 * i + c], exact[i].rates[c], 1e-5);
        }
        EXPECT_EQ(all.joint[i], simulation.joint(static_cast<int>(i)));
        EXPECT_EQ(simulation.read_joint(all.joint[i])->force, row(all.force, i));
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Types, JointReadings,
                         testing::Values(JointType::fixed, JointType::ball, JointType::hinge,
                                         JointType::slider, JointType::universal, JointType::cylindrical,
                                         JointType::planar, JointType::screw, JointType::distance,
                                         JointType::point_on_line));

/// An arm of 2 kg on a hinge about y at the origin, its centre 0.5 m along x.
struct Arm {
  explicit Arm(const JointAxis& axis) : simulation(ModelBuilder().build(), {.step = 1e-3}) {
    simulation.set_gravity(Vec3(0, 0, -g));
    BodyDescription description;
    description.p_WU = Vec3(0.5, 0, 0);
    description.inertia = GivenInertia{.mass = 2, .moments = Vec3(0.1, 0.1, 0.1)};
    arm = simulation.add_body(description);
    ModelBuilder::JointDescription hinge;
    hinge.type = JointType::hinge;
    hinge.anchors = {Vec3::Zero()};
    hinge.axis = Vec3::UnitY();
    hinge.axes = {axis};
    joint = *simulation.add_joint(hinge, world_end, arm);
  }
  JointReading after(int steps) {
    for (int k = 0; k < steps; ++k) simulation.step();
    return *simulation.read_joint(joint);
  }
  BulkSimulation simulation;
  BodyId arm;
  JointId joint;
};

TEST(BulkJointReadings, TellWhatActsAlongACoordinate) {
  // Held by its limit: the torque of the weight, and the weight.
  Arm limited({.lower = -0.1, .upper = 0});
  JointReading reading = limited.after(200);
  EXPECT_EQ(reading.coordinates, 1u);
  EXPECT_NEAR(reading.value[0], 0, 1e-4);
  EXPECT_NEAR(reading.effort[0], -2 * g * 0.5, 1e-3);
  EXPECT_LT((reading.force - Vec3(0, 0, 2 * g)).norm(), 1e-3);
  EXPECT_LT((reading.torque - Vec3(0, -2 * g * 0.5, 0)).norm(), 1e-3);
  // Asleep it holds the same.
  for (int k = 0; k < 2000 && !*limited.simulation.is_asleep(limited.arm); ++k) limited.simulation.step();
  ASSERT_TRUE(*limited.simulation.is_asleep(limited.arm));
  EXPECT_NEAR(limited.after(1).effort[0], -2 * g * 0.5, 1e-3);

  // A motor that is too weak pulls as it can; a spring by its law.
  Arm driven({.motor = JointMotor{-1, 3}});
  reading = driven.after(100);
  EXPECT_NEAR(reading.effort[0], -3, 1e-4);
  EXPECT_GT(reading.rate[0], 0);
  Arm sprung({.stiffness = 20, .rest = 0.5, .damping = 0.3});
  reading = sprung.after(150);
  // It is that of the last substep, within which the coordinate moves on.
  const double way = std::abs(reading.rate[0]) * 1e-3 / 6;
  EXPECT_NEAR(reading.effort[0], -20 * (reading.value[0] - 0.5) - 0.3 * reading.rate[0], 20 * way + 1e-3);
  // None that was switched off.
  EXPECT_EQ(driven.simulation.set_motor(driven.joint, 0, std::nullopt), BulkStatus::done);
  EXPECT_EQ(driven.after(1).effort[0], 0);
}

TEST(BulkJointReadings, StayWhenOtherJointsGoAndTheStateTellsThem) {
  Arm arm({});
  ModelBuilder::JointDescription ball;
  ball.type = JointType::ball;
  ball.anchors = {Vec3(5, 0, 0)};
  BodyDescription bob;
  bob.p_WU = Vec3(6, 0, 0);
  bob.inertia = GivenInertia{.mass = 1, .moments = Vec3(0.1, 0.1, 0.1)};
  const JointId first = *arm.simulation.add_joint(ball, world_end, arm.simulation.add_body(bob));
  const JointReading before = arm.after(50);
  // The joint becomes another's place, and more bodies come than there are places.
  ASSERT_EQ(arm.simulation.remove_joint(first), BulkStatus::done);
  for (int i = 0; i < 200; ++i) arm.simulation.add_body(bob);
  JointReading after = *arm.simulation.read_joint(arm.joint);
  EXPECT_EQ(before.force, after.force);
  EXPECT_EQ(before.value, after.value);
  EXPECT_FALSE(arm.simulation.read_joint(first));
  EXPECT_FALSE(arm.simulation.read_joint(JointId{}));
  // One that has just come does nothing yet.
  const BodyId last = arm.simulation.add_body(bob);
  EXPECT_EQ(arm.simulation.read_joint(*arm.simulation.add_joint(ball, world_end, last))->force, Vec3::Zero());
  EXPECT_EQ(arm.simulation.read_joint(arm.joint)->force, before.force);
}

}  // namespace
}  // namespace rigor::bulk_joint_readings_test
