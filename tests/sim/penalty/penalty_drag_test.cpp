// Drag under the penalty scheme, against closed forms.

#include "rigor/model/model_builder.hpp"
#include "rigor/sim/simulation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace rigor::penalty_drag_test {
namespace {

constexpr double radius = 0.3;

RunResult run(const ModelBuilder& builder, PenaltyMethod penalty, double step, double duration) {
  Method method;
  method.scheme = Scheme::penalty;
  method.penalty = penalty;
  RunSettings settings;
  settings.duration = settings.output_interval = duration;
  settings.step = step;
  return run_simulation(builder.build(), method, settings, std::nullopt,
                        [](const State&, const AdvanceReport&, const Auditor&) { return true; });
}

TEST(PenaltyDrag, FallAndSpinAreThoseOfTheClosedFormAtAnyRateAndStep) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int k = 0; k < 24; ++k) {
    const double m = std::pow(10, 2 * unit(random)), c = m * std::pow(10, k % 8 == 7 ? 12 : 3 * unit(random));
    const double I = 0.4 * m * radius * radius, c_spin = I * std::pow(10, 2 * unit(random));
    const Vec3 v(unit(random), unit(random), unit(random)), g(0, 0, -9.81), w(0, 0, 5 * unit(random));
    ModelBuilder builder;
    builder.set_gravity(g);
    BodyDescription ball;
    ball.name = "ball";
    ball.mass = m;
    ball.velocity = v;
    ball.angular_velocity = w;
    ball.linear_drag = c;
    ball.angular_drag = c_spin;
    ShapeDescription shape;
    shape.shape = Sphere{radius};
    ball.shapes = {shape};
    builder.add_body(ball);

    const double t = 0.5, gamma = c / m, decay = -std::expm1(-gamma * t) / gamma;
    const Vec3 x_exact = g / gamma * t + (v - g / gamma) * decay;
    const double L_exact = I * w.z() * std::exp(-c_spin / I * t);
    for (const PenaltyMethod penalty : {PenaltyMethod::local, PenaltyMethod::global}) {
      const RunResult result = run(builder, penalty, k % 2 == 0 ? 0.01 : 0.03, t);
      // Small rates: differences of large numbers in the formula above.
      const double rounding = 1e-12 * (1 + 1 / (gamma * gamma));
      EXPECT_LE((result.state.position(0) - x_exact).norm(), rounding + 1e-11 * x_exact.norm()) << c;
      EXPECT_NEAR(result.state.angular_momentum(0).z(), L_exact, 1e-11 * I) << c_spin;
      EXPECT_TRUE(result.audit.violations.empty()) << result.audit.violations.front();
    }
  }
}

TEST(PenaltyDrag, ABallOnASpringComesToRestWhereGravityAndSpringBalance) {
  for (const PenaltyMethod penalty : {PenaltyMethod::local, PenaltyMethod::global}) {
    for (const double c : {20.0, 2000.0}) {
      ModelBuilder builder;
      builder.set_gravity(Vec3(0, 0, -9.81));
      BodyDescription ball;
      ball.name = "ball";
      ball.mass = 1;
      ball.linear_drag = c;
      ShapeDescription shape;
      shape.shape = Sphere{radius};
      ball.shapes = {shape};
      builder.add_body(ball);
      ModelBuilder::ForceDescription spring{ModelBuilder::ForceDescription::Type::spring};
      spring.bodies = {"world", "ball"};
      spring.points = {Vec3(0, 0, 1), Vec3::Zero()};
      spring.stiffness = 100;
      spring.length = 1;
      builder.add_force(spring);
      const double t = 2, rest = -9.81 / 100;
      const RunResult result = run(builder, penalty, 0.005, t);
      // m z̈ + c ż + k (z - rest) = 0 from z = 0 at rest.
      const double half = 0.5 * c, root = std::sqrt(std::abs(half * half - 100));
      const double exact = half > 10 ? rest * (1 - (std::exp((-half + root) * t) * (half + root) -
                                                    std::exp((-half - root) * t) * (half - root)) /
                                                       (2 * root))
                                     : rest * (1 - std::exp(-half * t) * (1 + half * t));
      EXPECT_NEAR(result.state.position(0).z(), exact, 1e-3 * std::abs(rest)) << c;
    }
  }
}

}  // namespace
}  // namespace rigor::penalty_drag_test
