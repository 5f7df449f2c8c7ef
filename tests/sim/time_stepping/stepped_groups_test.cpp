// Groups of bodies that do not come near each other in a step are moved side by side, each by itself.

#include "random_vectors.hpp"
#include "rigor/core/work_count.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/sim/time_stepping/time_stepper.hpp"

#include "sim/time_stepping_scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>

namespace rigor::stepped_groups_test {
namespace {

constexpr double step = 0.01, interval = 0.02;

ModelBuilder::JointDescription ball_joint(const std::string& A, const std::string& B, const Vec3& anchor) {
  ModelBuilder::JointDescription joint;
  joint.name = A + "_" + B;
  joint.type = JointType::ball;
  joint.bodies = {A, B};
  joint.anchors = {anchor};
  return joint;
}

/// Some small heaps that fall askew, with a joint in each, a ball that rolls from the first to the second,
/// and a pendulum.
std::shared_ptr<const Model> field(unsigned seed) {
  test::Random random(seed);
  ModelBuilder builder = test::stepping_builder(0.2, 0.5, Vec3(0, 0, -9.81));
  for (int k = 0; k < 4; ++k) {
    for (int i = 0; i < 5; ++i) {
      const double size = 0.05 + 0.02 * random.number();
      const Shape shape = i % 2 == 0 ? Shape(Box{Vec3(size, 0.8 * size, 0.6 * size)}) : Shape(Sphere{size});
      const double x = 0.7 * k + 0.02 * random.number(), y = 0.02 * random.number();
      BodyDescription body =
          test::stepping_body("h" + std::to_string(k) + std::to_string(i), shape, Vec3(x, y, 0.1 + 0.17 * i));
      body.q_WU = rotation_exp(random.vector()).normalized();
      body.velocity = 0.3 * random.vector();
      builder.add_body(body);
    }
    builder.add_joint(
        ball_joint("h" + std::to_string(k) + "1", "h" + std::to_string(k) + "2", Vec3(0.7 * k, 0, 0.355)));
  }
  BodyDescription roller = test::stepping_body("roller", Sphere{0.05}, Vec3(0.2, 0, 0.05));
  roller.velocity = Vec3(2, 0, 0);
  builder.add_body(roller);
  builder.add_body(test::stepping_body("bob", Sphere{0.05}, Vec3(0, 3, 1)));
  builder.add_joint(ball_joint("world", "bob", Vec3(0.3, 3, 1.4)));
  return builder.build();
}

TEST(SteppedGroups, AnyNumberOfThreadsAndFreshSteppersGiveTheSameBits) {
  std::size_t most_groups = 0;
  for (const unsigned seed : {1u, 2u, 3u}) {
    const std::shared_ptr<const Model> model = field(seed);
    State of_one = make_initial_state(*model), of_two = of_one, of_three = of_one;
    TimeStepper one(model, Method{}, step, 1), two(model, Method{}, step, 2), three(model, Method{}, step, 3);
    for (int k = 1; k <= 40; ++k) {
      const double t = interval * k;
      State of_fresh = of_one;
      const AdvanceReport by_one = one.advance(of_one, t), by_two = two.advance(of_two, t),
                          by_three = three.advance(of_three, t),
                          by_fresh = TimeStepper(model, Method{}, step, 2).advance(of_fresh, t);
      ASSERT_EQ(by_one.reason, StopReason::reached_end) << by_one.detail;
      ASSERT_EQ(by_one.passages.instants, 0);
      EXPECT_LE(by_one.max_penetration, 1e-6);
      ASSERT_EQ(of_one, of_two) << "seed " << seed << ", t = " << t;
      ASSERT_EQ(of_one, of_three) << "seed " << seed << ", t = " << t;
      ASSERT_EQ(of_one, of_fresh) << "seed " << seed << ", t = " << t;
      for (const AdvanceReport* const other : {&by_two, &by_three, &by_fresh}) {
        ASSERT_EQ(by_one.momentum_error, other->momentum_error);
        ASSERT_EQ(by_one.impact_loss, other->impact_loss);
        ASSERT_EQ(by_one.step_work, other->step_work);
        ASSERT_EQ(by_one.events.size(), other->events.size());
        for (std::size_t i = 0; i < by_one.events.size(); ++i)
          ASSERT_EQ(by_one.events[i].time, other->events[i].time);
      }
      const auto shown = one.contacts_of(of_one), shown_by_two = two.contacts_of(of_two);
      ASSERT_EQ(shown->size(), shown_by_two->size());
      for (std::size_t i = 0; i < shown->size(); ++i)
        ASSERT_EQ((*shown)[i].force_W, (*shown_by_two)[i].force_W);
      most_groups = std::max(most_groups, one.group_count());
    }
  }
  EXPECT_GE(most_groups, 4u);
}

/// Balls in air: a heavy one strikes a light one, which becomes twice as fast and comes, in the same step, to
/// a third one that no speed before the step reaches.
TEST(SteppedGroups, GroupsThatMeetUnforeseenAreMovedAsOne) {
  ModelBuilder builder = test::stepping_builder(1, 0.1, Vec3::Zero());
  const auto add = [&](const std::string& name, double x, double mass, double speed) {
    BodyDescription body = test::stepping_body(name, Sphere{0.05}, Vec3(x, 0, 1));
    body.mass = mass;
    body.velocity = Vec3(speed, 0, 0);
    body.linear_damping = 0.01;
    builder.add_body(body);
  };
  add("heavy", 0, 100, 3);
  add("light", 0.15, 0.01, 0);
  add("struck", 0.55, 1, 0);
  add("far", 3, 1, 1);
  add("farther", 3.2, 1, 1);
  builder.add_joint(ball_joint("far", "farther", Vec3(3.1, 0, 1)));
  const std::shared_ptr<const Model> model = builder.build();
  State state = make_initial_state(*model);
  TimeStepper stepper(model, Method{}, 0.1, 2);
  const AdvanceReport report = stepper.advance(state, 0.1);
  EXPECT_EQ(report.reason, StopReason::reached_end);
  EXPECT_EQ(stepper.group_count(), 2u);
  EXPECT_EQ(report.passages.instants, 0);
  const int light = model->find_body("light").value(), struck = model->find_body("struck").value();
  EXPECT_LE(state.position(light).x(), state.position(struck).x() - 0.1 + 1e-6);
  EXPECT_GT(state.linear_momentum(struck).x(), 0.05);
}

/// Where a leg of a path ends just before a step does, what is left of the step is no step of a group.
void expect_an_end(double begin, double before) {
  ModelBuilder builder = test::stepping_builder(0.5, 0, Vec3(0, 0, -9.81));
  BodyDescription gate = test::stepping_body("gate", Box{Vec3::Constant(0.05)}, Vec3::Zero());
  gate.motion = MotionType::kinematic;
  gate.path = {{0, Vec3(0, 5, 0.5), Quat::Identity()},
               {begin + 4 * step - before, Vec3(0, 6, 0.5), Quat::Identity()}};
  builder.add_body(gate);
  for (const double x : {-3.0, 3.0}) {
    for (const double z : {0.05, 0.15}) {
      const std::string name = "box" + std::to_string(x) + "_" + std::to_string(z);
      BodyDescription body = test::stepping_body(name, Box{Vec3::Constant(0.05)}, Vec3(x, 0, z));
      body.velocity = Vec3(1, 0, 0);
      builder.add_body(body);
    }
  }
  const std::shared_ptr<const Model> model = builder.build();
  TimeStepper stepper(model, Method{}, step, 2);
  // An endless loop would ask for ever.
  long asked = 0;
  stepper.set_interrupt([&asked] { return ++asked > 100000; });
  State state = make_initial_state(*model);
  state.t = begin;
  state.anchor_here();
  EXPECT_EQ(stepper.advance(state, begin + 10 * step).reason, StopReason::reached_end)
      << begin << ", " << before;
  EXPECT_EQ(stepper.group_count(), 2u);
}

TEST(SteppedGroups, APartBelowTheResolutionOfTimeEnds) {
  for (const double before : {3e-16, 3e-13, 1e-12, 1e-10}) expect_an_end(0, before);
  // Late, the resolution is a few roundings of the time: as many as decide which side of it a part is on.
  const double rounding = std::nextafter(2100, 3000) - 2100;
  for (int k = 15; k < 30; ++k) expect_an_end(2100, k * rounding);
}

TEST(SteppedGroups, AStepThatTakesTooMuchIsGivenUpOnAnyNumberOfThreads) {
  const std::shared_ptr<const Model> model = field(1);
  State begin = make_initial_state(*model);
  TimeStepper(model, Method{}, step).advance(begin, 0.2);
  // What a step counts at all, and less.
  State end = begin;
  const double all = TimeStepper(model, Method{}, step).advance(end, begin.t + step).step_work;
  for (const double limit : {0.05 * all, 0.5 * all, 0.95 * all}) {
    for (const int threads : {1, 3}) {
      TimeStepper stepper(model, Method{}, step, threads);
      stepper.set_work_limit(limit);
      State state = begin;
      const std::uint64_t counted = work_counted();
      const AdvanceReport report = stepper.advance(state, begin.t + step);
      EXPECT_EQ(report.reason, StopReason::interrupted);
      EXPECT_TRUE(stepper.is_beyond_work_limit());
      EXPECT_EQ(report.step_work, limit + 1);
      EXPECT_EQ(state, begin);
      // One thread ends with the group in which it became too much.
      if (threads == 1) {
        EXPECT_LE(static_cast<double>(work_counted() - counted), 2 * limit + 1e5);
      }
    }
  }
}

}  // namespace
}  // namespace rigor::stepped_groups_test
