#include "rigor/dynamics/joint_rows.hpp"

#include "dynamics/joint_samples.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace rigor::gear_rows_test {
namespace {

using test::Random;
using tests::turned;

Joint gear_of(double ratio) {
  Joint gear;
  gear.type = JointType::gear;
  gear.parameter = ratio;
  return gear;
}

/// Bodies 0, 1, 2: two joints that both begin at body 0, a frame that may move too.
struct Train {
  Joint first, second;
  std::array<BodyMotion, 3> bodies;

  JointRows rows(double ratio, double t = 0) const {
    const BodyMotion frame = tests::moved(bodies[0], t);
    return gear_rows(gear_of(ratio), first, frame, tests::moved(bodies[1], t), second, frame,
                     tests::moved(bodies[2], t));
  }
};

Train train(JointType first, double c1, JointType second, double c2, Random& random) {
  Train result{tests::random_joint(first, random), tests::random_joint(second, random), {}};
  result.second.body_B = 2;
  for (BodyMotion& body : result.bodies) body = tests::random_motion(random);
  const auto pose = [](JointType type, double c) {
    const bool turns = is_angle(type, 0);
    return turns ? Pose{turned(c * Vec3::UnitZ()), Vec3::Zero()} : Pose{Mat3::Identity(), c * Vec3::UnitZ()};
  };
  tests::place(result.first, result.bodies[0], pose(first, c1), result.bodies[1]);
  tests::place(result.second, result.bodies[0], pose(second, c2), result.bodies[2]);
  return result;
}

TEST(GearRows, WholeTurnsOfWheelsAreMadeUpFor) {
  Random random(1);
  // Numbers of teeth 3 : 2 and the like, many turns on, and off by a part of a tooth.
  for (const double ratio : {1.0, -1.0, -1.5, 2.0 / 3, 1.0 / 3, -17.0 / 60, 12.5}) {
    for (const double angle : {0.1, 2.0, -7.0, 40.0}) {
      for (const double off : {0.0, 0.002, -0.003}) {
        const Train wheels = train(JointType::hinge, angle, JointType::hinge, ratio * angle + off, random);
        const JointRows rows = wheels.rows(ratio);
        ASSERT_EQ(rows.size, 1);
        // Rounding of the angle times the ratio.
        EXPECT_NEAR(rows.g[0], off, 1e-13) << ratio << " " << angle;
      }
    }
  }
}

TEST(GearRows, OtherRatiosHoldTheRateOnly) {
  Random random(2);
  for (const double ratio : {M_PI, std::sqrt(0.5), 0.12347}) {
    const Train wheels = train(JointType::hinge, 0.5, JointType::hinge, 0.1, random);
    const JointRows rows = wheels.rows(ratio);
    EXPECT_EQ(rows.g[0], 0);
    EXPECT_GT(rows.J[1].row(0).norm(), 0.1);
  }
}

TEST(GearRows, ARackGoesOnWhereItsPinionHasTurnedRound) {
  Random random(3);
  constexpr double radius = 0.0321;
  for (const double angle : {0.3, 5.0, -20.0}) {
    const double way = radius * angle;
    EXPECT_NEAR(train(JointType::hinge, angle, JointType::slider, way + 1e-3, random).rows(radius).g[0], 1e-3,
                1e-15 * 10);
    EXPECT_NEAR(train(JointType::slider, way, JointType::hinge, angle + 1e-3, random).rows(1 / radius).g[0],
                1e-3, 1e-13);
  }
  // Two racks have no turns.
  EXPECT_NEAR(train(JointType::slider, 2, JointType::slider, 20, random).rows(3).g[0], 14, 1e-13);
}

TEST(GearRows, ABodyOfBothJointsAppearsOnceAndTheRowIsTheDerivative) {
  Random random(4);
  for (int sample = 0; sample < 50; ++sample) {
    const double angle = 2 * random.number();
    const Train wheels = train(JointType::hinge, angle, JointType::screw, -1.5 * angle, random);
    const JointRows rows = wheels.rows(-1.5);
    ASSERT_EQ(rows.side_count, 3);
    double rate = 0;
    Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
    for (std::size_t side = 0; side < 3; ++side) {
      ASSERT_EQ(rows.bodies[side], static_cast<int>(side));
      const BodyMotion& body = wheels.bodies[side];
      const Vec3 f = rows.J[side].row(0).head<3>(), tau = rows.J[side].row(0).tail<3>();
      rate += f.dot(body.v) + tau.dot(body.w);
      force += f;
      moment += tau + body.x.cross(f);
    }
    EXPECT_LE(force.norm() + moment.norm(), 1e-13);
    // Fourth-order differences: the rest is of order h⁴, h⁴ = 1e-12 (and rounding 1e-16/h²).
    constexpr double h = 1e-3;
    const auto g = [&](double t) { return wheels.rows(-1.5, t).g[0]; };
    EXPECT_NEAR(rate, (8 * (g(h) - g(-h)) - (g(2 * h) - g(-2 * h))) / (12 * h), 1e-10);
    EXPECT_NEAR(rows.bias[0], (16 * (g(h) + g(-h)) - (g(2 * h) + g(-2 * h)) - 30 * g(0)) / (12 * h * h),
                3e-9);
  }
}

TEST(GearRows, WheelsOnTheWorldHaveTwoSides) {
  Random random(5);
  Train wheels = train(JointType::hinge, 0.2, JointType::hinge, -0.4, random);
  wheels.first.body_A = wheels.second.body_A = world_body;
  const JointRows rows = wheels.rows(-2);
  EXPECT_EQ(rows.side_count, 2);
  // Rate of the second + 2 rate of the first: torques 2 : 1 about the axes.
  const Vec3 axis = wheels.bodies[1].R * wheels.first.X_BK.R.col(2);
  EXPECT_LE((rows.J[0].row(0).tail<3>().transpose() - 2 * axis).norm(), 1e-14);
}

}  // namespace
}  // namespace rigor::gear_rows_test
