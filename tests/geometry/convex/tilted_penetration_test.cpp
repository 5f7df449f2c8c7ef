// Solids of revolution whose axes are nearly parallel: no direction is better than the proof allows.

#include "rigor/geometry/convex/tilted_penetration.hpp"
#include "random_vectors.hpp"
#include "rigor/geometry/distance/distance.hpp"
#include "rigor/math/rotation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace rigor::tilted_penetration_test {
namespace {

using test::Random;

constexpr double kPi = std::numbers::pi;

Shape random_solid(Random& random) {
  const double radius = random.uniform(0.05, 0.5), half_length = random.uniform(0.05, 0.5);
  const double kind = random.uniform(0, 3);
  if (kind < 1) return Cylinder{radius, half_length};
  if (kind < 2) return Cone{radius, half_length};
  return Capsule{radius, half_length};
}

double random_size(Random& random, double low, double high) {
  return std::pow(10, random.uniform(low, high));
}

/// B against A: tilted by `tilt` [rad], the axes up to 0.05 beside each other, one in three turned over.
Pose random_pose(Random& random, double tilt) {
  const double angle = random.uniform(0, 2 * kPi);
  const Vec3 across(std::cos(angle), std::sin(angle), 0);
  Quat q = rotation_exp(tilt * across) * rotation_exp(random.uniform(0, 2 * kPi) * Vec3::UnitZ());
  if (random.uniform(0, 3) < 1) q = q * rotation_exp(kPi * Vec3::UnitX());
  const double beside = random.uniform(0, 2) < 1 ? 0 : random_size(random, -7, -1.3);
  const double along = random.uniform(0, 2) < 1 ? 0 : random.uniform(-0.1, 0.1);
  return {rotation_matrix(q), Vec3(beside * across.y(), beside, along)};
}

/// s(n) by the support points of the cores.
double separation_along(const CorePair& pair, const Vec3& n) {
  return n.dot(pair.lowest(n).w);
}

TEST(TiltedPenetration, NoDirectionIsBetterThanItsBound) {
  Random random(2501);
  int proved = 0;
  for (int trial = 0; trial < 400; ++trial) {
    SCOPED_TRACE(trial);
    const ConvexCore a = make_core(random_solid(random)), b = make_core(random_solid(random));
    const CorePair pair(a, b, random_pose(random, random_size(random, -8, -2.3)));
    const std::optional<Penetration> found = find_tilted_penetration(pair);
    if (!found) continue;
    ++proved;
    const Separation& best = found->best;
    const double size = std::min(a.extent, b.extent);
    EXPECT_NEAR(best.value, separation_along(pair, best.n), pair.rounding);
    EXPECT_LE((best.b - best.a - best.value * best.n).norm(), 1e-7 * size);
    EXPECT_LE(found->upper - best.value, 1e-6 * size);

    // Everywhere, near the best direction, and all around the axes at its angle and at those of the ends.
    std::vector<Vec3> directions;
    for (int k = 0; k < 300; ++k) {
      directions.push_back(random.vector().normalized());
      directions.push_back((best.n + random_size(random, -8, -1) * random.vector()).normalized());
      const Vec3 end = (k % 2 == 0 ? Vec3(Vec3::UnitZ()) : Vec3(pair.X_AB.R.col(2)));
      directions.push_back((k % 4 < 2 ? 1 : -1) *
                           (end + random_size(random, -9, -1) * random.vector()).normalized());
    }
    for (int k = 0; k < 720; ++k) {
      const double angle = 2 * kPi * k / 720;
      for (const Vec3& axis : {Vec3(Vec3::UnitZ()), Vec3(pair.X_AB.R.col(2))})
        directions.push_back(rotation_matrix(rotation_exp(angle * axis)) * best.n);
    }
    for (const Vec3& n : directions) ASSERT_LE(separation_along(pair, n), found->upper + pair.rounding);
  }
  EXPECT_GT(proved, 300);
}

TEST(TiltedPenetration, BoundsOfNearlyCoaxialSolidsAreAsNearAsThoseOfOthers) {
  Random random(2502);
  int wide = 0, count = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const Shape a = random_solid(random), b = random_solid(random);
    const Pose X_AB = random_pose(random, random_size(random, -8, -3));
    const Pose X_WA{rotation_matrix(rotation_exp(3 * random.vector())), random.vector()};
    const DistanceResult ab = signed_distance(a, X_WA, b, X_WA * X_AB),
                         ba = signed_distance(b, X_WA * X_AB, a, X_WA);
    ASSERT_LT(ab.distance, 0);
    EXPECT_EQ(ab.distance, ba.distance);
    ++count;
    if (ab.upper - ab.lower > 1e-6) ++wide;
  }
  EXPECT_LE(wide, count / 50);
}

}  // namespace
}  // namespace rigor::tilted_penetration_test
