#include "rigor/solver/rosenbrock.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rigor::rosenbrock_test {
namespace {

VecX vector_of(double a, double b) {
  VecX y(2);
  y << a, b;
  return y;
}

/// A pendulum driven in time: ẏ₁ = y₂, ẏ₂ = -sin y₁ + cos t.
VecX driven(double t, const VecX& y) {
  return vector_of(y[1], -std::sin(y[0]) + std::cos(t));
}

VecX pendulum_after(double end, int steps, double* middle_error = nullptr) {
  VecX y = vector_of(0.3, 0);
  const double h = end / steps;
  for (int k = 0; k < steps; ++k) {
    const double t = k * h;
    MatX J(2, 2);
    J << 0, 1, -std::cos(y[0]), 0;
    const RungeKuttaStep step = rodas_step(driven, J, vector_of(0, -std::sin(t)), t, y, h);
    if (middle_error) {
      const RungeKuttaStep half = rodas_step(driven, J, vector_of(0, -std::sin(t)), t, y, h / 2);
      *middle_error = (step.at(0.5) - half.end).norm();
    }
    y = step.end;
  }
  return y;
}

TEST(Rosenbrock, IsOfOrderFourAlsoInTime) {
  const VecX exact = pendulum_after(2, 2000);
  const double coarse = (pendulum_after(2, 20) - exact).norm(), fine = (pendulum_after(2, 40) - exact).norm();
  EXPECT_GT(coarse, 12 * fine);
  EXPECT_LT(fine, 1e-7);
}

TEST(Rosenbrock, HasACubicInBetweenAndMeetsBothEnds) {
  double coarse = 0, fine = 0;
  pendulum_after(0.2, 1, &coarse);
  pendulum_after(0.1, 1, &fine);
  // Order 3: local error h⁴.
  EXPECT_GT(coarse, 10 * fine);
  MatX J(2, 2);
  J << 0, 1, -std::cos(0.3), 0;
  const RungeKuttaStep step = rodas_step(driven, J, vector_of(0, 0), 0, vector_of(0.3, 0), 0.1);
  EXPECT_EQ(step.at(0), vector_of(0.3, 0));
  EXPECT_LE((step.at(1) - step.end).norm(), 1e-15);
}

TEST(Rosenbrock, StiffDecayHasDecayedAtTheEndOfTheStep) {
  // ẏ = -k (y - cos t) for k h up to 1e13: y follows (k² cos t + k sin t)/(k² + 1).
  for (const double k : {1e3, 1e8, 1e15}) {
    const auto f = [k](double t, const VecX& y) { return VecX::Constant(1, -k * (y[0] - std::cos(t))); };
    const MatX J = MatX::Constant(1, 1, -k);
    VecX y = VecX::Constant(1, 5.0);
    const double h = 0.01;
    for (int step = 0; step < 10; ++step) {
      const double t = step * h;
      y = rodas_step(f, J, VecX::Constant(1, -k * std::sin(t)), t, y, h).end;
    }
    EXPECT_NEAR(y[0], (std::cos(0.1) + std::sin(0.1) / k) / (1 + 1 / (k * k)), 1e-7) << k;
  }
}

}  // namespace
}  // namespace rigor::rosenbrock_test
