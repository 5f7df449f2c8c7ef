// Gravity scale and damping of a body in every scheme.

#include "rigor/sim/make_stepper.hpp"
#include "sim/time_stepping_scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rigor::body_scales_test {
namespace {

constexpr double kStep = 0.01, kTime = 0.5;

/// The method, and how far its velocities may be off after kTime, as a share.
struct MethodCase {
  Scheme scheme;
  SolverMethod solver;
  double error;
};

class ScaledBodies : public testing::TestWithParam<MethodCase> {
 protected:
  State run(const std::shared_ptr<const Model>& model) const {
    Method method;
    method.scheme = GetParam().scheme;
    method.solver = GetParam().solver;
    method.integrator = IntegratorMethod::exact;
    State state = make_initial_state(*model);
    const AdvanceReport report = make_stepper(model, method, kStep)->advance(state, kTime);
    EXPECT_EQ(report.reason, StopReason::reached_end);
    return state;
  }
};

TEST_P(ScaledBodies, GravityScaleIsTimesGravity) {
  ModelBuilder builder = test::stepping_builder(0, 0, Vec3(0, 0, -10));
  for (const double scale : {1.0, 0.0, -0.5, 3.0}) {
    BodyDescription body = test::stepping_body(std::to_string(scale), Sphere{0.1}, Vec3(10 * scale, 0, 100));
    body.gravity_scale = scale;
    builder.add_body(body);
  }
  const State state = run(builder.build());
  const double scales[] = {1, 0, -0.5, 3};
  for (int i = 0; i < 4; ++i)
    EXPECT_NEAR(state.linear_momentum(i + 1).z(), -10 * scales[i] * kTime, 15 * GetParam().error) << i;
}

TEST_P(ScaledBodies, DampedMomentaDecayExponentially) {
  ModelBuilder builder = test::stepping_builder(0, 0, Vec3::Zero());
  BodyDescription body = test::stepping_body("body", Box{Vec3(0.1, 0.2, 0.3)}, Vec3(0, 0, 100));
  body.velocity = Vec3(1, 2, 3);
  body.angular_velocity = Vec3(0, 0, 2);
  body.linear_damping = 3;
  body.angular_damping = 2;
  builder.add_body(body);
  const std::shared_ptr<const Model> model = builder.build();
  const State state = run(model);
  const double linear = std::exp(-3 * kTime), angular = std::exp(-2 * kTime);
  EXPECT_LT((state.linear_momentum(1) - linear * Vec3(1, 2, 3)).norm(), 4 * GetParam().error);
  const double L = 2 * model->body(1).moments[2];
  EXPECT_LT((state.angular_momentum(1) - angular * L * Vec3::UnitZ()).norm(), L * GetParam().error);
}

// Time-stepping and its kin take forces in steps of second order; 32-bit velocities are off by 1e-6 after the
// roundings of 400 substeps. Impulse-based flights are integrated to 1e-10.
INSTANTIATE_TEST_SUITE_P(Schemes, ScaledBodies,
                         testing::Values(MethodCase{Scheme::event_driven, SolverMethod::exact, 1e-9},
                                         MethodCase{Scheme::time_stepping, SolverMethod::exact, 1e-4},
                                         MethodCase{Scheme::time_stepping, SolverMethod::substep, 1e-5},
                                         MethodCase{Scheme::penalty, SolverMethod::exact, 1e-4},
                                         MethodCase{Scheme::impulse_based, SolverMethod::exact, 1e-4},
                                         MethodCase{Scheme::hybrid, SolverMethod::exact, 1e-4}));

TEST(BulkDrag, NoDragIsTooStrongForAStep) {
  // 1000/s at steps of 1/60 s: it falls at g/c, its velocity having no time to be another.
  ModelBuilder builder = test::stepping_builder(0, 0, Vec3(0, 0, -10));
  BodyDescription body = test::stepping_body("body", Box{Vec3(0.1, 0.2, 0.3)}, Vec3(0, 0, 100));
  body.velocity = Vec3(100, 0, 0);
  body.angular_velocity = Vec3(5, 0, 50);
  body.linear_damping = body.angular_damping = 1000;
  builder.add_body(body);
  const std::shared_ptr<const Model> model = builder.build();
  Method method;
  method.scheme = Scheme::time_stepping;
  method.solver = SolverMethod::substep;
  State state = make_initial_state(*model);
  make_stepper(model, method, 1.0 / 60)->advance(state, 0.5);
  EXPECT_LT((state.linear_momentum(1) - Vec3(0, 0, -0.01)).norm(), 1e-5);
  EXPECT_LT(state.angular_momentum(1).norm(), 1e-6);
}

}  // namespace
}  // namespace rigor::body_scales_test
