#include "rigor/geometry/convex/parallel_penetration.hpp"

#include "geometry/random_pairs.hpp"
#include "rigor/geometry/distance/distance.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace rigor::parallel_penetration_test {
namespace {

using namespace test;

Shape solid_of_revolution(Draw& draw, int kind) {
  const double r = draw.size(), h = draw.size();
  if (kind == 0) return Capsule{r, h};
  if (kind == 1) return Cylinder{r, h};
  if (kind == 2) return Cone{r, h};
  return std::get<Revolution>(make_revolution(
      {Vec2(0, -h), Vec2(0.7 * r, -h), Vec2(r, -0.3 * h), Vec2(0.6 * r, 0.8 * h), Vec2(0, h)}));
}

/// Largest separation along directions in the plane of the axes, seen from A: the best of 4,000 angles.
double best_separation(const Shape& a, const Pose& X_WA, const Shape& b, const Pose& X_WB) {
  const Vec3 aside_A = X_WA.R.transpose() * (X_WB.p - X_WA.p);
  const Vec2 xy = aside_A.head<2>();
  const Vec2 out = xy.norm() > 1e-9 ? Vec2(xy.normalized()) : Vec2(Vec2::UnitX());
  double best = -std::numeric_limits<double>::infinity();
  for (int i = 0; i < 4000; ++i) {
    const double angle = 2 * std::numbers::pi * i / 4000;
    const Vec3 n_A(std::sin(angle) * out.x(), std::sin(angle) * out.y(), std::cos(angle));
    best = std::max(best, separation_along(X_WA.R * n_A, a, X_WA, b, X_WB));
  }
  return best;
}

TEST(ParallelPenetration, OfSolidsOnOneAxisOrOnParallelAxesIsExact) {
  Draw draw(41);
  for (int trial = 0; trial < 400; ++trial) {
    const Shape a = solid_of_revolution(draw, trial % 4), b = solid_of_revolution(draw, trial / 4 % 4);
    // On one axis, at one place, or side by side; upside down or not; turned about the axis.
    Pose X_AB{rotation_matrix(rotation_exp(Vec3(0, 0, draw.uniform(0, 6)))), Vec3::Zero()};
    if (trial % 2 == 1) X_AB.R = X_AB.R * rotation_matrix(rotation_exp(std::numbers::pi * Vec3::UnitX()));
    if (trial % 3 != 0) X_AB.p.z() = draw.uniform(-0.5, 0.5);
    if (trial % 5 == 0) X_AB.p.x() = draw.uniform(-0.3, 0.3);
    const Pose X_WA = draw.pose(1), X_WB = X_WA * X_AB;
    const DistanceResult d = signed_distance(a, X_WA, b, X_WB);
    if (d.distance >= 0) continue;
    EXPECT_LT(d.upper - d.lower, 1e-6) << trial;
    EXPECT_LT((d.p_WB - d.p_WA - d.distance * d.n_W).norm(), 1e-12) << trial;
    EXPECT_NEAR(separation_along(d.n_W, a, X_WA, b, X_WB), d.distance, 1e-12) << trial;
    // The angles are 1.6e-3 apart, and the sides are square to the best one.
    const double sampled = best_separation(a, X_WA, b, X_WB);
    EXPECT_GE(d.distance, sampled - 1e-12) << trial;
    EXPECT_LE(d.distance, sampled + 2e-3) << trial;
  }
}

TEST(ParallelPenetration, AllowsForAxesThatAreParallelButForRounding) {
  Draw draw(42);
  for (int trial = 0; trial < 200; ++trial) {
    const Shape a = solid_of_revolution(draw, trial % 4), b = solid_of_revolution(draw, trial / 4 % 4);
    const Mat3 tilt =
        rotation_matrix(rotation_exp(1e-16 * std::pow(1e9, draw.uniform(0, 1)) * Vec3::UnitX()));
    const Pose X_WA = draw.pose(1), X_WB = X_WA * Pose{tilt, Vec3(0, 0, draw.uniform(-0.3, 0.3))};
    const DistanceResult d = signed_distance(a, X_WA, b, X_WB);
    if (d.distance >= 0) continue;
    EXPECT_LT(d.upper - d.lower, 2e-6) << trial;
    for (int i = 0; i < 20; ++i)
      EXPECT_LE(separation_along(draw.direction(), a, X_WA, b, X_WB), d.upper + 1e-13);
  }
}

TEST(SphereDistance, LiesWithinItsBounds) {
  // Against the same in 64 bits of mantissa: bounds that were rounded inwards missed one in 15,000.
  Draw draw(43);
  for (int trial = 0; trial < 200000; ++trial) {
    const double r = draw.size(), s = draw.size();
    const Vec3 p = 2 * std::pow(1e-6, draw.uniform(0, 1)) * draw.direction(), q = Vec3::Zero();
    const DistanceResult d =
        signed_distance(Sphere{r}, {Mat3::Identity(), p}, Sphere{s}, {Mat3::Identity(), q});
    const long double x = p.x(), y = p.y(), z = p.z();
    const long double truth =
        std::sqrt(x * x + y * y + z * z) - static_cast<long double>(r) - static_cast<long double>(s);
    ASSERT_LE(static_cast<long double>(d.lower), truth) << trial;
    ASSERT_GE(static_cast<long double>(d.upper), truth) << trial;
  }
}

}  // namespace
}  // namespace rigor::parallel_penetration_test
