// The motion within a step is found for those who ask for it, and changes nothing that is not asked.

#include "sim/time_stepping_scenes.hpp"

#include "rigor/core/work_count.hpp"
#include "rigor/sim/event_driven/event_driven_stepper.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rigor::plain_paths_test {
namespace {

/// Rods that swing on each other, let go horizontally. With a ball far away they may meet something.
std::shared_ptr<const Model> swinging_rods(int count, bool has_ball) {
  ModelBuilder builder = test::stepping_builder(0.5, 0, Vec3(0, 0, -9.81));
  for (int i = 0; i < count; ++i) {
    BodyDescription rod =
        test::stepping_body("rod" + std::to_string(i), Box{Vec3(0.4, 0.02, 0.02)}, Vec3(0.5 * i, 0, 0));
    rod.mask = 2;
    builder.add_body(rod);
    ModelBuilder::JointDescription joint;
    joint.name = "joint" + std::to_string(i);
    joint.type = JointType::hinge;
    joint.bodies = {i == 0 ? "world" : "rod" + std::to_string(i - 1), "rod" + std::to_string(i)};
    joint.anchors = {Vec3(0.5 * i - 0.25, 0, 0)};
    joint.axis = Vec3::UnitY();
    builder.add_joint(joint);
  }
  if (has_ball) {
    BodyDescription ball = test::stepping_body("ball", Sphere{0.1}, Vec3(100, 0, 0));
    ball.motion = MotionType::fixed;
    ball.group = 2;
    builder.add_body(ball);
  }
  return builder.build();
}

TEST(PlainPaths, WhatNobodyMeetsMovesWithTheSameBitsForLess) {
  for (int count = 1; count <= 4; ++count) {
    SCOPED_TRACE(count);
    std::uint64_t work[2];
    State ends[2];
    for (const bool has_ball : {false, true}) {
      const std::shared_ptr<const Model> model = swinging_rods(count, has_ball);
      State& state = ends[has_ball ? 1 : 0];
      state = make_initial_state(*model);
      EventDrivenStepper stepper(model, Method{}, 0.1);
      const std::uint64_t before = work_counted();
      for (int k = 1; k <= 20; ++k)
        ASSERT_EQ(stepper.advance(state, 0.05 * k).reason, StopReason::reached_end);
      work[has_ball ? 1 : 0] = work_counted() - before;
    }
    for (int i = 0; i < count; ++i) {
      EXPECT_EQ(ends[0].position(i), ends[1].position(i));
      EXPECT_EQ(ends[0].linear_momentum(i), ends[1].linear_momentum(i));
      EXPECT_EQ(ends[0].angular_momentum(i), ends[1].angular_momentum(i));
    }
    // Four of sixteen stages are for the path.
    EXPECT_LT(static_cast<double>(work[0]), 0.85 * static_cast<double>(work[1]));
  }
}

}  // namespace
}  // namespace rigor::plain_paths_test
