// Balls that roll on tables, still and turning, with rolling and torsional friction.

#include "laws/scene_runs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

namespace rigor::test::rolling_test {
namespace {

constexpr double g = 9.81;

SceneRun run_text(const std::string& text) {
  SceneRun run;
  run.scene = parse_scene(text, "scene.yaml", ".");
  const Observer observer = [&](const State& state, const AdvanceReport& since, const Auditor&) {
    run.events.insert(run.events.end(), since.events.begin(), since.events.end());
    run.states.push_back(state);
    return true;
  };
  run.result = run_simulation(run.scene.model, run.scene.method, run.scene.run, std::nullopt, observer);
  return run;
}

/// A ball of 1 kg and radius 0.1 m with I = k m R² on a table.
std::string ball_scene(const std::string& material, double k, const std::string& table,
                       const std::string& ball, double duration) {
  std::ostringstream text;
  text.precision(17);
  const double moment = k * 0.01;
  text << "rigor: 1\nworld: {gravity: [0, 0, -9.81]}\nrun: {duration: " << duration
       << ", output_interval: 0.1}\nmaterials: [{name: m, friction: 1, " << material << "}]\nbodies:\n"
       << "  - {name: table, " << table
       << ", position: [0, 0, -0.1], shapes: [{type: cylinder, radius: 50, length: "
       << "0.2, material: m}]}\n  - {name: ball, " << ball << ", inertia: {mass: 1, moments: [" << moment
       << ", " << moment << ", " << moment << "]}, shapes: [{type: sphere, radius: 0.1, material: m}]}\n";
  return text.str();
}

/// A ball rolls on a table that turns at Ω, with rolling friction ρ:
///   v̇ = k/(1 + k) Ω ẑ × v - ρ g/(R (1 + k)) s/|s|,   s = v - Ω ẑ × x,
/// from I ω̇ = -R ẑ × m v̇ - ρ m g ω_t/|ω_t| and rolling, v = Ω ẑ × x + R ω × ẑ.
struct Rolling {
  double Omega, k, rho;

  Vec4 rate(const Vec4& y) const {
    const Vec2 x = y.head<2>(), v = y.tail<2>();
    const auto turned = [](const Vec2& a) { return Vec2(-a.y(), a.x()); };
    const Vec2 s = v - Omega * turned(x);
    Vec4 result;
    result << v, k / (1 + k) * Omega * turned(v) - rho * g / (0.1 * (1 + k)) * s.normalized();
    return result;
  }
  Vec4 after(Vec4 y, double duration) const {
    const int steps = static_cast<int>(std::ceil(duration * 2000));
    const double h = duration / steps;
    for (int i = 0; i < steps; ++i) {
      const Vec4 k1 = rate(y), k2 = rate(y + h / 2 * k1), k3 = rate(y + h / 2 * k2), k4 = rate(y + h * k3);
      y += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    }
    return y;
  }
};

TEST(Turntable, BallsRunOnClosedCircles) {
  // Ω = 3, placed rolling at 0.3 m/s: at k/(1 + k) Ω on a circle of radius 0.3 over that rate; solid and
  // hollow.
  for (const auto& [k, rate] : {std::pair{0.4, 6.0 / 7}, std::pair{2.0 / 3, 6.0 / 5}}) {
    const double turn = 2 * M_PI / rate, radius = 0.3 / rate;
    // ω: R ω × ẑ = v - Ω ẑ × x, with v = (0, 0.3, 0) at x = (1, 0).
    const SceneRun run = run_text(
        ball_scene("restitution: 0", k, "motion: kinematic, angular_velocity: [0, 0, 3]",
                   "position: [1, 0, 0.1], velocity: [0, 0.3, 0], angular_velocity: [27, 0, 0]", 3 * turn));
    EXPECT_TRUE(run.audit().violations.empty());
    const int ball = run.body("ball");
    for (const State& state : run.states) {
      EXPECT_NEAR((state.position(ball) - Vec3(1 - radius, 0, 0.1)).norm(), radius, 1e-9);
    }
    EXPECT_LT((run.end_of("ball").position - Vec3(1, 0, 0.1)).norm(), 1e-9);
  }
}

TEST(Turntable, TiltedByOneDegreeLetsTheBallDriftAcrossTheSlope) {
  // Gravity turned instead of the table: drift at (1/k) g sin α/Ω, k = 2/5, at right angles to the slope.
  const double alpha = M_PI / 180, Omega = 3, drift = 2.5 * g * std::sin(alpha) / Omega;
  EXPECT_NEAR(drift, 0.1426734226247928, 1e-15);
  std::ostringstream gravity;
  gravity.precision(17);
  gravity << "[" << g * std::sin(alpha) << ", 0, " << -g * std::cos(alpha) << "]";
  // Two whole turns at 2/7 Ω; by then the ball has moved by the drift alone.
  const double duration = 2 * 2 * M_PI / (2.0 / 7 * Omega);
  std::string text =
      ball_scene("restitution: 0", 0.4, "motion: kinematic, angular_velocity: [0, 0, 3]",
                 "position: [1, 0, 0.1], velocity: [0, 0.3, 0], angular_velocity: [27, 0, 0]", duration);
  const std::string old = "[0, 0, -9.81]";
  text.replace(text.find(old), old.size(), gravity.str());
  const SceneRun run = run_text(text);
  const Vec3 moved = run.end_of("ball").position - Vec3(1, 0, 0.1);
  EXPECT_NEAR(moved.x(), 0, 1e-8);
  EXPECT_NEAR(std::abs(moved.y()), drift * duration, 1e-8);
}

TEST(Turntable, OfThePeersComparisonStaysOnItsCircleForTwentySeconds) {
  const SceneRun run = run_scene("turntable.yaml", {"run.duration=20"});
  const int ball = run.body("ball");
  for (const State& state : run.states) {
    const double angle = 2 * 2.0 / 7 * state.t;
    const Vec3 expected(0.475 + 0.525 * std::cos(angle), 0.525 * std::sin(angle), 0.1);
    EXPECT_LT((state.position(ball) - expected).norm(), 1e-9);
  }
}

TEST(Turntable, WithRollingFrictionIsTheSpiralOfItsEquation) {
  const SceneRun run = run_scene("platter.yaml");
  EXPECT_EQ(run.audit().report.reason, StopReason::reached_end);
  const Rolling rolling{2, 0.4, 1e-3};
  const int ball = run.body("ball");
  double last_radius = 0, edge = 0;
  for (const State& state : run.states) {
    const Vec3 p = state.position(ball);
    const double radius = p.head<2>().norm();
    if (radius < 1) {
      const Vec4 expected = rolling.after({0.3, 0, 0, 0.1}, state.t);
      EXPECT_LT((p.head<2>() - expected.head<2>()).norm(), 1e-8) << state.t;
      EXPECT_NEAR(p.z(), 0.1, 1e-9);
    } else if (last_radius < 1) {
      edge = state.t;
    }
    last_radius = radius;
  }
  EXPECT_NEAR(edge, 7.415, 0.02);  // an output interval
}

TEST(RollingFriction, SlowsARollingBallAtItsRate) {
  // (I + m R²) ω̇ = -ρ m g.
  const double k = 0.4, rho = 0.002, rate = rho * g / (0.1 * (1 + k)), v = 1, duration = 2;
  const SceneRun run = run_text(
      ball_scene("rolling_friction: 0.002", k, "motion: static",
                 "position: [0, 0, 0.1], velocity: [1, 0, 0], angular_velocity: [0, 10, 0]", duration));
  EXPECT_NEAR(run.end_of("ball").velocity.x(), v - rate * duration, 1e-10);
  EXPECT_NEAR(run.end_of("ball").position.x(), v * duration - 0.5 * rate * duration * duration, 1e-9);
  // What it lost is booked as dissipated: the audit's balance holds.
  EXPECT_TRUE(run.audit().violations.empty());
  EXPECT_LT(run.audit().max_increase, 1e-12);
}

TEST(RollingFriction, BringsARollingBallToRestAndNotBack) {
  const double rate = 0.002 * g / 0.14;
  const SceneRun run =
      run_text(ball_scene("rolling_friction: 0.002", 0.4, "motion: static",
                          "position: [0, 0, 0.1], velocity: [0.1, 0, 0], angular_velocity: [0, 1, 0]", 2));
  const auto& ball = run.end_of("ball");
  EXPECT_NEAR(ball.position.x(), 0.1 * 0.1 / (2 * rate), 1e-3 * 0.1 / rate);  // fading below 1 mm/s
  EXPECT_LT(ball.velocity.norm(), 1e-5);
  EXPECT_GE(ball.velocity.x(), 0);
  EXPECT_EQ(run.audit().report.coarse_steps, 0);
}

TEST(TorsionalFriction, SlowsASpinningBallAtItsRate) {
  const double I = 0.004, sigma = 0.001, spin = 20, duration = 3;
  const SceneRun run = run_text(ball_scene("torsional_friction: 0.001", 0.4, "motion: static",
                                           "position: [0, 0, 0.1], angular_velocity: [0, 0, 20]", duration));
  EXPECT_NEAR(run.end_of("ball").angular_velocity.z(), spin - sigma * g / I * duration, 1e-9);
}

TEST(RollingFriction, CountsInABounceToo) {
  // A spinning ball dropped from 1 m: each impact takes σ (1 + e) v_n / I of its spin.
  const double e = 0.5, sigma = 0.001, I = 0.004, v = std::sqrt(2 * g);
  const SceneRun run =
      run_text(ball_scene("restitution: 0.5, torsional_friction: 0.001", 0.4, "motion: static",
                          "position: [0, 0, 1.1], angular_velocity: [0, 0, 20]", 0.6));
  EXPECT_EQ(run.audit().report.impacts, 1);
  EXPECT_NEAR(run.end_of("ball").angular_velocity.z(), 20 - sigma * (1 + e) * v / I, 1e-9);
  EXPECT_LT(run.audit().angular_momentum_error, 1e-14);
}

}  // namespace
}  // namespace rigor::test::rolling_test
