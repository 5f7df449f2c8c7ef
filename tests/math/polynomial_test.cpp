#include "rigor/math/polynomial.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace rigor::polynomial_test {
namespace {

constexpr double kEpsilon = 0x1p-52;

Polynomial from_roots(const std::vector<double>& roots) {
  Polynomial p{1};
  for (const double root : roots) p = p * Polynomial{-root, 1};
  return p;
}

TEST(Polynomial, AlgebraAgreesWithValues) {
  const Polynomial p{1, -2, 3}, q{0.5, 4};
  for (const double x : {-1.5, 0.0, 0.75}) {
    EXPECT_EQ(p(x), 1 - 2 * x + 3 * x * x);
    EXPECT_EQ((p + q)(x), p(x) + q(x));
    EXPECT_EQ((p - q)(x), p(x) - q(x));
    EXPECT_EQ((p * q)(x), p(x) * q(x));
    EXPECT_EQ(p.derivative()(x), -2 + 6 * x);
  }
  EXPECT_EQ((Polynomial{7}).derivative()(3), 0);
}

TEST(Polynomial, BernsteinFormTakesTheEndValuesAndBoundsEverythingBetween) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int trial = 0; trial < 200; ++trial) {
    Polynomial p;
    p.degree = 1 + trial % 8;
    for (int k = 0; k <= p.degree; ++k) p.c[k] = uniform(random);
    const double a = 2 * uniform(random), b = a + std::abs(uniform(random));
    const BernsteinForm form = bernstein_form(p, a, b);
    EXPECT_NEAR(form.b[0], p(a), form.rounding);
    EXPECT_NEAR(form.b[p.degree], p(b), form.rounding);
    const Bounds bounds = polynomial_bounds(p, a, b);
    for (int i = 0; i <= 50; ++i) {
      const double value = p(a + (b - a) * i / 50);
      EXPECT_GE(value, bounds.min);
      EXPECT_LE(value, bounds.max);
    }
  }
}

TEST(Polynomial, BoundsAreSharpToSecondOrder) {
  // Each halving of the interval cuts the excess over the true range of x² - x³ about its middle by four.
  const Polynomial p{0, 0, 1, -1};
  double previous = 0;
  for (const double width : {0.1, 0.05, 0.025, 0.0125}) {
    const double a = 2.0 / 3 - width / 2, b = 2.0 / 3 + width / 2;  // maximum 4/27 inside
    const double excess = polynomial_bounds(p, a, b).max - 4.0 / 27;
    EXPECT_GE(excess, 0);
    if (previous > 0) {
      EXPECT_NEAR(previous / excess, 4, 0.3);
    }
    previous = excess;
  }
}

TEST(Polynomial, QuadraticRootsDoNotCancel) {
  // x² - (10⁸ + 10⁻⁸) x + 1 = (x - 10⁸)(x - 10⁻⁸).
  const QuadraticRoots far = find_quadratic_roots(1, -(1e8 + 1e-8), 1);
  ASSERT_EQ(far.count, 2);
  EXPECT_NEAR(far.x[0], 1e-8, 4 * kEpsilon * 1e-8);
  EXPECT_NEAR(far.x[1], 1e8, 4 * kEpsilon * 1e8);
  // Roots closer than √ε: 1 and 1 + 2⁻²⁵; all coefficients are exact.
  const double d = std::ldexp(1, -25);
  const QuadraticRoots near = find_quadratic_roots(1, -(2 + d), 1 + d);
  ASSERT_EQ(near.count, 2);
  EXPECT_EQ(near.x[0], 1);
  EXPECT_EQ(near.x[1], 1 + d);
}

TEST(Polynomial, QuadraticRootsCoverTheDegenerateCases) {
  EXPECT_EQ(find_quadratic_roots(1, 0, 1).count, 0);
  EXPECT_EQ(find_quadratic_roots(0, 0, 1).count, 0);
  EXPECT_EQ(find_quadratic_roots(0, 0, 0).count, 0);
  const QuadraticRoots line = find_quadratic_roots(0, 2, -6);
  ASSERT_EQ(line.count, 1);
  EXPECT_EQ(line.x[0], 3);
  const QuadraticRoots twice = find_quadratic_roots(4, -4, 1);
  ASSERT_EQ(twice.count, 1);
  EXPECT_EQ(twice.x[0], 0.5);
  const QuadraticRoots zero = find_quadratic_roots(1, -3, 0);
  ASSERT_EQ(zero.count, 2);
  EXPECT_EQ(zero.x[0], 0);
  EXPECT_EQ(zero.x[1], 3);
  // Far from the range of squares.
  const QuadraticRoots huge = find_quadratic_roots(1e200, -3e200, 2e200);
  ASSERT_EQ(huge.count, 2);
  EXPECT_NEAR(huge.x[0], 1, 2 * kEpsilon);
  EXPECT_NEAR(huge.x[1], 2, 4 * kEpsilon);
}

TEST(Polynomial, SmallestRootIsTheFirstInTheInterval) {
  const Polynomial p = from_roots({-0.5, 0.25, 0.75, 2, 3, 5});
  EXPECT_NEAR(find_smallest_root(p, -1, 4).value(), -0.5, 1e-14);
  EXPECT_NEAR(find_smallest_root(p, 0, 4).value(), 0.25, 1e-14);
  EXPECT_NEAR(find_smallest_root(p, 0.3, 4).value(), 0.75, 1e-14);
  EXPECT_NEAR(find_smallest_root(p, 0.8, 2.5).value(), 2, 1e-13);
  EXPECT_FALSE(find_smallest_root(p, 0.3, 0.7).has_value());
  EXPECT_FALSE(find_smallest_root(p, 5.1, 9).has_value());
  EXPECT_EQ(find_smallest_root(p, 0.75, 4).value(), 0.75);
}

TEST(Polynomial, SmallestRootIsFoundForRandomRoots) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<double> roots(2 + static_cast<std::size_t>(trial % 5));
    for (double& root : roots) root = uniform(random);
    std::sort(roots.begin(), roots.end());
    const Polynomial p = from_roots(roots);
    const std::optional<double> found = find_smallest_root(p, -0.1, 1.1);
    ASSERT_TRUE(found.has_value());
    // Conditioning: rounding of the coefficients over the slope at the root.
    const double slope = std::abs(p.derivative()(roots[0]));
    EXPECT_NEAR(*found, roots[0], std::max(1e-15, 100 * kEpsilon / slope)) << trial;
  }
}

TEST(Polynomial, TouchingRootIsFoundAndANearMissIsNot) {
  const Polynomial touching = from_roots({0.375, 0.375, 2});
  EXPECT_NEAR(find_smallest_root(touching, 0, 1).value(), 0.375, 1e-7);
  const Polynomial miss = touching - Polynomial{1e-9};
  EXPECT_FALSE(find_smallest_root(miss, 0, 1).has_value());
  // A root of order four: flat over a width of ε^(1/4).
  EXPECT_NEAR(find_smallest_root(from_roots({0.3, 0.3, 0.3, 0.3}), -1, 1).value(), 0.3, 1e-3);
  EXPECT_EQ(find_smallest_root(Polynomial{0}, 0.2, 1).value(), 0.2);
  EXPECT_FALSE(find_smallest_root(Polynomial{1}, 0.2, 1).has_value());
}

TEST(Polynomial, RootAtTheRightEndCounts) {
  EXPECT_NEAR(find_smallest_root(Polynomial{-1, 0, 1}, 0, 1).value(), 1, 2 * kEpsilon);
}

TEST(Polynomial, ScalingByAPowerOfTwoScalesTheRootExactly) {
  const Polynomial p{-1, 0.3, 2, -0.5, 1};
  Polynomial scaled = p;
  for (int k = 0; k <= 4; ++k) scaled.c[k] = std::ldexp(p.c[k], 30 - 10 * k);
  EXPECT_EQ(find_smallest_root(scaled, 0, 1024.0).value(),
            std::ldexp(find_smallest_root(p, 0, 1).value(), 10));
}

}  // namespace
}  // namespace rigor::polynomial_test
