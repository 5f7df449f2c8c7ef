#include "rigor/dynamics/free_flight.hpp"

#include "rigor/math/rotation.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace rigor::free_flight_test {
namespace {

constexpr double kEpsilon = 0x1p-52;

const BodyInertia kInertia{2.5, Vec3(1, 2, 2.5)};
const Vec3 kGravity(0, 0, -9.81);

BodyPhase some_phase() {
  return {Vec3(1, -2, 30), rotation_exp(Vec3(0.3, -0.1, 0.8)), Vec3(2, 0.5, 12), Vec3(0.4, -1, 0.2)};
}

TEST(FreeFlight, PositionIsTheExactParabolaAfterTenThousandSeconds) {
  const FreeFlight flight(kInertia, some_phase(), 3, kGravity);
  const double t = 10003;
  const BodyPhase phase = flight.at(t);
  for (int i = 0; i < 3; ++i) {
    const long double tau = 10000, v = static_cast<long double>(flight.start.P[i]) / 2.5L;
    const long double a = kGravity[i];
    const long double expected = flight.start.x[i] + v * tau + a * tau * tau / 2;
    const double scale = static_cast<double>(std::abs(v * tau) + std::abs(a * tau * tau / 2)) + 30;
    EXPECT_LE(std::abs(static_cast<double>(phase.x[i] - expected)), 1e-15 * scale);
    EXPECT_NEAR(flight.velocity(t)[i], static_cast<double>(v + a * tau), 1e-15 * scale);
    EXPECT_NEAR(phase.P[i], 2.5 * flight.velocity(t)[i], 1e-15 * 2.5 * 98100);
  }
}

TEST(FreeFlight, AngularMomentumIsConstantBitForBit) {
  const FreeFlight flight(kInertia, some_phase(), 3, kGravity);
  for (const double t : {-1e4, 3.0, 3.1, 77.7, 1e4}) EXPECT_EQ(flight.at(t).L, some_phase().L);
}

TEST(FreeFlight, EnergyIsConserved) {
  const FreeFlight flight(kInertia, some_phase(), 3, kGravity);
  const auto energy = [](const BodyPhase& phase) {
    return kinetic_energy(kInertia, phase) - kInertia.mass * kGravity.dot(phase.x);
  };
  for (const double t : {3.0, 3.1, 4.5, 10.0, 100.0}) {
    const BodyPhase phase = flight.at(t);
    const double scale = kinetic_energy(kInertia, phase) + kInertia.mass * 9.81 * std::abs(phase.x.z());
    EXPECT_NEAR(energy(phase), energy(some_phase()), 16 * kEpsilon * scale);
  }
}

TEST(FreeFlight, StartIsReturnedExactlyAtTheEpoch) {
  const FreeFlight flight(kInertia, some_phase(), 3, kGravity);
  const BodyPhase phase = flight.at(3);
  EXPECT_EQ(phase.x, some_phase().x);
  EXPECT_EQ(phase.q.coeffs(), some_phase().q.coeffs());
  EXPECT_EQ(phase.P, some_phase().P);
}

TEST(FreeFlight, PathBoxHoldsThePathAndIsTight) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int trial = 0; trial < 100; ++trial) {
    BodyPhase phase = some_phase();
    phase.P = 10 * Vec3(uniform(random), uniform(random), uniform(random));
    const Vec3 a_W = trial % 3 == 0 ? Vec3::Zero() : Vec3(uniform(random), 0, 4 * uniform(random));
    const FreeFlight flight(kInertia, phase, 0, a_W);
    const double ta = 3 * uniform(random), tb = ta + 4 * std::abs(uniform(random));
    const Aabb box = flight.path_box(ta, tb);
    Aabb seen{flight.position(ta), flight.position(ta)};
    constexpr int samples = 500;
    for (int i = 0; i <= samples; ++i) {
      const Vec3 x = flight.position(ta + (tb - ta) * i / samples);
      EXPECT_TRUE(box.contains({x, x}));
      seen = seen.united({x, x});
    }
    // Samples miss a vertex by at most a δ²/8, δ their distance in time.
    const double miss = 4 * std::pow((tb - ta) / samples, 2) / 8 + 1e-13;
    EXPECT_TRUE(seen.grown(miss).contains(box));
  }
}

TEST(FreeFlight, ScalingTheUnitsByPowersOfTwoIsExact) {
  // Lengths times 8, times 4, masses as they are.
  const FreeFlight flight(kInertia, some_phase(), 1, kGravity);
  BodyPhase phase = some_phase();
  phase.x *= 8;
  phase.P *= 8.0 / 4;
  phase.L *= 64.0 / 4;
  const FreeFlight scaled({kInertia.mass, 64 * kInertia.moments}, phase, 4, kGravity * (8.0 / 16));
  const BodyPhase here = flight.at(6.3), there = scaled.at(4 * 6.3);
  EXPECT_EQ(there.x, 8 * here.x);
  EXPECT_EQ(there.q.coeffs(), here.q.coeffs());
  EXPECT_EQ(there.P, 2 * here.P);
  EXPECT_EQ(scaled.path_box(4 * 2, 4 * 5).upper, 8 * flight.path_box(2, 5).upper);
}

}  // namespace
}  // namespace rigor::free_flight_test
