#include "rigor/contact/impact/algebraic_impact.hpp"

#include "random_vectors.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigor::algebraic_impact_test {
namespace {

using test::Random;

constexpr double infinite = std::numeric_limits<double>::infinity();

Mat3 random_matrix(Random& random) {
  Mat3 A;
  for (int k = 0; k < 9; ++k) A(k / 3, k % 3) = random.number();
  return A * A.transpose() + 1e-2 * Mat3::Identity();
}

Collision random_collision(Random& random) {
  const double kind = random.uniform(0, 1);
  const double mu = kind < 0.1 ? 0 : kind < 0.2 ? infinite : std::pow(10, random.uniform(-2, 1));
  return {{random_matrix(random), mu},
          Vec3(random.number(), random.number(), -std::abs(random.number())),
          random.uniform(0, 1)};
}

TEST(AlgebraicImpact, NeverGainsEnergyAndStaysInTheCone) {
  Random random(11);
  int limited = 0;
  for (int k = 0; k < 20000; ++k) {
    const Collision collision = random_collision(random);
    const double e = collision.restitution, e_t = random.number();
    const AlgebraicOutcome outcome = resolve_algebraic_impact(collision, e_t);
    const Mat3& K = collision.matrix.K;
    limited += outcome.is_limited;
    // The loss by its formula: both parts of it are squares.
    const Vec3 plastic(0, 0, -collision.u.z() / K(2, 2)), change = -K.inverse() * collision.u - plastic;
    const double loss = 0.5 * (1 - e * e) * plastic.dot(K * plastic) +
                        0.5 * outcome.share * (2 - outcome.share) * change.dot(K * change);
    const double energy = 0.5 * collision.u.dot(K.inverse() * collision.u);
    EXPECT_NEAR(outcome.energy_change, -loss, 1e-11 * energy);
    EXPECT_LE(outcome.energy_change, 1e-12 * energy);
    EXPECT_GE(outcome.share, 0);
    EXPECT_LE(outcome.share, 1 + e_t);
    EXPECT_GE(outcome.lambda.z(), -1e-13 * outcome.lambda.norm());
    const double mu = collision.matrix.mu;
    if (std::isfinite(mu)) {
      EXPECT_LE(outcome.lambda.head<2>().norm(),
                mu * outcome.lambda.z() + 1e-12 * (1 + mu) * outcome.lambda.norm());
    }
    EXPECT_EQ(outcome.u.z(), -e * collision.u.z());
    EXPECT_LT((collision.u + K * outcome.lambda - outcome.u).norm(),
              1e-12 * (collision.u.norm() + outcome.lambda.norm() * K.norm()));
  }
  EXPECT_GT(limited, 1000);
}

TEST(AlgebraicImpact, WithoutFrictionOrWithTangentialRestitutionMinusOneKeepsTheTangentialImpulseZero) {
  Random random(12);
  for (int k = 0; k < 100; ++k) {
    Collision collision = random_collision(random);
    const double lambda_n = -(1 + collision.restitution) * collision.u.z() / collision.matrix.K(2, 2);
    const Vec3 slides = resolve_algebraic_impact(collision, -1).lambda;
    collision.matrix.mu = 0;
    for (const Vec3& lambda : {slides, resolve_algebraic_impact(collision, 0.5).lambda}) {
      EXPECT_EQ(lambda.head<2>(), Vec2(0, 0));
      EXPECT_NEAR(lambda.z() / lambda_n, 1, 1e-15);
    }
  }
}

TEST(AlgebraicImpact, PlasticWithEnoughFrictionStopsTheContact) {
  Random random(13);
  for (int k = 0; k < 100; ++k) {
    Collision collision = random_collision(random);
    const Vec3 sticking = -collision.matrix.K.inverse() * collision.u;
    if (sticking.z() <= 0) continue;
    collision.restitution = 0;
    const double needed = sticking.head<2>().norm() / sticking.z();
    collision.matrix.mu = 1.01 * needed;
    const AlgebraicOutcome stops = resolve_algebraic_impact(collision, 0);
    EXPECT_FALSE(stops.is_limited);
    EXPECT_LT(stops.u.norm(), 1e-11 * collision.u.norm());
    collision.matrix.mu = 0.99 * needed;
    EXPECT_TRUE(resolve_algebraic_impact(collision, 0).is_limited);
  }
}

TEST(AlgebraicImpact, WithFullTangentialRestitutionIsGarwinsSuperball) {
  // Ball of mass m, radius R, velocity v along x, spin ω about y: its lowest point moves at v - R ω. The
  // contact's velocity is reversed and L about the contact point kept (both by hand):
  //   v⁺ = (3 v + 4 R ω)/7,  R ω⁺ = (10 v - 3 R ω)/7.
  const double m = 0.2, R = 0.03, inertia = 0.4 * m * R * R;
  const Mat3 K = Vec3(3.5, 3.5, 1).asDiagonal().toDenseMatrix() / m;
  for (const auto& [v, w] : {std::pair{2.0, 0.0}, std::pair{1.0, 50.0}, std::pair{-0.7, 90.0}}) {
    const Vec3 u(v - R * w, 0, -3);
    const AlgebraicOutcome outcome = resolve_algebraic_impact({{K, 10}, u, 1}, 1);
    EXPECT_FALSE(outcome.is_limited);
    EXPECT_LT((outcome.u + u).norm(), 1e-14);
    EXPECT_NEAR(outcome.energy_change, 0, 1e-15);
    EXPECT_NEAR(v + outcome.lambda.x() / m, (3 * v + 4 * R * w) / 7, 1e-14);
    EXPECT_NEAR(R * (w - R * outcome.lambda.x() / inertia), (10 * v - 3 * R * w) / 7, 1e-14);
  }
}

TEST(AlgebraicImpact, LeavesAloneWhatDoesNotApproach) {
  const AlgebraicOutcome outcome =
      resolve_algebraic_impact({{Vec3(3, 2, 1).asDiagonal(), 0.5}, {1, 2, 0.5}, 1}, 1);
  EXPECT_EQ(outcome.u, Vec3(1, 2, 0.5));
  EXPECT_EQ(outcome.lambda, Vec3(0, 0, 0));
}

}  // namespace
}  // namespace rigor::algebraic_impact_test
