// The depth of ellipsoids that is proved in closed form.

#include "rigor/geometry/convex/ellipsoid_penetration.hpp"
#include "random_vectors.hpp"
#include "rigor/math/rotation.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rigor::ellipsoid_penetration_test {
namespace {

using test::Random;

Vec3 random_radii(Random& random) {
  return Vec3::Constant(0.65) + 0.35 * Vec3(random.number(), random.number(), random.number());
}

/// s(n) by its formula.
double separation_of(const CorePair& pair, const Vec3& n) {
  const double h_A = pair.a.size.cwiseProduct(n).norm();
  const double h_B = pair.b.size.cwiseProduct(pair.X_AB.R.transpose() * n).norm();
  return n.dot(pair.X_AB.p) - h_A - h_B;
}

/// The centre of B at that part of the way at which the two ellipsoids come apart along u.
CorePair overlapping(const ConvexCore& a, const ConvexCore& b, const Mat3& R, const Vec3& u, double part) {
  const CorePair at_once(a, b, {R, Vec3::Zero()});
  return {a, b, {R, -part * separation_of(at_once, u) * u}};
}

TEST(EllipsoidPenetration, NoDirectionIsBetterThanTheProvedOne) {
  Random random(41);
  int proved = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const ConvexCore a = make_core(Ellipsoid{random_radii(random)}),
                     b = make_core(Ellipsoid{random_radii(random)});
    const Mat3 R = rotation_matrix(rotation_exp(3 * random.vector()));
    const Vec3 u = random.vector().normalized();
    const CorePair pair = overlapping(a, b, R, u, 0.35 * (1 + random.number()));
    // From any start: a local maximum that is not the best must not be taken for it.
    const Vec3 start = trial % 2 == 0 ? u : random.vector().normalized();
    const std::optional<Penetration> found = find_ellipsoid_penetration(pair, start);
    if (!found) continue;
    ++proved;
    EXPECT_NEAR(found->best.value, separation_of(pair, found->best.n), pair.rounding);
    EXPECT_NEAR((found->best.b - found->best.a - found->best.value * found->best.n).norm(), 0, pair.rounding);
    for (int k = 0; k < 1000; ++k) {
      ASSERT_LE(separation_of(pair, random.vector().normalized()), found->best.value + pair.rounding)
          << trial;
    }
  }
  EXPECT_GT(proved, 70);  // From a random start Newton finds the best maximum seldom.
}

TEST(EllipsoidPenetration, RefusesALocalMaximumThatIsNotTheBest) {
  // Equal lengths across, a long axis along x; the other ball a little off the centre. Along x a maximum
  // needs the whole length; across it needs 0.3 + 0.1 only.
  const ConvexCore a = make_core(Ellipsoid{Vec3(1, 0.3, 0.3)}), b = make_core(Ellipsoid{Vec3::Constant(0.1)});
  const CorePair pair(a, b, {Mat3::Identity(), Vec3(0.05, 0, 0.01)});
  const std::optional<Penetration> found = find_ellipsoid_penetration(pair, Vec3::UnitX());
  if (found) {
    EXPECT_GT(std::abs(found->best.n.z()), 0.9);
  }
  // Concentric balls: every direction is as good, and the proof just does not hold.
  const CorePair balls(b, b, {Mat3::Identity(), Vec3::Zero()});
  const std::optional<Penetration> of_balls = find_ellipsoid_penetration(balls, Vec3::UnitX());
  EXPECT_TRUE(!of_balls || std::abs(of_balls->best.value + 0.2) <= balls.rounding);
}

TEST(EllipsoidPenetration, OfAPointIsKnownWhereTheSurfaceIsRoundEnough) {
  // A point on the z axis of an ellipsoid with the half axes r, r, 1 is nearest to the pole if the radius of
  // curvature there, r², is no less than its depth.
  const double r = 0.6;
  const ConvexCore a = make_core(Ellipsoid{Vec3(r, r, 1)}), point = make_core(Sphere{0.1});
  for (const double depth : {0.1, 0.2, 0.35}) {
    const CorePair pair(a, point, {Mat3::Identity(), Vec3(0, 0, 1 - depth)});
    const std::optional<Penetration> found = find_ellipsoid_penetration(pair, Vec3::UnitZ());
    ASSERT_TRUE(found) << depth;
    EXPECT_NEAR(found->best.value, -depth, pair.rounding);
  }
  for (const double depth : {0.37, 0.5, 0.9}) {
    const CorePair pair(a, point, {Mat3::Identity(), Vec3(0, 0, 1 - depth)});
    EXPECT_FALSE(find_ellipsoid_penetration(pair, Vec3::UnitZ())) << depth;
  }
}

}  // namespace
}  // namespace rigor::ellipsoid_penetration_test
