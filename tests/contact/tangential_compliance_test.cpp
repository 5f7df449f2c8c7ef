#include "rigor/contact/impact/tangential_compliance.hpp"

#include "random_vectors.hpp"
#include "solver/reference_data.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace rigor::tangential_compliance_test {
namespace {

using test::Random;

constexpr double pi = std::numbers::pi;

Mat3 sphere_matrix(double mass) {
  return Vec3(3.5, 3.5, 1).asDiagonal().toDenseMatrix() / mass;
}

int direction_of(const std::string& event) {
  return event == "stick" ? 0 : event == "slip-1" ? -1 : 1;
}

TEST(TangentialCompliance, ReproducesTheReferenceOfASolidSphere) {
  const nlohmann::json data = reference::read("tangential_compliance.json");
  const double m = 0.7, v_n = 1.3, angle = 0.4, mu = 0.3;
  const Vec2 along(std::cos(angle), std::sin(angle));
  for (const nlohmann::json& json : data["cases"]) {
    const double psi = json["psi"].get<double>();
    SCOPED_TRACE(psi);
    Collision collision{{sphere_matrix(m), mu}, {psi * v_n * along.x(), psi * v_n * along.y(), -v_n}, 1};
    const CompliantOutcome outcome = resolve_compliant_collision({collision, 1 / 1.21});
    // The reference has about ten digits.
    EXPECT_NEAR(outcome.end.u.head<2>().dot(along) / v_n, json["slip"].get<double>(), 1e-10);
    const nlohmann::json& events = json["events"];
    ASSERT_EQ(outcome.changes.size(), events.size() + 1);
    for (std::size_t k = 0; k < events.size(); ++k) {
      EXPECT_EQ(outcome.changes[k + 1].direction, direction_of(events[k][0].get<std::string>()));
      EXPECT_NEAR(outcome.changes[k + 1].phase, events[k][1].get<double>(), 1e-10);
    }
  }
}

/// The same equations by many small steps: what the closed forms must give to the order of the step.
double slip_by_small_steps(const CompliantCollision& compliant, int steps) {
  const auto& [collision, r] = compliant;
  const double mu = collision.matrix.mu, e = collision.restitution;
  const double alpha = collision.matrix.K(0, 0) / collision.matrix.K(2, 2);
  double u = collision.u.x() / -collision.u.z(), x = 0;
  const double h = 0.5 * pi * (1 + e) / steps;
  for (int k = 0; k < steps; ++k) {
    const double y = (k + 0.5) * h - 0.5 * pi, limit = mu * std::cos(y < 0 ? y : y / e) / r;
    x += 0.5 * h * u;
    if (std::abs(x) > limit) x = std::copysign(limit, x);
    u -= h * alpha * r * x;
    x += 0.5 * h * u;
  }
  return u * -collision.u.z();
}

TEST(TangentialCompliance, AgreesWithManySmallStepsOfTheSameEquations) {
  Random random(7);
  int changed_often = 0;
  for (int k = 0; k < 60; ++k) {
    const Mat3 K = Vec3(random.uniform(0.5, 6), 1, random.uniform(0.5, 2)).asDiagonal();
    const CompliantCollision compliant{
        {{K, random.uniform(0.05, 1)}, {random.uniform(-3, 3), 0, -1}, random.uniform(0.3, 1)},
        random.uniform(0.2, 4)};
    const CompliantOutcome outcome = resolve_compliant_collision(compliant);
    changed_often += outcome.changes.size() > 2;
    EXPECT_NEAR(outcome.end.u.x(), slip_by_small_steps(compliant, 20000), 2e-3);
  }
  EXPECT_GT(changed_often, 10);
}

TEST(TangentialCompliance, NeverGainsEnergyAndStaysInTheCone) {
  Random random(8);
  for (int k = 0; k < 20000; ++k) {
    const double kind = random.uniform(0, 1), e = kind < 0.1 ? 0 : kind < 0.2 ? 1 : random.uniform(0, 1);
    const double mu = random.uniform(0, 1) < 0.1 ? std::numeric_limits<double>::infinity()
                                                 : std::pow(10, random.uniform(-3, 1));
    const Mat3 K = Vec3(random.uniform(0.1, 6), random.uniform(0.1, 6), random.uniform(0.5, 2)).asDiagonal();
    const Vec3 u(std::pow(10, random.uniform(-3, 2)), 0, -random.uniform(0.1, 2));
    const CompliantCollision compliant{{{K, mu}, u, e}, std::pow(10, random.uniform(-1, 1))};
    std::vector<CollisionPoint> path;
    const CompliantOutcome outcome = resolve_compliant_collision(compliant, &path);
    const double energy = 0.5 * u.dot(K.inverse() * u);
    EXPECT_LE(outcome.energy_change, 1e-13 * energy);
    EXPECT_EQ(outcome.end.u.z(), -e * u.z());
    EXPECT_NEAR(outcome.end.work, (1 - e * e) * outcome.compression.work, 1e-14 * energy);
    EXPECT_TRUE(outcome.is_resolved);
    EXPECT_LT(outcome.changes.size(), 40u);
    for (std::size_t i = 1; i < path.size(); ++i) {
      const Vec3 force = path[i].lambda - path[i - 1].lambda;
      EXPECT_GE(force.z(), 0);
      EXPECT_LE(std::abs(force.x()), mu * force.z() + 1e-14 * (u.norm() / K(0, 0) + path[i].lambda.norm()));
      EXPECT_LT((u + K * path[i].lambda - path[i].u).norm(), 1e-13 * u.norm());
    }
  }
}

TEST(TangentialCompliance, AFastSpringChattersToTheEnd) {
  // At the limit of what is allowed, for all kinds of slip and restitution.
  Random random(9);
  std::size_t most = 0;
  for (int k = 0; k < 500; ++k) {
    const double alpha = random.uniform(0.5, 5);
    const Vec3 u(std::pow(10, random.uniform(-6, 1)), 0, -1);
    const CompliantCollision compliant{
        {{Vec3(alpha, alpha, 1).asDiagonal(), std::pow(10, random.uniform(-3, 1))}, u, random.uniform(0, 1)},
        0.999e4 / alpha};
    const CompliantOutcome outcome = resolve_compliant_collision(compliant);
    ASSERT_TRUE(outcome.is_resolved);
    EXPECT_LE(outcome.energy_change, 0);
    EXPECT_LE(outcome.end.u.head<2>().norm(), u.x());
    most = std::max(most, outcome.changes.size());
  }
  EXPECT_GT(most, 20u);
}

TEST(TangentialCompliance, AVeryStiffTangentIsCoulombsImpact) {
  // k_t → ∞ is a rigid contact that sticks or slips: Stronge's law with K_tn = 0.
  for (const double slip : {0.3, 1.0, 4.0}) {
    const Collision collision{{sphere_matrix(1), 0.2}, {slip, 0, -1}, 0.6};
    const Vec3 rigid = resolve_collision(collision, RestitutionLaw::stronge).end.u;
    const double alpha = 3.5, ratio = 1e4 / alpha;
    const CompliantOutcome stiff = resolve_compliant_collision({collision, ratio});
    // The spring still swings: μ sqrt(α/r) of the approach.
    EXPECT_LT((stiff.end.u - rigid).norm(), 2 * 0.2 * std::sqrt(alpha / ratio));
  }
}

TEST(TangentialCompliance, ASpringAsSlowAsTheNormalOneTurnsTheTangentialVelocityRound) {
  // α r = 1 and no slip: half a swing in the time of contact, for any speed. Energy is kept: a superball.
  const Collision collision{{sphere_matrix(1), std::numeric_limits<double>::infinity()}, {0.8, -0.6, -2}, 1};
  const CompliantOutcome outcome = resolve_compliant_collision({collision, 2.0 / 7});
  EXPECT_LT((outcome.end.u + collision.u).norm(), 1e-14);
  EXPECT_NEAR(outcome.energy_change, 0, 1e-15);
  ASSERT_EQ(outcome.changes.size(), 1u);
  EXPECT_EQ(outcome.changes[0].direction, 0);
}

TEST(TangentialCompliance, AtTheLimitOfSlipAtOnceBothAnswersAreOne) {
  // ψ = μ k_n/k_t: the spring grows as fast as friction.
  const double mu = 0.3, r = 1 / 1.21;
  const auto slip_after = [&](double psi) {
    return resolve_compliant_collision({{{sphere_matrix(1), mu}, {psi, 0, -1}, 1}, r}).end.u.x();
  };
  EXPECT_NEAR(slip_after(mu / r), slip_after(mu / r * (1 + 1e-12)), 1e-10);
  EXPECT_NEAR(slip_after(mu / r), slip_after(mu / r * (1 - 1e-12)), 1e-10);
}

TEST(TangentialCompliance, LeavesAloneWhatDoesNotApproach) {
  const CompliantOutcome outcome =
      resolve_compliant_collision({{{sphere_matrix(1), 0.3}, {1, 0, 0.1}, 1}, 1});
  EXPECT_EQ(outcome.end.u, Vec3(1, 0, 0.1));
  EXPECT_TRUE(outcome.changes.empty());
}

TEST(TangentialCompliance, RefusesWhatIsCoupledOrNotPlanar) {
  Mat3 K = sphere_matrix(1);
  EXPECT_EQ(check_compliant_collision({{{K, 0.3}, {1, 2, -1}, 1}, 1}), "");
  K(0, 0) = 5;
  EXPECT_EQ(check_compliant_collision({{{K, 0.3}, {1, 0, -1}, 1}, 1}), "");
  EXPECT_NE(check_compliant_collision({{{K, 0.3}, {1, 2, -1}, 1}, 1}).find("principal direction"),
            std::string::npos);
  EXPECT_NE(check_compliant_collision({{{K, 0.3}, {1, 0, -1}, 1}, 2001}).find("at most 100 times as fast"),
            std::string::npos);
  K(0, 2) = K(2, 0) = 0.1;
  EXPECT_NE(check_compliant_collision({{{K, 0.3}, {1, 0, -1}, 1}, 1}).find("without coupling"),
            std::string::npos);
}

}  // namespace
}  // namespace rigor::tangential_compliance_test
