// Tops about a fixed point against closed forms and integrations of their own equations.

#include "laws/reference_motion.hpp"
#include "laws/scene_runs.hpp"

#include "rigor/math/rotation.hpp"
#include "solver/reference_data.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rigor::test::tops_test {
namespace {

constexpr double g = 9.81;

void expect_trusted(const SceneRun& run) {
  EXPECT_EQ(run.audit().report.reason, StopReason::reached_end) << run.audit().report.detail;
  for (const std::string& violation : run.audit().violations) ADD_FAILURE() << violation;
}

/// Direction of a body's z axis.
Vec3 axis_of(const State& state) {
  return rotation_matrix(state.orientation(0)).col(2);
}

double tilt_of(const State& state) {
  const Vec3 axis = axis_of(state);
  return std::atan2(axis.head<2>().norm(), axis.z());
}

TEST(Tops, HeavyTopFollowsItsReference) {
  const SceneRun run = run_scene("heavy_top.yaml");
  expect_trusted(run);
  for (const nlohmann::json& expected : reference::read("mechanisms.json")["heavy_top"]) {
    const State& state = run.state_at(expected["t"]);
    const VecX q = reference::vector(expected["q"]);
    const Quat turned(q[0], q[1], q[2], q[3]);
    const Vec4 found = state.orientation(0).coeffs(), wanted = turned.coeffs();
    EXPECT_LE(std::min((found - wanted).norm(), (found + wanted).norm()), 1e-9) << expected["t"];
    EXPECT_LE((state.position(0) - reference::vector(expected["x"])).norm(), 1e-9) << expected["t"];
  }
  EXPECT_LE(run.audit().report.max_joint_drift, 1e-12);
}

TEST(Tops, FastTopSleeps) {
  const SceneRun run = run_scene("sleeping_top.yaml");
  expect_trusted(run);
  double most = 0;
  for (const State& state : run.states) most = std::max(most, tilt_of(state));
  EXPECT_LT(most, 2e-4);
  EXPECT_NEAR(tilt_of(run.states.front()), 1e-4, 1e-15);
}

TEST(Tops, SlowTopFalls) {
  const SceneRun run = run_scene(
      "sleeping_top.yaml",
      {"bodies.top.angular_velocity=[0,-0.0038429632303206038,48.5322674748694]", "run.duration=8"});
  double most = 0;
  for (const State& state : run.states) most = std::max(most, tilt_of(state));
  // With p = I₃ ω₃ the tilt turns at p²/(2 I₁ m g l) = 1 + cos θ; p² is 0.98² of the least 4 I₁ m g l. The
  // start is off by 1e-4, outputs miss the turn by little.
  EXPECT_NEAR(most, 2 * std::acos(0.98), 1e-4);
}

/// Rate of a steady precession with I₁ cos θ Ω² - I₃ ω₃ Ω + m g l = 0, by the stable form of either root.
double precession_rate(bool is_fast) {
  const double I1 = 0.002, I3 = 0.0008, w3 = 300, mgl = 0.5 * g * 0.04;
  const double a = I1 * std::cos(M_PI / 6);
  const double sum = I3 * w3 + std::sqrt(I3 * w3 * I3 * w3 - 4 * a * mgl);
  return is_fast ? sum / (2 * a) : 2 * mgl / sum;
}

TEST(Tops, SteadyPrecessionKeepsItsTiltForAHundredRounds) {
  const SceneRun run = run_scene("steady_top.yaml");
  expect_trusted(run);
  const double rate = precession_rate(true);
  EXPECT_GE(run.states.back().t * rate / (2 * M_PI), 99.9);
  for (const State& state : run.states) {
    ASSERT_NEAR(tilt_of(state), M_PI / 6, 1e-9) << state.t;
    const double azimuth = -M_PI / 2 + rate * state.t;
    const Vec3 axis = axis_of(state);
    ASSERT_NEAR(std::remainder(std::atan2(axis.y(), axis.x()) - azimuth, 2 * M_PI), 0, 1e-8) << state.t;
  }
}

/// A symmetric top let go from a tilt with a spin about its axis only. With p = I₃ ω₃ and c₀ = cos θ₀
///   I₁ θ̈ = sin θ (m g l - p φ̇ + I₁ φ̇² cos θ),   φ̇ = p (c₀ - cos θ) / (I₁ sin² θ).
struct SpinningTop {
  long double I1, p, mgl, c0;

  long double precession(long double theta) const {
    const long double s = std::sin(theta);
    return p * (c0 - std::cos(theta)) / (I1 * s * s);
  }
  long double operator()(const OneFreedom& at) const {
    const long double phi_rate = precession(at.angle);
    return std::sin(at.angle) * (mgl - p * phi_rate + I1 * phi_rate * phi_rate * std::cos(at.angle)) / I1;
  }
};

TEST(Tops, SpinningTopFollowsEulersEquations) {
  const SceneRun run = run_scene("spinning_top.yaml");
  expect_trusted(run);
  const long double tilt = std::acos(-1.0L) / 6;
  const SpinningTop top{0.14L, 0.02L * 50, 9.81L * 0.3L, std::cos(tilt)};
  // The azimuth by Simpson's rule over the same steps.
  OneFreedom y{tilt, 0};
  long double azimuth = -std::acos(-1.0L) / 2;
  double worst = 0;
  for (std::size_t k = 1; k < run.states.size(); ++k) {
    constexpr int steps = 10;
    const long double h = 0.01L / steps;
    for (int i = 0; i < steps; ++i) {
      const OneFreedom middle = motion_after(y, h / 2, 1, top), end = motion_after(y, h, 2, top);
      azimuth +=
          h / 6 * (top.precession(y.angle) + 4 * top.precession(middle.angle) + top.precession(end.angle));
      y = end;
    }
    const long double s = std::sin(y.angle);
    const Vec3 axis(static_cast<double>(s * std::cos(azimuth)), static_cast<double>(s * std::sin(azimuth)),
                    static_cast<double>(std::cos(y.angle)));
    worst = std::max(worst, (axis_of(run.states[k]) - axis).norm());
  }
  EXPECT_LE(worst, 1e-8);
  EXPECT_GT(worst, 0);
}

}  // namespace
}  // namespace rigor::test::tops_test
