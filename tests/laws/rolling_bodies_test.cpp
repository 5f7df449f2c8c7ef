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

}  // namespace
}  // namespace rigor::test
