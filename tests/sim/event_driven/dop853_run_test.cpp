#include "rigor/math/rotation.hpp"
#include "rigor/model/model_builder.hpp"
#include "rigor/sim/event_driven/event_driven_stepper.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rigor::dop853_run_test {
namespace {

/// A box that tumbles freely.
std::shared_ptr<const Model> free_top() {
  ModelBuilder builder;
  builder.set_gravity(Vec3::Zero());
  BodyDescription top;
  top.name = "top";
  top.mass = 1;
  top.shapes.push_back({Box{Vec3(0.1, 0.2, 0.3)}, Vec3::Zero(), Quat::Identity(), "", ""});
  top.angular_velocity = Vec3(0.3, 2, 0.5);
  builder.add_body(top);
  return builder.build();
}

struct TopRun {
  Quat q;
  long steps = 0, coarse_steps = 0;
};

/// The top at t = 3.
TopRun run_top(IntegratorMethod integrator, double tolerance, double target_step) {
  const std::shared_ptr<const Model> model = free_top();
  Method method;
  method.integrator = integrator;
  method.tolerance = tolerance;
  State state = make_initial_state(*model);
  const AdvanceReport report = EventDrivenStepper(model, method, target_step).advance(state, 3);
  EXPECT_EQ(report.reason, StopReason::reached_end);
  return {state.orientation(0), report.steps, report.coarse_steps};
}

double error_of(const TopRun& run) {
  return rotation_angle_between(run.q, run_top(IntegratorMethod::exact, 1e-10, 0.01).q);
}

// With a tolerance that no step breaks, all steps are the target step.
TEST(Dop853Run, AFreeTopConvergesAtOrderEightInTheTargetStep) {
  const TopRun coarse = run_top(IntegratorMethod::dop853, 0.1, 0.375),
               fine = run_top(IntegratorMethod::dop853, 0.1, 0.1875);
  EXPECT_EQ(coarse.steps, 8);
  EXPECT_EQ(fine.steps, 16);
  EXPECT_NEAR(std::log2(error_of(coarse) / error_of(fine)), 8, 0.4);
}

TEST(Dop853Run, StepsAreAsShortAsTheToleranceAsksAndFewerThanThoseOfDopri5) {
  for (const double tolerance : {1e-8, 1e-10, 1e-12}) {
    const TopRun run = run_top(IntegratorMethod::dop853, tolerance, 1);
    EXPECT_LT(error_of(run), 300 * tolerance);
    EXPECT_EQ(run.coarse_steps, 0);
    EXPECT_GT(run.steps, 3);
    // Sixteen stages a step against seven.
    EXPECT_LT(16 * run.steps, 7 * run_top(IntegratorMethod::dopri5, tolerance, 1).steps) << tolerance;
  }
}

}  // namespace
}  // namespace rigor::dop853_run_test
