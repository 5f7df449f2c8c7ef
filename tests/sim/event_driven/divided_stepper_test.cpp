// Groups of bodies that have nothing to do with each other are advanced side by side, with the bits of one
// queue of events for all.

#include "rigor/sim/event_driven/divided_stepper.hpp"

#include "random_vectors.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/model/model_builder.hpp"
#include "rigor/sim/event_driven/hybrid_stepper.hpp"
#include "rigor/sim/event_driven/impulse_based_stepper.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace rigor::divided_stepper_test {
namespace {

constexpr double step = 0.01, interval = 0.02;

/// Some small heaps on one floor, of boxes, balls and capsules that fall askew; a pendulum, a ball that rolls
/// from the first heap towards the second, and one that flies over all of them.
std::shared_ptr<const Model> field(unsigned seed, int heaps, int bodies) {
  constexpr double distance = 0.7;
  test::Random random(seed);
  ModelBuilder builder;
  builder.set_gravity(Vec3(0, 0, -9.81));
  builder.add_material({"m", 1000, 0.5, 0.3});
  BodyDescription floor;
  floor.name = "floor";
  floor.motion = MotionType::fixed;
  floor.shapes.push_back({HalfSpace{Vec3::UnitZ(), 0}, Vec3::Zero(), Quat::Identity(), "m", ""});
  builder.add_body(floor);
  const auto add = [&](const std::string& name, const Shape& shape, const Vec3& x, const Vec3& v) {
    BodyDescription body;
    body.name = name;
    body.p_WU = x;
    body.q_WU = rotation_exp(random.vector()).normalized();
    body.mass = std::exp(random.number());
    body.velocity = v;
    body.angular_velocity = 2 * random.vector();
    body.shapes.push_back({shape, Vec3::Zero(), Quat::Identity(), "m", ""});
    return builder.add_body(body);
  };
  for (int k = 0; k < heaps; ++k) {
    for (int i = 0; i < bodies; ++i) {
      const double size = 0.05 + 0.02 * random.number();
      const Shape shape = i % 3 == 0   ? Shape(Box{Vec3(size, 0.8 * size, 0.6 * size)})
                          : i % 3 == 1 ? Shape(Sphere{size})
                                       : Shape(Capsule{0.6 * size, size});
      const Vec3 x(distance * k + 0.02 * random.number(), 0.02 * random.number(), 0.1 + 0.17 * i);
      add("h" + std::to_string(k) + "_" + std::to_string(i), shape, x, 0.3 * random.vector());
    }
  }
  add("roller", Sphere{0.05}, Vec3(0.2, 0, 0.05), Vec3(2, 0, 0));
  add("flier", Sphere{0.05}, Vec3(-1, 0, 1.2), Vec3(4, 0, 1));
  add("bob", Sphere{0.05}, Vec3(0, 3, 1), random.vector());
  ModelBuilder::JointDescription joint;
  joint.name = "pivot";
  joint.type = JointType::ball;
  joint.bodies = {"world", "bob"};
  joint.anchors = {Vec3(0, 3, 1.5)};
  builder.add_joint(joint);
  return builder.build();
}

std::unique_ptr<EventDrivenStepper> make_whole(const std::shared_ptr<const Model>& model,
                                               const Method& method) {
  if (method.scheme == Scheme::hybrid) return std::make_unique<HybridStepper>(model, method, step);
  if (method.scheme == Scheme::impulse_based)
    return std::make_unique<ImpulseBasedStepper>(model, method, step);
  return std::make_unique<EventDrivenStepper>(model, method, step);
}

DividedStepper make_divided(const std::shared_ptr<const Model>& model, const Method& method, int threads) {
  return {model, method, [model, method] { return make_whole(model, method); }, threads};
}

class Divided : public testing::TestWithParam<Scheme> {};

/// One queue for all, and groups on one to three threads; a fresh stepper at each output, too.
TEST_P(Divided, HasTheBitsOfOneQueueForAllOnAnyNumberOfThreads) {
  Method method;
  method.scheme = GetParam();
  const bool is_impulse_based = method.scheme == Scheme::impulse_based;
  const int intervals = is_impulse_based ? 14 : 18;
  std::size_t most_groups = 0;
  for (const unsigned seed : {1u, 2u}) {
    const std::shared_ptr<const Model> model = field(seed, 3, is_impulse_based ? 4 : 3);
    const State start = make_initial_state(*model);
    State of_whole = start, of_one = start, of_two = start, of_three = start;
    const std::unique_ptr<EventDrivenStepper> whole = make_whole(model, method);
    DividedStepper one = make_divided(model, method, 1), two = make_divided(model, method, 2),
                   three = make_divided(model, method, 3);
    for (int k = 1; k <= intervals; ++k) {
      const double t = interval * k;
      State of_fresh = of_one;
      const AdvanceReport by_whole = whole->advance(of_whole, t), by_one = one.advance(of_one, t),
                          by_two = two.advance(of_two, t), by_three = three.advance(of_three, t),
                          by_fresh = make_divided(model, method, 2).advance(of_fresh, t);
      ASSERT_EQ(by_one.reason, StopReason::reached_end) << by_one.detail;
      ASSERT_EQ(of_one, of_whole) << "seed " << seed << ", t = " << t;
      ASSERT_EQ(of_one, of_two) << "seed " << seed << ", t = " << t;
      ASSERT_EQ(of_one, of_three) << "seed " << seed << ", t = " << t;
      ASSERT_EQ(of_one, of_fresh) << "seed " << seed << ", t = " << t;
      // What happened is the same as well, in the order of time; sums are those of the groups.
      for (const AdvanceReport* const other : {&by_two, &by_three, &by_fresh}) {
        ASSERT_EQ(by_one.momentum_error, other->momentum_error);
        ASSERT_EQ(by_one.impact_loss, other->impact_loss);
        ASSERT_EQ(by_one.friction_loss, other->friction_loss);
        ASSERT_EQ(by_one.effort, other->effort);
        ASSERT_EQ(by_one.events.size(), other->events.size());
        for (std::size_t i = 0; i < by_one.events.size(); ++i) {
          ASSERT_EQ(by_one.events[i].time, other->events[i].time);
          ASSERT_EQ(by_one.events[i].body_A, other->events[i].body_A);
          ASSERT_EQ(by_one.events[i].j_W, other->events[i].j_W);
        }
      }
      ASSERT_EQ(by_one.impacts, by_whole.impacts);
      ASSERT_EQ(by_one.steps, by_whole.steps);
      ASSERT_EQ(by_one.resting, by_whole.resting);
      ASSERT_EQ(by_one.max_penetration, by_whole.max_penetration);
      ASSERT_NEAR(by_one.impact_loss, by_whole.impact_loss, 1e-12 * (1 + by_whole.impact_loss));
      most_groups = std::max(most_groups, one.group_count());
    }
  }
  EXPECT_GE(most_groups, 3u);
}

/// Balls in air: a heavy one strikes a light one, which becomes twice as fast as it, strikes a third one that
/// nobody foresaw, and two on a joint are far away.
std::shared_ptr<const Model> unforeseen_strike() {
  ModelBuilder builder;
  builder.set_gravity(Vec3::Zero());
  builder.add_material({"m", 1000, 0.1, 1});
  const auto add = [&](const std::string& name, double x, double mass, double speed) {
    BodyDescription body;
    body.name = name;
    body.p_WU = Vec3(x, 0, 0);
    body.mass = mass;
    body.velocity = Vec3(speed, 0, 0);
    body.linear_damping = 0.1;
    body.shapes.push_back({Sphere{0.05}, Vec3::Zero(), Quat::Identity(), "m", ""});
    builder.add_body(body);
  };
  add("heavy", 0, 100, 3);
  add("light", 0.15, 0.01, 0);
  add("struck", 0.55, 1, 0);
  add("far", 3, 1, 1);
  add("farther", 3.2, 1, 1);
  ModelBuilder::JointDescription joint;
  joint.name = "between";
  joint.type = JointType::ball;
  joint.bodies = {"far", "farther"};
  joint.anchors = {Vec3(3.1, 0, 0)};
  builder.add_joint(joint);
  return builder.build();
}

TEST(DividedStepper, GroupsThatMeetUnforeseenAreAdvancedAsOne) {
  const std::shared_ptr<const Model> model = unforeseen_strike();
  const Method method;
  Environment environment(*model);
  State divided_state = make_initial_state(*model), whole_state = divided_state;
  constexpr double span = 0.1;
  const BodyRanges foreseen =
      foreseen_ranges(*model, environment, divided_state, span, method.contact_tolerance);
  EXPECT_EQ(groups_apart(*model, environment, foreseen).size(), 3u);
  DividedStepper divided = make_divided(model, method, 2);
  const AdvanceReport report = divided.advance(divided_state, span),
                      by_whole = make_whole(model, method)->advance(whole_state, span);
  EXPECT_EQ(report.impacts, by_whole.impacts);
  EXPECT_GE(report.impacts, 2);
  EXPECT_EQ(divided.group_count(), 2u);
  EXPECT_EQ(divided_state, whole_state);
}

/// What a moving table carries in two places is in two groups, each of which sees the table go on alone.
TEST(DividedStepper, ATableMovesWhatLiesOnItInTwoGroups) {
  for (const double speed : {1.0, 10.0}) {
    ModelBuilder builder;
    builder.set_gravity(Vec3(0, 0, -9.81));
    builder.add_material({"m", 1000, 0.5, 0});
    const auto add = [&](const std::string& name, const Vec3& half, const Vec3& x, MotionType motion) {
      BodyDescription body;
      body.name = name;
      body.motion = motion;
      body.p_WU = x;
      body.velocity = Vec3(0, 0, speed);
      body.shapes.push_back({Box{half}, Vec3::Zero(), Quat::Identity(), "m", ""});
      builder.add_body(body);
    };
    add("table", Vec3(4, 0.5, 0.05), Vec3(0, 0, -0.05), MotionType::kinematic);
    for (const double x : {-3.0, 3.0}) {
      add("lower" + std::to_string(x), Vec3::Constant(0.05), Vec3(x, 0, 0.05), MotionType::dynamic);
      add("upper" + std::to_string(x), Vec3::Constant(0.05), Vec3(x, 0, 0.15), MotionType::dynamic);
    }
    const std::shared_ptr<const Model> model = builder.build();
    DividedStepper events = make_divided(model, Method{}, 2);
    State state = make_initial_state(*model);
    std::size_t most_groups = 0;
    for (int k = 1; k <= 10; ++k) {
      EXPECT_EQ(events.advance(state, interval * k).passages.instants, 0);
      most_groups = std::max(most_groups, events.group_count());
    }
    EXPECT_EQ(most_groups, 2u);
  }
}

/// Each thread asks the one interrupt, and what is broken off is done again from the State.
TEST(DividedStepper, AnInterruptLeavesTheStateThatWas) {
  const std::shared_ptr<const Model> model = field(4, 3, 3);
  const Method method;
  State state = make_initial_state(*model), undisturbed = state;
  DividedStepper stepper = make_divided(model, method, 2), other = make_divided(model, method, 1);
  // Until there is something to divide.
  int k = 0;
  while (stepper.group_count() < 2 && k < 30) {
    stepper.advance(state, interval * ++k);
    other.advance(undisturbed, interval * k);
  }
  ASSERT_GT(stepper.group_count(), 1u);
  const State before = state;
  int asked = 0;
  stepper.set_interrupt([&asked] { return ++asked > 20; });
  EXPECT_EQ(stepper.advance(state, interval * (k + 1)).reason, StopReason::interrupted);
  EXPECT_EQ(state, before);
  stepper.set_interrupt({});
  EXPECT_EQ(stepper.advance(state, interval * (k + 1)).reason, StopReason::reached_end);
  other.advance(undisturbed, interval * (k + 1));
  EXPECT_EQ(state, undisturbed);
}

INSTANTIATE_TEST_SUITE_P(Schemes, Divided,
                         testing::Values(Scheme::event_driven, Scheme::hybrid, Scheme::impulse_based));

}  // namespace
}  // namespace rigor::divided_stepper_test
