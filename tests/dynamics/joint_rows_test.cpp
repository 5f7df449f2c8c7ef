#include "rigor/dynamics/joint_rows.hpp"

#include "dynamics/joint_samples.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

namespace rigor::joint_rows_test {
namespace {

using test::Random;
using tests::moved;
using tests::place;
using tests::turned;

constexpr int kSamples = 200;
constexpr double kTurn = 2 * M_PI;

using Curve = std::function<double(double)>;

/// Extrapolates values of a formula whose error is a series in h², at h, h/2 and h/4: the rest is of order
/// h⁶.
double extrapolated(const std::function<double(double)>& formula) {
  constexpr double h = 0.03;
  const double a = formula(h), b = formula(h / 2), c = formula(h / 4);
  const double ab = (4 * b - a) / 3, bc = (4 * c - b) / 3;
  return (16 * bc - ab) / 15;
}
double slope(const Curve& f) {
  return extrapolated([&](double h) { return (f(h) - f(-h)) / (2 * h); });
}
double curvature(const Curve& f) {
  return extrapolated([&](double h) { return ((f(h) - f(0)) + (f(-h) - f(0))) / (h * h); });
}

Vec6 velocities(const BodyMotion& body) {
  Vec6 V;
  V << body.v, body.w;
  return V;
}

/// Two bodies that satisfy the joint, with any velocities.
struct Pair {
  Joint joint;
  BodyMotion A, B;
  std::vector<double> coordinates;
};
Pair random_pair(JointType type, Random& random) {
  Pair pair{
      tests::random_joint(type, random), tests::random_motion(random), tests::random_motion(random), {}};
  const tests::AllowedPose allowed = tests::random_allowed_pose(pair.joint, random);
  place(pair.joint, pair.A, allowed.X_FK, pair.B);
  pair.coordinates = allowed.coordinates;
  return pair;
}
/// The same with B shifted and turned away by parts of a metre and of a radian.
Pair disturbed(Pair pair, Random& random) {
  pair.B.x += 0.05 * random.vector();
  pair.B.R = turned(0.4 * random.vector()) * pair.B.R;
  return pair;
}

class JointTypes : public testing::TestWithParam<JointType> {};
INSTANTIATE_TEST_SUITE_P(All, JointTypes, testing::ValuesIn(tests::kTypesWithRows));

int expected_rows(JointType type) {
  switch (type) {
    case JointType::fixed:
      return 6;
    case JointType::ball:
    case JointType::planar:
      return 3;
    case JointType::universal:
    case JointType::cylindrical:
      return 4;
    case JointType::distance:
      return 1;
    case JointType::point_on_line:
      return 2;
    default:
      return 5;  // hinge, slider, screw
  }
}

MatX both_sides(const JointRows& rows) {
  MatX J(rows.size, 12);
  J << rows.J[0].topRows(rows.size), rows.J[1].topRows(rows.size);
  return J;
}

TEST_P(JointTypes, RowsAreZeroWhereTheJointHoldsAndLeaveTheRightNumberOfFreedoms) {
  Random random(1);
  for (int sample = 0; sample < kSamples; ++sample) {
    const Pair pair = random_pair(GetParam(), random);
    const JointRows rows = joint_rows(pair.joint, pair.A, pair.B);
    ASSERT_EQ(rows.size, expected_rows(GetParam()));
    ASSERT_EQ(rows.side_count, 2);
    EXPECT_EQ(rows.bodies[0], 0);
    EXPECT_EQ(rows.bodies[1], 1);
    // Rounding of coordinates of a few metres.
    EXPECT_LE(rows.g.head(rows.size).norm(), 1e-14);
    // 12 velocities less 6 of both bodies together, less the rows.
    EXPECT_EQ(both_sides(rows).colPivHouseholderQr().rank(), rows.size);
  }
}

TEST_P(JointTypes, RowsOfBodiesWhoseFramesAreOneAreExactlyZero) {
  Random random(2);
  Joint joint = tests::random_joint(GetParam(), random);
  joint.X_BK = joint.X_AF;
  joint.length = 0;
  const BodyMotion body = tests::random_motion(random);
  EXPECT_TRUE(joint_rows(joint, body, body).g.isZero(0));
}

TEST_P(JointTypes, RatesAndSecondDerivativesAreThoseOfTheResidual) {
  Random random(3);
  for (int sample = 0; sample < kSamples; ++sample) {
    Pair pair = random_pair(GetParam(), random);
    if (sample % 2 == 1) pair = disturbed(pair, random);
    const JointRows rows = joint_rows(pair.joint, pair.A, pair.B);
    for (int row = 0; row < rows.size; ++row) {
      const bool has_turns = GetParam() == JointType::screw && row == 4;
      const Curve change = [&](double t) {
        const double value = joint_rows(pair.joint, moved(pair.A, t), moved(pair.B, t)).g[row] - rows.g[row];
        return has_turns ? std::remainder(value, pair.joint.parameter) : value;
      };
      const double rate =
          rows.J[0].row(row).dot(velocities(pair.A)) + rows.J[1].row(row).dot(velocities(pair.B));
      EXPECT_NEAR(rate, slope(change), 1e-9) << row;
      EXPECT_NEAR(rows.bias[row], curvature(change), 1e-9 * (1 + rows.bias[row] * rows.bias[row])) << row;
    }
  }
}

TEST_P(JointTypes, WrenchesOfEveryRowAndCoordinateAreActionAndReaction) {
  Random random(4);
  for (int sample = 0; sample < kSamples; ++sample) {
    const Pair pair = disturbed(random_pair(GetParam(), random), random);
    std::vector<std::pair<Vec6, Vec6>> wrenches;
    const JointRows rows = joint_rows(pair.joint, pair.A, pair.B);
    for (int row = 0; row < rows.size; ++row) wrenches.emplace_back(rows.J[0].row(row), rows.J[1].row(row));
    for (int k = 0; k < coordinate_count(GetParam()); ++k) {
      const JointCoordinate coordinate = joint_coordinate(pair.joint, k, pair.A, pair.B);
      wrenches.emplace_back(coordinate.J_A, coordinate.J_B);
    }
    for (const auto& [on_A, on_B] : wrenches) {
      EXPECT_LE((on_A.head<3>() + on_B.head<3>()).norm(), 1e-14);
      const Vec3 moment =
          on_A.tail<3>() + pair.A.x.cross(on_A.head<3>()) + on_B.tail<3>() + pair.B.x.cross(on_B.head<3>());
      EXPECT_LE(moment.norm(), 1e-13);
    }
  }
}

TEST_P(JointTypes, CoordinatesSayHowTheFrameWasMoved) {
  Random random(5);
  for (int sample = 0; sample < kSamples; ++sample) {
    const Pair pair = random_pair(GetParam(), random);
    ASSERT_EQ(static_cast<int>(pair.coordinates.size()), coordinate_count(GetParam()));
    for (int k = 0; k < coordinate_count(GetParam()); ++k) {
      const double found = joint_coordinate(pair.joint, k, pair.A, pair.B).value;
      EXPECT_NEAR(found, pair.coordinates[static_cast<std::size_t>(k)], 1e-14) << k;
    }
  }
}

TEST_P(JointTypes, RatesAndSecondDerivativesOfCoordinatesAreTheirs) {
  Random random(6);
  for (int sample = 0; sample < kSamples; ++sample) {
    Pair pair = random_pair(GetParam(), random);
    if (sample % 2 == 1) pair = disturbed(pair, random);
    for (int k = 0; k < coordinate_count(GetParam()); ++k) {
      const JointCoordinate now = joint_coordinate(pair.joint, k, pair.A, pair.B);
      const Curve change = [&](double t) {
        const double value =
            joint_coordinate(pair.joint, k, moved(pair.A, t), moved(pair.B, t)).value - now.value;
        return is_angle(GetParam(), k) ? std::remainder(value, kTurn) : value;
      };
      const double rate = now.J_A.dot(velocities(pair.A)) + now.J_B.dot(velocities(pair.B));
      EXPECT_NEAR(now.rate, rate, 1e-13) << k;
      EXPECT_NEAR(rate, slope(change), 1e-9 * (1 + now.bias * now.bias)) << k;
      EXPECT_NEAR(now.bias, curvature(change), 1e-9 * (1 + now.bias * now.bias)) << k;
    }
  }
}

/// Newton's method on the rows, moving B by the smallest steps.
void solve_for_B(const Joint& joint, const BodyMotion& A, BodyMotion& B) {
  for (int iteration = 0; iteration < 12; ++iteration) {
    const JointRows rows = joint_rows(joint, A, B);
    const MatX J = rows.J[static_cast<std::size_t>(rows.side_count - 1)].topRows(rows.size);
    const Vec6 step = -J.completeOrthogonalDecomposition().solve(VecX(rows.g.head(rows.size)));
    B.x += step.head<3>();
    B.R = turned(step.tail<3>()) * B.R;
  }
}

TEST_P(JointTypes, NewtonsMethodOnTheRowsEndsOnTheRightBranch) {
  Random random(7);
  for (int sample = 0; sample < kSamples; ++sample) {
    Pair pair = random_pair(GetParam(), random);
    // Any orientation, among them half turns.
    const Vec3 half_turn = M_PI * random.vector().normalized(), any = 3 * random.vector();
    const Vec3 turn = sample % 4 == 0 ? half_turn : any;
    pair.B.R = turned(turn) * pair.B.R;
    pair.B.x += 0.05 * random.vector();
    solve_for_B(pair.joint, pair.A, pair.B);
    EXPECT_LE(joint_rows(pair.joint, pair.A, pair.B).g.norm(), 1e-12);
    const Mat3 R_FK = (pair.A.R * pair.joint.X_AF.R).transpose() * pair.B.R * pair.joint.X_BK.R;
    const JointType type = GetParam();
    if (type == JointType::fixed || type == JointType::slider) {
      EXPECT_LE((R_FK - Mat3::Identity()).norm(), 1e-11);
    } else if (joint_traits(type).held_rotation == LockedRotation::swing) {
      EXPECT_NEAR(R_FK(2, 2), 1, 1e-11);
    }
  }
}

TEST(JointRows, AnAxisTurnedOverIsFarFromSatisfied) {
  for (const JointType type :
       {JointType::fixed, JointType::slider, JointType::hinge, JointType::planar, JointType::screw}) {
    for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0.6, 0.8, 0)}) {
      Joint joint;
      joint.type = type;
      joint.body_A = world_body;
      joint.axes.resize(1);
      BodyMotion B;
      // A matrix turned by exactly π about an axis in the plane z = 0: 2 a aᵀ - 1.
      B.R = 2 * axis * axis.transpose() - Mat3::Identity();
      const JointRows rows = joint_rows(joint, BodyMotion{}, B);
      EXPECT_NEAR(rows.g.norm(), 4, 1e-14) << testing::PrintToString(type);
      EXPECT_EQ(MatX(rows.J[0].topRows(rows.size)).colPivHouseholderQr().rank(), rows.size);
      solve_for_B(joint, BodyMotion{}, B);
      EXPECT_LE(joint_rows(joint, BodyMotion{}, B).g.norm(), 1e-14);
      EXPECT_NEAR(B.R(2, 2), 1, 1e-14);
    }
  }
}

TEST(JointRows, TheWorldHasNoSide) {
  Random random(8);
  for (const bool world_is_A : {true, false}) {
    Joint joint = tests::random_joint(JointType::hinge, random);
    (world_is_A ? joint.body_A : joint.body_B) = world_body;
    const JointRows rows = joint_rows(joint, BodyMotion{}, BodyMotion{});
    EXPECT_EQ(rows.side_count, 1);
    EXPECT_EQ(rows.bodies[0], world_is_A ? 1 : 0);
  }
}

TEST(JointRows, ADistanceJointWithLimitsHasNone) {
  Random random(9);
  Joint joint = tests::random_joint(JointType::distance, random);
  joint.axes[0].upper = 2;
  EXPECT_EQ(joint_rows(joint, BodyMotion{}, BodyMotion{}).size, 0);
}

TEST(JointRows, MultipliersOfAHingeAreTheForceAndTheTorqueOnB) {
  Joint joint;
  joint.type = JointType::hinge;
  joint.body_A = world_body;
  joint.X_BK.p = Vec3(0, 2, 0);
  const BodyMotion B{Vec3(0, -2, 0), Mat3::Identity(), Vec3::Zero(), Vec3::Zero()};
  const JointRows rows = joint_rows(joint, BodyMotion{}, B);
  Vec6 lambda = Vec6::Zero();
  lambda.head<5>() << 1, 2, 3, 4, 5;
  const Vec6 wrench = rows.J[0].transpose() * lambda;
  EXPECT_LE((wrench.head<3>() - Vec3(1, 2, 3)).norm(), 1e-15);
  // Torque (4, 5, 0) and the moment (0, 2, 0) × (1, 2, 3) of the force.
  EXPECT_LE((wrench.tail<3>() - Vec3(4 + 6, 5, -2)).norm(), 1e-14);
}

TEST(JointCoordinate, AngleOfAHingeIsRightAllTheWayRound) {
  Joint joint;
  joint.type = JointType::hinge;
  for (int degrees = -179; degrees <= 180; ++degrees) {
    BodyMotion B;
    const double angle = degrees * M_PI / 180;
    B.R = turned(angle * Vec3::UnitZ());
    B.w = Vec3(0, 0, 3);
    const JointCoordinate coordinate = joint_coordinate(joint, 0, BodyMotion{}, B);
    EXPECT_NEAR(std::remainder(coordinate.value - angle, kTurn), 0, 1e-15);
    EXPECT_LE(std::abs(coordinate.value), M_PI);
    EXPECT_NEAR(coordinate.rate, 3, 1e-15);
  }
}

TEST(JointCoordinate, AngleOfABallNearZeroAndNearAHalfTurn) {
  Joint joint;
  joint.type = JointType::ball;
  const Vec3 axis = Vec3(1, -2, 2) / 3;
  for (const double angle : {1e-12, 1e-8, 1e-4, M_PI - 1e-4, M_PI - 1e-8}) {
    BodyMotion B;
    B.R = turned(angle * axis);
    B.w = Vec3(0, 0, 3);
    const JointCoordinate coordinate = joint_coordinate(joint, 0, BodyMotion{}, B);
    EXPECT_NEAR(coordinate.value, angle, 1e-15 * (1 + angle));
    // Rounding of 1e-16 in the matrix turns the axis by 1e-16/sin θ.
    EXPECT_NEAR(coordinate.rate, 2, 3e-16 / std::sin(angle) + 1e-14);
  }
  // At zero every rotation makes the angle larger; without any the axis is z.
  BodyMotion B;
  B.w = Vec3(0, 3, -4);
  const JointCoordinate start = joint_coordinate(joint, 0, BodyMotion{}, B);
  EXPECT_EQ(start.value, 0);
  EXPECT_DOUBLE_EQ(start.rate, 5);
  const JointCoordinate still = joint_coordinate(joint, 0, BodyMotion{}, BodyMotion{});
  EXPECT_EQ(still.rate, 0);
  EXPECT_EQ(Vec3(still.J_B.tail<3>()), Vec3(0, 0, 1));
}

TEST(JointCoordinate, DistanceOfPointsThatMeetHasTheDirectionOfTheirMotion) {
  Joint joint;
  joint.type = JointType::distance;
  BodyMotion B;
  B.v = Vec3(0, -2, 0);
  const JointCoordinate coordinate = joint_coordinate(joint, 0, BodyMotion{}, B);
  EXPECT_EQ(coordinate.value, 0);
  EXPECT_EQ(coordinate.rate, 2);
  EXPECT_TRUE(std::isfinite(coordinate.bias));
}

}  // namespace
}  // namespace rigor::joint_rows_test
