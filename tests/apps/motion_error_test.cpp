#include "apps/motion_error.hpp"

#include "rigor/math/rotation.hpp"
#include "rigor/sim/simulation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace rigor::motion_error_test {
namespace {

constexpr double kForever = std::numeric_limits<double>::infinity();

/// A ball of radius 0.1 m and one of 0.2 m in free flight; the second turns about z.
Scene flight(double velocity, double spin, const std::string& more = "", double end = 1) {
  return parse_scene("rigor: 1\nworld: {gravity: [0, 0, 0]}\nrun: {duration: " + std::to_string(end) +
                         ", output_interval: 0.25}\nbodies:\n  - {name: a, mass: 1, velocity: [" +
                         std::to_string(velocity) +
                         ", 0, 0], shapes: [{type: sphere, radius: 0.1}]}\n"
                         "  - {name: b, mass: 2, position: [0, 5, 0], angular_velocity: [0, 0, " +
                         std::to_string(spin) + "], shapes: [{type: sphere, radius: 0.2}]}\n" + more,
                     "flight.yaml", ".");
}

template <typename Watch>
void run(const Scene& scene, Watch watch) {
  run_simulation(scene.model, scene.method, scene.run, std::nullopt,
                 [&](const State& state, const AdvanceReport&, const Auditor& auditor) {
                   watch(state, auditor.energy());
                   return true;
                 });
}

std::optional<MotionError> error_over_time(const Scene& scene, const Scene& reference, double bound,
                                           double horizon = kForever) {
  MotionRecorder keeper(reference);
  run(reference, [&](const State& state, const Energy& energy) {
    keeper.write(make_sample(*reference.model, state, energy), {});
  });
  ErrorOverTime measure(scene.model, keeper.recording(), bound, horizon);
  run(scene, [&](const State& state, const Energy& energy) { measure.observe(state, energy); });
  return measure.error();
}

TEST(LargestPointDistance, IsThatOfTheWorstPointOfTheBall) {
  const double radius = 0.7;
  // The largest distance is along s of length ρ that (Q - I) takes in the direction of Δ across n; a search
  // over directions finds it from below.
  for (int trial = 0; trial < 20; ++trial) {
    const double t = 0.3 * trial;
    const Vec3 p(std::sin(t), std::cos(2 * t), 0.5 * t), other(0.1, -0.2, 0.3);
    const Quat q = rotation_exp(Vec3(0.2 * t, -0.1, 0.05 * t)), q_other = rotation_exp(Vec3(0.3, t, -0.2));
    const double expected = largest_point_distance(p, q, other, q_other, radius);
    double found = 0;
    constexpr int steps = 120;
    for (int i = 0; i <= steps; ++i) {
      for (int k = 0; k < 2 * steps; ++k) {
        const double polar = M_PI * i / steps, azimuth = M_PI * k / steps;
        const Vec3 r = radius * Vec3(std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth),
                                     std::cos(polar));
        found = std::max(found, (p + q * r - other - q_other * r).norm());
      }
    }
    EXPECT_LE(found, expected * (1 + 1e-14)) << trial;
    // The nearest direction of the grid is off by at most δ = 1/2 √2 π/120 rad; a maximum loses δ² of its
    // length.
    EXPECT_GT(found, expected - 4 * radius * 3.5e-4) << trial;
  }
}

TEST(LargestPointDistance, OfPureMotionsIsTheirOwn) {
  const Quat one = Quat::Identity(), turned = rotation_exp(Vec3(0, 0, 0.5));
  EXPECT_EQ(largest_point_distance(Vec3(1, 2, 2), one, Vec3::Zero(), one, 9), 3);
  // A point of the equator moves by the chord.
  EXPECT_NEAR(largest_point_distance(Vec3::Zero(), turned, Vec3::Zero(), one, 2), 4 * std::sin(0.25), 1e-15);
  // Along the axis the two are at right angles.
  EXPECT_NEAR(largest_point_distance(Vec3(0, 0, 3), turned, Vec3::Zero(), one, 2),
              std::hypot(3, 4 * std::sin(0.25)), 1e-15);
  EXPECT_EQ(largest_point_distance(Vec3(1, 0, 0), turned, Vec3::Zero(), one, 0), 1);
}

TEST(ErrorOverTime, IsTheLargestOfAllTimesWithBodyAndTime) {
  EXPECT_EQ(error_over_time(flight(1, 1), flight(1, 1), 1)->position.value, 0);
  // a is 0.25 m/s faster; b turns 0.5 rad/s faster, so that its points are off by 0.4 sin(t/4).
  const MotionError error = error_over_time(flight(1.25, 1.5), flight(1, 1), 1).value();
  EXPECT_EQ(error.position.value, 0.25);
  EXPECT_EQ(error.position.body, "a");
  EXPECT_EQ(error.position.time, 1);
  EXPECT_NEAR(error.angle.value, 0.5, 1e-14);
  EXPECT_EQ(error.angle.body, "b");
  EXPECT_TRUE(error.is_good_throughout);
  EXPECT_EQ(error.good_until, 1);
  EXPECT_NEAR(error_over_time(flight(1, 1.5), flight(1, 1), 1)->position.value, 0.4 * std::sin(0.25), 1e-14);
}

TEST(ErrorOverTime, TellsUntilWhenTheMotionIsGood) {
  // 0.25 m/s: 0.0625, 0.125, 0.1875, 0.25 m at the output times.
  const MotionError error = error_over_time(flight(1.25, 0), flight(1, 0), 0.15).value();
  EXPECT_FALSE(error.is_good_throughout);
  EXPECT_EQ(error.good_until, 0.5);
  EXPECT_EQ(error.compared_until, 1);
}

TEST(ErrorOverTime, IsNotMeasuredBeyondTheHorizon) {
  const MotionError error = error_over_time(flight(1.25, 0), flight(1, 0), 1, 0.5).value();
  EXPECT_EQ(error.position.value, 0.125);
  EXPECT_EQ(error.compared_until, 0.5);
}

TEST(ErrorOverTime, EndsWhereEitherMotionEnds) {
  EXPECT_EQ(error_over_time(flight(1.25, 0, "", 0.5), flight(1, 0), 1)->compared_until, 0.5);
  EXPECT_EQ(error_over_time(flight(1.25, 0), flight(1, 0, "", 0.5), 1)->compared_until, 0.5);
}

TEST(ErrorAtPlaces, ComparesOriginsAndFramesAtTheirTimes) {
  const Scene scene = flight(1, 0.5,
                             "expect:\n"
                             "  - {body: a, time: 0.5, position: [0.5, 0.25, 0]}\n"
                             "  - {body: a, time: 0.3, position: [9, 9, 9]}\n"
                             "  - {body: b, time: 1, orientation: [1, 0, 0, 0]}\n");
  ErrorAtPlaces measure(scene.model, scene.expected, 0.1);
  run(scene, [&](const State& state, const Energy& energy) { measure.observe(state, energy); });
  const MotionError error = measure.error().value();
  // At 0.3 s there is no output.
  EXPECT_EQ(error.position.value, 0.25);
  EXPECT_EQ(error.position.body, "a");
  EXPECT_EQ(error.position.time, 0.5);
  EXPECT_NEAR(error.angle.value, 0.5, 1e-14);
  EXPECT_EQ(error.angle.body, "b");
  EXPECT_FALSE(error.is_good_throughout);
}

TEST(ErrorAtPlaces, IsUnknownWithoutACommonTime) {
  const Scene scene = flight(1, 0, "expect: [{body: a, time: 0.3, position: [9, 9, 9]}]\n");
  ErrorAtPlaces measure(scene.model, scene.expected, 0.1);
  run(scene, [&](const State& state, const Energy& energy) { measure.observe(state, energy); });
  EXPECT_FALSE(measure.error());
}

TEST(DefaultErrorBound, IsAHundredthOfTheLargestMovingBody) {
  EXPECT_DOUBLE_EQ(default_error_bound(*flight(0, 0).model), 0.002);
}

}  // namespace
}  // namespace rigor::motion_error_test
