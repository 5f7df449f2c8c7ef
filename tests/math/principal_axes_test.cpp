#include "rigor/math/principal_axes.hpp"

#include "rigor/math/rotation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace rigor::principal_axes_test {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon() / 2;

Mat3 tensor(const Vec3& moments, const Vec3& turn) {
  const Mat3 R = rotation_matrix(rotation_exp(turn));
  const Mat3 I = R * moments.asDiagonal() * R.transpose();
  return 0.5 * (I + I.transpose());
}

void expect_frame_of(const PrincipalAxes& axes, const Mat3& inertia) {
  // A few roundings of a sum of three products each.
  const Mat3 back = axes.R * axes.moments.asDiagonal() * axes.R.transpose();
  EXPECT_LE((back - inertia).norm(), 32 * kEpsilon * inertia.norm());
  EXPECT_LE((axes.R.transpose() * axes.R - Mat3::Identity()).norm(), 8 * kEpsilon);
  EXPECT_NEAR(axes.R.determinant(), 1, 8 * kEpsilon);
}

TEST(PrincipalAxes, KeepTheAxesOfADiagonalTensorInItsOrder) {
  const Mat3 inertia = Vec3(3, 1, 2).asDiagonal();
  const PrincipalAxes axes = principal_axes(inertia);
  EXPECT_EQ(axes.R, Mat3::Identity());
  EXPECT_EQ(axes.moments, Vec3(3, 1, 2));
}

TEST(PrincipalAxes, KeepTheAxesWhenTheProductsAreRoundingNoise) {
  Mat3 inertia = Vec3(2, 2, 2).asDiagonal();
  inertia(0, 1) = inertia(1, 0) = 16 * kEpsilon * inertia.norm();
  EXPECT_EQ(principal_axes(inertia).R, Mat3::Identity());
  inertia(0, 1) = inertia(1, 0) = 20 * kEpsilon * inertia.norm();
  EXPECT_NE(principal_axes(inertia).R, Mat3::Identity());
}

TEST(PrincipalAxes, DiagonaliseAnyTensorWithARightHandedFrame) {
  const std::vector<Vec3> turns = {{0.3, 0, 0},  {0, -1.2, 0}, {0.1, 0.2, 3},
                                   {1e-9, 0, 0}, {1, 1, 1},    {-2, 0.5, 1}};
  const std::vector<Vec3> moments = {{1, 2, 3}, {3, 2, 1},    {1, 1, 2}, {2, 1, 1},
                                     {1, 1, 1}, {1e-6, 1, 1}, {0, 1, 1}};
  for (const Vec3& turn : turns) {
    for (const Vec3& m : moments) expect_frame_of(principal_axes(tensor(m, turn)), tensor(m, turn));
  }
}

TEST(PrincipalAxes, StayNearTheGivenAxes) {
  // A tensor that is turned a little must not change the order or the direction of the axes.
  const Vec3 turn(0.05, -0.1, 0.15);
  const PrincipalAxes axes = principal_axes(tensor({3, 1, 2}, turn));
  EXPECT_LE((axes.R - rotation_matrix(rotation_exp(turn))).norm(), 1e-14);
  EXPECT_LE((axes.moments - Vec3(3, 1, 2)).norm(), 1e-14);
}

TEST(PrincipalAxes, OfATensorWithOneKnownRotation) {
  // [2 1; 1 2] has 3 along (1, 1) and 1 along (1, -1).
  Mat3 inertia;
  inertia << 2, 1, 0, 1, 2, 0, 0, 0, 3;
  const PrincipalAxes axes = principal_axes(inertia);
  EXPECT_NEAR(axes.moments.prod(), 9, 1e-14);
  EXPECT_NEAR(std::abs(axes.R(0, 0)), std::sqrt(0.5), 1e-15);
  EXPECT_EQ(axes.R(2, 2), 1);
}

TEST(PrincipalAxes, ScaleWithPowersOfTwoBitForBit) {
  const Mat3 inertia = tensor({0.3, 1.1, 1.2}, {0.4, 0.5, -0.6});
  const PrincipalAxes axes = principal_axes(inertia);
  for (const double factor : {0x1p-400, 0x1p-7, 0x1p300}) {
    const PrincipalAxes scaled = principal_axes(factor * inertia);
    EXPECT_EQ(scaled.R, axes.R);
    EXPECT_EQ(scaled.moments, Vec3(factor * axes.moments));
  }
}

TEST(PrincipalAxes, OfNothingAreTheGivenAxes) {
  EXPECT_EQ(principal_axes(Mat3::Zero()).R, Mat3::Identity());
  EXPECT_EQ(principal_axes(Mat3::Zero()).moments, Vec3::Zero());
}

}  // namespace
}  // namespace rigor::principal_axes_test
