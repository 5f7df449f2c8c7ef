#include "rigor/contact/impact/impact_path.hpp"

#include "random_vectors.hpp"
#include "rigor/math/dense.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

// What docs/theory/impact.md proves, seen in numbers.

namespace rigor::impact_theory_test {
namespace {

using test::Random;

Mat3 random_matrix(Random& random) {
  Mat3 A;
  for (int k = 0; k < 9; ++k) A(k / 3, k % 3) = random.number();
  return A * A.transpose() + 0.02 * Mat3::Identity();
}

/// One in four has no slip before.
Collision random_collision(Random& random) {
  Collision collision{{random_matrix(random), std::pow(10, random.uniform(-1.5, 0.7))},
                      Vec3(random.number(), random.number(), -random.uniform(0.05, 1)),
                      random.uniform(0, 1)};
  if (random.uniform(0, 1) < 0.25) collision.u.head<2>().setZero();
  return collision;
}

/// Nearer to the end of slip its direction is rounding.
bool is_clear(const Collision& collision, const CollisionPoint& point) {
  const double slip = point.u.head<2>().norm();
  return slip == 0 || slip > 1e-9 * collision.u.norm();
}

Vec2 unit(double theta) {
  return {std::cos(theta), std::sin(theta)};
}

TEST(ImpactTheory, TheRateOfEnergyGrowsAndItsGrowthFalls) {
  // T is convex and T' = u_n - μ s concave in p, through slides, stops and new starts.
  Random random(51);
  int restarts = 0;
  for (int k = 0; k < 2000; ++k) {
    const Collision collision = random_collision(random);
    std::vector<CollisionPoint> path;
    const CollisionOutcome outcome = resolve_collision(collision, RestitutionLaw::stronge, &path);
    restarts += outcome.phases.find('U') != std::string::npos;
    const double least = symmetric_eigenvalues(collision.matrix.K)[0];
    const auto rate = [&](std::size_t i) {
      return path[i].u.z() - collision.matrix.mu * path[i].u.head<2>().norm();
    };
    double slope_before = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < path.size(); ++i) {
      const double step = path[i].lambda.z() - path[i - 1].lambda.z();
      // Of shorter steps the slope is rounding.
      if (step < 1e-7 || !is_clear(collision, path[i - 1]) || !is_clear(collision, path[i])) continue;
      const double slope = (rate(i) - rate(i - 1)) / step;
      EXPECT_GE(slope, least * (1 - 1e-6)) << outcome.phases;
      EXPECT_LE(slope, slope_before * (1 + 1e-6)) << outcome.phases;
      slope_before = slope;
    }
    // The bound of the impulse of compression.
    const double bound = -rate(0) / least;
    EXPECT_LE(outcome.compression.lambda.z(), bound * (1 + 1e-12));
  }
  EXPECT_GT(restarts, 100);
}

TEST(ImpactTheory, InAJamSlipSlowsDownAndStableStickingCatchesIt) {
  Random random(52);
  int jams = 0, caught = 0;
  for (int k = 0; k < 3000; ++k) {
    const Collision collision = random_collision(random);
    const SlipFlow flow(collision.matrix);
    const bool is_stable = test_sticking(collision.matrix).is_stable;
    std::vector<CollisionPoint> path;
    resolve_collision(collision, RestitutionLaw::stronge, &path);
    const Mat2 inverse = flow.M.inverse();
    for (std::size_t i = 1; i < path.size(); ++i) {
      const Vec2 from = path[i - 1].u.head<2>(), to = path[i].u.head<2>();
      if (from.isZero(0) || !is_clear(collision, path[i - 1]) || !is_clear(collision, path[i])) continue;
      if (path[i].u.z() < path[i - 1].u.z()) {
        ++jams;
        EXPECT_LT(to.norm(), from.norm());
      }
      if (is_stable) {
        ++caught;
        EXPECT_LT(to.dot(inverse * to), from.dot(inverse * from));
      }
    }
  }
  EXPECT_GT(jams, 100);
  EXPECT_GT(caught, 1000);
}

TEST(ImpactTheory, TheDirectionOfGreatestGrowthIsWhereGIsGreatest) {
  // g(û1) - g(û2) = ¼ (λ1 - λ2) |û1 - û2|² for any two invariant directions, and the number of them by the
  // astroid in the principal axes of M.
  Random random(53);
  int fours = 0;
  for (int k = 0; k < 2000; ++k) {
    CollisionMatrix matrix{random_matrix(random), random.uniform(0.1, 2)};
    if (k % 2 == 0) matrix.K.topRightCorner<2, 1>() *= 0.1, matrix.K.bottomLeftCorner<1, 2>() *= 0.1;
    const SlipFlow flow(matrix);
    const auto g = [&](const Vec2& d) { return flow.b.dot(d) - 0.5 * flow.mu * d.dot(flow.M * d); };
    const std::vector<InvariantDirection> directions = find_invariant_directions(flow);
    for (const InvariantDirection& one : directions) {
      for (const InvariantDirection& two : directions) {
        const Vec2 d1 = unit(one.theta), d2 = unit(two.theta);
        EXPECT_NEAR(g(d1) - g(d2), 0.25 * (one.radial_rate - two.radial_rate) * (d1 - d2).squaredNorm(),
                    1e-13 * flow.rate_bound());
      }
    }
    const Eigen::SelfAdjointEigenSolver<Mat2> principal(flow.M);
    const Vec2 b = principal.eigenvectors().transpose() * flow.b;
    const double a = flow.mu * (principal.eigenvalues()[1] - principal.eigenvalues()[0]);
    const double inside = std::pow(std::abs(a), 2.0 / 3) - std::pow(std::abs(b.x()), 2.0 / 3) -
                          std::pow(std::abs(b.y()), 2.0 / 3);
    if (std::abs(inside) < 1e-6) continue;
    EXPECT_EQ(directions.size(), inside > 0 ? 4u : 2u);
    fours += inside > 0;
  }
  EXPECT_GT(fours, 200);
  EXPECT_LT(fours, 1800);
}

TEST(ImpactTheory, InfiniteFrictionActsBeforeAnyNormalImpulse) {
  Random random(54);
  int stopped_first = 0;
  for (int k = 0; k < 500; ++k) {
    Collision collision = random_collision(random);
    collision.matrix.mu = std::numeric_limits<double>::infinity();
    std::vector<CollisionPoint> path;
    resolve_collision(collision, RestitutionLaw::stronge, &path);
    const auto stopped = std::find_if(path.begin(), path.end(), [](const CollisionPoint& point) {
      return point.u.head<2>().norm() < 1e-14;
    });
    if (stopped == path.end()) {
      // Friction alone has parted the bodies before.
      EXPECT_GE(path.back().u.z(), 0);
      EXPECT_EQ(path.back().lambda.z(), 0);
      continue;
    }
    ++stopped_first;
    const Vec2 slip = collision.u.head<2>(), impulse = stopped->lambda.head<2>();
    const SlipFlow flow(collision.matrix);
    EXPECT_EQ(stopped->lambda.z(), 0);
    EXPECT_LT((flow.M * impulse + slip).norm(), 1e-13);
    EXPECT_NEAR(stopped->u.z(), collision.u.z() + flow.b.dot(impulse), 1e-12 * (1 + impulse.norm()));
  }
  EXPECT_GT(stopped_first, 100);
  EXPECT_LT(stopped_first, 500);
}

TEST(ImpactTheory, WithoutCouplingTheThreeLawsAreOne) {
  Random random(55);
  for (int k = 0; k < 300; ++k) {
    Collision collision = random_collision(random);
    collision.matrix.K.topRightCorner<2, 1>().setZero();
    collision.matrix.K.bottomLeftCorner<1, 2>().setZero();
    const Vec3 newton = resolve_collision(collision, RestitutionLaw::newton).end.u;
    for (const RestitutionLaw law : {RestitutionLaw::poisson, RestitutionLaw::stronge})
      EXPECT_LT((resolve_collision(collision, law).end.u - newton).norm(), 1e-13);
  }
}

}  // namespace
}  // namespace rigor::impact_theory_test
