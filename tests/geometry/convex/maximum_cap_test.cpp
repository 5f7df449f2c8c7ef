#include "rigor/geometry/convex/maximum_cap.hpp"

#include "geometry/random_pairs.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace rigor::maximum_cap_test {
namespace {

using test::Draw;

/// A direction within the angle from n.
Vec3 direction_near(Draw& draw, const Vec3& n, double angle) {
  const Vec3 across = n.cross(draw.direction()).normalized();
  const double turn = draw.uniform(0, angle);
  return std::cos(turn) * n + std::sin(turn) * across;
}

TEST(MaximumCap, NoDirectionInItIsBetter) {
  Draw draw(1);
  int count = 0;
  for (int i = 0; i < 1600; ++i) {
    const ConvexCore a = make_core(Ellipsoid{draw.sizes()});
    const Shape other = draw.shape(i % 2 ? 5 : 1);
    const ConvexCore b = make_core(other);
    const CorePair pair(a, b, draw.pose(0.3));
    const Vec3 start = draw.direction();
    const std::array<DifferencePoint, 1> lowest{pair.lowest(start)};
    const std::array<double, 1> weights{1};
    const std::optional<Separation> maximum = polish_separation(pair, start, {lowest, weights});
    if (!maximum || maximum->value >= 0) continue;
    if ((maximum->b - maximum->a - maximum->value * maximum->n).norm() > pair.rounding) continue;
    const double cosine = cap_cosine(pair, *maximum);
    if (cosine == 1) continue;
    ++count;
    for (int k = 0; k < 200; ++k) {
      const Vec3 n = direction_near(draw, maximum->n, std::acos(cosine));
      EXPECT_LE(n.dot(pair.lowest(n).w), maximum->value + pair.rounding);
    }
  }
  EXPECT_GT(count, 100);
}

TEST(MaximumCap, IsAllDirectionsWhereTheDepthIsLessThanTheSmallestRadiusOfCurvature) {
  // Radii of curvature of the ellipsoid (0.2, 0.3, 0.4) are at least 0.2²/0.4 = 0.1.
  const ConvexCore egg = make_core(Ellipsoid{Vec3(0.2, 0.3, 0.4)});
  const ConvexCore point = make_core(Sphere{0.1});
  const Separation shallow{Vec3::UnitX(), -0.099, Vec3(0.2, 0, 0), Vec3(0.101, 0, 0)};
  EXPECT_EQ(cap_cosine(CorePair(egg, point, {.p = Vec3(0.101, 0, 0)}), shallow), -1);
  const Separation deep{Vec3::UnitX(), -0.15, Vec3(0.2, 0, 0), Vec3(0.05, 0, 0)};
  EXPECT_GT(cap_cosine(CorePair(egg, point, {.p = Vec3(0.05, 0, 0)}), deep), -1);
}

TEST(MaximumCap, IsUnknownWithoutAnEllipsoid) {
  const ConvexCore box = make_core(Box{Vec3(1, 1, 1)});
  const Separation maximum{Vec3::UnitX(), -0.1, Vec3(1, 0, 0), Vec3(0.9, 0, 0)};
  EXPECT_EQ(cap_cosine(CorePair(box, box, {.p = Vec3(1.9, 0, 0)}), maximum), 1);
}

}  // namespace
}  // namespace rigor::maximum_cap_test
