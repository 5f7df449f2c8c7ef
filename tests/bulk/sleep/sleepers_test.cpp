// Sleep in a world of many bodies.

#include "rigor/bulk/bulk_world.hpp"
#include "rigor/model/model_builder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

namespace rigor::sleepers_test {
namespace {

constexpr double kStep = 1.0 / 60, g = 9.81;

BodyDescription body_at(const std::string& name, const Shape& shape, const Vec3& x,
                        MotionType motion = MotionType::dynamic) {
  BodyDescription body;
  body.name = name;
  body.motion = motion;
  body.p_WU = x;
  body.shapes.push_back({shape, Vec3::Zero(), Quat::Identity(), "m", ""});
  return body;
}

ModelBuilder builder_with_floor() {
  ModelBuilder builder;
  builder.set_gravity(Vec3(0, 0, -g));
  builder.add_material({"m", 1000, 0.5, 0});
  builder.add_body(body_at("floor", HalfSpace{Vec3::UnitZ(), 0}, Vec3::Zero(), MotionType::fixed));
  return builder;
}

/// Cubes of 1 m on each other: bodies 1 to `count`.
void add_tower(int count, ModelBuilder& builder) {
  for (int i = 0; i < count; ++i)
    builder.add_body(body_at("cube" + std::to_string(i), Box{Vec3(0.5, 0.5, 0.5)}, Vec3(0, 0, 0.5 + i)));
}

BulkSettings sleeping(int threads = 1) {
  BulkSettings settings;
  settings.threads = threads;
  settings.sleeping = true;
  return settings;
}

/// A world of a model at its start, and what its last step did.
struct Steps {
  Steps(std::shared_ptr<const Model> of, const BulkSettings& settings)
      : model(std::move(of)), world(model, settings) {
    world.read(make_initial_state(*model));
  }
  void steps(int count) {
    for (int k = 0; k < count; ++k) report = world.step(kStep);
  }
  /// Until so many sleep; false if that takes more than a minute.
  bool steps_until_asleep(int count) {
    for (int k = 0; k < 3600 && report.sleeping_count < count; ++k) steps(1);
    return report.sleeping_count == count;
  }
  State state() const {
    State state = make_initial_state(*model);
    world.write(state);
    return state;
  }

  std::shared_ptr<const Model> model;
  BulkWorld world;
  BulkStepReport report;
};

/// Boxes and balls that fall in a heap.
std::shared_ptr<const Model> heap() {
  ModelBuilder builder = builder_with_floor();
  for (int i = 0; i < 24; ++i) {
    const Vec3 place(0.85 * (i % 4) + 0.02 * i, 0.7 * (i / 4 % 3), 0.7 + 1.1 * (i / 12));
    const Shape box = Box{Vec3(0.5, 0.3, 0.4)}, plate = Box{Vec3(0.4, 0.4, 0.2)};
    builder.add_body(body_at("b" + std::to_string(i), i % 3 == 0 ? plate : box, place));
  }
  return builder.build();
}

TEST(Sleepers, HeapFallsAsleepAndThenNothingIsSolvedAndNothingMoves) {
  Steps run(heap(), sleeping());
  run.steps(60);
  EXPECT_GT(run.report.manifold_count, 20);
  ASSERT_TRUE(run.steps_until_asleep(24));
  run.steps(1);
  EXPECT_EQ(run.report.pair_count, 0);
  EXPECT_EQ(run.report.manifold_count, 0);
  State before = run.state();
  EXPECT_GT(before.manifolds.size(), 20u);
  run.steps(100);
  before.t = run.world.time();
  EXPECT_EQ(run.state().x, before.x);
  EXPECT_EQ(run.state().q, before.q);
  EXPECT_EQ(run.state().manifolds, before.manifolds);
  EXPECT_TRUE(std::all_of(before.P.begin(), before.P.end(), [](double p) { return p == 0; }));
}

TEST(Sleepers, OffByDefaultAndThenNobodySleeps) {
  Steps run(heap(), BulkSettings{});
  run.steps(1200);
  EXPECT_EQ(run.report.sleeping_count, 0);
  EXPECT_GT(run.report.manifold_count, 20);
  EXPECT_TRUE(run.state().quiet_time.empty());
}

TEST(Sleepers, SameBitsFromTheStateInTheMiddleOfSleepAndOnMoreThreads) {
  // A ball rolls into the heap after it has come to rest.
  ModelBuilder builder = builder_with_floor();
  for (int i = 0; i < 12; ++i)
    builder.add_body(
        body_at("b" + std::to_string(i), Box{Vec3(0.4, 0.3, 0.3)}, Vec3(0.1 * i, 0, 0.4 + 0.7 * i)));
  BodyDescription ball = body_at("ball", Sphere{0.4}, Vec3(-25, 0, 0.4));
  ball.velocity = Vec3(5, 0, 0);
  builder.add_body(ball);
  const std::shared_ptr<const Model> model = builder.build();
  Steps whole(model, sleeping());
  State pieces = make_initial_state(*model);
  int most = 0, after_the_hit = 12;
  for (int k = 0; k < 600; ++k) {
    whole.steps(1);
    BulkWorld fresh(model, sleeping(1 + k % 3));
    fresh.read(deserialise(serialise(pieces)));
    fresh.step(kStep);
    fresh.write(pieces);
    ASSERT_EQ(pieces, whole.state()) << "step " << k;
    most = std::max(most, whole.report.sleeping_count);
    if (k > 400) after_the_hit = std::min(after_the_hit, whole.report.sleeping_count);
  }
  EXPECT_GE(most, 12);
  EXPECT_LT(after_the_hit, 12);
}

TEST(Sleepers, BallWakesATowerWhichMovesAsIfItHadNeverSlept) {
  ModelBuilder builder = builder_with_floor();
  add_tower(5, builder);
  // It flies 5 s and arrives at the topmost cube; what it weighs does not topple the tower.
  BodyDescription ball = body_at("ball", Sphere{0.2}, Vec3(-25.7, 0, 4.5));
  ball.gravity_scale = 0;
  ball.velocity = Vec3(5, 0, 0);
  builder.add_body(ball);
  const std::shared_ptr<const Model> model = builder.build();
  Steps slept(model, sleeping()), awake(model, BulkSettings{});
  slept.steps(290);
  awake.steps(290);
  EXPECT_EQ(slept.report.sleeping_count, 5);
  slept.steps(30);
  awake.steps(30);
  EXPECT_EQ(slept.report.sleeping_count, 0);
  // The ball, of a thirtieth of the mass of a cube, has pushed the topmost one.
  EXPECT_GT(awake.world.bodies().x[5].x(), 5e-4);
  for (std::size_t i = 1; i <= 6; ++i) {
    // While they slept the others have settled by micrometres, a hundredth of the push.
    EXPECT_LT((slept.world.bodies().x[i] - awake.world.bodies().x[i]).norm(), 5e-6) << i;
  }
}

TEST(Sleepers, WakeWithTheImpulsesThatTheyHad) {
  ModelBuilder builder = builder_with_floor();
  add_tower(10, builder);
  Steps run(builder.build(), sleeping());
  ASSERT_TRUE(run.steps_until_asleep(10));
  const std::vector<Vec3> before = run.world.bodies().x;
  run.world.wake(10);
  run.steps(1);
  EXPECT_EQ(run.report.sleeping_count, 0);
  EXPECT_GT(run.report.manifold_count, 9);
  // Without them the tower would begin to fall: ½ g h² = 1.4 mm in the first step.
  for (std::size_t i = 1; i <= 10; ++i) EXPECT_LT((run.world.bodies().x[i] - before[i]).norm(), 5e-5) << i;
}

TEST(Sleepers, SupportThatIsPulledAwayWakesWhatItCarried) {
  ModelBuilder builder = builder_with_floor();
  BodyDescription plate = body_at("plate", Box{Vec3(1, 1, 0.1)}, Vec3::Zero(), MotionType::kinematic);
  plate.path = {{0, Vec3(0, 0, 2), Quat::Identity()},
                {4, Vec3(0, 0, 2), Quat::Identity()},
                {4.2, Vec3(0, 10, 2), Quat::Identity()}};
  builder.add_body(plate);
  builder.add_body(body_at("box", Box{Vec3(0.2, 0.2, 0.2)}, Vec3(0, 0, 2.3)));
  builder.add_body(body_at("other", Box{Vec3(0.2, 0.2, 0.2)}, Vec3(5, 0, 0.2)));
  Steps run(builder.build(), sleeping());
  ASSERT_TRUE(run.steps_until_asleep(2));
  EXPECT_LT(run.world.time(), 3.9);
  while (run.world.time() < 3.98) run.steps(1);
  EXPECT_EQ(run.report.sleeping_count, 2);
  while (run.world.time() < 4.5) run.steps(1);
  EXPECT_EQ(run.report.sleeping_count, 1);
  EXPECT_FALSE(run.world.is_asleep(2));
  EXPECT_LT(run.world.bodies().x[2].z(), 2);
}

TEST(Sleepers, MovingPlaneAndMovingAnchorOfASpringWake) {
  ModelBuilder builder = builder_with_floor();
  BodyDescription press = body_at("press", HalfSpace{-Vec3::UnitZ(), 0}, Vec3::Zero(), MotionType::kinematic);
  press.path = {{3, Vec3(0, 0, 3), Quat::Identity()},
                {4, Vec3(0, 0, 2), Quat::Identity()},
                {5, Vec3(0, 0, 0.9), Quat::Identity()}};
  builder.add_body(press);
  builder.add_body(body_at("box", Box{Vec3(0.5, 0.5, 0.5)}, Vec3(0, 0, 0.5)));
  BodyDescription winch = body_at("winch", Sphere{0.1}, Vec3::Zero(), MotionType::kinematic);
  winch.path = {{3, Vec3(9, 0, 0.7), Quat::Identity()}, {5, Vec3(9, 0, 0.9), Quat::Identity()}};
  winch.mask = 0;
  builder.add_body(winch);
  builder.add_body(body_at("hung", Box{Vec3(0.1, 0.1, 0.1)}, Vec3(9, 0, 0.1)));
  ModelBuilder::ForceDescription spring;
  spring.type = ModelBuilder::ForceDescription::Type::spring;
  spring.bodies = {"winch", "hung"};
  spring.stiffness = 1000;
  spring.length = 0.6;
  builder.add_force(spring);
  Steps run(builder.build(), sleeping());
  ASSERT_TRUE(run.steps_until_asleep(2));
  EXPECT_LT(run.world.time(), 2.9);
  while (run.world.time() < 3.5) run.steps(1);
  // The winch pulls; the press is still far away.
  EXPECT_TRUE(run.world.is_asleep(2));
  EXPECT_FALSE(run.world.is_asleep(4));
  while (run.world.time() < 4.95) run.steps(1);
  EXPECT_FALSE(run.world.is_asleep(2));
}

TEST(Sleepers, JointedBodiesSleepAsOneBesideOthersThatSwing) {
  // Two pendulums in one block of eight: one hangs at rest, the other swings.
  ModelBuilder builder = builder_with_floor();
  for (const double x : {0.0, 5.0}) {
    const std::string name = std::to_string(static_cast<int>(x));
    const bool swings = x > 0;
    BodyDescription upper = body_at("upper" + name, Capsule{0.1, 0.3}, Vec3(x, 0, 4.5));
    BodyDescription lower = body_at("lower" + name, Capsule{0.1, 0.3}, Vec3(x, 0, 3.5));
    if (swings) lower.velocity = Vec3(0, 2, 0);
    builder.add_body(upper);
    builder.add_body(lower);
    ModelBuilder::JointDescription joint;
    joint.type = JointType::ball;
    joint.name = "top" + name;
    joint.bodies = {"world", "upper" + name};
    joint.anchors = {Vec3(x, 0, 5)};
    builder.add_joint(joint);
    joint.name = "middle" + name;
    joint.bodies = {"upper" + name, "lower" + name};
    joint.anchors = {Vec3(x, 0, 4)};
    builder.add_joint(joint);
  }
  const std::shared_ptr<const Model> model = builder.build();
  Steps run(model, sleeping()), awake(model, BulkSettings{});
  run.steps(120);
  awake.steps(120);
  EXPECT_TRUE(run.world.is_asleep(1));
  EXPECT_TRUE(run.world.is_asleep(2));
  EXPECT_FALSE(run.world.is_asleep(3));
  const State slept = run.state(), moved = awake.state();
  EXPECT_EQ(slept.P[3], 0);
  // Lanes do not know of each other: what swings does so to the last bit.
  for (std::size_t k = 9; k < 15; ++k) EXPECT_EQ(slept.x[k], moved.x[k]);
  // The joint at the top still tells what it carries: the weight of both, m g of a substep.
  const double weight = (model->body(1).mass + model->body(2).mass) * g * kStep / BulkSettings{}.substeps;
  const double carried = Eigen::Vector3f::Map(slept.joint_impulses.data()).norm();
  EXPECT_NEAR(carried, weight, 1e-3 * weight);
}

TEST(Sleepers, MotorsThatDriveSlowlyAndLiftsKeepBodiesAwake) {
  ModelBuilder builder = builder_with_floor();
  BodyDescription lift = body_at("lift", Box{Vec3(1, 1, 0.1)}, Vec3(0, 0, 1), MotionType::kinematic);
  lift.velocity = Vec3(0, 0, 0.002);
  builder.add_body(lift);
  builder.add_body(body_at("rider", Box{Vec3(0.2, 0.2, 0.2)}, Vec3(0, 0, 1.3)));
  builder.add_body(body_at("hand", Box{Vec3(0.02, 0.02, 0.2)}, Vec3(5, 0, 3)));
  ModelBuilder::JointDescription hinge;
  hinge.name = "clock";
  hinge.type = JointType::hinge;
  hinge.bodies = {"world", "hand"};
  hinge.anchors = {Vec3(5, 0, 3)};
  hinge.axis = Vec3::UnitY();
  JointAxis axis;
  axis.motor = JointMotor{0.01, 1e3};
  hinge.axes = {axis};
  builder.add_joint(hinge);
  Steps run(builder.build(), sleeping());
  run.steps(180);
  EXPECT_EQ(run.report.sleeping_count, 0);
  EXPECT_NEAR(run.world.bodies().x[2].z(), 1.3 + 3 * 0.002, 1e-3);
}

}  // namespace
}  // namespace rigor::sleepers_test
