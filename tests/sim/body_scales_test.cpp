// Gravity scale and damping of a body in every scheme.

#include "random_vectors.hpp"
#include "rigor/sim/make_stepper.hpp"
#include "sim/time_stepping_scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <utility>

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

/// A ball, a box and a hinged pair that fall on a floor and slide, with lengths L times, times √L times and
/// masses M times those of a scene of some decimetres and kilograms.
std::shared_ptr<const Model> scaled_scene(unsigned seed, double L, double M) {
  test::Random random(seed);
  const double T = std::sqrt(L), V = L / T;
  ModelBuilder builder;
  builder.set_gravity(Vec3(0, 0, -9.81));
  builder.add_material({"m", 1000 * M / (L * L * L), random.uniform(0, 0.8), random.uniform(0, 0.8)});
  BodyDescription floor = test::stepping_body("floor", HalfSpace{Vec3::UnitZ(), 0}, Vec3::Zero());
  floor.motion = MotionType::fixed, floor.mass = {};
  builder.add_body(floor);
  const auto add = [&](const std::string& name, const Shape& shape, const Vec3& p) {
    BodyDescription body = test::stepping_body(name, shape, L * p);
    body.mass = {};
    body.q_WU = Quat(random.number(), random.number(), random.number(), random.number()).normalized();
    body.velocity = V * random.vector();
    body.angular_velocity = 4 / T * random.vector();
    builder.add_body(body);
  };
  add("ball", Sphere{0.1 * L}, Vec3(0, 0, 0.2));
  add("box", Box{L * Vec3(0.1, 0.08, 0.05)}, Vec3(0.5, 0, 0.3));
  add("arm", Box{L * Vec3(0.05, 0.05, 0.1)}, Vec3(-0.5, 0, 0.5));
  add("hand", Sphere{0.06 * L}, Vec3(-0.5, 0.2, 0.5));
  ModelBuilder::JointDescription hinge;
  hinge.name = "hinge";
  hinge.type = JointType::ball;
  hinge.bodies = {"arm", "hand"};
  hinge.anchors = {L * Vec3(-0.5, 0.1, 0.5)};
  builder.add_joint(hinge);
  return builder.build();
}

struct ScaleCase {
  Scheme scheme;
  double error;  ///< Of places, as a share of the scene's lengths.
};
class ScaledUnits : public testing::TestWithParam<ScaleCase> {};

// Besides the numbers that the method states no scheme knows a length, a speed or a mass.
TEST_P(ScaledUnits, ChangeNoMotion) {
  const auto end = [&](unsigned seed, double L, double M) {
    const double T = std::sqrt(L);
    Method method;
    method.scheme = GetParam().scheme;
    method.contact_tolerance = 1e-8 * L;
    method.resting_velocity = 1e-3 * L / T;
    method.penalty_depth = 1e-4 * L;
    method.time_tolerance = 1e-12 * T;
    const std::shared_ptr<const Model> model = scaled_scene(seed, L, M);
    State state = make_initial_state(*model);
    const AdvanceReport report = make_stepper(model, method, 0.005 * T)->advance(state, 0.4 * T);
    EXPECT_EQ(report.reason, StopReason::reached_end);
    return state;
  };
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const State expected = end(seed, 1, 1);
    for (const auto& [L, M] : {std::pair{1e-3, 1e-9}, {0.01, 1.0}, {30.0, 1e3}, {1e3, 1e9}}) {
      const State found = end(seed, L, M);
      for (int i = 1; i < found.body_count(); ++i)
        EXPECT_LT((found.position(i) / L - expected.position(i)).norm(), GetParam().error)
            << "seed " << seed << ", lengths " << L << ", body " << i;
    }
  }
}

// Impacts enlarge what is rounded; sub-steps of the penalty scheme are counted in whole numbers.
INSTANTIATE_TEST_SUITE_P(Schemes, ScaledUnits,
                         testing::Values(ScaleCase{Scheme::event_driven, 1e-6},
                                         ScaleCase{Scheme::time_stepping, 1e-9},
                                         ScaleCase{Scheme::penalty, 1e-3}));

}  // namespace
}  // namespace rigor::body_scales_test
