// Bodies whose motion on one contact is known: tops, disks and balls that slip and roll.

#include "laws/scene_runs.hpp"

#include "rigor/math/rotation.hpp"
#include "solver/reference_data.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rigor::test {
namespace {

constexpr double g = 9.81;

void expect_trusted(const SceneRun& run) {
  EXPECT_EQ(run.audit().report.reason, StopReason::reached_end) << run.audit().report.detail;
  for (const std::string& violation : run.audit().violations) ADD_FAILURE() << violation;
}

/// Direction of a body's z axis.
Vec3 axis_of(const State& state, int body) {
  return rotation_matrix(state.orientation(body)).col(2);
}

TEST(RollingBodies, TippeTopInvertsAsItsReference) {
  const SceneRun run = run_scene("tippe_top.yaml");
  expect_trusted(run);
  const int top = run.body("top");
  // 1e-13 a step of the integrator, over 23000 steps.
  constexpr double tolerance = 1e-10;
  for (const nlohmann::json& expected : reference::read("rolling_bodies.json")["tippe_top"]) {
    const State& state = run.state_at(expected["t"]);
    const Vec3 axis = axis_of(state, top);
    const Vec3 turning = angular_velocity(*run.scene.model, state, top);
    const Vec3 v = linear_velocity(*run.scene.model, state, top);
    const Vec3 slip = v + turning.cross(0.004 * axis - 0.02 * Vec3::UnitZ());
    EXPECT_NEAR(axis.z(), expected["cosine"], tolerance) << expected["t"];
    EXPECT_NEAR(turning.dot(axis), expected["spin"], 150 * tolerance) << expected["t"];
    EXPECT_NEAR(slip.norm(), expected["slip"], tolerance) << expected["t"];
    EXPECT_LE((v.head<2>() - reference::vector(expected["v"])).norm(), tolerance) << expected["t"];
  }
}

TEST(RollingBodies, TippeTopKeepsJellettsNumber) {
  // L · (vector from the centre of mass to the contact), whatever the friction.
  const SceneRun run = run_scene("tippe_top.yaml");
  const int top = run.body("top");
  const auto jellett = [&](const State& state) {
    return state.angular_momentum(top).dot(0.004 * axis_of(state, top) - 0.02 * Vec3::UnitZ());
  };
  const double start = jellett(run.states.front());
  EXPECT_NEAR(start, -2.304007188008996e-6, 1e-20);
  for (const State& state : run.states) EXPECT_NEAR(jellett(state) / start, 1, 1e-12) << state.t;
}

TEST(RollingBodies, DiskFollowsItsReference) {
  const SceneRun run = run_scene("rolling_disk.yaml");
  expect_trusted(run);
  EXPECT_EQ(run.audit().report.impacts, 0);
  const int disk = run.body("disk");
  // 1e-13 a step of the integrator; the thickness c counts as (c/R)².
  constexpr double tolerance = 1e-11;
  for (const nlohmann::json& expected : reference::read("rolling_bodies.json")["rolling_disk"]) {
    const State& state = run.state_at(expected["t"]);
    const VecX q = reference::vector(expected["q"]);
    const Vec4 found = state.orientation(disk).coeffs(), wanted(q[1], q[2], q[3], q[0]);
    EXPECT_LE(std::min((found - wanted).norm(), (found + wanted).norm()), tolerance) << expected["t"];
    EXPECT_LE((state.position(disk).head<2>() - reference::vector(expected["x"])).norm(), tolerance)
        << expected["t"];
    const Vec3 rates = rotation_matrix(state.orientation(disk)).transpose() *
                       angular_velocity(*run.scene.model, state, disk);
    EXPECT_LE((rates - reference::vector(expected["rates"])).norm(), 10 * tolerance) << expected["t"];
  }
  for (const State& state : run.states) {
    const Vec3 v = linear_velocity(*run.scene.model, state, disk);
    const Vec3 w = angular_velocity(*run.scene.model, state, disk);
    const double energy =
        0.5 * v.squaredNorm() + 0.5 * w.dot(state.angular_momentum(disk)) + g * state.position(disk).z();
    EXPECT_NEAR(energy, 1.1223834211125343, 1e-11);
  }
}

/// Lean of the upright disk over its lean at the start, with what is to be: cos(k t), or cosh(k t) if slow.
void expect_leans(const std::vector<std::string>& overrides, double v) {
  const SceneRun run = run_scene("upright_disk.yaml", overrides);
  expect_trusted(run);
  // (I1 + m R²) λ'' = m g R λ - (I3 + m R²) ω ψ', I1 ψ' = -I3 ω λ, with I1 = m R²/4, I3 = m R²/2, ω = v/R.
  const double square = 2.4 * (v * v - g * 0.1 / 3) / 0.01, rate = std::sqrt(std::abs(square));
  for (const State& state : run.states) {
    const double lean = std::asin(axis_of(state, run.body("disk")).z());
    const double expected = square > 0 ? std::cos(rate * state.t) : std::cosh(rate * state.t);
    // Of the linear equation: the square of the lean, 1e-3 at most. Of 1e-5 rad the integrator resolves 1e-7.
    EXPECT_NEAR(lean / 1e-5, expected, 1e-6 * std::abs(expected) + 1e-6) << state.t;
  }
}

TEST(RollingBodies, UprightDiskRollsOnIfFasterThanItsCriticalSpeed) {
  EXPECT_NEAR(std::sqrt(g * 0.1 / 3), 0.5718391382198319, 1e-15);
  expect_leans({}, 0.6);
}

TEST(RollingBodies, UprightDiskFallsIfSlowerThanItsCriticalSpeed) {
  expect_leans(
      {"bodies.disk.velocity=[0.54,0,0]", "bodies.disk.angular_velocity=[0,5.4,-5.4e-5]", "run.duration=1.5"},
      0.54);
}

}  // namespace
}  // namespace rigor::test
