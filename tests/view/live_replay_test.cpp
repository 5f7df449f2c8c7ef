#include "rigor/view/live/live_replay.hpp"

#include "rigor/io/trajectory/trajectory_writer.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/sim/simulation.hpp"
#include "rigor/view/page/page_run.hpp"
#include "view/frame_reading.hpp"
#include "view/page_reading.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iterator>

namespace rigor::live_replay_test {
namespace {

/// A spinning plate whose centre of mass and axes are not those of its file, and a ball that bounces.
const std::string scene_text = R"(rigor: 1
name: replay
world: {gravity: [0, 0, -10]}
run: {duration: 1, output_interval: 0.05}
materials: [{name: rubber, restitution: 0.5}]
bodies:
  - {name: floor, motion: static, shapes: [{type: plane, normal: [0, 0, 1], offset: 0, material: rubber}]}
  - {name: ball, position: [0, 0, 1], mass: 1, shapes: [{type: sphere, radius: 0.1, material: rubber}]}
  - name: plate
    position: [2, 0, 9]
    rpy: [0.1, 0.2, 0.3]
    angular_velocity: [1, 2, 3]
    inertia: {mass: 2, center: [0.1, 0.2, 0], moments: [1, 1.5, 2], products: [0.1, 0, 0.2]}
)";

std::vector<PageBlock> frames_of(const std::vector<PageBlock>& blocks) {
  std::vector<PageBlock> frames;
  std::copy_if(blocks.begin(), blocks.end(), std::back_inserter(frames),
               [](const PageBlock& block) { return block.kind == "frames"; });
  return frames;
}

TEST(LiveReplay, HoldsTheMotionAndTheEventsOfTheRunThatWasStored) {
  std::string name = (std::filesystem::temp_directory_path() / "rigor_replay_XXXXXX").string();
  ASSERT_NE(::mkdtemp(name.data()), nullptr);
  const std::filesystem::path folder = name;
  // An override is part of what is stored.
  const std::vector<std::string> overrides = {"bodies.ball.velocity=[1, 0, 0]"};
  const Scene scene = parse_scene(scene_text, "replay.yaml", ".", overrides);
  TrajectoryHeader header{.scene = scene.name,
                          .scene_text = scene_text,
                          .overrides = overrides,
                          .method = scene.method,
                          .run = scene.run};
  for (const Body& body : scene.model->bodies()) header.bodies.push_back(body.name);
  const auto writer = make_trajectory_writer(folder / "run.h5", header);
  PageRun page(scene, make_initial_state(*scene.model));
  const RunResult result =
      run_simulation(scene.model, scene.method, scene.run, std::nullopt,
                     [&](const State& state, const AdvanceReport& since, const Auditor& auditor) {
                       writer->write(make_sample(*scene.model, state, auditor.energy()), since.events);
                       page.add(state, since, auditor.energy());
                       return true;
                     });
  writer->close(result.audit);
  const std::vector<PageBlock> expected = page.finish(result.audit);

  const LiveReplay replay = read_live_replay(folder / "run.h5");
  std::filesystem::remove_all(folder);
  EXPECT_EQ(replay.title, "replay");
  const PageScale scale = page_scale(*scene.model, make_initial_state(*scene.model));
  const test::ReadFrames a = test::read_frames(frames_of(expected), scale),
                         b = test::read_frames(frames_of(replay.blocks), scale);
  ASSERT_EQ(a.x.size(), 21u);
  ASSERT_EQ(b.x.size(), 21u);
  // The way from body frames to user frames and back rounds: at most one step of what is quantised.
  const auto largest = [](const Vec3& v) { return v.cwiseAbs().maxCoeff(); };
  for (std::size_t k = 0; k < a.x.size(); ++k) {
    ASSERT_EQ(b.x[k].size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_LE(largest(a.x[k][i] - b.x[k][i]), 1.001 * scale.position_step);
      EXPECT_LE(largest(a.v[k][i] - b.v[k][i]), 1.001 * a.speed_step);
      EXPECT_LE(largest(a.w[k][i] - b.w[k][i]), 1.001 * a.spin_step);
      EXPECT_LE(rotation_angle_between(a.q[k][i], b.q[k][i]), 2 * packing_error);
    }
  }
  const auto block = [](const std::vector<PageBlock>& blocks, const std::string& kind) {
    return test::inflated(*std::find_if(blocks.begin(), blocks.end(), [&kind](const PageBlock& candidate) {
      return candidate.kind == kind;
    }));
  };
  EXPECT_GT(result.audit.report.impacts, 0);
  EXPECT_EQ(block(replay.blocks, "events"), block(expected, "events"));
  const auto told = nlohmann::json::parse(block(replay.blocks, "header"));
  EXPECT_EQ(told["audit"]["events"]["impacts"], result.audit.report.impacts);
}

}  // namespace
}  // namespace rigor::live_replay_test
