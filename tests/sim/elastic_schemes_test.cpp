#include "rigor/dynamics/environment.hpp"
#include "rigor/model/model_builder.hpp"
#include "rigor/sim/make_stepper.hpp"
#include "rigor/sim/report/energy.hpp"

#include <gtest/gtest.h>

#include <random>

namespace rigor::elastic_schemes_test {
namespace {

/// n³ balls of restitution 1 above a floor, as SimBenchmark's "elastic 666": r = 0.1 m, m = 10 kg, 0.21 m
/// apart, moved by up to a millimetre, the lowest 1.101 m up.
std::shared_ptr<const Model> elastic_cube(int n) {
  ModelBuilder builder;
  builder.set_gravity(Vec3(0, 0, -9.81));
  builder.add_material({"m", 1000, 0, 1});
  BodyDescription floor;
  floor.name = "floor";
  floor.motion = MotionType::fixed;
  floor.shapes.push_back({HalfSpace{Vec3::UnitZ(), 0}, Vec3::Zero(), Quat::Identity(), "m", ""});
  builder.add_body(floor);
  std::mt19937 generator(1);
  const auto jitter = [&] { return 1e-3 * static_cast<double>(generator()) / 4294967296.0; };
  for (int k = 0; k < n * n * n; ++k) {
    BodyDescription ball;
    ball.name = "ball" + std::to_string(k);
    const double x = 0.21 * (k % n) + jitter(), y = 0.21 * (k / n % n) + jitter();
    ball.p_WU = Vec3(x, y, 1.101 + 0.21 * (k / (n * n)) + jitter());
    ball.mass = 10;
    ball.shapes.push_back({Sphere{0.1}, Vec3::Zero(), Quat::Identity(), "m", ""});
    builder.add_body(ball);
  }
  return builder.build();
}

class ElasticBalls : public testing::TestWithParam<Scheme> {};

TEST_P(ElasticBalls, KeepTheirEnergyToRounding) {
  const std::shared_ptr<const Model> model = elastic_cube(3);
  Method method;
  method.scheme = GetParam();
  const std::unique_ptr<Stepper> stepper = make_stepper(model, method, 1e-3);
  State state = make_initial_state(*model);
  const Environment environment(*model);
  const double start = mechanical_energy(*model, environment, state).total();
  double sum = 0;
  constexpr int outputs = 200;
  long impacts = 0;
  for (int k = 1; k <= outputs; ++k) {
    const AdvanceReport report = stepper->advance(state, 0.01 * k);
    ASSERT_EQ(report.reason, StopReason::reached_end);
    impacts += report.impacts;
    const double error = mechanical_energy(*model, environment, state).total() - start;
    sum += error * error;
  }
  EXPECT_GT(impacts, 50);
  // SimBenchmark's measure, here of some 4000 J.
  EXPECT_LE(sum / outputs, 1e-18 * start * start);
}

INSTANTIATE_TEST_SUITE_P(Schemes, ElasticBalls,
                         testing::Values(Scheme::event_driven, Scheme::impulse_based, Scheme::hybrid));

}  // namespace
}  // namespace rigor::elastic_schemes_test
