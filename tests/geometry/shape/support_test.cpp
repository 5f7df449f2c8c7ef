#include "rigor/geometry/shape/support.hpp"

#include "geometry/random_pairs.hpp"

#include "rigor/geometry/shape/convex_core.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigor::support_test {
namespace {

using test::Draw;

TEST(Support, ValueOfEachShapeIsItsFormula) {
  Draw draw(1);
  for (int i = 0; i < 200; ++i) {
    const Vec3 d = draw.uniform(0.1, 10) * draw.direction();
    const double across = std::hypot(d.x(), d.y());
    const double r = draw.size();
    const double l = draw.size();
    const Vec3 s = draw.sizes();
    const double tolerance = 1e-14 * d.norm();  // Sums of a few terms, each at most |d|.
    EXPECT_NEAR(support_value(Sphere{r}, d), r * d.norm(), tolerance);
    EXPECT_NEAR(support_value(Box{s}, d), s.dot(d.cwiseAbs()), tolerance);
    EXPECT_NEAR(support_value(Capsule{r, l}, d), r * d.norm() + l * std::abs(d.z()), tolerance);
    EXPECT_NEAR(support_value(Cylinder{r, l}, d), r * across + l * std::abs(d.z()), tolerance);
    EXPECT_NEAR(support_value(Cone{r, l}, d), std::max(l * d.z(), r * across - l * d.z()), tolerance);
    EXPECT_NEAR(support_value(Ellipsoid{s}, d), s.cwiseProduct(d).norm(), tolerance);
  }
}

TEST(Support, AlongTheAxisOfRevolutionAPointOfTheCapIsReturned) {
  for (const double sign : {-1.0, 1.0}) {
    EXPECT_EQ(support_value(Cylinder{2, 3}, Vec3(0, 0, sign)), 3);
  }
  EXPECT_EQ(support_value(Cone{2, 3}, Vec3(0, 0, -1)), 3);
  EXPECT_EQ(support_point(Cone{2, 3}, Vec3(0, 0, 1)), Vec3(0, 0, 3));
}

TEST(Support, WalkOnALargeHullFindsWhatAScanFinds) {
  Draw draw(2);
  const Shape shape = draw.hull(500);
  const ConvexHull& hull = *std::get<Convex>(shape).hull;
  for (int i = 0; i < 500; ++i) {
    const Vec3 d = draw.direction();
    double best = -std::numeric_limits<double>::infinity();
    for (const Vec3& v : hull.vertices) best = std::max(best, d.dot(v));
    EXPECT_EQ(support_value(shape, d), best);
  }
}

TEST(Support, WalkDoesNotStopOnAFlatFace) {
  // Three layers of 40-gons: many vertices share the height along the axis.
  std::vector<Vec3> points;
  for (int i = 0; i < 40; ++i) {
    const double angle = 2 * std::numbers::pi * i / 40;
    for (const double z : {-1.0, 1.0}) points.emplace_back(std::cos(angle), std::sin(angle), z);
    points.emplace_back(1.5 * std::cos(angle), 1.5 * std::sin(angle), 0);
  }
  const Shape shape =
      Convex{std::make_shared<const ConvexHull>(std::get<ConvexHull>(make_convex_hull(points)))};
  EXPECT_EQ(support_value(shape, Vec3(0, 0, 1)), 1);
  EXPECT_EQ(support_value(shape, Vec3(0, 0, -1)), 1);
  EXPECT_EQ(support_value(shape, Vec3(1, 0, 0)), 1.5);
}

TEST(Support, RadiusAboutAPointHoldsTheShapeAndIsReached) {
  Draw draw(3);
  for (int kind = 0; kind < Draw::kKinds; ++kind) {
    for (int i = 0; i < 20; ++i) {
      const Shape shape = draw.shape(kind);
      const Vec3 c(draw.uniform(-1, 1), draw.uniform(-1, 1), i % 3 == 0 ? 0 : draw.uniform(-1, 1));
      const double radius = radius_about(shape, c);
      // x -> support point along x - c goes to a farthest point: |x - c| grows at every step.
      double farthest = 0;
      for (int start = 0; start < 100; ++start) {
        Vec3 x = support_point(shape, draw.direction());
        for (int step = 0; step < 100; ++step) x = support_point(shape, x - c);
        farthest = std::max(farthest, (x - c).norm());
      }
      EXPECT_GE(radius, farthest * (1 - 1e-15)) << shape_type_name(shape);
      // The ascent is slow where curvatures nearly agree.
      EXPECT_NEAR(radius, farthest, 1e-6) << shape_type_name(shape);
    }
  }
}

TEST(Support, RadiusOfAnEllipsoidAboutAPlaneOfSymmetry) {
  EXPECT_DOUBLE_EQ(radius_about(Ellipsoid{Vec3(1, 2, 3)}, Vec3::Zero()), 3);
  EXPECT_DOUBLE_EQ(radius_about(Ellipsoid{Vec3(2, 2, 2)}, Vec3(1, 0, 0)), 3);
  EXPECT_NEAR(radius_about(Ellipsoid{Vec3(1, 2, 3)}, Vec3(0, 0, -0.5)), 3.5, 1e-15);
  // From (c, 0, 0) on the short axis: x² + z²/9 = 1, |p - c|² = 9 - 8x² - 2cx + c² is largest at x = -c/8.
  const double c = 0.5;
  EXPECT_NEAR(radius_about(Ellipsoid{Vec3(1, 2, 3)}, Vec3(c, 0, 0)), std::sqrt(9 + c * c / 8 + c * c), 1e-14);
}

TEST(Support, RadiusOfAPlaneIsInfinite) {
  EXPECT_EQ(radius_about(HalfSpace{Vec3::UnitZ(), 0}, Vec3::Zero()), std::numeric_limits<double>::infinity());
}

TEST(ConvexCore, CurvatureIsTheDerivativeOfThePoint) {
  Draw draw(4);
  for (const int kind : {3, 4, 5}) {
    const Shape shape = draw.shape(kind);
    const ConvexCore core = make_core(shape);
    for (int i = 0; i < 20; ++i) {
      const Vec3 n = draw.direction();
      const int piece = core_support(core, n).piece;
      const Vec3 t = draw.direction();
      // Central difference, error O(h²) of the third derivative, at most a few hundred here.
      const double h = 1e-5;
      const Vec3 slope =
          (piece_point(core, piece, n + h * t) - piece_point(core, piece, n - h * t)) / (2 * h);
      const double sine = std::hypot(n.x(), n.y());
      EXPECT_LT((slope - piece_curvature(core, piece, n) * t).norm(), 1e-7 / (sine * sine * sine))
          << shape_type_name(shape);
    }
  }
}

}  // namespace
}  // namespace rigor::support_test
