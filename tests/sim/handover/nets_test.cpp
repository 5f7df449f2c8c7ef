// Nets and cloth of jointed bodies under `auto`: near configurations in which joints have no bound exact
// steps lose the motion or take too long, and soft steps go on.

#include "random_vectors.hpp"
#include "rigor/core/work_count.hpp"
#include "rigor/model/model_builder.hpp"
#include "rigor/sim/audit/audit.hpp"
#include "rigor/sim/handover/auto_stepper.hpp"
#include "rigor/sim/method/scheme_choice.hpp"
#include "rigor/sim/simulation.hpp"
#include "rigor/sim/time_stepping/time_stepper.hpp"
#include "sim/handover/falling_heaps.hpp"
#include "sim/time_stepping_scenes.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace rigor::handover_test {
namespace {

/// A square net of knots that ball joints in the middles of its meshes hold, level and taut between four
/// nails at its corners: the straight ropes along its edges can carry no weight.
std::shared_ptr<const Model> taut_net(test::Random& random) {
  const int count = static_cast<int>(random.uniform(3, 5.999));
  const double mesh = random.uniform(0.1, 0.4), mass = random.uniform(0.05, 0.3);
  ModelBuilder builder;
  builder.set_gravity(Vec3(0, 0, -9.81));
  builder.add_material({"m", 1000, 0.5, 0});
  const auto name = [](int i, int k) { return "knot" + std::to_string(i) + "_" + std::to_string(k); };
  const auto add_joint = [&](const std::string& a, const std::string& b, const Vec3& at) {
    ModelBuilder::JointDescription joint;
    joint.name = a + "-" + b;
    joint.type = JointType::ball;
    joint.bodies = {a, b};
    joint.anchors = {at};
    builder.add_joint(joint);
  };
  for (int i = 0; i < count; ++i) {
    for (int k = 0; k < count; ++k) {
      const Vec3 place(i * mesh, k * mesh, 1);
      BodyDescription knot = test::stepping_body(name(i, k), Sphere{0.12 * mesh}, place);
      knot.mass = mass;
      builder.add_body(knot);
      if (i > 0) add_joint(name(i - 1, k), name(i, k), place - Vec3(0.5 * mesh, 0, 0));
      if (k > 0) add_joint(name(i, k - 1), name(i, k), place - Vec3(0, 0.5 * mesh, 0));
      if (i % (count - 1) == 0 && k % (count - 1) == 0) add_joint("world", name(i, k), place);
    }
  }
  return builder.build();
}

TEST(Nets, WhatExactStepsLoseOrPayTooMuchForGoesOnSoftly) {
  // As little is paid for exact steps as ends a test soon.
  const HandoverBounds bounds{.paid_to_steps = 1e6, .most_owed_by_steps = 1e6};
  for (unsigned seed = 0; seed < 4; ++seed) {
    SCOPED_TRACE(seed);
    test::Random random(4100 + seed);
    const std::shared_ptr<const Model> model = taut_net(random);
    const ResolvedMethod resolved = resolve_scheme(*model, automatic());
    const auto fresh = [&] {
      return AutoStepper(model, std::make_unique<EventDrivenStepper>(model, resolved.method, step), resolved,
                         step, 1, bounds);
    };
    AutoStepper stepper = fresh();
    State state = make_initial_state(*model), middle = state;
    Auditor auditor(model, automatic(), state);
    for (int k = 1; k <= 10; ++k) {
      const AdvanceReport report = stepper.advance(state, k * interval);
      ASSERT_EQ(report.reason, StopReason::reached_end) << report.detail << " at " << state.t;
      auditor.observe(state, report);
      if (k == 5) middle = state;
    }
    const Audit audit = auditor.audit(state);
    ASSERT_GE(audit.spans.size(), 2u);
    EXPECT_EQ(audit.spans.back().of.solver, SolverMethod::substep);

    // From where it was put aside the run goes the same way.
    AutoStepper again = fresh();
    State resumed = deserialise(serialise(middle));
    for (int k = 6; k <= 10; ++k) again.advance(resumed, k * interval);
    EXPECT_EQ(resumed, state);
  }
}

TEST(Nets, AMotionThatExactStepsCannotFollowGoesOnSoftly) {
  for (const double speed : {1e7, 1e8}) {
    // A ball on two rods, faster than useful parts of a step follow.
    ModelBuilder builder;
    builder.set_gravity(Vec3(0, 0, -9.81));
    builder.add_material({"m", 1000, 0.5, 0});
    for (int k = 0; k < 2; ++k) {
      BodyDescription ball = test::stepping_body("ball" + std::to_string(k), Sphere{0.05}, Vec3(k + 1, 0, 0));
      ball.velocity = Vec3(0, k * speed, 0);
      builder.add_body(ball);
      ModelBuilder::JointDescription rod;
      rod.name = "rod" + std::to_string(k);
      rod.type = JointType::ball;
      rod.bodies = {k == 0 ? "world" : "ball0", "ball" + std::to_string(k)};
      rod.anchors = {Vec3(k, 0, 0)};
      builder.add_joint(rod);
    }
    const std::shared_ptr<const Model> model = builder.build();
    const ResolvedMethod resolved = resolve_scheme(*model, automatic());
    AutoStepper stepper(model, std::make_unique<EventDrivenStepper>(model, resolved.method, step), resolved,
                        step);
    State state = make_initial_state(*model);
    const AdvanceReport report = stepper.advance(state, interval);
    EXPECT_EQ(report.reason, StopReason::reached_end) << report.detail;
    ASSERT_EQ(report.spans.size(), 3u);
    EXPECT_NE(report.spans[1].end_cause.find("unresolved by exact steps: body 'ball"), std::string::npos)
        << report.spans[1].end_cause;
    EXPECT_EQ(report.spans[2].solver, SolverMethod::substep);
    EXPECT_EQ(report.spans[2].end, interval);
  }
}

TEST(Nets, AStepThatTakesTooMuchIsGivenUpWithinATry) {
  test::Random random(4200);
  for (int k = 0; k < 4; ++k) {
    SCOPED_TRACE(k);
    const std::shared_ptr<const Model> model = taut_net(random);
    Method method;
    method.scheme = Scheme::time_stepping;
    TimeStepper stepper(model, method, step);
    constexpr double limit = 1e6;
    stepper.set_work_limit(limit);
    State state = make_initial_state(*model);
    const State before = state;
    const std::uint64_t counted = work_counted();
    const AdvanceReport report = stepper.advance(state, step);
    EXPECT_EQ(report.reason, StopReason::interrupted);
    EXPECT_TRUE(stepper.is_beyond_work_limit());
    EXPECT_EQ(state, before);
    // It is asked for in each stage of an integrator; what joins these factors equations some dozen times.
    EXPECT_LE(static_cast<double>(work_counted() - counted), limit + 1e5);
  }
}

}  // namespace
}  // namespace rigor::handover_test
