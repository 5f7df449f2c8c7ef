#include "rigor/view/live/live_run.hpp"

#include "rigor/core/input_error.hpp"
#include "rigor/io/trajectory/checkpoint.hpp"
#include "rigor/io/trajectory/fingerprint.hpp"
#include "view/live_scenes.hpp"
#include "view/page_reading.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

namespace rigor::live_run_test {
namespace {

using test::ball_index;
using test::live_scene;

void go_to(LiveRun& run, double time) {
  while (run.time() < time - 1e-9) run.step();
}
double height(const LiveRun& run) {
  return run.state().position(ball_index).z();
}
Vec3 velocity(const LiveRun& run) {
  return run.state().linear_momentum(ball_index);  // its mass is 1 kg
}

TEST(LiveRun, StepsGoFromOutputTimeToOutputTime) {
  LiveRun run(live_scene());
  run.step();
  EXPECT_EQ(run.time(), 0.01);
  run.advance(0.004);
  EXPECT_DOUBLE_EQ(run.time(), 0.014);
  run.step();
  EXPECT_EQ(run.time(), 0.02);
  EXPECT_EQ(run.recorded_frames(), 3u);
}

TEST(LiveRun, FallsAsARunOfTheSceneDoes) {
  LiveRun run(live_scene());
  go_to(run, 0.3);
  EXPECT_NEAR(height(run), 1 - 0.5 * 10 * 0.09, 1e-12);
}

TEST(LiveRun, WithoutGravityTheBallGoesOnStraightFromWhereItIs) {
  LiveRun run(live_scene());
  go_to(run, 0.2);
  run.set_gravity(Vec3::Zero());
  EXPECT_DOUBLE_EQ(height(run), 0.8) << "the past stays what it was";
  go_to(run, 0.3);
  // It keeps the 2 m/s that it had.
  EXPECT_NEAR(height(run), 0.8 - 2 * 0.1, 1e-12);
}

TEST(LiveRun, ResetGoesBackToTheStartAndKeepsTheChanges) {
  LiveRun run(live_scene());
  run.set_gravity(Vec3::Zero());
  run.push(ball_index, Vec3::Zero(), Vec3(0, 0, 1));
  go_to(run, 0.2);
  run.reset();
  EXPECT_EQ(run.time(), 0);
  EXPECT_EQ(run.recorded_frames(), 1u);
  go_to(run, 0.2);
  EXPECT_EQ(height(run), 1);
}

TEST(LiveRun, RestitutionOfTheNextImpactIsThatOfTheSlider) {
  for (const double restitution : {0.0, 1.0}) {
    LiveRun run(live_scene());
    run.set_surface("rubber", std::nullopt, restitution);
    // Falls 0.9 m in 0.4243 s.
    go_to(run, 0.45);
    const double impact = std::sqrt(2 * 0.9 / 10), speed = restitution * 10 * impact;
    EXPECT_NEAR(velocity(run).z(), restitution > 0 ? speed - 10 * (0.45 - impact) : 0, 1e-9);
  }
}

TEST(LiveRun, AnImpulseChangesMomentumAndAngularMomentum) {
  LiveRun run(live_scene());
  run.push(ball_index, Vec3(0, 0, 0.1), Vec3(3, 0, 0));
  EXPECT_EQ(velocity(run), Vec3(3, 0, 0));
  // r × j = (0, 0, 0.1) × (3, 0, 0) = (0, 0.3, 0).
  EXPECT_TRUE(run.state().angular_momentum(ball_index).isApprox(Vec3(0, 0.3, 0), 1e-14));
  EXPECT_THROW(run.push(test::floor_index, Vec3::Zero(), Vec3(1, 0, 0)), InputError);
  EXPECT_THROW(run.push(7, Vec3::Zero(), Vec3(1, 0, 0)), InputError);
}

TEST(LiveRun, APulledBallComesToRestBelowItsTargetByItsWeightOverTheSpring) {
  LiveRun run(live_scene());
  run.pull({ball_index, Vec3::Zero(), Vec3(1, 0, 1)});
  go_to(run, 4);
  // The spring sags by g / ω², which is a twentieth of the ball's radius (the length of this scene).
  EXPECT_TRUE(run.state().position(ball_index).isApprox(Vec3(1, 0, 1 - 0.1 / 20), 1e-6))
      << run.state().position(ball_index).transpose();
  run.release();
  go_to(run, 4.1);
  EXPECT_NEAR(velocity(run).z(), -1, 1e-6) << "free again, it falls";
}

TEST(LiveRun, WhatMakesNoSenseIsRefusedAndChangesNothing) {
  LiveRun run(live_scene());
  const State before = run.state();
  EXPECT_THROW(run.set_surface("rubber", -1.0, std::nullopt), InputError);
  EXPECT_THROW(run.set_surface("steel", 0.1, std::nullopt), InputError);
  // As in a scene file.
  for (const double step : {0.0, -1.0, 9e-13, 2e9, std::nan("")})
    EXPECT_THROW(run.set_target_step(step), InputError);
  EXPECT_THROW(run.set_method("integrator", "rk5"), InputError);
  EXPECT_THROW(run.set_gravity(Vec3(0, 0, 1e9)), InputError);
  EXPECT_EQ(run.state(), before);
  EXPECT_EQ(run.changes().surfaces[1].friction, 0.2);
  EXPECT_EQ(run.changes().g_W, Vec3(0, 0, -10));
}

TEST(LiveRun, EveryChoiceOfTheMethodCanBeTaken) {
  for (const std::string& key : method_choice_keys()) {
    for (const std::string& value : method_values(key)) {
      LiveRun run(live_scene());
      run.step();
      // A matrix goes with the integrators that turn one.
      if (key == "orientation") run.set_method("integrator", "rk4");
      // Only the impulse-based scheme has micro-collisions.
      if (key == "micro_collisions") run.set_method("scheme", "impulse-based");
      run.set_method(key, value);
      EXPECT_EQ(method_choice(run.method(), key), value);
      run.step();
      EXPECT_EQ(run.stop_text(), "");
    }
  }
}

TEST(LiveRun, ACombinationThatMakesNoSenseIsRefused) {
  LiveRun run(live_scene());
  run.set_method("integrator", "lie-rk4");
  EXPECT_THROW(run.set_method("orientation", "matrix"), InputError);
  EXPECT_EQ(method_choice(run.method(), "orientation"), "quaternion");
}

TEST(LiveRun, ItsCheckpointGoesOnBitForBitInTheSceneWithTheSameChanges) {
  LiveRun run(live_scene());
  run.set_gravity(Vec3(0, 0, -5));
  go_to(run, 0.1);
  const std::filesystem::path path = std::filesystem::temp_directory_path() / "rigor_live_test.checkpoint";
  std::ofstream(path, std::ios::binary) << run.checkpoint();
  const Scene changed = parse_scene(test::live_ball, "live.yaml", ".", {"world.gravity=[0, 0, -5]"});
  const Checkpoint checkpoint =
      read_checkpoint(path, fingerprint(*changed.model, changed.method, changed.run.step), *changed.model);
  EXPECT_EQ(checkpoint.state, run.state());
  std::filesystem::remove(path);
}

TEST(LiveRun, ThePageOfTheRecordingHoldsItsFramesAndTheRunGoesOn) {
  LiveRun run(live_scene());
  go_to(run, 0.1);
  const std::string page = run.page();
  EXPECT_NE(page.find("data-kind=\"frames\""), std::string::npos);
  EXPECT_NE(page.find("<title>live ball · Rigor</title>"), std::string::npos);
  EXPECT_EQ(page, run.page());
  run.step();
  EXPECT_EQ(run.recorded_frames(), 12u);
}

TEST(LiveRun, AFrameHoldsTheBallAndItsContacts) {
  LiveRun run(live_scene());
  run.set_surface("rubber", std::nullopt, 0.0);
  go_to(run, 0.5);
  test::BytesReader frame(run.frame(3));
  EXPECT_EQ(frame.take<std::uint32_t>(), 1u);  // kind
  EXPECT_EQ(frame.take<std::uint32_t>(), 3u);  // generation
  EXPECT_EQ(frame.take<std::uint32_t>(), 1u);  // bodies that are not static
  EXPECT_EQ(frame.take<std::uint32_t>(), 1u);  // contacts
  const std::uint32_t series = frame.take<std::uint32_t>();
  EXPECT_EQ(frame.take<double>(), 0.5);
  EXPECT_EQ(frame.take<double>(), 0.5) << "the first of the series is the time";
  for (std::uint32_t i = 1; i < series; ++i) frame.take<double>();
  // Position from the start of the only body that moves: it lies 0.9 m lower.
  EXPECT_FLOAT_EQ(frame.take<float>(), 0);
  EXPECT_FLOAT_EQ(frame.take<float>(), 0);
  EXPECT_NEAR(frame.take<float>(), -0.9, 1e-6);
  for (int i = 0; i < 10; ++i) frame.take<float>();
  EXPECT_EQ(frame.take<std::uint32_t>(), 0u);
  EXPECT_EQ(frame.take<std::uint32_t>(), 1u);
  EXPECT_EQ(frame.take<std::uint32_t>(), static_cast<std::uint32_t>(TouchingPoint::Mode::stick));
  for (int i = 0; i < 9; ++i) frame.take<float>();
  EXPECT_NEAR(frame.take<float>(), 10, 1e-4) << "the floor carries the ball's weight";
}

TEST(LiveRun, BodiesThatOverlapAreRefused) {
  std::string text = test::live_ball;
  text.replace(text.find("[0, 0, 1], mass"), 9, "[0, 0, 0]");
  EXPECT_THROW(LiveRun run(live_scene(text)), InputError);
}

TEST(LiveRun, GoesBackFromOutputTimeToOutputTimeToTheStatesThatWereThere) {
  LiveRun run(live_scene());
  std::vector<State> seen = {run.state()};
  for (int k = 0; k < 60; ++k) {
    run.step();
    seen.push_back(run.state());
  }
  EXPECT_EQ(run.earlier_count(), 60u);
  // From between two output times to the one before, then from one to the next.
  run.advance(0.004);
  for (std::size_t k = 61; k-- > 0;) {
    run.go_back();
    EXPECT_EQ(run.time(), seen[k].t);
    EXPECT_EQ(run.state().position(ball_index), seen[k].position(ball_index));
    EXPECT_EQ(run.state().linear_momentum(ball_index), seen[k].linear_momentum(ball_index));
    EXPECT_EQ(run.history().rows().back()[0], seen[k].t);
  }
  run.go_back();
  EXPECT_EQ(run.time(), 0);
  EXPECT_EQ(run.earlier_count(), 0u);
  // The impact that was undone has not happened; it comes again.
  EXPECT_EQ(run.history().events().size(), 0u);
  go_to(run, 0.6);
  EXPECT_NEAR((run.state().position(ball_index) - seen[60].position(ball_index)).norm(), 0, 1e-12);
  EXPECT_GT(run.history().events().size(), 0u);
}

const std::string hinged = R"(rigor: 1
name: hinged
world: {gravity: [0, 0, 0]}
run: {duration: 1, output_interval: 0.01}
materials: [{name: steel}]
bodies:
  - {name: wheel, position: [0, 0, 1], mass: 1, shapes: [{type: cylinder, radius: 0.5, length: 0.1, material: steel}]}
joints:
  - {name: axle, type: hinge, bodies: [world, wheel], anchor: [0, 0, 1], axis: [0, 0, 1]}
)";

TEST(LiveRun, AMotorOfAJointIsSetAndLetGo) {
  LiveRun run(live_scene(hinged));
  const auto spin = [&] { return angular_velocity(*run.scene().model, run.state(), 0).z(); };
  run.set_motor(0, 0, 2);
  go_to(run, 0.1);
  EXPECT_NEAR(spin(), 2, 1e-9);
  run.set_motor(0, 0, -1);
  go_to(run, 0.2);
  EXPECT_NEAR(spin(), -1, 1e-9);
  // Without a motor and friction it turns on; a new motor finds it so.
  run.set_motor(0, 0, std::nullopt);
  EXPECT_FALSE(run.laws(0, 0).motor);
  go_to(run, 0.3);
  EXPECT_NEAR(spin(), -1, 1e-9);
  EXPECT_THROW(run.set_motor(1, 0, 1), InputError);
  EXPECT_THROW(run.set_motor(0, 1, 1), InputError);
  EXPECT_THROW(run.set_rest(0, 0, 1), InputError);
}

}  // namespace
}  // namespace rigor::live_run_test
