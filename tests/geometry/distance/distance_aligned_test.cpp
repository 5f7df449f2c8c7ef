// Distances of shapes whose faces, edges, axes and corners coincide.

#include "rigor/geometry/distance/distance.hpp"

#include "geometry/random_pairs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace rigor::distance_aligned_test {
namespace {

using test::Draw;
using test::separation_along;

/// One of the 24 turns of a cube, an exact matrix.
Mat3 quarter_turns(Draw& draw) {
  const auto pick = [&](int count) { return static_cast<int>(draw.uniform(0, count)); };
  const int i = pick(3);
  const int j = (i + 1 + pick(2)) % 3;
  Mat3 R;
  R.col(0) = Vec3::Unit(i) * (pick(2) ? 1 : -1);
  R.col(1) = Vec3::Unit(j) * (pick(2) ? 1 : -1);
  R.col(2) = R.col(0).cross(R.col(1));
  return R;
}

/// Sizes and places in quarters: faces, edges, axes and corners coincide all the time.
Shape shape_in_quarters(Draw& draw, int kind) {
  const auto quarters = [&] { return 0.25 * (1 + static_cast<int>(draw.uniform(0, 3))); };
  const double x = quarters();
  const double y = quarters();
  const double z = quarters();
  switch (kind) {
    case 0:
      return Sphere{x};
    case 1:
      return Box{Vec3(x, y, z)};
    case 2:
      return Capsule{x, y};
    case 3:
      return Cylinder{x, y};
    case 4:
      return Cone{x, y};
    case 5:
      return Ellipsoid{Vec3(x, y, z)};
    case 6:
      return Convex{std::make_shared<const ConvexHull>(make_box_hull(Vec3(x, y, z)))};
    default:  // An octahedron.
      return test::hull_of(
          {Vec3(x, 0, 0), Vec3(-x, 0, 0), Vec3(0, y, 0), Vec3(0, -y, 0), Vec3(0, 0, z), Vec3(0, 0, -z)});
  }
}

TEST(Distance, HoldsWhereEverythingIsAlignedAndDegenerate) {
  Draw draw(13);
  for (int i = 0; i < 64 * 40; ++i) {
    const Shape a = shape_in_quarters(draw, i % 8);
    const Shape b = shape_in_quarters(draw, i / 8 % 8);
    SCOPED_TRACE(std::to_string(i) + " " + shape_type_name(a) + " " + shape_type_name(b));
    const auto place = [&] { return 0.25 * std::floor(draw.uniform(-5, 6)); };
    const Pose X_WB{quarter_turns(draw), Vec3(place(), place(), place())};
    const DistanceResult r = signed_distance(a, {}, b, X_WB);
    EXPECT_LE(r.lower, r.distance);
    EXPECT_LE(r.distance, r.upper);
    EXPECT_NEAR(r.n_W.norm(), 1, 1e-15);
    EXPECT_NEAR(separation_along(r.n_W, a, {}, b, X_WB), r.distance, 2e-15);
    EXPECT_LT((r.p_WB - r.p_WA - r.distance * r.n_W).norm(), 2e-15);
    // A cap and a face whose outlines touch from outside share one point, which is found to the root of the
    // rounding.
    EXPECT_NEAR(signed_distance(a, {}, Sphere{0.25}, {.p = r.p_WA}).distance, -0.25, 1e-7);
    EXPECT_NEAR(signed_distance(b, X_WB, Sphere{0.25}, {.p = r.p_WB}).distance, -0.25, 1e-7);
    if (r.distance > -1e-15) {
      EXPECT_LT(r.upper - r.lower, 4e-14);
    }
    for (int k = 0; k < 30; ++k) {
      EXPECT_LE(separation_along(draw.direction(), a, {}, b, X_WB), r.distance + 2e-15);
    }
  }
}

TEST(Distance, OfAlignedBoxesIsTheirFormula) {
  Draw draw(14);
  for (int i = 0; i < 2000; ++i) {
    const Shape a = shape_in_quarters(draw, 1);
    const Shape b = shape_in_quarters(draw, i % 2 ? 1 : 6);
    const auto place = [&] { return 0.25 * std::floor(draw.uniform(-7, 8)); };
    const Pose X_WB{quarter_turns(draw), Vec3(place(), place(), place())};
    const Vec3 h_b = std::holds_alternative<Box>(b) ? std::get<Box>(b).half_extents
                                                    : std::get<Convex>(b).hull->vertices[7];
    const Vec3 over = X_WB.p.cwiseAbs() - std::get<Box>(a).half_extents - X_WB.R.cwiseAbs() * h_b;
    const double expected = over.maxCoeff() > 0 ? over.cwiseMax(0).norm() : over.maxCoeff();
    const DistanceResult r = signed_distance(a, {}, b, X_WB);
    EXPECT_NEAR(r.distance, expected, 1e-15);
    if (over.maxCoeff() <= 0) {
      EXPECT_EQ(r.n_W.cwiseAbs().maxCoeff(), 1);
    }
  }
}

}  // namespace
}  // namespace rigor::distance_aligned_test
