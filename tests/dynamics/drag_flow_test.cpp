#include "rigor/dynamics/drag_flow.hpp"
#include "rigor/math/rotation.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rigor::drag_flow_test {
namespace {

constexpr double c_linear = 3, m = 2;

TEST(DragFlow, FallsAsTheClosedFormSaysAtAnyRate) {
  for (const double c : {1e-12, 1e-3, 1.0, 40.0, 1e6, 1e15}) {
    const double rate = c / m, h = 0.5, z = rate * h;
    const Vec3 v(3, -1, 2), g(0, 0, -9.81), x(1, 2, 3);
    const BodyPhase end = drag_flow({m, Vec3(1, 2, 3)}, {c, 0, 0}, Wrench{m * g, Vec3::Zero()},
                                    {x, Quat::Identity(), m * v, Vec3::Zero()}, h);
    // v = v∞ + (v₀ - v∞) e^(-γ t), v∞ = g/γ; for small γ by the series in z.
    const Vec3 v_exact = z < 1e-2 ? Vec3(v * (1 - z + z * z / 2) + g * h * (1 - z / 2 + z * z / 6))
                                  : Vec3(g / rate + (v - g / rate) * std::exp(-z));
    const Vec3 x_exact =
        z < 1e-2 ? Vec3(x + v * h * (1 - z / 2 + z * z / 6) + g * h * h * (0.5 - z / 6 + z * z / 24))
                 : Vec3(x + g / rate * h + (v - g / rate) * -std::expm1(-z) / rate);
    const double truncated = z < 1e-2 ? z * z * z : 0;
    EXPECT_LE((end.P / m - v_exact).norm(), 1e-13 * (1 + v_exact.norm()) + 10 * truncated) << c;
    EXPECT_LE((end.x - x_exact).norm(), 1e-13 * (1 + x_exact.norm()) + 10 * truncated) << c;
  }
}

TEST(DragFlow, ASphereSpinsDownAlongItsFreeRotation) {
  // Isotropic: L decays by e^(-λ h), and the angle is ω (1 - e^(-λ h))/λ.
  const double I = 0.4, c = 2, h = 0.7, lambda = c / I;
  const Vec3 w(0.3, -2, 1);
  const BodyPhase end = drag_flow({m, Vec3::Constant(I)}, {0, c, 0}, {},
                                  {Vec3::Zero(), Quat::Identity(), Vec3::Zero(), I * w}, h);
  EXPECT_LE((end.L - I * w * std::exp(-lambda * h)).norm(), 1e-15);
  const Quat exact = rotation_exp(w * -std::expm1(-lambda * h) / lambda);
  EXPECT_LE(end.q.angularDistance(exact), 1e-14);
}

TEST(DragFlow, ConvergesWithOrderTwoForAnyBodyAndTorque) {
  const BodyInertia inertia{m, Vec3(0.2, 0.5, 0.6)};
  const Environment::DragRates drag{c_linear, 0.3, 0.2};
  const Wrench force{Vec3(1, 2, 3), Vec3(0.1, -0.2, 0.3)};
  const BodyPhase start{Vec3(1, 0, 0), Quat(0.5, 0.5, -0.5, 0.5), Vec3(1, 0, 2), Vec3(0.3, 0.2, -0.4)};
  const auto flown = [&](int steps) {
    BodyPhase phase = start;
    for (int k = 0; k < steps; ++k) phase = drag_flow(inertia, drag, force, phase, 1.0 / steps);
    return phase;
  };
  const BodyPhase exact = flown(4096);
  const auto error = [&](int steps) {
    const BodyPhase phase = flown(steps);
    return (phase.L - exact.L).norm() + phase.q.angularDistance(exact.q);
  };
  EXPECT_GT(error(16), 3.5 * error(32));
  EXPECT_LT(error(16), 4.5 * error(32));
  EXPECT_LE((flown(7).x - exact.x).norm(), 1e-13);
}

}  // namespace
}  // namespace rigor::drag_flow_test
