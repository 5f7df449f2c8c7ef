// Scenes of impacts: every number that their headers promise.

#include "laws/scene_runs.hpp"
#include "solver/reference_data.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace rigor::test::impact_scenes_test {
namespace {

std::vector<MotionEvent> impacts_of(const SceneRun& run) {
  std::vector<MotionEvent> impacts;
  for (const MotionEvent& event : run.events) {
    if (event.kind == MotionEvent::Kind::impact) impacts.push_back(event);
  }
  return impacts;
}

TEST(ImpactScenes, ObliqueBoxLeavesAsRouthsConstructionSays) {
  // Angle, velocity x and z before, μ, e; velocity x and z, angular velocity y after: given to 1e-6.
  struct Case {
    const char* law;
    std::vector<std::string> overrides;
    Vec3 after;
  };
  const std::vector<std::string> k0 = {"bodies.box.velocity=[1, 0, -2]", "materials.wood.friction=0.1"};
  const std::vector<std::string> k2 = {"bodies.box.velocity=[-2, 0, -2]", "materials.wood.friction=0.6",
                                       "bodies.box.axis_angle.angle=45 deg",
                                       "bodies.box.position=[0, 0, 0.4]"};
  const std::vector<Case> cases = {
      {"newton", k0, {.900278, -1.002781, -4.734566}},   {"poisson", k0, {.900278, -1.002781, -4.734566}},
      {"stronge", k0, {.900278, -1.002781, -4.734566}},  {"newton", {}, {-.968310, -1.059412, -4.868439}},
      {"poisson", {}, {-.945009, -1.137081, -4.549434}}, {"stronge", {}, {-.955022, -1.103704, -4.686519}},
      {"newton", k2, {-1.931310, -.782748, -5.252470}},  {"poisson", k2, {-1.759024, -1.084617, -4.783913}},
      {"stronge", k2, {-1.815381, -.985871, -4.937186}}};
  for (const Case& each : cases) {
    std::vector<std::string> overrides = each.overrides;
    overrides.push_back(std::string("method.impact=") + each.law);
    const SceneRun run = run_scene("oblique_box.yaml", overrides);
    const auto& box = run.end_of("box");
    EXPECT_EQ(run.audit().report.impacts, 1) << each.law;
    EXPECT_NEAR(box.velocity.x(), each.after.x(), 1e-6) << each.law;
    EXPECT_NEAR(box.velocity.z(), each.after.y(), 1e-6) << each.law;
    EXPECT_NEAR(box.angular_velocity.y(), each.after.z(), 1e-6) << each.law;
    // The edge strikes with both its ends at once: nothing turns the box out of its plane.
    EXPECT_NEAR(box.velocity.y(), 0, 1e-13);
    EXPECT_NEAR(box.angular_velocity.x(), 0, 1e-12);
    EXPECT_NEAR(box.angular_velocity.z(), 0, 1e-12);
  }
}

TEST(ImpactScenes, SuperballReversesTheVelocityOfThePointThatTouches) {
  // Garwin: v⁺ = (3 v - 4 R ω)/7, R ω⁺ = -(3 R ω + 10 v)/7 on the floor, with x along v and ω about y; under
  // the table the same with -R.
  const SceneRun run = run_scene("superball.yaml");
  ASSERT_EQ(run.audit().report.impacts, 3);
  double v = 3, spin = 0;
  for (const double side : {1.0, -1.0, 1.0}) {
    // The velocity of the touching point, u = v - side R ω, is reversed; L about that point stays.
    const double after = (3 * v + 4 * side * spin) / 7;
    spin = (10 * side * v - 3 * spin) / 7;
    v = after;
  }
  const auto& ball = run.end_of("ball");
  EXPECT_NEAR(ball.velocity.x(), v, 1e-13);
  EXPECT_NEAR(0.03 * ball.angular_velocity.y(), spin, 1e-13);
  EXPECT_NEAR(ball.velocity.z(), 4, 1e-13);
  EXPECT_NEAR(run.audit().final.total() / run.audit().initial.total(), 1, 1e-14);
}

TEST(ImpactScenes, BackspinGoesBounceByBounceUntilTheBallRolls) {
  const double g = 9.81, R = 0.11, v_n = std::sqrt(2 * g), loss = 0.1 * 1.6 * v_n;
  const SceneRun first = run_scene("backspin.yaml", {"run.duration=0.5"});
  EXPECT_EQ(first.audit().report.impacts, 1);
  EXPECT_NEAR(first.end_of("ball").velocity.x(), 4 - loss, 1e-13);
  EXPECT_NEAR(first.end_of("ball").angular_velocity.y(), -60 + 2.5 * loss / R, 1e-12);
  const SceneRun run = run_scene("backspin.yaml");
  EXPECT_TRUE(run.audit().violations.empty());
  // Angular momentum about the lane.
  const double rolls = (4 + 0.4 * R * -60) / 1.4;
  EXPECT_NEAR(run.end_of("ball").velocity.x(), rolls, 1e-10);
  EXPECT_NEAR(run.end_of("ball").angular_velocity.y() * R, rolls, 1e-10);
}

TEST(ImpactScenes, RodTurnsOnIceAndSticksOnRubber) {
  const double v = std::sqrt(2 * 9.81 * 0.4), e = 0.5, arm = 0.5 * std::sqrt(0.5), I = 1.0 / 12;
  const double impulse = (1 + e) * v / 2.5;
  const SceneRun ice = run_scene("rod.yaml");
  EXPECT_EQ(ice.audit().report.impacts, 1);
  EXPECT_NEAR(ice.end_of("rod").angular_velocity.y(), impulse * arm / I, 1e-10);
  EXPECT_EQ(ice.end_of("rod").velocity.x(), 0);
  // On rubber the end has no tangential velocity after the impact, and e times the normal one.
  const SceneRun rubber = run_scene("rod.yaml", {"materials.ice.friction=1.5"});
  const std::vector<MotionEvent> impacts = impacts_of(rubber);
  ASSERT_EQ(impacts.size(), 1u);
  const Vec3 j = impacts[0].j_W, centre(0, 0, 0.01 + arm);
  const Vec3 r = impacts[0].p_W - centre;
  const Vec3 turning = r.cross(j) / I;
  const Vec3 tip = Vec3(0, 0, -v) + j + turning.cross(r);
  EXPECT_NEAR(tip.x(), 0, 1e-9);
  EXPECT_NEAR(tip.z(), e * v, 1e-9);
}

TEST(ImpactScenes, DieFallsAsTheReferenceThroughEightImpacts) {
  for (const nlohmann::json& json : reference::read("cube_drop.json")["cases"]) {
    const std::string law = json["law"].get<std::string>();
    SCOPED_TRACE(law);
    const SceneRun run = run_scene("dice.yaml", {"method.impact=" + law, "run.duration=0.9",
                                                 "run.output_interval=0.9", "method.time_tolerance=1e-15"});
    const std::vector<MotionEvent> impacts = impacts_of(run);
    ASSERT_GE(impacts.size(), 8u);
    for (std::size_t k = 0; k < 8; ++k) {
      const nlohmann::json& expected = json["impacts"][k];
      EXPECT_NEAR(impacts[k].time, expected["time"].get<double>(), 1e-11) << k;
      EXPECT_LT((impacts[k].j_W - Vec3(reference::vector(expected["lambda"]))).norm(), 1e-9) << k;
    }
  }
}

// Newton's law on both contacts holds the right one, which parts, at u_n⁺ = 0 while it presses.
TEST(ImpactScenes, NewtonsLawOnAllContactsAddsEnergyToALightBallBetweenHeavyOnes) {
  const double before = 25.0 / 4, gained = 605.0 / 76;
  EXPECT_NEAR(gained / before, 121.0 / 95, 1e-15);
  for (const char* law : {"lcp", "projection"}) {
    const SceneRun run = run_scene("energy_gain.yaml", {std::string("method.simultaneous=") + law});
    EXPECT_NEAR(run.audit().initial.total(), before, 1e-14);
    EXPECT_NEAR(run.audit().final.total(), gained, 1e-13) << law;
    EXPECT_NEAR(run.audit().report.impact_gain, gained - before, 1e-13) << law;
    EXPECT_NEAR(run.end_of("left").velocity.x(), 7.0 / 38, 1e-14) << law;
    EXPECT_NEAR(run.end_of("light").velocity.x(), 45.0 / 38, 1e-14) << law;
    EXPECT_NEAR(run.end_of("right").velocity.x(), 45.0 / 38, 1e-14) << law;
    EXPECT_EQ(run.audit().warnings.size(), 1u) << law;
  }
  for (const char* law : {"moreau", "reflections", "sequential"}) {
    const SceneRun run = run_scene("energy_gain.yaml", {std::string("method.simultaneous=") + law});
    EXPECT_NEAR(run.audit().final.total(), before, 1e-13) << law;
    EXPECT_LE(run.audit().report.impact_gain, 1e-13) << law;
    EXPECT_TRUE(run.audit().warnings.empty()) << law;
    EXPECT_TRUE(run.audit().violations.empty()) << law;
  }
}

}  // namespace
}  // namespace rigor::test::impact_scenes_test
