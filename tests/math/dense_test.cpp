#include "rigor/math/dense.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace rigor::dense_test {
namespace {

// Rounding of a few dozen operations on numbers near one, the condition numbers here being below ten.
constexpr double kRounding = 64 * std::numeric_limits<double>::epsilon();

TEST(Dense, TheLeastNormSolutionSharesWhatEqualUnknownsCarry) {
  // x1 + x2 = 1 and x1 + x2 = 3: least squares ask for the sum 2, the least norm for halves.
  const VecX x = least_norm_solution(MatX::Ones(2, 2), Vec2(1, 3));
  EXPECT_LE((x - Vec2(1, 1)).norm(), kRounding);
  const MatX X = least_norm_solutions(MatX::Ones(2, 2), MatX{{1, 4}, {3, 0}});
  EXPECT_LE((X - MatX::Ones(2, 2)).norm(), kRounding);
}

TEST(Dense, WhatThePivotsToleranceLeavesOutCountsAsZero) {
  const MatX A = Vec2(1, 1e-6).asDiagonal();
  EXPECT_LE((least_norm_solution(A, Vec2(1, 1)) - Vec2(1, 1e6)).norm(), 1e6 * kRounding);
  EXPECT_LE((least_norm_solution(A, Vec2(1, 1), 1e-5) - Vec2(1, 0)).norm(), kRounding);
}

TEST(Dense, SolutionsOfAnIndefiniteMatrixAreThoseOfItsInverse) {
  Mat3 A;
  A << 1, 2, 0, 2, 1, 0, 0, 0, -4;
  const Vec3 x(1, -2, 3), b = A * x;
  EXPECT_LE((symmetric_solution(A, b) - x).norm(), kRounding);
  EXPECT_LE((refined_symmetric_solution(A, b) - x).norm(), kRounding);
  EXPECT_LE((symmetric_solution(MatX(A), VecX(b)) - x).norm(), kRounding);
}

TEST(Dense, TheLeastPivotHasTheSignOfTheLeastEigenvalue) {
  EXPECT_EQ(least_symmetric_pivot(Vec3(3, 1, 2).asDiagonal()), 1);
  EXPECT_EQ(least_symmetric_pivot(Vec3(3, -1, 2).asDiagonal()), -1);
  // Of rank one: rounding of the largest pivot.
  EXPECT_LE(std::abs(least_symmetric_pivot(Mat3::Ones())), kRounding);
}

TEST(Dense, ASquareMatrixNeedsNoSymmetry) {
  MatX A(2, 2);
  A << 0, 2, 1, 1;
  EXPECT_LE((square_solution(A, Vec2(4, 5)) - Vec2(3, 2)).norm(), kRounding);
}

TEST(Dense, TheFactorOfCholeskyIsLowerAndMakesTheMatrix) {
  Mat3 A;
  A << 4, 2, 0, 2, 5, 2, 0, 2, 10;
  Mat3 L;
  L << 2, 0, 0, 1, 2, 0, 0, 1, 3;
  EXPECT_LE((cholesky_factor(A) - L).norm(), kRounding);
  const Mat6 six = Vec6(1, 4, 9, 16, 25, 36).asDiagonal();
  EXPECT_EQ(cholesky_factor(six), Mat6(Vec6(1, 2, 3, 4, 5, 6).asDiagonal()));
  const Vec3 x(1, 2, 3);
  EXPECT_LE((positive_definite_solution(A, A * x) - x).norm(), kRounding);
  EXPECT_LE((positive_definite_solution(MatX(A), A * x) - x).norm(), kRounding);
}

TEST(Dense, AMatrixWithANegativeEigenvalueIsNotPositiveDefinite) {
  EXPECT_TRUE(is_positive_definite(Vec3(1, 2, 3).asDiagonal()));
  EXPECT_FALSE(is_positive_definite(Vec3(1, -1e-3, 3).asDiagonal()));
}

TEST(Dense, EigenvaluesOfASymmetricMatrixAscend) {
  Mat3 A;
  A << 2, 1, 0, 1, 2, 0, 0, 0, -5;
  EXPECT_LE((symmetric_eigenvalues(A) - Vec3(-5, 1, 3)).norm(), 8 * kRounding);
}

}  // namespace
}  // namespace rigor::dense_test
