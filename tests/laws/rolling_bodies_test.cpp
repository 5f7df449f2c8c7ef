// Bodies whose motion on one contact is known: tops, disks and balls that slip and roll.

#include "laws/scene_runs.hpp"

#include "rigor/math/dense.hpp"
#include "rigor/math/rotation.hpp"
#include "solver/reference_data.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

namespace rigor::test::rolling_bodies_test {
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

/// A rattleback that rolls: an ellipsoid with the squared half axes D², its centre of mass d below its
/// centre. With γ the vertical in the body's frame, the contact at ρ = d ẑ - D² γ/|D γ| from the centre of
/// mass and v = ρ × ω,
///   γ' = γ × ω,   (I + m (ρ² - ρ ρᵀ)) ω' = -ω × I ω + m ρ × (ρ' × ω + ω × (ρ × ω) + g γ).
struct Rattleback {
  Mat3 squares, inertia;
  double mass, depth;
  Vec3 vertical, turning;

  Vec3 contact() const {
    const double height = std::sqrt(vertical.dot(squares * vertical));
    return depth * Vec3::UnitZ() - squares * vertical / height;
  }
  double spin() const { return vertical.dot(turning); }
  std::pair<Vec3, Vec3> rate() const {
    const double height = std::sqrt(vertical.dot(squares * vertical));
    const Vec3 p = squares * vertical / height, rho = contact(), vertical_rate = vertical.cross(turning);
    const Vec3 rho_rate = -(squares - p * p.transpose()) * vertical_rate / height;
    const Mat3 about_contact =
        inertia + mass * (rho.squaredNorm() * Mat3::Identity() - rho * rho.transpose());
    const Vec3 push = rho_rate.cross(turning) + turning.cross(rho.cross(turning)) + g * vertical;
    const Vec3 moment = mass * rho.cross(push) - turning.cross(inertia * turning);
    return {vertical_rate, positive_definite_solution(about_contact, moment)};
  }
  Rattleback moved(double h, const std::pair<Vec3, Vec3>& rates) const {
    Rattleback result = *this;
    result.vertical += h * rates.first;
    result.turning += h * rates.second;
    return result;
  }
  /// By the classical Runge-Kutta method.
  void advance(double duration, int steps) {
    const double h = duration / steps;
    for (int i = 0; i < steps; ++i) {
      const auto k1 = rate(), k2 = moved(h / 2, k1).rate(), k3 = moved(h / 2, k2).rate();
      const auto k4 = moved(h, k3).rate();
      *this = moved(h / 6, k1).moved(h / 3, k2).moved(h / 3, k3).moved(h / 6, k4);
    }
  }
};

Rattleback rattleback_of(const Scene& scene, const State& state) {
  const int stone = scene.model->find_body("stone").value();
  // The model's bodies turn with their principal axes; here the axes of the surface count.
  const Mat3 R = rotation_matrix(state.orientation(stone)) * scene.model->body(stone).shapes.front().X_BS.R;
  const Vec3 half_axes(0.2, 0.03, 0.02);
  Mat3 inertia = Vec3(0.0002038346732422088, 0.0015961653267577915, 0.0017).asDiagonal();
  inertia(0, 1) = inertia(1, 0) = -7.316992428735743e-05;
  return {half_axes.cwiseAbs2().asDiagonal(),
          inertia,
          1,
          0.01,
          R.transpose() * Vec3::UnitZ(),
          R.transpose() * angular_velocity(*scene.model, state, stone)};
}

/// Rate about the vertical at every output, checked against the equation of rolling on the way.
std::vector<double> spins_of(const SceneRun& run, double tolerance) {
  std::vector<double> spins;
  Rattleback expected = rattleback_of(run.scene, run.states.front());
  for (const State& state : run.states) {
    if (!spins.empty()) expected.advance(run.scene.run.output_interval, 200);
    const Rattleback found = rattleback_of(run.scene, state);
    EXPECT_LE((found.vertical - expected.vertical).norm(), tolerance) << state.t;
    EXPECT_LE((found.turning - expected.turning).norm(), 10 * tolerance) << state.t;
    spins.push_back(found.spin());
  }
  return spins;
}

TEST(RollingBodies, RattlebackReversesItsSpin) {
  const SceneRun run = run_scene("rattleback.yaml");
  expect_trusted(run);
  const std::vector<double> spins = spins_of(run, 1e-8);
  EXPECT_NEAR(spins.front(), -3, 1e-12);
  EXPECT_GT(spins.back(), 3);
  // It goes through zero once, where the scene says, as a line between outputs tells it.
  std::vector<double> reversals;
  for (std::size_t i = 1; i < spins.size(); ++i) {
    if ((spins[i] > 0) != (spins[i - 1] > 0)) {
      const double part = spins[i - 1] / (spins[i - 1] - spins[i]);
      reversals.push_back(run.states[i - 1].t + part * (run.states[i].t - run.states[i - 1].t));
    }
  }
  ASSERT_EQ(reversals.size(), 1u);
  EXPECT_NEAR(reversals.front(), 0.846, 0.001);
  // No slip, so nothing is lost.
  EXPECT_NEAR(run.audit().final.total() / run.audit().initial.total(), 1, 1e-9);
}

TEST(RollingBodies, RattlebackReversesAtTheSameInstantWithATighterTolerance) {
  const SceneRun run = run_scene("rattleback.yaml");
  const SceneRun tighter = run_scene("rattleback.yaml", {"method.tolerance=1e-13"});
  ASSERT_EQ(run.states.size(), tighter.states.size());
  for (std::size_t i = 0; i < run.states.size(); ++i) {
    EXPECT_NEAR(rattleback_of(run.scene, run.states[i]).spin(),
                rattleback_of(tighter.scene, tighter.states[i]).spin(), 1e-8);
  }
}

TEST(RollingBodies, RattlebackKeepsTheOtherSense) {
  const SceneRun run = run_scene("rattleback.yaml",
                                 {"bodies.stone.angular_velocity=[0,0,3]",
                                  "bodies.stone.velocity=[-0.0003663554619015709,-0.020826406780174556,0]"});
  expect_trusted(run);
  for (const double spin : spins_of(run, 1e-8)) EXPECT_GT(spin, 2.9);
}

/// Angle from the top at which the ball leaves the dome.
double leaving_angle(const std::vector<std::string>& overrides) {
  const SceneRun run = run_scene("roll_off.yaml", overrides);
  expect_trusted(run);
  for (const MotionEvent& event : run.events) {
    if (event.kind != MotionEvent::Kind::separation) continue;
    std::ostringstream until;
    until.precision(17);
    until << "run.duration=" << event.time;
    std::vector<std::string> shorter = overrides;
    shorter.push_back(until.str());
    const Vec3 p = run_scene("roll_off.yaml", shorter).end_of("ball").position;
    return std::atan2(p.x(), p.z());
  }
  ADD_FAILURE() << "the ball stays on the dome";
  return 0;
}

/// The same with friction μ. Rolling needs friction 2/7 m g sin θ and leaves N = m g (17 cos θ - 10)/7, so at
/// last it slips, with u = (R + r) θ'²/g from du/dθ = 2 sin θ - 2 μ (cos θ - u) until N = cos θ - u = 0.
double leaving_angle_with_slip(double mu) {
  double angle = std::acos(10 * mu / std::hypot(17 * mu, 2)) - std::atan(2 / (17 * mu));
  double u = 10.0 / 7 * (1 - std::cos(angle)), before = angle;
  const double h = 1e-4 / mu;
  const auto rate = [mu](double at, double v) { return 2 * std::sin(at) - 2 * mu * (std::cos(at) - v); };
  double margin = std::cos(angle) - u, last_margin = margin;
  while (margin > 0) {
    before = angle;
    last_margin = margin;
    const double k1 = rate(angle, u), k2 = rate(angle + h / 2, u + h / 2 * k1);
    const double k3 = rate(angle + h / 2, u + h / 2 * k2), k4 = rate(angle + h, u + h * k3);
    u += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    angle += h;
    margin = std::cos(angle) - u;
  }
  return before + h * last_margin / (last_margin - margin);
}

TEST(RollingBodies, BallRollsOffASphereAtItsAngle) {
  const double rolled = leaving_angle({}), limit = std::acos(10.0 / 17);
  EXPECT_NEAR(limit * 180 / M_PI, 53.96812092752944, 1e-13);
  EXPECT_NEAR(rolled, leaving_angle_with_slip(1000), 1e-9);
  EXPECT_NEAR(rolled, limit, 1e-4);
}

TEST(RollingBodies, BallSlidesOffASphereAtItsAngle) {
  const double limit = std::acos(2.0 / 3);
  EXPECT_NEAR(limit * 180 / M_PI, 48.18968510422140, 1e-13);
  const double slid = leaving_angle({"materials.rubber.friction=0", "bodies.ball.angular_velocity=[0,0,0]",
                                     "bodies.ball.velocity=[0.5639080693248623,0,-0.09943220726119271]"});
  EXPECT_NEAR(slid, limit, 1e-9);
}

/// Rate after each impact of a rimless wheel of 1 kg with spokes of 1 m and moment I about its hub in the
/// end: an impact keeps η = (cos 45° + I)/(1 + I) of it, a step adds 4 g sin 22.5° sin 5°/(1 + I) to its
/// square.
double rimless_rate(double I) {
  const double kept = (std::cos(M_PI / 4) + I) / (1 + I);
  const double gain = 4 * g * std::sin(M_PI / 8) * std::sin(M_PI / 36) / (1 + I);
  return kept * std::sqrt(gain / (1 - kept * kept));
}

TEST(RollingBodies, RimlessWheelComesToItsLimitCycle) {
  EXPECT_NEAR(rimless_rate(0), 1.144016619950734, 1e-14);
  const SceneRun run = run_scene("rimless_wheel.yaml");
  expect_trusted(run);
  EXPECT_GE(run.audit().report.impacts, 30);
  const int wheel = run.body("wheel");
  int compared = 0;
  for (const State& state : run.states) {
    if (state.t < 28) continue;
    // Back to the last impact by the energy: the hub moves across its spoke, which shows the lean.
    const Vec3 v = state.linear_momentum(wheel);
    const double lean = std::atan2(-v.z(), v.x());
    const double rate = angular_velocity(*run.scene.model, state, wheel).y();
    const double gained = 2 * g * (std::cos(-M_PI / 8 + M_PI / 36) - std::cos(lean + M_PI / 36)) / 1.01;
    EXPECT_NEAR(std::sqrt(rate * rate - gained), rimless_rate(0.01), 1e-9) << state.t;
    ++compared;
  }
  EXPECT_GE(compared, 100);
}

}  // namespace
}  // namespace rigor::test::rolling_bodies_test
