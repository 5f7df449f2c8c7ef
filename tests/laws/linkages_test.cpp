// Linkages, chains and what motors drive, against closed forms and integrations of their own freedom.

#include "laws/reference_motion.hpp"
#include "laws/scene_runs.hpp"

#include "rigor/math/rotation.hpp"
#include "rigor/sim/audit/contact_snapshot.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace rigor::test::linkages_test {
namespace {

constexpr double g = 9.81;
using LongVec2 = Eigen::Matrix<long double, 2, 1>;

void expect_trusted(const SceneRun& run) {
  EXPECT_EQ(run.audit().report.reason, StopReason::reached_end) << run.audit().report.detail;
  for (const std::string& violation : run.audit().violations) ADD_FAILURE() << violation;
}

Vec3 point_of(const SceneRun& run, const State& state, const std::string& body, const Vec3& p_BP) {
  const int i = run.body(body);
  return state.position(i) + rotation_matrix(state.orientation(i)) * p_BP;
}

/// The four-bar linkage as one freedom, the crank's angle a from the horizontal, in the plane of x and
/// height. With B the crank's pin and C the rocker's, |C - B| = 2 and |C - D| = 1.5 give C, its rates and
/// what of its acceleration a'' does not cause. J(a) a'' + ½ J' a'² = -V'.
struct FourBar {
  struct Place {
    LongVec2 B, C, dB, dC, ddB, ddC;  ///< Points, first and second derivatives by the angle.
  };
  static Place place(long double a) {
    const LongVec2 D(2, 0);
    Place at;
    at.B = LongVec2(std::cos(a), std::sin(a));
    at.dB = LongVec2(-at.B.y(), at.B.x());
    at.ddB = -at.B;
    const LongVec2 line = D - at.B;
    const long double length = line.norm(), along = (4 - 2.25L + length * length) / (2 * length);
    const LongVec2 e = line / length;
    at.C = at.B + along * e + std::sqrt(4 - along * along) * LongVec2(-e.y(), e.x());
    // (C - B)·(C' - B') = 0 and (C - D)·C' = 0, and both once more by the angle.
    const LongVec2 u = at.C - at.B, v = at.C - D;
    const long double det = u.x() * v.y() - u.y() * v.x();
    const auto solve = [&](long double r, long double s) {
      return LongVec2((r * v.y() - s * u.y()) / det, (u.x() * s - v.x() * r) / det);
    };
    at.dC = solve(u.dot(at.dB), 0);
    at.ddC = solve(u.dot(at.ddB) - (at.dC - at.dB).squaredNorm(), -at.dC.squaredNorm());
    return at;
  }
  long double operator()(const OneFreedom& state) const {
    const Place at = place(state.angle);
    // A uniform bar of mass m has the energy m/6 (|p|² + p·q + |q|²), p and q the velocities of its ends.
    const auto bar = [](long double m, const LongVec2& p, const LongVec2& q) {
      return m / 3 * (p.squaredNorm() + p.dot(q) + q.squaredNorm());
    };
    const auto half_slope = [](long double m, const LongVec2& p, const LongVec2& dp, const LongVec2& q,
                               const LongVec2& dq) {
      return m / 6 * (2 * p.dot(dp) + p.dot(dq) + q.dot(dp) + 2 * q.dot(dq));
    };
    const LongVec2 zero(0, 0);
    const long double J = bar(1, zero, at.dB) + bar(2, at.dB, at.dC) + bar(1.5L, zero, at.dC);
    const long double half_dJ = half_slope(1, zero, zero, at.dB, at.ddB) +
                                half_slope(2, at.dB, at.ddB, at.dC, at.ddC) +
                                half_slope(1.5L, zero, zero, at.dC, at.ddC);
    const long double dV = 9.81L * ((0.5L + 1) * at.dB.y() + (1 + 0.75L) * at.dC.y());
    return -(half_dJ * state.rate * state.rate + dV) / J;
  }
};

TEST(Linkages, FourBarFollowsLagrangesEquationOfItsCrank) {
  const SceneRun run = run_scene("four_bar.yaml");
  expect_trusted(run);
  OneFreedom y{std::acos(-1.0L) / 2, 0};
  double worst = 0, lowest = 1;
  for (std::size_t k = 1; k < run.states.size(); ++k) {
    y = motion_after(y, 0.01L, 40, FourBar{});
    const FourBar::Place at = FourBar::place(y.angle);
    const Vec3 B(static_cast<double>(at.B.x()), 0, static_cast<double>(at.B.y()));
    const Vec3 C(static_cast<double>(at.C.x()), 0, static_cast<double>(at.C.y()));
    const State& state = run.states[k];
    worst = std::max(worst, (point_of(run, state, "crank", Vec3(0.5, 0, 0)) - B).norm());
    worst = std::max(worst, (point_of(run, state, "coupler", Vec3(1, 0, 0)) - C).norm());
    worst = std::max(worst, (point_of(run, state, "rocker", Vec3(0.75, 0, 0)) - C).norm());
    lowest = std::min(lowest, B.z());
  }
  EXPECT_LE(worst, 1e-9);
  EXPECT_LT(lowest, 0);
  EXPECT_LE(run.audit().report.max_joint_drift, 1e-13);
}

TEST(Linkages, PistonMovesAsTheCrankTellsIt) {
  const SceneRun run = run_scene("slider_crank.yaml");
  expect_trusted(run);
  const int piston = run.body("piston");
  for (const State& state : run.states) {
    const double c = std::cos(10 * state.t), s = std::sin(10 * state.t);
    const Vec3 expected(0.5 * c + std::sqrt(2.25 - 0.25 * s * s), 0, 0);
    ASSERT_LE((state.position(piston) - expected).norm(), 1e-10) << state.t;
  }
}

TEST(Linkages, GovernorSettlesAtTheAngleOfItsSpeed) {
  const SceneRun run = run_scene("governor.yaml");
  expect_trusted(run);
  const double l = 0.4, ball = 2, link = 0.3, sleeve = 1, w = 9;
  const double cosine =
      g * (ball * l + 1.5 * link * l + sleeve * l) / (w * w * (ball * l * l + link * l * l / 3 - 1e-5));
  const Vec3 found = run.result.state.position(run.body("right_arm"));
  EXPECT_NEAR(-found.z() / l, cosine, 1e-8);
  EXPECT_NEAR(run.end_of("sleeve").position.z(), -2 * l * cosine, 1e-8);
  EXPECT_NEAR(run.end_of("shaft").angular_velocity.z(), w, 1e-12);
  // The motor has paid for the balls' speed and the damper's heat.
  EXPECT_GT(run.audit().report.work, run.audit().final.kinetic - run.audit().initial.kinetic);
}

TEST(Linkages, TableOnParallelBarsSwingsLikeAPendulum) {
  const SceneRun run = run_scene("parallel_bars.yaml");
  expect_trusted(run);
  const auto acceleration = [](const OneFreedom& at) {
    return -9.81L * std::sin(at.angle) * (4 * 0.5L + 4) / (4 / 3.0L + 4);
  };
  OneFreedom y{std::acos(-1.0L) / 3, 0};
  const int table = run.body("table");
  for (std::size_t k = 1; k < run.states.size(); ++k) {
    y = motion_after(y, 0.01L, 20, acceleration);
    const Vec3 expected(static_cast<double>(-std::sin(y.angle)), 0, static_cast<double>(-std::cos(y.angle)));
    ASSERT_LE((run.states[k].position(table) - expected).norm(), 1e-9) << run.states[k].t;
  }
}

/// Reactions at hinge name[i,j,0].
using HingeForces = std::array<std::array<JointReaction, 2>, 2>;
HingeForces hinge_forces(const SceneRun& run, const State& state, const std::string& name) {
  HingeForces result;
  for (const JointReaction& joint : joint_snapshot(*run.scene.model, run.scene.method, state)) {
    for (std::size_t i = 0; i < 2; ++i) {
      for (std::size_t j = 0; j < 2; ++j) {
        const std::string wanted = name + "[" + std::to_string(i) + "," + std::to_string(j) + ",0]";
        if (run.scene.model->joint(joint.joint).name == wanted) result[i][j] = joint;
      }
    }
  }
  return result;
}

TEST(Linkages, ParallelBarsAtFrontAndBackShareAlike) {
  const SceneRun run = run_scene("parallel_bars.yaml", {"run.duration=1"});
  for (const double t : {0.0, 0.3, 1.0}) {
    for (const std::string name : {"top", "low"}) {
      const HingeForces hinges = hinge_forces(run, run.state_at(t), name);
      for (std::size_t i = 0; i < 2; ++i) {
        const JointReaction &front = hinges[i][0], &back = hinges[i][1];
        // Mirrored in y: forces keep x and z, torques keep y.
        EXPECT_LE((front.force_W - Vec3(1, -1, 1).cwiseProduct(back.force_W)).norm(), 1e-9) << name << t;
        EXPECT_LE((front.torque_W - Vec3(-1, 1, -1).cwiseProduct(back.torque_W)).norm(), 1e-9) << name << t;
        EXPECT_TRUE(front.force_W.allFinite());
      }
    }
  }
}

TEST(Linkages, HangingTableLoadsAllBarsAlike) {
  const SceneRun run =
      run_scene("parallel_bars.yaml",
                {"bodies.bar.position=[-0.8,-0.4,-0.5]", "bodies.bar.rpy=[0,0,0]",
                 "bodies.table.position=[0,0,-1]", "joints.low.anchor=[-0.8,-0.4,-1]", "run.duration=1"});
  expect_trusted(run);
  EXPECT_EQ(run.audit().final.kinetic, 0);
  const HingeForces top = hinge_forces(run, run.result.state, "top");
  const HingeForces low = hinge_forces(run, run.result.state, "low");
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t j = 0; j < 2; ++j) {
      EXPECT_LE((top[i][j].force_W - Vec3(0, 0, 2 * g)).norm(), 1e-12);
      EXPECT_LE((low[i][j].force_W - Vec3(0, 0, g)).norm(), 1e-12);
      EXPECT_LE(top[i][j].torque_W.norm() + low[i][j].torque_W.norm(), 1e-12);
    }
  }
}

TEST(Linkages, FloatingChainKeepsItsMomenta) {
  const SceneRun run = run_scene("free_chain.yaml");
  expect_trusted(run);
  EXPECT_GE(run.audit().report.steps, 10000);
  const Momentum start = total_momentum(*run.scene.model, run.states.front());
  double linear = 0, angular = 0;
  for (const State& state : run.states) {
    const Momentum now = total_momentum(*run.scene.model, state);
    linear = std::max(linear, (now.linear - start.linear).norm());
    angular = std::max(angular, (now.angular - start.angular).norm());
  }
  EXPECT_LE(linear, 1e-12);
  EXPECT_LE(angular, 1e-12);
}

TEST(Linkages, ChainOfAThousandLinksFallsAndHolds) {
  const SceneRun run = run_scene("chain.yaml", {"run.duration=0.005"});
  expect_trusted(run);
  EXPECT_LE(run.audit().report.max_joint_drift, 1e-12);
  // Far from the hook the chain does not know of it yet.
  EXPECT_NEAR(run.end_of("link[999,0,0]").position.z(), -0.5 * g * 0.005 * 0.005, 1e-9);
}

}  // namespace
}  // namespace rigor::test::linkages_test
