// Scenes of impacts: every number that their headers promise.

#include "laws/scene_runs.hpp"
#include "solver/reference_data.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace rigor::test {
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

}  // namespace
}  // namespace rigor::test
