#include "rigor/sim/event_driven/hybrid_stepper.hpp"

#include "rigor/model/model_builder.hpp"
#include "rigor/sim/audit/audit.hpp"

#include "sim/time_stepping_scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rigor::hybrid_stepper_test {
namespace {

constexpr double g = 9.81;

void add_stack(int cubes, ModelBuilder& builder) {
  for (int k = 0; k < cubes; ++k)
    builder.add_body(
        test::stepping_body("cube" + std::to_string(k), Box{Vec3(0.1, 0.1, 0.1)}, Vec3(0, 0, 0.1 + 0.2 * k)));
}

/// Largest displacement of a body since the start [m].
double largest_drift(const Model& model, const State& state) {
  const State start = make_initial_state(model);
  double drift = 0;
  for (int i = 0; i < model.body_count(); ++i)
    drift = std::max(drift, (state.position(i) - start.position(i)).norm());
  return drift;
}

TEST(HybridStepper, BlockOnASlopeDoesNotCreep) {
  const double angle = 20 * std::acos(-1.0) / 180;
  ModelBuilder builder =
      test::stepping_builder(0, 1.01 * std::tan(angle), g * Vec3(std::sin(angle), 0, -std::cos(angle)));
  builder.add_body(test::stepping_body("block", Box{Vec3(0.2, 0.2, 0.1)}, Vec3(0, 0, 0.1)));
  const std::shared_ptr<const Model> model = builder.build();
  HybridStepper stepper(model, Method{}, 0.01);
  State state = make_initial_state(*model);
  EXPECT_EQ(stepper.advance(state, 1000).reason, StopReason::reached_end);
  EXPECT_LE(largest_drift(*model, state), 1e-12);
}

TEST(HybridStepper, StacksStand) {
  for (const int cubes : {10, 20, 50}) {
    ModelBuilder builder = test::stepping_builder(0, 0.5, Vec3(0, 0, -g));
    add_stack(cubes, builder);
    const std::shared_ptr<const Model> model = builder.build();
    HybridStepper stepper(model, Method{}, 1.0 / 60);
    State state = make_initial_state(*model);
    EXPECT_EQ(stepper.advance(state, 10).reason, StopReason::reached_end);
    EXPECT_LE(largest_drift(*model, state), 1e-9) << cubes << " cubes";
  }
}

TEST(HybridStepper, BallThatBouncesOnAStackLeavesItStanding) {
  ModelBuilder builder = test::stepping_builder(0.5, 0.5, Vec3(0, 0, -g));
  add_stack(2, builder);
  builder.add_body(test::stepping_body("ball", Sphere{0.1}, Vec3(0, 0, 1)));
  const std::shared_ptr<const Model> model = builder.build();
  HybridStepper stepper(model, Method{}, 0.01);
  State state = make_initial_state(*model);
  const AdvanceReport report = stepper.advance(state, 4);
  EXPECT_EQ(report.reason, StopReason::reached_end);
  EXPECT_EQ(report.impact_gain, 0);
  EXPECT_LE(report.momentum_error.norm(), 1e-11);
  // All came to rest, one on top of the other.
  for (int i = 1; i <= 2; ++i) EXPECT_NEAR(state.position(i).z(), 0.1 + 0.2 * (i - 1), 1e-6);
  EXPECT_NEAR(state.position(3).z(), 0.5, 1e-6);
  EXPECT_LE(state.linear_momentum(3).norm(), 1e-5);
}

/// Three balls of restitution 0.9 above a stack of slabs that bounce by 0.5 themselves.
std::shared_ptr<const Model> hail_on_slabs() {
  ModelBuilder builder = test::stepping_builder(0.5, 0.6, Vec3(0, 0, -g));
  builder.add_material({"rubber", 1000, 0.2, 0.9});
  builder.set_pair("rubber", "m", {.friction = 0.2, .restitution = 0.9});
  for (int k = 0; k < 4; ++k) {
    BodyDescription slab = test::stepping_body("slab" + std::to_string(k), Box{Vec3(0.15, 0.15, 0.05)},
                                               Vec3(0, 0, 0.05 + 0.1 * k));
    slab.mass = 18;
    builder.add_body(slab);
  }
  for (int k = 0; k < 3; ++k) {
    BodyDescription ball = test::stepping_body("ball" + std::to_string(k), Sphere{0.04},
                                               Vec3(0.1 * (k - 1), 0.02 * k, 0.6 + 0.1 * k));
    ball.mass = 0.24;
    ball.shapes[0].material = "rubber";
    builder.add_body(ball);
  }
  return builder.build();
}

TEST(HybridStepper, ContactsThatLastDoNotBounceInTheImpactsOfOthers) {
  const std::shared_ptr<const Model> model = hail_on_slabs();
  HybridStepper stepper(model, Method{}, 0.01);
  State state = make_initial_state(*model);
  Auditor auditor(model, Method{}, state);
  for (int k = 1; k <= 50; ++k) auditor.observe(state, stepper.advance(state, 0.01 * k));
  const Audit audit = auditor.audit(state);
  EXPECT_EQ(audit.report.reason, StopReason::reached_end);
  EXPECT_LE(audit.max_increase, 1e-9 * audit.initial.total());
  // Some two bounces a ball, each with what it does to the four slabs: not a train of bounces of the slabs.
  EXPECT_GE(audit.report.impacts, 5);
  EXPECT_LE(audit.report.impacts, 60);
  for (int i = 1; i <= 4; ++i)
    EXPECT_LE((state.position(i) - make_initial_state(*model).position(i)).norm(), 1e-6) << i;
}

TEST(HybridStepper, FreshStepperContinuesBitForBitThroughHail) {
  const std::shared_ptr<const Model> model = hail_on_slabs();
  State state = make_initial_state(*model);
  HybridStepper stepper(model, Method{}, 0.01);
  for (int k = 1; k <= 10; ++k) {
    State copy = state;
    HybridStepper fresh(model, Method{}, 0.01);
    fresh.advance(copy, 0.05 * k);
    EXPECT_EQ(stepper.advance(state, 0.05 * k).reason, StopReason::reached_end);
    ASSERT_EQ(state, copy) << "at t = " << state.t;
  }
}

TEST(HybridStepper, FreshStepperContinuesBitForBit) {
  ModelBuilder builder = test::stepping_builder(0.3, 0.4, Vec3(0, 0, -g));
  add_stack(2, builder);
  BodyDescription cube = test::stepping_body("falling", Box{Vec3(0.1, 0.1, 0.1)}, Vec3(0.05, 0.02, 0.7));
  cube.q_WU = Quat(0.9, 0.3, -0.2, 0.1).normalized();
  builder.add_body(cube);
  const std::shared_ptr<const Model> model = builder.build();
  State state = make_initial_state(*model);
  HybridStepper stepper(model, Method{}, 0.01);
  for (int k = 1; k <= 6; ++k) {
    State copy = state;
    HybridStepper fresh(model, Method{}, 0.01);
    fresh.advance(copy, 0.05 * k);
    EXPECT_EQ(stepper.advance(state, 0.05 * k).reason, StopReason::reached_end);
    ASSERT_EQ(state, copy) << "at t = " << state.t;
  }
}

TEST(HybridStepper, SlidingBlockStopsWhereFrictionStopsIt) {
  ModelBuilder builder = test::stepping_builder(0, 0.3, Vec3(0, 0, -g));
  BodyDescription block = test::stepping_body("block", Box{Vec3(0.2, 0.2, 0.05)}, Vec3(0, 0, 0.05));
  block.velocity = Vec3(2, 0, 0);
  builder.add_body(block);
  const std::shared_ptr<const Model> model = builder.build();
  HybridStepper stepper(model, Method{}, 0.01);
  State state = make_initial_state(*model);
  stepper.advance(state, 2);
  EXPECT_NEAR(state.position(1).x(), 2 * 2 / (2 * 0.3 * g), 1e-9);
}

}  // namespace
}  // namespace rigor::hybrid_stepper_test
