#include "rigor/sim/fixed_steps/stepper.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/interrupt.hpp"
#include "rigor/model/model_builder.hpp"
#include "rigor/sim/make_stepper.hpp"
#include "rigor/sim/simulation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <memory>

namespace rigor::stepper_test {
namespace {

/// A ball on a stiff and damped distance joint of a light one, under a drag: no explicit integrator follows
/// it with steps that a user has the patience for.
std::shared_ptr<const Model> stiff_model(double stiffness, double damping, double mass, double drag) {
  ModelBuilder builder;
  BodyDescription light;
  light.name = "light";
  light.p_WU = Vec3(0, 0, 3);
  light.mass = mass;
  light.linear_drag = light.angular_drag = drag;
  light.shapes.push_back({Sphere{0.1}});
  BodyDescription heavy = light;
  heavy.name = "heavy";
  heavy.p_WU = Vec3(0.3, 0, 3);
  heavy.mass = 1;
  heavy.linear_drag = heavy.angular_drag = 0;
  builder.add_body(light);
  builder.add_body(heavy);
  ModelBuilder::JointDescription joint;
  joint.name = "s";
  joint.type = JointType::distance;
  joint.bodies = {"light", "heavy"};
  joint.anchors = {Vec3(0, 0, 3), Vec3(0.3, 0, 3)};
  joint.axes.push_back({.lower = 0.2, .upper = 0.5, .stiffness = stiffness, .damping = damping});
  builder.add_joint(joint);
  return builder.build();
}

/// A stepper that does one thing to the State and then what the test says.
class Broken : public Stepper {
 public:
  explicit Broken(std::function<void(State&)> act) : act_(std::move(act)) {}

 protected:
  AdvanceReport advance_span(State& state, double t_end) override {
    state.t = 0.5 * (state.t + t_end);
    act_(state);
    AdvanceReport report;
    report.steps = 7;
    return report;
  }
  double time_reached() const override { return 0.25; }

 private:
  std::function<void(State&)> act_;
};

State one_body() {
  State state;
  state.x = {1, 2, 3};
  state.q = {1, 0, 0, 0};
  state.P = {0, 0, 0};
  state.L = {0, 0, 0};
  state.epoch = {0};
  state.anchor.assign(13, 0);
  return state;
}

TEST(Stepper, ABrokenPromiseIsAReportWithItsPlaceAndTheStateStays) {
  State state = one_body();
  Broken stepper([](State&) { RIGOR_ASSERT(1 + 1 == 3); });
  const AdvanceReport report = stepper.advance(state, 1);
  EXPECT_EQ(report.reason, StopReason::broken_promise);
  EXPECT_NE(report.detail.find("stepper_test.cpp:"), std::string::npos) << report.detail;
  EXPECT_NE(report.detail.find("broken promise: 1 + 1 == 3, at t = 0.25 s"), std::string::npos)
      << report.detail;
  EXPECT_EQ(report.steps, 0);
  EXPECT_EQ(state, one_body());
}

TEST(Stepper, AnInterruptWithinAStepLeavesTheState) {
  State state = one_body();
  int asked = 0;
  Broken stepper([](State&) {
    while (true) poll_interrupt();
  });
  stepper.set_interrupt([&asked] { return ++asked == 1000; });
  EXPECT_EQ(stepper.advance(state, 1).reason, StopReason::interrupted);
  EXPECT_EQ(asked, 1000);
  EXPECT_EQ(state, one_body());
}

TEST(Stepper, NumbersThatAreNoneNeverLeaveIt) {
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(), 5.5e229}) {
    State state = one_body();
    Broken stepper([bad](State& inner) { inner.P[1] = bad; });
    const AdvanceReport report = stepper.advance(state, 1);
    EXPECT_EQ(report.reason, StopReason::not_finite) << bad;
    EXPECT_EQ(report.bodies, std::vector<int>{0});
    EXPECT_EQ(state, one_body());
  }
}

TEST(InterruptScope, TheInnermostIsAskedAndTheOuterOneComesBack) {
  EXPECT_NO_THROW(poll_interrupt());
  const std::function<bool()> yes = [] { return true; }, no = [] { return false; };
  const InterruptScope outer(yes);
  EXPECT_THROW(poll_interrupt(), Interrupted);
  {
    const InterruptScope inner(no);
    EXPECT_NO_THROW(poll_interrupt());
  }
  EXPECT_THROW(poll_interrupt(), Interrupted);
}

/// Whatever the numbers, every scheme asks its interrupt within a step, ends when it says so, and leaves
/// numbers.
TEST(Stepper, StiffScenesEndWhenAsked) {
  for (const Scheme scheme : {Scheme::event_driven, Scheme::time_stepping, Scheme::impulse_based,
                              Scheme::hybrid, Scheme::penalty}) {
    for (const double stiffness : {0.0, 1e6, 1e12}) {
      for (const double drag : {0.0, 1e15}) {
        const auto model = stiff_model(stiffness, stiffness / 1e3, 1e-6, drag);
        Method method;
        method.scheme = scheme;
        const std::unique_ptr<Stepper> stepper = make_stepper(model, method, 0.01);
        State state = make_initial_state(*model);
        const State before = state;
        long asked = 0;
        stepper->set_interrupt([&asked] { return ++asked > 3000; });
        const AdvanceReport report = stepper->advance(state, 0.1);
        EXPECT_LE(asked, 3002);
        EXPECT_NE(report.reason, StopReason::broken_promise) << report.detail;
        if (report.reason == StopReason::not_finite) {
          EXPECT_EQ(state, before);
        }
        for (const double x : state.x) EXPECT_TRUE(std::isfinite(x * x));
        for (const double P : state.P) EXPECT_TRUE(std::isfinite(P * P));
      }
    }
  }
}

}  // namespace
}  // namespace rigor::stepper_test
