#include "apps/cost_estimate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

namespace rigor::cost_estimate_test {
namespace {

/// A scene file of balls that fall side by side, which is gone with this object.
class BallScene {
 public:
  BallScene(const std::string& name, const std::string& method, double duration)
      : path_(std::filesystem::path(testing::TempDir()) / ("cost_estimate_" + name + ".yaml")) {
    std::ofstream file(path_);
    file << "rigor: 1\nrun: {duration: " << duration << ", step: 0.01}\nmethod: " << method
         << "\nmaterials: [{name: steel, density: 7800, friction: 0.3, restitution: 0.5}]\nbodies:\n"
            "  - {name: floor, motion: static, shapes: [{type: plane, material: steel}]}\n";
    for (int i = 0; i < 3; ++i)
      file << "  - {name: ball" << i << ", position: [" << i
           << ", 0, 0.3], shapes: [{type: sphere, radius: 0.1, material: steel}]}\n";
  }
  ~BallScene() { std::filesystem::remove(path_); }
  BallScene(const BallScene&) = delete;
  BallScene& operator=(const BallScene&) = delete;

  std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

const SchemeCost* find_scheme(const CostEstimate& estimate, const std::string& name) {
  const auto it = std::find_if(estimate.schemes.begin(), estimate.schemes.end(),
                               [&](const SchemeCost& cost) { return cost.scheme == name; });
  return it == estimate.schemes.end() ? nullptr : &*it;
}

TEST(CostEstimate, AQuickRunIsMeasuredWhole) {
  const BallScene scene("quick", "{scheme: time-stepping}", 0.5);
  const CostEstimate estimate = estimate_costs(
      scene.path(), [](const std::string&) {}, [] { return false; });

  ASSERT_FALSE(estimate.schemes.empty());
  EXPECT_EQ(estimate.schemes.front().scheme, "as written");
  EXPECT_DOUBLE_EQ(estimate.duration, 0.5);
  EXPECT_NEAR(estimate.pilot_duration, 0.5, 1e-12);
  for (const std::string scheme : {"event-driven", "time-stepping", "hybrid", "penalty", "solver: substep"}) {
    const SchemeCost* const cost = find_scheme(estimate, scheme);
    ASSERT_NE(cost, nullptr) << scheme;
    EXPECT_GT(cost->cpu_time, 0) << scheme;
  }
  const SchemeCost& steps = *find_scheme(estimate, "time-stepping");
  EXPECT_FALSE(steps.is_at_least);
  EXPECT_EQ(steps.note, "");
}

TEST(CostEstimate, ALongRunIsForeseenInProportion) {
  // 1e6 s cannot be run within the time of the measurement.
  const BallScene scene("long", "{scheme: time-stepping}", 1e6);
  const CostEstimate estimate = estimate_costs(
      scene.path(), [](const std::string&) {}, [] { return false; }, EstimateBudget{0.1, 0.05, 0.05});

  const SchemeCost* const cost = find_scheme(estimate, "as written");
  ASSERT_NE(cost, nullptr);
  EXPECT_GT(cost->cpu_time, 60);
  EXPECT_NE(cost->note, "");
}

TEST(CostEstimate, AnInterruptEndsItBeforeTheFirstScheme) {
  const BallScene scene("interrupted", "{scheme: time-stepping}", 1e6);
  const CostEstimate estimate = estimate_costs(
      scene.path(), [](const std::string&) {}, [] { return true; });
  EXPECT_LE(estimate.schemes.size(), 1U);
}

TEST(CostEstimate, ItsTextNamesEachSchemeAndWhatIsABound) {
  const CostEstimate estimate{2, 1.5, {{"as written", 3.2, false, ""}, {"penalty", 70, true, "foreseen"}}};
  const std::string text = estimate_text(estimate);
  EXPECT_NE(text.find("2 s of motion"), std::string::npos);
  EXPECT_NE(text.find("came to t = 1.5 s"), std::string::npos);
  EXPECT_NE(text.find("3.2 s"), std::string::npos);
  EXPECT_NE(text.find("more than 70 s  foreseen"), std::string::npos);
}

}  // namespace
}  // namespace rigor::cost_estimate_test
