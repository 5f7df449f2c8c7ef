#include "rigor/math/roots.hpp"

#include <cmath>
#include <functional>
#include <vector>

#include <gtest/gtest.h>

namespace rigor::roots_test {
namespace {

constexpr double kEpsilon = 0x1p-52;

using Finder = RootBracket (*)(ScalarFunction, double, double, double);
constexpr Finder kFinders[] = {find_root_bisection, find_root_illinois, find_root_itp};

struct Case {
  std::function<double(double)> f;
  double lo, hi, root;
};

std::vector<Case> cases() {
  return {{[](double x) { return x * x - 2; }, 0, 2, std::sqrt(2.0)},
          {[](double x) { return std::cos(x); }, 0, 3, std::acos(0.0)},
          {[](double x) { return std::exp(x) - 1e6; }, -50, 50, std::log(1e6)},
          {[](double x) { return std::pow(x - 1, 9); }, -3, 4.1, 1},
          {[](double x) { return std::cbrt(x - 0.3); }, -1, 2, 0.3},
          {[](double x) { return x < 0.7 ? -1.0 : 5.0; }, 0, 1, 0.7}};
}

TEST(Roots, EveryMethodEndsWithASignChangeNoWiderThanTheTolerance) {
  for (const Finder find : kFinders) {
    for (const Case& c : cases()) {
      for (const double tolerance : {1e-3, 1e-9, 0.0}) {
        const RootBracket bracket = find([&](double x) { return c.f(x); }, c.lo, c.hi, tolerance);
        EXPECT_LE(bracket.width(),
                  std::max(tolerance, 4 * kEpsilon * std::max(std::abs(c.lo), std::abs(c.hi))));
        EXPECT_LE(bracket.f_lo * bracket.f_hi, 0);
        EXPECT_EQ(bracket.f_lo, c.f(bracket.lo));
        EXPECT_EQ(bracket.f_hi, c.f(bracket.hi));
        // The power 9 underflows to an exact zero near its root.
        EXPECT_NEAR(bracket.best(), c.root, std::max(tolerance, 1e-15 * std::max(1.0, std::abs(c.hi))));
      }
    }
  }
}

TEST(Roots, FalsePositionNeedsFewerEvaluationsThanHalvingOnSmoothFunctions) {
  const auto f = [](double x) { return x * x * x - x - 2; };
  const int halving = find_root_bisection(f, 1, 2, 1e-14).iterations;
  EXPECT_EQ(halving, 47);  // 2⁻⁴⁷ ≤ 1e-14
  EXPECT_LE(find_root_illinois(f, 1, 2, 1e-14).iterations, 14);
  EXPECT_LE(find_root_itp(f, 1, 2, 1e-14).iterations, 14);
}

TEST(Roots, ItpIsNeverMoreThanTwoEvaluationsWorseThanHalving) {
  for (const Case& c : cases()) {
    const auto f = [&](double x) { return c.f(x); };
    const int bound = static_cast<int>(std::ceil(std::log2((c.hi - c.lo) / 1e-9))) + 2;
    EXPECT_LE(find_root_itp(f, c.lo, c.hi, 1e-9).iterations, bound);
  }
}

TEST(Roots, IllinoisIsAtMostFourTimesHalving) {
  for (const Case& c : cases()) {
    const auto f = [&](double x) { return c.f(x); };
    const int bound = 4 * static_cast<int>(std::ceil(std::log2((c.hi - c.lo) / 1e-9)));
    EXPECT_LE(find_root_illinois(f, c.lo, c.hi, 1e-9).iterations, bound);
  }
}

TEST(Roots, ZeroAtAnEndNeedsNoEvaluation) {
  for (const Finder find : kFinders) {
    const RootBracket left = find([](double x) { return x; }, 0, 1, 1e-9);
    EXPECT_EQ(left.lo, 0);
    EXPECT_EQ(left.hi, 0);
    const RootBracket right = find([](double x) { return x - 1; }, 0, 1, 1e-9);
    EXPECT_EQ(right.best(), 1);
    EXPECT_EQ(right.iterations, 0);
  }
}

TEST(Roots, ScalingByAPowerOfTwoScalesTheBracketExactly) {
  for (const Finder find : kFinders) {
    const RootBracket one = find([](double x) { return x * x * x - 2; }, 0, 3, 1e-10);
    const RootBracket big = find([](double x) { return std::ldexp(std::pow(std::ldexp(x, -20), 3) - 2, 60); },
                                 0, std::ldexp(3, 20), std::ldexp(1e-10, 20));
    const RootBracket same = find([](double x) { return std::pow(x, 3) - 2; }, 0, 3, 1e-10);
    EXPECT_NEAR(one.lo, same.lo, 1e-10);
    EXPECT_EQ(big.lo, std::ldexp(same.lo, 20));
    EXPECT_EQ(big.hi, std::ldexp(same.hi, 20));
    EXPECT_EQ(big.iterations, same.iterations);
  }
}

}  // namespace
}  // namespace rigor::roots_test
