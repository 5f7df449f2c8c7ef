// Mechanisms of the literature, as scenes, against references of 15 digits and more.

#include "laws/reference_motion.hpp"
#include "laws/scene_runs.hpp"

#include "rigor/dynamics/environment.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/sim/audit/contact_snapshot.hpp"
#include "solver/reference_data.hpp"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>
#include <utility>

namespace rigor::test::mechanisms_test {
namespace {

const nlohmann::json& references(const char* mechanism) {
  return reference::read("mechanisms.json")[mechanism];
}

void expect_trusted(const SceneRun& run) {
  EXPECT_EQ(run.audit().report.reason, StopReason::reached_end) << run.audit().report.detail;
  for (const std::string& violation : run.audit().violations) ADD_FAILURE() << violation;
  EXPECT_EQ(run.audit().report.coarse_steps, 0);
}

double largest_kinetic_energy(const SceneRun& run) {
  const Environment environment(*run.scene.model);
  double kinetic = 0;
  for (const State& state : run.states)
    kinetic = std::max(kinetic, mechanical_energy(*run.scene.model, environment, state).kinetic);
  return kinetic;
}

/// Largest difference of energies at output times, relative to the largest kinetic energy.
double energy_error(const SceneRun& run) {
  const Environment environment(*run.scene.model);
  double least = INFINITY, most = -INFINITY;
  for (const State& state : run.states) {
    const double energy = mechanical_energy(*run.scene.model, environment, state).total();
    least = std::min(least, energy);
    most = std::max(most, energy);
  }
  return (most - least) / largest_kinetic_energy(run);
}

TEST(Mechanisms, PendulumKeepsTime) {
  const SceneRun run = run_scene("pendulum.yaml");
  expect_trusted(run);
  for (const nlohmann::json& expected : references("pendulum")) {
    const Vec3 x = run.state_at(expected["t"]).position(0);
    EXPECT_NEAR(x.x(), expected["x"].get<double>(), 1e-10) << expected["t"];
    EXPECT_NEAR(x.z(), expected["z"].get<double>(), 1e-10) << expected["t"];
  }
}

TEST(Mechanisms, DoublePendulumKeepsItsDigitsThroughChaos) {
  const SceneRun run = run_scene("double_pendulum.yaml");
  expect_trusted(run);
  for (const nlohmann::json& expected : references("double_pendulum")) {
    const VecX angles = reference::vector(expected["angles"]);
    const auto along = [](double angle) { return Vec3(std::sin(angle), 0, -std::cos(angle)); };
    const State& state = run.state_at(expected["t"]);
    EXPECT_LE((state.position(0) - 0.5 * along(angles[0])).norm(), 1e-8) << expected["t"];
    EXPECT_LE((state.position(1) - along(angles[0]) - 0.5 * along(angles[1])).norm(), 1e-8) << expected["t"];
  }
  EXPECT_LE(energy_error(run), 1e-11);
  EXPECT_LE(run.audit().report.max_joint_drift, 1e-14);
}

/// Place of the first pin, at the upper end of the first crank.
Vec3 first_pin(const SceneRun& run, const State& state) {
  const int crank = run.body("crank[0,0,0]");
  return state.position(crank) + rotation_matrix(state.orientation(crank)) * Vec3(0, 0, 0.5);
}

TEST(Mechanisms, FourBarLinkagesStayOnTheirBranchWhereBarsAreInLine) {
  const SceneRun run = run_scene("n_four_bar.yaml");
  expect_trusted(run);
  for (const nlohmann::json& expected : references("n_four_bar")) {
    if (expected["linkages"] != 2) continue;
    const VecX pin = reference::vector(expected["pin"]);
    const Vec3 found = first_pin(run, run.state_at(expected["t"]));
    EXPECT_LE((found - Vec3(pin[0], 0, pin[1])).norm(), 1e-6) << expected["t"];
  }
  EXPECT_LE(energy_error(run), 1e-9);
  EXPECT_LE(run.audit().report.max_joint_drift, 1e-12);
}

/// All cranks of N linkages turn alike: one freedom, the angle from the upright.
OneFreedom crank_after(long double duration, int linkages) {
  const long double N = linkages;
  const long double factor = ((N + 1) / 2 + N) / ((N + 1) / 3 + N) * 9.81L;
  return motion_after({0, 1}, duration, 20000,
                      [&](const OneFreedom& at) { return factor * std::sin(at.angle); });
}

TEST(Mechanisms, ReferencesOfLinkagesAreTheirOneFreedom) {
  for (const nlohmann::json& expected : references("n_four_bar")) {
    const OneFreedom y = crank_after(expected["t"].get<double>(), expected["linkages"]);
    EXPECT_NEAR(static_cast<double>(y.angle), expected["angle"].get<double>(), 1e-11);
    EXPECT_NEAR(static_cast<double>(y.rate), expected["rate"].get<double>(), 1e-11);
  }
}

SceneRun run_linkages(int linkages, double duration) {
  const auto count = [](const char* key, int n) { return fmt::format("{}.repeat.count=[{},1,1]", key, n); };
  return run_scene("n_four_bar.yaml", {count("bodies.crank", linkages + 1), count("bodies.coupler", linkages),
                                       count("joints.base", linkages + 1), count("joints.left", linkages),
                                       count("joints.right", linkages),
                                       fmt::format("run.duration={}", duration), "run.output_interval=0.5"});
}

TEST(Mechanisms, TenAndFortyLinkagesPassTheLineTogether) {
  // All bars are in line when the cranks have turned by 90°: N loops lose a row each there.
  for (const auto& [linkages, duration] : {std::pair(10, 2), std::pair(40, 1)}) {
    const SceneRun run = run_linkages(linkages, duration);
    expect_trusted(run);
    const OneFreedom expected = crank_after(duration, linkages);
    const double angle = static_cast<double>(expected.angle);
    EXPECT_GT(angle, std::numbers::pi / 2);
    EXPECT_LE((first_pin(run, run.result.state) - Vec3(std::sin(angle), 0, std::cos(angle))).norm(), 1e-6);
    EXPECT_LE(energy_error(run), 1e-9);
    // Rounding of places up to 40 m from the origin.
    EXPECT_LE(run.audit().report.max_joint_drift, 4 * 40 * std::numeric_limits<double>::epsilon());
  }
}

double angle_about_z(const State& state, int body) {
  const Mat3 R = rotation_matrix(state.orientation(body));
  return std::atan2(R(1, 0), R(0, 0));
}

const SceneRun& andrews() {
  static const SceneRun run = run_scene("andrews.yaml");
  return run;
}

TEST(Mechanisms, AndrewsSqueezerFollowsSchiehlensAngles) {
  expect_trusted(andrews());
  for (const nlohmann::json& expected : references("andrews")) {
    const State& state = andrews().state_at(expected["t"]);
    const VecX q = reference::vector(expected["angles"]);
    const double angles[7] = {q[0], q[0] + q[1], q[2], q[3] + q[4], q[4], q[5] + q[6], q[6]};
    for (int i = 0; i < 7; ++i) {
      const double found = angle_about_z(state, andrews().body("k" + std::to_string(i + 1)));
      EXPECT_NEAR(std::remainder(found - angles[i], 2 * M_PI), 0, 1e-8) << expected["t"] << " k" << i + 1;
    }
  }
}

TEST(Mechanisms, ForcesInAndrewsSqueezerAreTheMultipliers) {
  for (const nlohmann::json& expected : references("andrews")) {
    const std::vector<JointReaction> joints =
        joint_snapshot(*andrews().scene.model, andrews().scene.method, andrews().state_at(expected["t"]));
    const VecX forces = reference::vector(expected["forces"]);
    Eigen::Index first = 0;
    for (const JointReaction& joint : joints) {
      const std::string& name = andrews().scene.model->joint(joint.joint).name;
      if (name != "e3" && name != "e4" && name != "e6") continue;
      EXPECT_LE((joint.force_W - Vec3(forces[first], forces[first + 1], 0)).norm(), 1e-6 * forces.norm())
          << name << " " << expected["t"];
      first += 2;
    }
    EXPECT_EQ(first, 6);
  }
}

TEST(Mechanisms, SqueezerWithoutItsMotorNeverGainsEnergy) {
  // Pushed out of its dead centre: the crank turns at w, its rod at -(rr/d - 1) w against it, the rest
  // stands.
  const double w = 100, s = std::sin(-0.0617138900142764), c = std::cos(-0.0617138900142764);
  const auto set = [](const std::string& key, const Vec3& value) {
    std::ostringstream text;
    text.precision(17);
    text << key << "=[" << value.x() << "," << value.y() << "," << value.z() << "]";
    return text.str();
  };
  const double of_k1 = 0.00092 * w, of_k2 = (0.007 - 0.0115 * 0.25) * w;
  const SceneRun run =
      run_scene("andrews.yaml",
                {"forces.0.torque=[0,0,0]", set("bodies.k1.angular_velocity", Vec3(0, 0, w)),
                 set("bodies.k1.velocity", Vec3(-s * of_k1, c * of_k1, 0)),
                 set("bodies.k2.angular_velocity", Vec3(0, 0, w / 4)),
                 set("bodies.k2.velocity", Vec3(-s * of_k2, c * of_k2, 0)), "run.output_interval=0.001"});
  expect_trusted(run);
  EXPECT_GT(largest_kinetic_energy(run), 10 * run.audit().initial.kinetic);
  EXPECT_LE(run.audit().max_increase, 1e-12 * run.audit().final.total());
  EXPECT_LE(energy_error(run), 1e-11);
  EXPECT_LE(run.audit().report.max_joint_drift, 1e-15);
}

TEST(Mechanisms, BricardsLoopMovesThoughCountedRigid) {
  const SceneRun run = run_scene("bricard.yaml");
  expect_trusted(run);
  const int bar = run.body("bar3");
  for (const nlohmann::json& expected : references("bricard")) {
    const State& state = run.state_at(expected["t"]);
    const Vec3 corner = state.position(bar) + rotation_matrix(state.orientation(bar)) * Vec3(0, 0, 0.5);
    EXPECT_LE((corner - reference::vector(expected["corner"])).norm(), 1e-7) << expected["t"];
  }
  EXPECT_LE(run.audit().report.max_joint_drift, 1e-14);
  EXPECT_LE(run.audit().max_increase, 1e-12 * largest_kinetic_energy(run));
  EXPECT_LE(energy_error(run), 1e-11);
}

TEST(Mechanisms, BricardsLoopStaysClosedFor100Seconds) {
  const SceneRun run = run_scene("bricard.yaml", {"run.duration=100", "run.output_interval=0.1"});
  expect_trusted(run);
  // Places are put back in every step: what is left is the rounding of places of a few metres.
  EXPECT_LE(run.audit().report.max_joint_drift, 16 * std::numeric_limits<double>::epsilon());
  EXPECT_LE(run.audit().max_increase, 1e-12 * largest_kinetic_energy(run));
  // The errors of the steps add up at most: ten times those of the 10 s above.
  EXPECT_LE(energy_error(run), 1e-10);
}

TEST(Mechanisms, AStruckLinkageKeepsItsAngularMomentumThroughCoarseSteps) {
  // Three boxes on a slider and a hinge fall on the floor and topple about, in part at velocity level, where
  // the joints are off by more and are put back each step.
  const char* text = R"(
rigor: 1
world: {gravity: [0, 0, -9.81]}
run: {duration: 1, step: 0.01, output_interval: 0.1}
materials: [{name: m, friction: 0.8, restitution: 0}]
bodies:
  - {name: floor, motion: static, shapes: [{type: plane, normal: [0, 0, 1], offset: -1.2, material: m}]}
  - {name: b0, position: [-1, -0.053, 0.994], rpy: [-0.79, -0.36, 0.9], mass: 0.792, shapes: [{type: box, size: [0.3, 0.2, 0.1], material: m}]}
  - {name: b1, position: [-0.3, -0.099, 0.427], rpy: [0.26, 0.61, -0.02], mass: 0.146, shapes: [{type: box, size: [0.3, 0.2, 0.1], material: m}]}
  - {name: b2, position: [0.4, -0.186, 0.693], rpy: [-0.43, 0.38, -0.67], mass: 0.172, shapes: [{type: box, size: [0.3, 0.2, 0.1], material: m}]}
joints:
  - {name: j0, type: slider, bodies: [b0, b1], anchor: [-0.432, 0.018, 0.329], axis: [-0.888, 0.598, 0.235], stiffness: 16.7, damping: 0.16}
  - {name: j1, type: hinge, bodies: [b0, b2], anchor: [0.17, -0.121, 0.705], axis: [0.992, 0.161, -0.31], stiffness: 17.7}
)";
  const Scene scene = parse_scene(text, "linkage.yaml", ".");
  const Observer go_on = [](const State&, const AdvanceReport&, const Auditor&) { return true; };
  const Audit audit = run_simulation(scene.model, scene.method, scene.run, std::nullopt, go_on).audit;
  EXPECT_TRUE(audit.violations.empty());
  EXPECT_GT(audit.report.coarse_steps, 100);
  EXPECT_LE(audit.report.angular_momentum_error.norm(), 1e-10);
  EXPECT_LE(audit.report.momentum_error.norm(), 1e-10);
  EXPECT_LE(audit.report.max_joint_drift, 1e-14);
}

}  // namespace
}  // namespace rigor::test::mechanisms_test
