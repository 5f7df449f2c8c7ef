#include "rigor/contact/penalty/penalty_law.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace rigor::penalty_law_test {
namespace {

struct Bounce {
  double restitution;
  double depth;  ///< Greatest [m].
};

/// A mass of 2 kg that meets the spring at this speed, by RK4 in steps of 1/2000 of the contact's time scale.
/// The force ends somewhere within a step: the error is of order (step × frequency)².
Bounce bounce(const PenaltySpring& spring, double speed, double depth) {
  constexpr double mass = 2;
  const double h = depth / speed / 2000;
  double x = 0, v = speed, deepest = 0;
  const auto a = [&](double at, double rate) { return -normal_force(spring, at, rate) / mass; };
  for (int i = 0; i < 4000000 && (x > 0 || v > 0); ++i) {
    const double a1 = a(x, v), v2 = v + 0.5 * h * a1;
    const double a2 = a(x + 0.5 * h * v, v2), v3 = v + 0.5 * h * a2;
    const double a3 = a(x + 0.5 * h * v2, v3), v4 = v + h * a3;
    const double a4 = a(x + h * v3, v4);
    x += h / 6 * (v + 2 * v2 + 2 * v3 + v4);
    v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    deepest = std::max(deepest, x);
  }
  return {-v / speed, deepest};
}

TEST(PenaltyLaw, GivesTheRestitutionThatItIsMadeFor) {
  for (const PenaltyNormalLaw law : {PenaltyNormalLaw::linear, PenaltyNormalLaw::hunt_crossley}) {
    for (const double e : {1.0, 0.9, 0.5, 0.2, 0.1}) {
      const PenaltySpring spring = spring_for_impact(law, e, 2, 3, 1e-3);
      const Bounce seen = bounce(spring, 3, 1e-3);
      EXPECT_NEAR(seen.restitution, e, 1e-4) << "law " << static_cast<int>(law) << " e " << e;
      EXPECT_LE(seen.depth, 1e-3 * (1 + 1e-9));
    }
  }
}

TEST(PenaltyLaw, RestitutionBelowTheLeastIsTheLeast) {
  const Bounce linear = bounce(spring_for_impact(PenaltyNormalLaw::linear, 0, 2, 3, 1e-3), 3, 1e-3);
  EXPECT_NEAR(linear.restitution, least_linear_restitution, 1e-4);
  const Bounce curved = bounce(spring_for_impact(PenaltyNormalLaw::hunt_crossley, 0, 2, 3, 1e-3), 3, 1e-3);
  EXPECT_NEAR(curved.restitution, least_hunt_crossley_restitution, 1e-3);
}

TEST(PenaltyLaw, AnUndampedImpactPressesByTheDepthThatItIsMadeFor) {
  for (const PenaltyNormalLaw law : {PenaltyNormalLaw::linear, PenaltyNormalLaw::hunt_crossley}) {
    const PenaltySpring spring = spring_for_impact(law, 1, 2, 3, 1e-3);
    EXPECT_NEAR(bounce(spring, 3, 1e-3).depth, 1e-3, 1e-9);
    EXPECT_NEAR(stored_energy(spring, 1e-3), 0.5 * 2 * 3 * 3, 1e-12);
  }
}

TEST(PenaltyLaw, NaiveDampingWouldBounceMoreThanTheClampedForceAllows) {
  // c = -2 ln e √(k m) / √(π² + ln² e) lets the force pull at the end; where it may not, e is larger.
  const double e = 0.3, naive = -std::log(e) / std::hypot(4 * std::atan(1.0), std::log(e));
  EXPECT_GT(damping_ratio(e), naive + 0.05);
}

TEST(PenaltyLaw, DampingRatioHasItsClosedForms) {
  EXPECT_EQ(damping_ratio(1), 0);
  // θ / tan θ = 1 at θ = 0: critical damping returns exp(-2). θ = π/4: ζ = 1/√2, e = exp(-π/2).
  EXPECT_NEAR(damping_ratio(std::exp(-2.0)), 1, 1e-7);
  EXPECT_NEAR(damping_ratio(std::exp(-2 * std::atan(1.0))), std::sqrt(0.5), 1e-15);
  double last = 0;
  for (const double e : {0.99, 0.8, 0.4, 0.14, 0.13, 0.05, 0.02}) {
    EXPECT_GT(damping_ratio(e), last);
    last = damping_ratio(e);
  }
}

TEST(PenaltyLaw, NeverPullsAndNeverPushesFromAfar) {
  for (const PenaltyNormalLaw law : {PenaltyNormalLaw::linear, PenaltyNormalLaw::hunt_crossley}) {
    const PenaltySpring spring = spring_for_impact(law, 0.2, 1, 1, 1e-3);
    EXPECT_EQ(normal_force(spring, 1e-4, -100), 0);
    EXPECT_EQ(normal_force(spring, -1e-4, 100), 0);
    EXPECT_EQ(normal_force(spring, 0, 100), 0);
    EXPECT_GT(normal_force(spring, 1e-4, 0), 0);
    EXPECT_EQ(stored_energy(spring, -1), 0);
  }
}

TEST(PenaltyLaw, HardensBeyondItsLimitAndKeepsItsEnergyThere) {
  for (const PenaltyNormalLaw law : {PenaltyNormalLaw::linear, PenaltyNormalLaw::hunt_crossley}) {
    PenaltySpring spring = spring_for_impact(law, 1, 2, 3, 1e-3);
    const double force = normal_force(spring, 1e-3, 0), energy = stored_energy(spring, 1e-3);
    spring.limit = 1e-3;
    EXPECT_EQ(normal_force(spring, 1e-3, 0), force);
    EXPECT_EQ(stored_energy(spring, 1e-3), energy);
    // e times as strong over a twentieth of the limit.
    EXPECT_NEAR(normal_force(spring, 1.05e-3, 0) / force, std::exp(1), 1e-12);
    // The last one is where the curve has gone over into its tangent.
    for (const double x : {1.02e-3, 1.7e-3, 3.5e-3}) {
      const double d = 1e-9, f = normal_force(spring, x, 0);
      EXPECT_NEAR((stored_energy(spring, x + d) - stored_energy(spring, x - d)) / (2 * d * f), 1, 1e-6);
      EXPECT_NEAR((normal_force(spring, x + d, 0) - normal_force(spring, x - d, 0)) /
                      (2 * d * stiffness_at(spring, x)),
                  1, 1e-6);
      EXPECT_NEAR(depth_under(spring, f), x, 1e-12 * x);
      EXPECT_NEAR(depth_holding(spring, stored_energy(spring, x)), x, 1e-12 * x);
    }
  }
}

TEST(PenaltyLaw, DampersHardenWithTheirSprings) {
  for (const PenaltyNormalLaw law : {PenaltyNormalLaw::linear, PenaltyNormalLaw::hunt_crossley}) {
    PenaltySpring spring = spring_for_impact(law, 0.5, 1, 2, 1e-3);
    spring.limit = 1e-3;
    const double x = 1.3e-3, w = 1e-3;
    const double rate = (normal_force(spring, x, w) - normal_force(spring, x, -w)) / (2 * w);
    EXPECT_NEAR(damping_at(spring, x) / rate, 1, 1e-9);
  }
}

TEST(PenaltyLaw, AMillionTimesTheEnergyPressesTwiceAsDeep) {
  PenaltySpring spring = spring_for_impact(PenaltyNormalLaw::linear, 1, 2, 3, 1e-3);
  spring.limit = 1e-3;
  const double energy = 1e6 * 9;
  // ½ m v² of the spring is k d²/2 = 9 J, beyond it k d ℓ (e^x - 1).
  const double expected = 1e-3 + 5e-5 * std::log1p((energy - 9) / (18 / 1e-3 * 5e-5));
  EXPECT_NEAR(stored_energy(spring, expected), energy, 1e-9 * energy);
  EXPECT_LE(expected, 2e-3);
}

TEST(PenaltyLaw, TangentsAreDerivatives) {
  for (const PenaltyNormalLaw law : {PenaltyNormalLaw::linear, PenaltyNormalLaw::hunt_crossley}) {
    const PenaltySpring spring = spring_for_impact(law, 0.5, 1, 2, 1e-3);
    const double x = 4e-4, d = 1e-8, w = 1e-3;
    const double slope = (normal_force(spring, x + d, 0) - normal_force(spring, x - d, 0)) / (2 * d);
    EXPECT_NEAR(stiffness_at(spring, x) / slope, 1, 1e-7);
    const double rate = (normal_force(spring, x, w) - normal_force(spring, x, -w)) / (2 * w);
    EXPECT_NEAR(damping_at(spring, x) / rate, 1, 1e-9);
  }
}

}  // namespace
}  // namespace rigor::penalty_law_test
