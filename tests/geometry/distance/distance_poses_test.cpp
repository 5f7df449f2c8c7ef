#include "rigor/geometry/distance/distance.hpp"
#include "rigor/geometry/shape/convex_hull.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <memory>

namespace rigor::distance_poses_test {
namespace {

Pose moved(double x, double y, double z) {
  return {.p = Vec3(x, y, z)};
}

Shape corner() {
  return Convex{std::make_shared<const ConvexHull>(
      std::get<ConvexHull>(make_convex_hull({Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()})))};
}

TEST(Distance, OfAPoseThatIsNotFiniteIsUnknownAndAbortsNothing) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const std::vector<Shape> shapes = {Sphere{1},  Box{Vec3::Ones()},        Capsule{1, 1}, Cylinder{1, 1},
                                     Cone{1, 1}, Ellipsoid{Vec3(1, 2, 3)}, corner()};
  std::vector<Pose> poses = {moved(nan, 0, 0), moved(0, infinity, 0), moved(0, 0, 1e200), Pose{}};
  poses.back().R(1, 2) = nan;
  for (const Shape& a : shapes) {
    for (const Shape& b : shapes) {
      for (const Pose& X : poses) {
        for (const bool is_first : {true, false}) {
          const DistanceResult r = is_first ? signed_distance(a, X, b, {}) : signed_distance(a, {}, b, X);
          EXPECT_EQ(r.distance, infinity);
          EXPECT_EQ(r.lower, -infinity);
          EXPECT_EQ(r.upper, infinity);
          EXPECT_TRUE(r.p_WA.allFinite() && r.p_WB.allFinite() && r.n_W.allFinite());
        }
      }
    }
  }
}

}  // namespace
}  // namespace rigor::distance_poses_test
