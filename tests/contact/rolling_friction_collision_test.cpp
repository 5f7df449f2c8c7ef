#include "rigor/contact/impact/rolling_friction_collision.hpp"

#include "random_vectors.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace rigor::rolling_friction_collision_test {
namespace {

using test::Random;

constexpr std::array laws = {RestitutionLaw::newton, RestitutionLaw::poisson, RestitutionLaw::stronge};

/// Ball of mass m, radius R, moment I on a fixed floor; normal up, contact below its centre.
Mat6 ball_matrix(double m, double R, double I) {
  // u = v + ω × (-R n): u_x = v_x - R ω_y, u_y = v_y + R ω_x.
  Mat6 J = Mat6::Identity();
  J(0, 4) = -R, J(1, 3) = R;
  const Mat6 inverse_mass = (Vec6() << 1 / m, 1 / m, 1 / m, 1 / I, 1 / I, 1 / I).finished().asDiagonal();
  return J * inverse_mass * J.transpose();
}

Mat6 random_matrix(Random& random) {
  Mat6 A;
  for (int i = 0; i < 36; ++i) A(i / 6, i % 6) = random.number();
  return A * A.transpose() + 0.05 * Mat6::Identity();
}

TEST(RollingFrictionCollision, WithoutMomentsIsThePlainImpact) {
  Random random(9);
  for (int k = 0; k < 200; ++k) {
    RollingFrictionCollision collision{
        random_matrix(random), random.vector(), random.vector(), random.uniform(0, 1.5), 0, 0,
        random.uniform(0, 1)};
    collision.u.z() = -std::abs(collision.u.z()) - 0.1;
    for (const RestitutionLaw law : laws) {
      const CollisionOutcome plain = resolve_collision(
          {{collision.K.topLeftCorner<3, 3>(), collision.mu}, collision.u, collision.restitution}, law);
      if (plain.phases.find_first_of("r;") != std::string::npos) continue;
      const RollingFrictionOutcome outcome = resolve_rolling_friction_collision(collision, law);
      ASSERT_TRUE(outcome.is_resolved);
      // Dense output of order 4 within steps of error 1e-12.
      EXPECT_LT((outcome.u - plain.end.u).norm(), 1e-8 * collision.u.norm()) << plain.phases;
      EXPECT_LT((outcome.lambda - plain.end.lambda).norm(), 1e-8 * plain.end.lambda.norm()) << plain.phases;
      EXPECT_EQ(outcome.moment, Vec3(0, 0, 0));
    }
  }
}

TEST(RollingFrictionCollision, OfASpinningBallLosesItsSpinByTheGreatestMoment) {
  // Spinning about the normal: I ω decreases by σ λ_n until nothing is left.
  const double m = 2, R = 0.1, I = 0.4 * m * R * R, e = 0.5, v = 3, sigma = 0.002;
  const double impulse = (1 + e) * m * v, loss = sigma * impulse / I;
  for (const RestitutionLaw law : laws) {
    RollingFrictionCollision collision{ball_matrix(m, R, I), {0, 0, -v}, {0, 0, 2 * loss}, 0.3, 0, sigma, e};
    RollingFrictionOutcome outcome = resolve_rolling_friction_collision(collision, law);
    EXPECT_NEAR(outcome.w.z(), loss, 1e-12 * loss);
    EXPECT_NEAR(outcome.u.z(), e * v, 1e-14);
    collision.w.z() = -0.5 * loss;
    outcome = resolve_rolling_friction_collision(collision, law);
    EXPECT_EQ(outcome.w.z(), 0);
    // Rest is below 1e-10 of the velocities.
    EXPECT_NEAR(outcome.moment.z(), 0.5 * loss * I, 1e-8 * loss * I);
  }
}

TEST(RollingFrictionCollision, OfARollingBallSlowsItsRolling) {
  // Rolling along x: v = R ω. The contact keeps rolling (friction large), so L about the contact changes by
  // the rolling moment alone: (I + m R²) Δω = -ρ λ_n.
  const double m = 2, R = 0.1, I = 0.4 * m * R * R, e = 0.5, v_n = 1, rho = 0.001;
  const double impulse = (1 + e) * m * v_n, omega = 30;
  for (const RestitutionLaw law : laws) {
    const RollingFrictionOutcome outcome = resolve_rolling_friction_collision(
        {ball_matrix(m, R, I), {0, 0, -v_n}, {0, omega, 0}, 0.5, rho, 0, e}, law);
    EXPECT_LT(outcome.u.head<2>().norm(), 1e-13);
    EXPECT_NEAR(outcome.w.y(), omega - rho * impulse / (I + m * R * R), 1e-10);
    EXPECT_NEAR(outcome.moment.y(), -rho * impulse, 1e-14);
    // Friction at the contact slows the centre with it.
    EXPECT_NEAR(outcome.lambda.x(), -m * R * rho * impulse / (I + m * R * R), 1e-11);
  }
}

TEST(RollingFrictionCollision, NeverGainsEnergyUnderStrongeAndPoissonAndKeepsItsLimits) {
  Random random(12);
  for (int k = 0; k < 300; ++k) {
    RollingFrictionCollision collision{random_matrix(random),  random.vector(),      random.vector(),
                                       random.uniform(0, 1.5), random.uniform(0, 1), random.uniform(0, 1),
                                       random.uniform(0, 1)};
    collision.u.z() = -std::abs(collision.u.z()) - 0.1;
    Vec6 twist;
    twist << collision.u, collision.w;
    const double energy = 0.5 * twist.dot(collision.K.ldlt().solve(twist));
    for (const RestitutionLaw law : {RestitutionLaw::poisson, RestitutionLaw::stronge}) {
      const RollingFrictionOutcome outcome = resolve_rolling_friction_collision(collision, law);
      ASSERT_TRUE(outcome.is_resolved);
      EXPECT_LE(outcome.energy_change, 1e-9 * energy);
      const double p = outcome.lambda.z() * (1 + 1e-10);
      EXPECT_LE(outcome.lambda.head<2>().norm(), collision.mu * p);
      EXPECT_LE(outcome.moment.head<2>().norm(), collision.rolling_friction * p);
      EXPECT_LE(std::abs(outcome.moment.z()), collision.torsional_friction * p);
      Vec6 impulse, after;
      impulse << outcome.lambda, outcome.moment;
      after << outcome.u, outcome.w;
      // What is slower than 1e-10 of the velocities is set to rest.
      EXPECT_LT((twist + collision.K * impulse - after).norm(), 1e-9 * twist.norm());
    }
  }
}

}  // namespace
}  // namespace rigor::rolling_friction_collision_test
