#include "rigor/math/rotation.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

namespace rigor::rotation_test {
namespace {

constexpr double kEpsilon = 0x1p-52;

Quat random_quaternion(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  return Quat(normal(random), normal(random), normal(random), normal(random));
}

TEST(Rotation, MatrixIsOrthonormalForAnyLengthOfTheQuaternion) {
  std::mt19937_64 random(1);
  for (int trial = 0; trial < 100; ++trial) {
    Quat q = random_quaternion(random);
    q.coeffs() *= std::pow(10.0, trial % 7 - 3);
    const Mat3 R = rotation_matrix(q);
    EXPECT_LE((R.transpose() * R - Mat3::Identity()).norm(), 8 * kEpsilon);
    EXPECT_NEAR(R.determinant(), 1, 8 * kEpsilon);
    EXPECT_LE((R - q.normalized().toRotationMatrix()).norm(), 16 * kEpsilon);
  }
}

TEST(Rotation, ProductOfQuaternionsIsTheProductOfMatrices) {
  std::mt19937_64 random(2);
  const Quat p = random_quaternion(random), q = random_quaternion(random);
  EXPECT_LE((rotation_matrix(p * q) - rotation_matrix(p) * rotation_matrix(q)).norm(), 16 * kEpsilon);
}

TEST(Rotation, ExpTurnsAboutItsAxisByItsLength) {
  // Rodrigues: R = 1 + sin a n~ + (1 - cos a) n~².
  const Vec3 n = Vec3(1, -2, 2) / 3;
  for (const double angle : {0.0, 1e-12, 9.9e-5, 1.01e-4, 0.3, 2.0, 3.1, 6.0}) {
    const Mat3 N = skew(n);
    const Mat3 expected = Mat3::Identity() + std::sin(angle) * N + (1 - std::cos(angle)) * N * N;
    const Quat q = rotation_exp(angle * n);
    EXPECT_LE((rotation_matrix(q) - expected).norm(), 8 * kEpsilon);
    EXPECT_NEAR(q.norm(), 1, 2 * kEpsilon);
  }
}

TEST(Rotation, LogInvertsExpUpToHalfATurn) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  for (const double angle : {1e-9, 1e-3, 0.5, 2.0, 3.14}) {
    const Vec3 phi = angle * Vec3(normal(random), normal(random), normal(random)).normalized();
    Quat q = rotation_exp(phi);
    // Near half a turn rounding of w moves the angle no more than elsewhere.
    EXPECT_LE((rotation_log(q) - phi).norm(), 8 * kEpsilon * angle + 4 * kEpsilon * (angle > 3 ? 1 : 0));
    q.coeffs() *= -3;
    EXPECT_LE((rotation_log(q) - phi).norm(), 16 * kEpsilon * std::max(angle, 0.1));
  }
  EXPECT_EQ(rotation_log(Quat::Identity()), Vec3::Zero());
}

TEST(Rotation, AngleBetweenSeesSmallAnglesAndIgnoresTheSign) {
  const Quat a = rotation_exp(Vec3(0.3, -1, 0.2));
  for (const double angle : {1e-10, 0.01, 1.0, 3.0}) {
    const Quat b = a * rotation_exp(Vec3(0, angle, 0));
    const Quat minus_b(Vec4(-b.coeffs()));
    EXPECT_NEAR(rotation_angle_between(a, b), angle, 8 * kEpsilon);
    EXPECT_NEAR(rotation_angle_between(a, minus_b), angle, 8 * kEpsilon);
  }
}

TEST(Rotation, QuaternionOfMatrixInvertsAndHasNonNegativeW) {
  std::mt19937_64 random(4);
  for (int trial = 0; trial < 100; ++trial) {
    Quat q = random_quaternion(random).normalized();
    if (trial % 4 == 0) q = Quat(1e-9 * q.w(), q.x(), q.y(), q.z()).normalized();  // near half a turn
    const Quat back = quaternion_of(rotation_matrix(q));
    EXPECT_GE(back.w(), 0);
    EXPECT_LE(rotation_angle_between(q, back), 8 * kEpsilon);
  }
}

TEST(Rotation, GramSchmidtKeepsTheDirectionOfTheFirstColumn) {
  Mat3 R = rotation_matrix(rotation_exp(Vec3(0.4, 0.9, -0.3)));
  EXPECT_LE((gram_schmidt(R) - R).norm(), 8 * kEpsilon);
  R(0, 1) += 0.01;
  R(2, 0) -= 0.02;
  const Mat3 fixed = gram_schmidt(R);
  EXPECT_LE((fixed.transpose() * fixed - Mat3::Identity()).norm(), 8 * kEpsilon);
  EXPECT_NEAR(fixed.determinant(), 1, 8 * kEpsilon);
  EXPECT_LE((fixed.col(0) - R.col(0).normalized()).norm(), kEpsilon);
}

TEST(Rotation, SkewIsTheCrossProduct) {
  const Vec3 a(1, -2, 3), b(0.5, 4, -1);
  EXPECT_EQ(Vec3(skew(a) * b), a.cross(b));
}

TEST(Rotation, FrameWithZIsRightHanded) {
  for (const Vec3& n : {Vec3(0, 0, 1), Vec3(0, 0, -1), Vec3(1, 0, 0), Vec3(Vec3(1, 1, 1).normalized())}) {
    const Mat3 C = frame_with_z(n);
    EXPECT_EQ(C.col(2), n);
    EXPECT_LE((C.transpose() * C - Mat3::Identity()).norm(), 4 * kEpsilon);
    EXPECT_NEAR(C.determinant(), 1, 4 * kEpsilon);
  }
}

}  // namespace
}  // namespace rigor::rotation_test
