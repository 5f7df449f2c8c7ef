#include "rigor/solver/runge_kutta.hpp"

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace rigor {
namespace {

struct Method {
  std::string name;
  ButcherTableau tableau;
  int dense_order;
};

std::vector<Method> methods() {
  return {{"euler", explicit_euler_tableau(), 1},
          {"midpoint", midpoint_tableau(), 2},
          {"rk4", rk4_tableau(), 3},
          {"dopri5", dopri5_tableau(), 4}};
}

/// y₁' = t y₂, y₂' = -t y₁: the solution is (sin t²/2, cos t²/2) from (0, 1).
VecX clock(double t, const VecX& y) {
  return Vec2(t * y[1], -t * y[0]);
}
VecX clock_solution(double t) {
  return Vec2(std::sin(0.5 * t * t), std::cos(0.5 * t * t));
}

double clock_error(const ButcherTableau& tableau, int steps) {
  VecX y = clock_solution(0);
  const double h = 2.0 / steps;
  for (int i = 0; i < steps; ++i) y = runge_kutta_step(tableau, clock, i * h, y, h).end;
  return (y - clock_solution(2)).norm();
}

TEST(RungeKutta, TableausAreConsistent) {
  for (const Method& method : methods()) {
    const ButcherTableau& T = method.tableau;
    double sum_b = 0, sum_error = 0;
    for (int i = 0; i < T.stages; ++i) {
      double sum_a = 0;
      for (int j = 0; j < i; ++j) sum_a += T.a[i][j];
      EXPECT_NEAR(sum_a, T.c[i], 4e-15) << method.name;
      double dense_at_one = 0;
      for (int m = 0; m <= T.dense_degree; ++m) dense_at_one += T.dense[i][m];
      EXPECT_NEAR(dense_at_one, T.b[i], 1e-14) << method.name;
      sum_b += T.b[i];
      sum_error += T.error[i];
    }
    EXPECT_NEAR(sum_b, 1, 1e-15) << method.name;
    EXPECT_NEAR(sum_error, 0, 1e-15) << method.name;
  }
}

TEST(RungeKutta, ObservedOrderIsTheOrderOfTheMethod) {
  for (const Method& method : methods()) {
    const double order = std::log2(clock_error(method.tableau, 64) / clock_error(method.tableau, 128));
    EXPECT_NEAR(order, method.tableau.order, 0.1) << method.name;
  }
}

TEST(RungeKutta, DenseOutputMeetsBothEndsAndHasItsOrderBetween) {
  for (const Method& method : methods()) {
    const auto error = [&](double h, double theta) {
      const RungeKuttaStep step = runge_kutta_step(method.tableau, clock, 1, clock_solution(1), h);
      EXPECT_LE((step.at(0) - clock_solution(1)).norm(), 0) << method.name;
      EXPECT_LE((step.at(1) - step.end).norm(), 1e-15) << method.name;
      return (step.at(theta) - clock_solution(1 + theta * h)).norm();
    };
    for (const double theta : {0.2, 0.45, 0.9}) {
      // A local error of order p + 1; the next term disturbs by a few per cent of an order.
      EXPECT_GE(std::log2(error(0.04, theta) / error(0.02, theta)), method.dense_order + 1 - 0.15)
          << method.name;
    }
  }
}

TEST(RungeKutta, EmbeddedErrorIsOfOrderFive) {
  const auto error = [](double h) {
    return runge_kutta_step(dopri5_tableau(), clock, 1, clock_solution(1), h).error.norm();
  };
  EXPECT_NEAR(std::log2(error(0.04) / error(0.02)), 5, 0.2);
  EXPECT_EQ(runge_kutta_step(rk4_tableau(), clock, 0, clock_solution(0), 0.1).error.size(), 0);
}

TEST(RungeKutta, PolynomialsInTimeUpToTheOrderAreExact) {
  for (const Method& method : methods()) {
    const int p = method.tableau.order;
    const auto f = [p](double t, const VecX&) { return VecX::Constant(1, p * std::pow(t, p - 1)); };
    const double end = runge_kutta_step(method.tableau, f, 1, VecX::Constant(1, 1.0), 0.5).end[0];
    EXPECT_NEAR(end, std::pow(1.5, p), 8e-15) << method.name;
  }
}

}  // namespace
}  // namespace rigor
