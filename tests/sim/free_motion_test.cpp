#include "rigor/sim/time_stepping/free_motion.hpp"

#include "rigor/core/work_count.hpp"
#include "rigor/sim/time_stepping/part_memory.hpp"
#include "sim/time_stepping_scenes.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace rigor::free_motion_test {
namespace {

/// A chain of four rods on ball joints that swings, and a ball that flies by itself.
std::shared_ptr<const Model> chain_and_ball() {
  ModelBuilder builder = test::stepping_builder(0, 0.5, Vec3(0, 0, -9.81));
  for (int i = 0; i < 4; ++i) {
    const std::string name = "rod" + std::to_string(i);
    builder.add_body(test::stepping_body(name, Box{Vec3(0.2, 0.02, 0.03)}, Vec3(0.5 * i, 0, 3)));
    ModelBuilder::JointDescription joint;
    joint.name = "joint" + std::to_string(i);
    joint.type = JointType::ball;
    joint.bodies = {i == 0 ? "world" : "rod" + std::to_string(i - 1), name};
    joint.anchors = {Vec3(0.5 * i - 0.25, 0, 3)};
    builder.add_joint(joint);
  }
  BodyDescription ball = test::stepping_body("ball", Sphere{0.1}, Vec3(0, 1, 3));
  ball.velocity = Vec3(1, 0, 2);
  builder.add_body(ball);
  return builder.build();
}

struct Scene {
  std::shared_ptr<const Model> model = chain_and_ball();
  Method method;
  Environment environment{*model};
  ContactSystemAssembler assembler{*model, environment};
  JointProjection joints{*model, assembler};
  FreeMotion motion{*model, environment, assembler, joints, method};

  Cluster all() const {
    const State state = make_initial_state(*model);
    Cluster part;
    for (int i = 0; i < model->body_count(); ++i) {
      if (model->body(i).motion != MotionType::dynamic) continue;
      part.bodies.push_back(i);
      part.phases.push_back(
          {state.position(i), state.orientation(i), state.linear_momentum(i), state.angular_momentum(i)});
    }
    return part;
  }
};

TEST(FreeMotion, BodiesThatNothingConnectsDoNotChangeEachOther) {
  const Scene scene;
  const Cluster all = scene.all();
  Cluster chain = all, ball = all;
  chain.bodies.pop_back();
  chain.phases.pop_back();
  ball.bodies = {all.bodies.back()};
  ball.phases = {all.phases.back()};
  FreeMotionMemory of_all, of_chain, of_ball;
  AdvanceReport report;
  const FreeEnd together = scene.motion.fly(0.02, all, of_all, report);
  FreeEnd apart = scene.motion.fly(0.02, chain, of_chain, report);
  const FreeEnd flight = scene.motion.fly(0.02, ball, of_ball, report);
  apart.phases.push_back(flight.phases.front());
  EXPECT_TRUE(are_same_phases(together.phases, apart.phases));
  // The parabola of the ball.
  const Vec3 x = all.phases.back().x + 0.02 * Vec3(1, 0, 2) - 0.5 * 9.81 * 0.02 * 0.02 * Vec3::UnitZ();
  EXPECT_LE((together.phases.back().x - x).norm(), 1e-15);
  EXPECT_LE((together.impulse - apart.impulse - flight.impulse).norm(), 1e-14);
}

TEST(FreeMotion, IsIntegratedOnceForAllTriesOfAStep) {
  const Scene scene;
  Cluster part = scene.all();
  FreeMotionMemory memory;
  AdvanceReport first, second, other;
  const std::uint64_t begin = work_counted();
  const FreeEnd fresh = scene.motion.fly(0.02, part, memory, first);
  const std::uint64_t middle = work_counted();
  EXPECT_GT(middle, begin);
  // What does not hold the chain has no part in the question.
  part.phases.back().P += Vec3(0, 1, 0);
  const FreeEnd again = scene.motion.fly(0.02, part, memory, second);
  EXPECT_EQ(work_counted(), middle);
  EXPECT_EQ(first.steps, second.steps);
  for (std::size_t i = 0; i + 1 < part.bodies.size(); ++i) {
    EXPECT_EQ(fresh.phases[i].x, again.phases[i].x);
    EXPECT_EQ(fresh.phases[i].P, again.phases[i].P);
  }
  // Another start or length is another question; so is another step.
  scene.motion.fly(0.01, part, memory, other);
  const std::uint64_t shorter = work_counted();
  EXPECT_GT(shorter, middle);
  part.phases.front().L += Vec3(0, 1e-9, 0);
  scene.motion.fly(0.02, part, memory, other);
  const std::uint64_t elsewhere = work_counted();
  EXPECT_GT(elsewhere, shorter);
  memory.clear();
  scene.motion.fly(0.02, part, memory, other);
  EXPECT_GT(work_counted(), elsewhere);
}

}  // namespace
}  // namespace rigor::free_motion_test
