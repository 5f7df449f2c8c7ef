#include "rigor/geometry/rays/inner_points.hpp"

#include "rigor/geometry/distance/distance.hpp"
#include "rigor/geometry/shape/containment.hpp"
#include "rigor/geometry/shape/convex_hull.hpp"

#include <gtest/gtest.h>

namespace rigor::inner_points_test {
namespace {

/// How deep a point lies in a convex shape [m].
double depth_of(const Shape& shape, const Vec3& p) {
  constexpr double tiny = 1e-9;
  const Pose at_origin{Mat3::Identity(), Vec3::Zero()};
  return -signed_distance(shape, at_origin, Sphere{tiny}, {Mat3::Identity(), p}).distance - tiny;
}

TEST(InnerPoints, LieInsideAsDeepAsTheySay) {
  for (const Shape& shape :
       {Shape{Sphere{0.2}}, Shape{Box{Vec3(0.1, 0.2, 0.3)}}, Shape{Box{Vec3(1, 1, 0.001)}},
        Shape{Capsule{0.02, 0.3}}, Shape{Cylinder{0.3, 0.01}}, Shape{Cylinder{0.01, 0.3}},
        Shape{Cone{0.1, 0.2}}, Shape{Ellipsoid{Vec3(0.3, 0.01, 0.1)}}}) {
    const std::vector<InnerPoint> points = inner_points(shape);
    ASSERT_FALSE(points.empty()) << shape_type_name(shape);
    for (const InnerPoint& point : points) {
      const double depth = depth_of(shape, point.p_S);
      EXPECT_GT(depth, 0) << shape_type_name(shape);
      // 26 rays see at least as far as the nearest surface, and not twice as far where it is flat or round.
      EXPECT_GE(point.clearance, depth * (1 - 1e-6)) << shape_type_name(shape);
      EXPECT_LE(point.clearance, 4 * depth) << shape_type_name(shape);
    }
  }
}

TEST(InnerPoints, LongShapesHaveThemTowardsBothEnds) {
  EXPECT_EQ(inner_points(Sphere{1}).size(), 1U);
  const std::vector<InnerPoint> of_rod = inner_points(Capsule{0.01, 0.5});
  ASSERT_EQ(of_rod.size(), 3U);
  EXPECT_GT(std::abs(of_rod[1].p_S.z()), 0.25);
  EXPECT_LT(of_rod[1].p_S.z() * of_rod[2].p_S.z(), 0);
  EXPECT_TRUE(inner_points(HalfSpace{Vec3::UnitZ(), 0}).empty());
}

}  // namespace
}  // namespace rigor::inner_points_test
