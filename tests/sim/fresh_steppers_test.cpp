// Whatever the scheme, the State alone says how a run goes on.

#include "rigor/model/model_builder.hpp"
#include "rigor/sim/make_stepper.hpp"

#include <gtest/gtest.h>

namespace rigor::fresh_steppers_test {
namespace {

/// A cube falls, tumbling, on a stack of two.
std::shared_ptr<const Model> tumbling_cube_on_a_stack() {
  ModelBuilder builder;
  builder.set_gravity(Vec3(0, 0, -9.81));
  builder.add_material({"m", 1000, 0.4, 0.3});
  const auto add = [&](const std::string& name, const Shape& shape, const Vec3& x, const Quat& q) {
    BodyDescription body;
    body.name = name;
    body.p_WU = x;
    body.q_WU = q;
    if (std::holds_alternative<HalfSpace>(shape)) {
      body.motion = MotionType::fixed;
    } else {
      body.mass = 1;
    }
    body.shapes.push_back({shape, Vec3::Zero(), Quat::Identity(), "m", ""});
    builder.add_body(body);
  };
  add("floor", HalfSpace{Vec3::UnitZ(), 0}, Vec3::Zero(), Quat::Identity());
  const Box cube{Vec3(0.1, 0.1, 0.1)};
  add("lower", cube, Vec3(0, 0, 0.1), Quat::Identity());
  add("upper", cube, Vec3(0, 0, 0.3), Quat::Identity());
  add("falling", cube, Vec3(0.05, 0.02, 0.7), Quat(0.9, 0.3, -0.2, 0.1).normalized());
  return builder.build();
}

class FreshSteppers : public testing::TestWithParam<Scheme> {};

TEST_P(FreshSteppers, ContinueBitForBit) {
  const std::shared_ptr<const Model> model = tumbling_cube_on_a_stack();
  Method method;
  method.scheme = GetParam();
  constexpr double step = 0.01, interval = 0.05;
  // The cube strikes at 0.163 s. Trains of micro-collisions and small steps take long.
  const bool is_located = method.scheme == Scheme::event_driven || method.scheme == Scheme::hybrid;
  const int intervals = is_located ? 20 : method.scheme == Scheme::impulse_based ? 2 : 6;
  State state = make_initial_state(*model);
  const std::unique_ptr<Stepper> kept = make_stepper(model, method, step);
  for (int k = 1; k <= intervals; ++k) {
    State copy = state;
    EXPECT_EQ(make_stepper(model, method, step)->advance(copy, interval * k).reason, StopReason::reached_end);
    EXPECT_EQ(kept->advance(state, interval * k).reason, StopReason::reached_end);
    ASSERT_EQ(state, copy) << "at t = " << state.t;
  }
}

INSTANTIATE_TEST_SUITE_P(Schemes, FreshSteppers,
                         testing::Values(Scheme::event_driven, Scheme::time_stepping, Scheme::penalty,
                                         Scheme::impulse_based, Scheme::hybrid));

}  // namespace
}  // namespace rigor::fresh_steppers_test
