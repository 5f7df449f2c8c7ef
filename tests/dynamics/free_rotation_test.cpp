#include "rigor/dynamics/free_rotation.hpp"

#include "dynamics/long_double_rotation.hpp"
#include "rigor/math/rotation.hpp"

#include <cmath>
#include <fstream>
#include <random>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace rigor::free_rotation_test {
namespace {

constexpr double kEpsilon = 0x1p-52;

Vec3 body_angular_velocity(const Vec3& moments, const Quat& q, const Vec3& L) {
  return (rotation_matrix(q).transpose() * L).cwiseQuotient(moments);
}

double distance(const Quat& a, const Quat& b) {
  return (a.coeffs() - b.coeffs()).norm();
}

/// Rounding of the phase: the rates that the input fixes carry a few ε, so the angle a few ε ω t. Noise of ε
/// |L| in the component along the smallest moment is a rate too.
double expected_error(const Vec3& moments, const Vec3& L, const FreeRotation& rotation, double t) {
  const double rate = rotation.max_angular_speed() + L.norm() / moments.minCoeff();
  return kEpsilon * (8 + 4 * rate * std::abs(t));
}

void expect_agrees_with_series(const Vec3& moments, const Quat& q, const Vec3& L, double t,
                               double factor = 1) {
  const FreeRotation rotation(moments, q, L);
  const Quat expected = tests::rotate_extended(moments, q, L, t).quaternion();
  EXPECT_LE(distance(rotation.orientation(t), expected), factor * expected_error(moments, L, rotation, t))
      << "moments " << moments.transpose() << ", L " << L.transpose() << ", t " << t;
}

/// Random moments of a body that can exist, in ascending order.
Vec3 random_moments(std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  const Vec3 p(std::exp(uniform(random)), std::exp(uniform(random)), std::exp(uniform(random)));
  Vec3 moments(p[1] + p[2], p[0] + p[2], p[0] + p[1]);
  std::sort(moments.begin(), moments.end());
  return moments;
}

Vec3 random_direction(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  return Vec3(normal(random), normal(random), normal(random)).normalized();
}

Quat random_attitude(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  return Quat(normal(random), normal(random), normal(random), normal(random)).normalized();
}

TEST(FreeRotation, DzhanibekovBodyAgreesWithReferenceTo1em12) {
  std::ifstream file(std::string(RIGOR_TEST_DATA) + "/dzhanibekov.json");
  const nlohmann::json data = nlohmann::json::parse(file);
  const Vec3 moments(data["moments"][0], data["moments"][1], data["moments"][2]);
  const Vec3 L = moments.cwiseProduct(Vec3(data["w"][0], data["w"][1], data["w"][2]));
  const FreeRotation rotation(moments, Quat::Identity(), L);
  for (const auto& sample : data["samples"]) {
    const Quat q = rotation.orientation(sample["t"]);
    const Vec3 w(sample["w"][0], sample["w"][1], sample["w"][2]);
    EXPECT_LE((body_angular_velocity(moments, q, L) - w).norm(), 1e-12) << sample["t"];
    if (!sample.contains("q")) continue;
    const Quat expected(sample["q"][0], sample["q"][1], sample["q"][2], sample["q"][3]);
    EXPECT_LE(distance(q, expected), 1e-12) << sample["t"];
  }
  // The motion in the body repeats after one period.
  const Vec3 later = body_angular_velocity(moments, rotation.orientation(data["period"]), L);
  EXPECT_LE((later - L.cwiseQuotient(moments)).norm(), 1e-13);
  EXPECT_LE(std::abs(body_angular_velocity(moments, rotation.orientation(data["first_w2_zero"]), L)[1]),
            1e-13);
}

TEST(FreeRotation, EnergyAndAngularMomentumHoldOverManyEvaluations) {
  const Vec3 moments(1, 2, 3);
  const Vec3 L = moments.cwiseProduct(Vec3(0.01, 1, 0.01));
  const FreeRotation rotation(moments, Quat::Identity(), L);
  const BodyInertia inertia{1, moments};
  BodyPhase phase{.L = L};
  const double energy = kinetic_energy(inertia, phase);
  double worst = 0;
  for (int i = 1; i <= 200000; ++i) {
    phase.q = rotation.orientation(5e-4 * i);
    worst = std::max(worst, std::abs(kinetic_energy(inertia, phase) - energy));
  }
  EXPECT_LE(worst, 1e-14 * energy);
}

TEST(FreeRotation, GenericBodiesAgreeWithTheTaylorSeries) {
  std::mt19937_64 random(1);
  for (int trial = 0; trial < 100; ++trial) {
    const double t = (trial % 2 ? 1 : -1) * 20.0 * (trial + 1) / 100;
    expect_agrees_with_series(random_moments(random), random_attitude(random), 2 * random_direction(random),
                              t);
  }
}

TEST(FreeRotation, MomentsInAnyOrderAgreeWithTheTaylorSeries) {
  const Vec3 orders[] = {{1, 2, 2.5}, {1, 2.5, 2}, {2, 1, 2.5}, {2, 2.5, 1}, {2.5, 1, 2}, {2.5, 2, 1}};
  const Vec3 directions[] = {{1, 0.2, 0.3}, {0.2, 1, 0.3}, {0.2, -0.3, 1}, {-1, 0.1, -0.2}, {-0.1, -0.2, -1}};
  for (const Vec3& moments : orders) {
    for (const Vec3& L : directions) expect_agrees_with_series(moments, Quat::Identity(), L, 12.5);
  }
}

TEST(FreeRotation, NearlyEqualMomentsAgreeWithTheTaylorSeries) {
  std::mt19937_64 random(2);
  for (int digits = 1; digits <= 16; ++digits) {
    const double e = std::pow(10.0, -digits);
    const Quat q = random_attitude(random);
    const Vec3 L = 2 * random_direction(random);
    expect_agrees_with_series(Vec3(1, 1 + e, 1.7), q, L, 15);
    expect_agrees_with_series(Vec3(1, 1.7, 1.7 * (1 + e)), q, L, 15);
    expect_agrees_with_series(Vec3(1, 1 + e, 1 + 3 * e), q, L, 15);
    // Spin across the nearly symmetric axis: the precession jumps where M passes near the axis of the
    // smallest moment.
    expect_agrees_with_series(Vec3(1, 1 + e, 1.7), Quat::Identity(), Vec3(1, 0.3, 2 * std::sqrt(e)), 15);
    expect_agrees_with_series(Vec3(1, 1.7, 1.7 * (1 + e)), Quat::Identity(), Vec3(0.5 * std::sqrt(e), 0.3, 1),
                              15);
  }
}

TEST(FreeRotation, NearThePrincipalAxesAgreesWithTheTaylorSeries) {
  const Vec3 moments(1, 2, 2.5);
  for (int digits = 1; digits <= 18; ++digits) {
    const double e = std::pow(10.0, -digits);
    expect_agrees_with_series(moments, Quat::Identity(), Vec3(1, e, -e), 30);
    expect_agrees_with_series(moments, Quat::Identity(), Vec3(-e, 1, e), 60);
    expect_agrees_with_series(moments, Quat::Identity(), Vec3(e, e, -1), 30);
    expect_agrees_with_series(moments, Quat::Identity(), Vec3(0, 1, e), 60);
    expect_agrees_with_series(moments, Quat::Identity(), Vec3(e, -1, 0), 60);
  }
}

TEST(FreeRotation, NearTheSeparatrixAgreesWithTheTaylorSeries) {
  // On the separatrix M1² (1/I1 - 1/I2) = M3² (1/I2 - 1/I3); with 1/I = 4, 3, 1: M3 = M1/√2.
  const Vec3 moments(1.0 / 4, 1.0 / 3, 1);
  for (int digits = 1; digits <= 15; ++digits) {
    const double e = std::pow(10.0, -digits);
    for (const double side : {1 - e, 1 + e}) {
      // Leaving the neighbourhood of the axis amplifies rounding of the input by at most |M2|/M1 a passage.
      expect_agrees_with_series(moments, Quat::Identity(), Vec3(0.5, 0.2, 0.5 * side / std::sqrt(2.0)), 6,
                                10);
      expect_agrees_with_series(moments, Quat::Identity(), Vec3(0.05, -0.9, 0.05 * side / std::sqrt(2.0)), 8,
                                40);
    }
  }
}

TEST(FreeRotation, OnTheSeparatrixAgreesWithTheTaylorSeries) {
  // 1/I = 5, 4, 3 times 1/60: the bounds of M1 and M3 are equal, and so are their roundings.
  const Vec3 moments(12, 15, 20);
  for (const Vec3& L :
       {Vec3(1, 0.3, 1), Vec3(-2, 1, 2), Vec3(3, 0, -3), Vec3(-1, -2, -1), Vec3(1e-3, 5, 1e-3)}) {
    for (const double t : {-40.0, -3.0, 0.5, 20.0})
      expect_agrees_with_series(moments, Quat::Identity(), L, t, 10);
  }
  // In the end it spins about the intermediate axis for ever.
  const FreeRotation rotation(moments, Quat::Identity(), Vec3(1, 0.3, 1));
  for (const double t : {1e4, 1e6}) {
    const Vec3 M = rotation_matrix(rotation.orientation(t)).transpose() * Vec3(1, 0.3, 1);
    EXPECT_NEAR(std::abs(M[1]), std::sqrt(2.09), 8 * kEpsilon);
  }
}

TEST(FreeRotation, ThinRodsAndFlatBodiesAgreeWithTheTaylorSeries) {
  std::mt19937_64 random(4);
  for (int trial = 0; trial < 30; ++trial) {
    const Quat q = random_attitude(random);
    const double thin = std::pow(10.0, -1 - trial % 4);
    // A rod that spins at rates of order one about every axis.
    Vec3 M = random_direction(random);
    M[0] *= thin;
    expect_agrees_with_series(Vec3(thin, 1, 1 + 0.5 * thin), q, rotation_matrix(q) * M, 5);
    const Vec3 flat = random_moments(random);
    expect_agrees_with_series(Vec3(flat[0], flat[1], flat[0] + flat[1]), q, random_direction(random), 10);
  }
}

TEST(FreeRotation, ExtremeSizesOfMomentsChangeNothing) {
  const Vec3 moments(1, 2, 2.5), L(0.3, 1, -0.4);
  for (const double size : {1e-9, 1e9}) {
    expect_agrees_with_series(size * moments, Quat::Identity(), size * L, 25);
    expect_agrees_with_series(size * moments, Quat::Identity(), L, 25 * size);
  }
}

TEST(FreeRotation, ScalingTheUnitsByPowersOfTwoIsExact) {
  // Lengths times 2ᵃ, times 2ᵇ, masses times 2ᶜ: moments times 2^(c+2a), L times 2^(c+2a-b), dt times 2ᵇ.
  std::mt19937_64 random(5);
  for (int trial = 0; trial < 50; ++trial) {
    Vec3 moments = random_moments(random);
    if (trial % 5 == 1) moments[1] = moments[0];
    const Quat q = random_attitude(random);
    const Vec3 L = random_direction(random);
    const int a = trial % 7 - 3, b = trial % 11 - 5, c = trial % 3;
    const Quat here = FreeRotation(moments, q, L).orientation(3.7);
    const FreeRotation scaled(std::ldexp(1, c + 2 * a) * moments, q, std::ldexp(1, c + 2 * a - b) * L);
    EXPECT_EQ(scaled.orientation(std::ldexp(3.7, b)).coeffs(), here.coeffs());
  }
}

TEST(FreeRotation, SphericalBodyTurnsAtConstantAngularVelocity) {
  const Vec3 L(0.3, -0.2, 0.9);
  const Quat q = rotation_exp(Vec3(1, 2, -0.5));
  const FreeRotation rotation(Vec3::Constant(0.4), q, L);
  for (const double t : {-3.0, 0.1, 7.0}) {
    EXPECT_LE(distance(rotation.orientation(t), rotation_exp(t * L / 0.4) * q),
              8 * kEpsilon * (1 + std::abs(t)));
  }
  EXPECT_NEAR(rotation.max_angular_speed(), L.norm() / 0.4, 64 * kEpsilon);
}

TEST(FreeRotation, SymmetricTopPrecessesAtTheTwoRatesOfTheory) {
  // I = (2, 2, 1): in the body ω precesses about the axis at (I3 - I1)/I1 ω3, in space the axis about L at
  // |L|/I1.
  const Vec3 moments(2, 2, 1), w(0.6, 0, 1.5);
  const Vec3 L = moments.cwiseProduct(w);
  const FreeRotation rotation(moments, Quat::Identity(), L);
  const double body_rate = (1.0 - 2.0) / 2.0 * w[2], space_rate = L.norm() / 2;
  for (const double t : {0.5, 10.0, 100.0}) {
    const Quat q = rotation.orientation(t);
    const Vec3 w_B = body_angular_velocity(moments, q, L);
    const Vec3 expected_w(0.6 * std::cos(body_rate * t), 0.6 * std::sin(body_rate * t), 1.5);
    EXPECT_LE((w_B - expected_w).norm(), 1e-15 * (4 + 4 * t));
    const Vec3 axis_W = rotation_matrix(q).col(2);
    const Vec3 expected_axis = rotation_matrix(rotation_exp(t * space_rate * L.normalized())).col(2);
    EXPECT_LE((axis_W - expected_axis).norm(), 1e-15 * (4 + 4 * t));
  }
}

TEST(FreeRotation, SpinAboutAnyPrincipalAxisStaysThereAtAnyAttitude) {
  const Vec3 moments(1, 2, 2.5);
  std::mt19937_64 random(6);
  for (int axis = 0; axis < 3; ++axis) {
    for (int trial = 0; trial < 200; ++trial) {
      const Quat q = trial == 0 ? Quat::Identity() : random_attitude(random);
      const Vec3 L = 3 * rotation_matrix(q).col(axis);
      const FreeRotation rotation(moments, q, L);
      for (const double t : {-1e4, 5.0, 1e4}) {
        const Vec3 M = rotation_matrix(rotation.orientation(t)).transpose() * L;
        EXPECT_NEAR(M[axis], 3, 16 * kEpsilon);
      }
      EXPECT_NEAR(rotation.max_angular_speed(), 3 / moments[axis], 64 * kEpsilon);
    }
  }
}

TEST(FreeRotation, WithoutAngularMomentumNothingMoves) {
  const Quat q = rotation_exp(Vec3(0.2, 0.4, 0.1));
  for (const Vec3& moments : {Vec3(1, 1, 1), Vec3(1, 2, 2), Vec3(1, 2, 2.5)}) {
    const FreeRotation rotation(moments, q, Vec3::Zero());
    EXPECT_LE(distance(rotation.orientation(1e6), q), 2 * kEpsilon);
    EXPECT_EQ(rotation.max_angular_speed(), 0);
  }
  EXPECT_EQ(FreeRotation().orientation(3).coeffs(), Quat::Identity().coeffs());
}

TEST(FreeRotation, StartIsExactAndContinuousAndUnit) {
  std::mt19937_64 random(7);
  for (int trial = 0; trial < 50; ++trial) {
    const Quat q = random_attitude(random);
    const FreeRotation rotation(random_moments(random), q, random_direction(random));
    EXPECT_EQ(rotation.orientation(0).coeffs(), q.coeffs());
    EXPECT_LE(distance(rotation.orientation(1e-300), q), 4 * kEpsilon);
    EXPECT_NEAR(rotation.orientation(1234.5).norm(), 1, 2 * kEpsilon);
  }
}

TEST(FreeRotation, HugeTimesKeepEnergy) {
  const Vec3 moments(1, 2, 2.5), L(0.1, 1.9, -0.2);
  const BodyInertia inertia{1, moments};
  const FreeRotation rotation(moments, Quat::Identity(), L);
  const double energy = kinetic_energy(inertia, BodyPhase{.L = L});
  for (const double t : {-1e4, 1e4, 1e9, 1e15}) {
    const BodyPhase phase{.q = rotation.orientation(t), .L = L};
    EXPECT_NEAR(kinetic_energy(inertia, phase), energy, 16 * kEpsilon * energy);
  }
  expect_agrees_with_series(moments, Quat::Identity(), L, 2e3);
}

TEST(FreeRotation, RestartingAlongTheWayGivesTheSameMotion) {
  std::mt19937_64 random(8);
  for (int trial = 0; trial < 30; ++trial) {
    const Vec3 moments = random_moments(random), L = random_direction(random);
    const Quat q = random_attitude(random);
    const FreeRotation rotation(moments, q, L);
    const FreeRotation restarted(moments, rotation.orientation(4), L);
    // Rounding of q at the restart grows like the time, unless it is near the separatrix.
    EXPECT_LE(distance(restarted.orientation(6), rotation.orientation(10)), 2e-13);
  }
}

TEST(FreeRotation, AngularSpeedBoundHoldsAndIsAttained) {
  std::mt19937_64 random(9);
  for (int trial = 0; trial < 40; ++trial) {
    Vec3 moments = random_moments(random);
    if (trial % 4 == 1) moments[1] = moments[2];
    const Vec3 L = random_direction(random);
    const FreeRotation rotation(moments, random_attitude(random), L);
    double largest = 0;
    for (int i = 0; i < 2000; ++i) {
      const Quat q = rotation.orientation(0.1 * i);
      largest = std::max(largest, angular_velocity(BodyInertia{1, moments}, q, L).norm());
    }
    EXPECT_LE(largest, rotation.max_angular_speed());
    EXPECT_GE(largest, 0.99 * rotation.max_angular_speed());
  }
}

TEST(FreeRotation, AngularMomentaOfAnySizeRotate) {
  // Components whose squares underflow, alone or beside larger ones: the rotation by ω t to first order.
  std::mt19937_64 random(31);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int trial = 0; trial < 20000; ++trial) {
    Vec3 L;
    for (double& component : L)
      component = (uniform(random) < 0.3 ? 0 : 1) * (uniform(random) < 0.5 ? -1 : 1) *
                  std::pow(10.0, -322 + 322 * uniform(random));
    const Vec3 moments = random_moments(random);
    const Quat q = trial % 2 == 0 ? Quat::Identity() : random_attitude(random);
    const double t = 1e-3;
    const Quat found = FreeRotation(moments, q, L).orientation(t);
    const Quat expected = rotation_exp(t * angular_velocity(BodyInertia{1, moments}, q, L)) * q;
    const double second_order = std::pow(t * L.stableNorm() / moments[0], 2);
    EXPECT_LE(distance(found, expected), second_order + 8 * kEpsilon) << L.transpose();
  }
}

}  // namespace
}  // namespace rigor::free_rotation_test
