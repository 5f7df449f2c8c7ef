#include "apps/motion_comparison.hpp"

#include "rigor/sim/simulation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace rigor::motion_comparison_test {
namespace {

/// Two bodies in free flight without gravity; b turns about z at `spin` rad/s. Output times 0, interval, ...
/// end.
Scene flight(double velocity_of_a, double spin, double interval = 0.25, double end = 1,
             const std::string& name_of_b = "b") {
  return parse_scene("rigor: 1\nworld: {gravity: [0, 0, 0]}\nrun: {duration: " + std::to_string(end) +
                         ", output_interval: " + std::to_string(interval) +
                         "}\nbodies:\n"
                         "  - {name: a, mass: 1, velocity: [" +
                         std::to_string(velocity_of_a) +
                         ", 0, 0], shapes: [{type: sphere, radius: 0.1}]}\n"
                         "  - {name: " +
                         name_of_b + ", mass: 2, position: [0, 5, 0], angular_velocity: [0, 0, " +
                         std::to_string(spin) + "], shapes: [{type: sphere, radius: 0.1}]}\n",
                     "flight.yaml", ".");
}

std::optional<MotionDifference> difference_of(const Scene& scene, MotionComparison& comparison) {
  comparison.begin(scene);
  run_simulation(scene.model, scene.method, scene.run, std::nullopt,
                 [&](const State& state, const AdvanceReport&, const Auditor& auditor) {
                   comparison.observe(state, auditor.energy());
                   return true;
                 });
  return comparison.finish();
}

TEST(MotionComparison, TheLargestDifferencesAtTheEndNameTheirBodies) {
  MotionComparison comparison;
  EXPECT_FALSE(difference_of(flight(1, 1), comparison));
  const std::optional<MotionDifference> same = difference_of(flight(1, 1), comparison);
  ASSERT_TRUE(same);
  for (const LargestDifference& largest : {same->position, same->rotation, same->velocity, same->spin})
    EXPECT_EQ(largest.value, 0);
  const std::optional<MotionDifference> other = difference_of(flight(1.5, -1), comparison);
  ASSERT_TRUE(other);
  EXPECT_EQ(other->time, 1);
  // a is 0.5 m/s faster for 1 s; b turned by 1 rad one way and the other.
  EXPECT_EQ(other->position.value, 0.5);
  EXPECT_EQ(other->position.body, "a");
  EXPECT_EQ(other->velocity.value, 0.5);
  EXPECT_EQ(other->velocity.body, "a");
  EXPECT_NEAR(other->rotation.value, 2, 1e-14);
  EXPECT_EQ(other->rotation.body, "b");
  EXPECT_NEAR(other->spin.value, 2, 1e-14);
  EXPECT_EQ(other->spin.body, "b");
}

TEST(MotionComparison, RunsOfDifferentLengthsMeetAtTheirLastCommonOutputTime) {
  MotionComparison comparison;
  difference_of(flight(1, 0), comparison);
  const std::optional<MotionDifference> shorter = difference_of(flight(2, 0, 0.25, 0.6), comparison);
  ASSERT_TRUE(shorter);
  // Output times 0, 0.25, 0.5, 0.6: the last of them that the reference has too is 0.5 s.
  EXPECT_EQ(shorter->time, 0.5);
  EXPECT_EQ(shorter->position.value, 0.5);
  const std::optional<MotionDifference> longer = difference_of(flight(2, 0, 0.25, 3), comparison);
  ASSERT_TRUE(longer);
  EXPECT_EQ(longer->time, 1);
  EXPECT_EQ(longer->position.value, 1);
}

TEST(MotionComparison, TimesThatDifferByRoundingAreTheSame) {
  // 0.3 is not 3 x 0.1 in doubles.
  ASSERT_NE(3 * 0.1, 0.3);
  MotionComparison comparison;
  difference_of(flight(1, 0, 0.1, 0.35), comparison);
  const std::optional<MotionDifference> coarser = difference_of(flight(2, 0, 0.3, 0.32), comparison);
  ASSERT_TRUE(coarser);
  EXPECT_NEAR(coarser->time, 0.3, 1e-15);
  EXPECT_NEAR(coarser->position.value, 0.3, 1e-15);
}

TEST(MotionComparison, BodiesAreFoundByNameAndThoseOfOneRunAreLeftOut) {
  MotionComparison comparison;
  difference_of(flight(1, 0), comparison);
  const std::optional<MotionDifference> other = difference_of(flight(1, 5, 0.25, 1, "only_here"), comparison);
  ASSERT_TRUE(other);
  EXPECT_EQ(other->spin.value, 0);
  EXPECT_EQ(other->spin.body, "");
}

TEST(MotionComparison, WithLittleMemoryItComparesAtAnEarlierTimeAndStillAtTheEnd) {
  // Two bodies take 31 numbers an output time: room for about four of the five.
  MotionComparison comparison(4 * 31 * sizeof(double));
  difference_of(flight(1, 0), comparison);
  const std::optional<MotionDifference> whole = difference_of(flight(2, 0), comparison);
  ASSERT_TRUE(whole);
  EXPECT_EQ(whole->time, 1);
  EXPECT_EQ(whole->position.value, 1);
  const std::optional<MotionDifference> part = difference_of(flight(2, 0, 0.25, 0.75), comparison);
  ASSERT_TRUE(part);
  EXPECT_EQ(part->time, 0.5);
  EXPECT_EQ(part->position.value, 0.5);
}

TEST(MotionComparison, AnglesAreExactWhereTheyAreSmallAndTakeTheShorterWay) {
  const Quat start(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()));
  for (const double angle : {1e-12, 1e-3, 1.0, 3.0}) {
    const Quat end = start * Quat(Eigen::AngleAxisd(angle, Vec3(2, -1, 1).normalized()));
    // Quaternions carry roundings of 1e-16 in each number.
    EXPECT_NEAR(rotation_angle(start, end), angle, 2e-15);
    EXPECT_NEAR(rotation_angle(start, Quat(-end.coeffs())), angle, 2e-15);
  }
  const Quat most = start * Quat(Eigen::AngleAxisd(4, Vec3::UnitX()));
  EXPECT_NEAR(rotation_angle(start, most), 2 * std::numbers::pi - 4, 2e-15);
}

}  // namespace
}  // namespace rigor::motion_comparison_test
