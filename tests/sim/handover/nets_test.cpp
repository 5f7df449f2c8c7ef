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
  const HandoverBounds bounds{.paid_to_steps = 3e6, .most_owed_by_steps = 3e6};
  int lost = 0;
  for (unsigned seed = 0; seed < 8; ++seed) {
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
    for (int k = 1; k <= 20; ++k) {
      const AdvanceReport report = stepper.advance(state, k * interval);
      ASSERT_EQ(report.reason, StopReason::reached_end) << report.detail << " at " << state.t;
      auditor.observe(state, report);
      if (k == 10) middle = state;
    }
    const Audit audit = auditor.audit(state);
    ASSERT_GE(audit.spans.size(), 2u);
    EXPECT_EQ(audit.spans.back().of.solver, SolverMethod::substep);
    for (const auto& span : audit.spans)
      lost += span.of.end_cause.find("by exact steps: body 'knot") != std::string::npos ? 1 : 0;

    // From where it was put aside the run goes the same way.
    AutoStepper again = fresh();
    State resumed = deserialise(serialise(middle));
    for (int k = 11; k <= 20; ++k) again.advance(resumed, k * interval);
    EXPECT_EQ(resumed, state);
  }
  EXPECT_GT(lost, 0);
}

TEST(Nets, AStepThatTakesTooMuchIsGivenUpWithinATry) {
  test::Random random(4200);
  for (int k = 0; k < 4; ++k) {
    SCOPED_TRACE(k);
    const std::shared_ptr<const Model> model = taut_net(random);
    Method method;
    method.scheme = Scheme::time_stepping;
    TimeStepper stepper(model, method, step);
    constexpr double limit = 1e5;
    stepper.set_work_limit(limit);
    State state = make_initial_state(*model);
    const State before = state;
    const std::uint64_t counted = work_counted();
    const AdvanceReport report = stepper.advance(state, step);
    EXPECT_EQ(report.reason, StopReason::interrupted);
    EXPECT_TRUE(stepper.is_beyond_work_limit());
    EXPECT_EQ(state, before);
    // It is asked for in each stage of an integrator, which factors the equations of the joints a few times.
    EXPECT_LE(static_cast<double>(work_counted() - counted), 1.5 * limit);
  }
}

}  // namespace
}  // namespace rigor::handover_test
