// `scheme: auto` has a scheme for every scene that is shipped.

#include "rigor/io/scene/scene_reader.hpp"
#include "rigor/sim/make_stepper.hpp"
#include "rigor/sim/method/scheme_check.hpp"
#include "rigor/sim/method/scheme_choice.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <vector>

namespace rigor::auto_scenes_test {
namespace {

std::vector<std::filesystem::path> shipped_scenes() {
  std::vector<std::filesystem::path> scenes;
  for (const auto& entry : std::filesystem::directory_iterator(std::string(RIGOR_SOURCE_DIR) + "/scenes")) {
    if (entry.path().extension() == ".yaml") scenes.push_back(entry.path());
  }
  std::sort(scenes.begin(), scenes.end());
  return scenes;
}

TEST(AutoScenes, EveryShippedSceneHasASchemeThatTakesItsFirstSteps) {
  const std::vector<std::filesystem::path> scenes = shipped_scenes();
  ASSERT_GE(scenes.size(), 70u);
  for (const std::filesystem::path& path : scenes) {
    const Scene scene = read_scene(path, {"method.scheme=auto"});
    const ResolvedMethod resolved = resolve_scheme(*scene.model, scene.method);
    EXPECT_FALSE(resolved.scheme_reason.empty()) << path;
    EXPECT_TRUE(check_scheme(*scene.model, resolved.method).empty()) << path;
    State state = make_initial_state(*scene.model);
    const std::unique_ptr<Stepper> stepper = make_stepper(scene.model, scene.method, scene.run.step);
    const AdvanceReport report = stepper->advance(state, 2 * scene.run.step);
    EXPECT_EQ(report.reason, StopReason::reached_end) << path << ": " << report.detail;
    EXPECT_EQ(state.t, 2 * scene.run.step) << path;
  }
}

TEST(AutoScenes, BodiesThatBounceOnPilesThatRestAreLeftToHybrid) {
  // Every other scene of few bodies that collide is event-driven, but that of plain micro-collisions, which
  // one scheme alone has.
  for (const std::filesystem::path& path : shipped_scenes()) {
    const Scene scene = read_scene(path, {"method.scheme=auto"});
    if (scheme_facts(*scene.model, scene.method.contact_tolerance).colliding_bodies > 40) continue;
    const Scheme expected = path.stem() == "hail"         ? Scheme::hybrid
                            : path.stem() == "ramp_creep" ? Scheme::impulse_based
                                                          : Scheme::event_driven;
    EXPECT_EQ(resolve_scheme(*scene.model, scene.method).method.scheme, expected) << path;
  }
}

}  // namespace
}  // namespace rigor::auto_scenes_test
