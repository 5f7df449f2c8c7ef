#include "rigor/model/model_builder.hpp"
#include "rigor/sim/simulation.hpp"

#include <gtest/gtest.h>

namespace rigor::impact_gain_test {
namespace {

/// A light ball between two heavy ones, all touching; the left one runs into it, the right one runs off.
std::shared_ptr<const Model> light_ball_between_heavy_ones() {
  ModelBuilder builder;
  builder.add_material({"m", 1000, 0, 1});
  const double masses[] = {10, 10.0 / 9, 10}, speeds[] = {1, 0, 0.5};
  for (int i = 0; i < 3; ++i) {
    BodyDescription ball;
    ball.name = "ball" + std::to_string(i);
    ball.p_WU = Vec3(0.2 * i, 0, 0);
    ball.velocity = Vec3(speeds[i], 0, 0);
    ball.mass = masses[i];
    ball.shapes.push_back({Sphere{0.1}, Vec3::Zero(), Quat::Identity(), "m", ""});
    builder.add_body(ball);
  }
  return builder.build();
}

Audit audit_with(SimultaneousLaw law) {
  Method method;
  method.simultaneous = law;
  RunSettings settings;
  settings.duration = 0.01;
  return run_simulation(light_ball_between_heavy_ones(), method, settings, std::nullopt,
                        [](const State&, const AdvanceReport&, const Auditor&) { return true; })
      .audit;
}

TEST(ImpactGain, EnergyThatNewtonsLawOnAllContactsAddsIsReportedAndNamed) {
  const Audit audit = audit_with(SimultaneousLaw::lcp);
  // 25/4 J before, 605/76 J after.
  EXPECT_NEAR(audit.report.impact_gain, 605.0 / 76 - 25.0 / 4, 1e-13);
  ASSERT_EQ(audit.warnings.size(), 1u);
  EXPECT_NE(audit.warnings[0].find("impacts added 1.71 J"), std::string::npos) << audit.warnings[0];
  EXPECT_NE(audit.warnings[0].find("`lcp`"), std::string::npos) << audit.warnings[0];
}

TEST(ImpactGain, OtherLawsAddNone) {
  for (const SimultaneousLaw law : {SimultaneousLaw::reflections, SimultaneousLaw::sequential}) {
    const Audit audit = audit_with(law);
    EXPECT_LE(audit.report.impact_gain, 1e-14);
    EXPECT_TRUE(audit.warnings.empty());
  }
}

}  // namespace
}  // namespace rigor::impact_gain_test
