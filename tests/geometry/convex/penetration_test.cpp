#include "geometry/random_pairs.hpp"

#include "rigor/geometry/convex/convex_distance.hpp"
#include "rigor/geometry/convex/expanding_polytope.hpp"
#include "rigor/geometry/convex/separation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigor::penetration_test {
namespace {

using test::Draw;
using test::separation_along;

Pose moved(double x, double y, double z) {
  return {.p = Vec3(x, y, z)};
}

DistanceResult distance_of(const Shape& a, const Pose& X_WA, const Shape& b, const Pose& X_WB) {
  return convex_distance(make_core(a), X_WA, make_core(b), X_WB);
}

/// What holds for every answer: an enclosure, a unit normal whose own separation is the distance, and
/// witnesses that far apart along it, on the surfaces.
void expect_consistent(const DistanceResult& r, const Shape& a, const Pose& X_WA, const Shape& b,
                       const Pose& X_WB) {
  const double tolerance = 1e-14 * (1 + X_WA.p.norm() + X_WB.p.norm());
  EXPECT_LE(r.lower, r.distance);
  EXPECT_LE(r.distance, r.upper);
  EXPECT_NEAR(r.n_W.norm(), 1, 1e-15);
  EXPECT_NEAR(separation_along(r.n_W, a, X_WA, b, X_WB), r.distance, tolerance);
  EXPECT_LT((r.p_WB - r.p_WA - r.distance * r.n_W).norm(), tolerance);
  const ConvexCore point;
  EXPECT_NEAR(convex_distance(make_core(a), X_WA, point, {.p = r.p_WA}).distance, 0, 10 * tolerance);
  EXPECT_NEAR(convex_distance(make_core(b), X_WB, point, {.p = r.p_WB}).distance, 0, 10 * tolerance);
}

/// Exact for overlapping polyhedra: the best of all face normals and all products of edges.
double depth_by_all_normals(const Shape& a, const Pose& X_WA, const Shape& b, const Pose& X_WB) {
  const ConvexHull& hull_a = *std::get<Convex>(a).hull;
  const ConvexHull& hull_b = *std::get<Convex>(b).hull;
  double best = -std::numeric_limits<double>::infinity();
  const auto try_normal = [&](const Vec3& n) {
    best = std::max(best, separation_along(n, a, X_WA, b, X_WB));
  };
  for (const Vec3& n : hull_a.face_normals) try_normal(X_WA.R * n);
  for (const Vec3& n : hull_b.face_normals) try_normal(-(X_WB.R * n));
  const auto edge = [](const ConvexHull& hull, const ConvexHull::Edge& e) -> Vec3 {
    return hull.vertices[static_cast<std::size_t>(e.v1)] - hull.vertices[static_cast<std::size_t>(e.v0)];
  };
  for (const ConvexHull::Edge& e : hull_a.edges) {
    for (const ConvexHull::Edge& f : hull_b.edges) {
      const Vec3 n = (X_WA.R * edge(hull_a, e)).cross(X_WB.R * edge(hull_b, f));
      if (n.norm() < 1e-9) continue;
      try_normal(n.normalized());
      try_normal(-n.normalized());
    }
  }
  return -best;
}

TEST(Penetration, OfPolyhedraIsTheBestOfAllFaceNormalsAndEdgeProducts) {
  Draw draw(1);
  for (int i = 0; i < 40; ++i) {
    const Shape a = draw.hull(8 + i % 9);
    const Shape b = draw.hull(8 + i % 5);
    const Pose X_WA = draw.pose(0.1);
    const Pose X_WB = draw.pose(i % 2 ? 0.1 : 0.3);
    const DistanceResult r = distance_of(a, X_WA, b, X_WB);
    if (r.distance > 0) continue;
    EXPECT_NEAR(-r.distance, depth_by_all_normals(a, X_WA, b, X_WB), 2e-15);
    EXPECT_LT(r.upper - r.lower, 3e-14);  // Polytopes end at an exact facet.
    expect_consistent(r, a, X_WA, b, X_WB);
  }
}

TEST(Penetration, NoDirectionIsBetterThanTheCertifiedBound) {
  Draw draw(2);
  for (int i = 0; i < 81 * 3; ++i) {
    const Shape a = draw.shape(i % Draw::kKinds);
    const Shape b = draw.shape(i / Draw::kKinds % Draw::kKinds);
    const Pose X_WA = draw.pose(0.2);
    const Pose X_WB = draw.pose(0.2);
    const DistanceResult r = distance_of(a, X_WA, b, X_WB);
    expect_consistent(r, a, X_WA, b, X_WB);
    EXPECT_LT(r.upper - r.lower, 1e-6) << shape_type_name(a) << " " << shape_type_name(b);
    for (int k = 0; k < 300; ++k) {
      EXPECT_LE(separation_along(draw.direction(), a, X_WA, b, X_WB), r.distance + 1e-14);
    }
    // Nor is one near the answer.
    for (int k = 0; k < 100; ++k) {
      const Vec3 n = (r.n_W + std::pow(10, draw.uniform(-7, -1)) * draw.direction()).normalized();
      EXPECT_LE(separation_along(n, a, X_WA, b, X_WB), r.distance + 1e-14);
    }
  }
}

TEST(Penetration, MovingOutAlongTheNormalMakesTheShapesTouch) {
  Draw draw(3);
  for (int i = 0; i < 81 * 2; ++i) {
    const Shape a = draw.shape(i % Draw::kKinds);
    const Shape b = draw.shape(i / Draw::kKinds % Draw::kKinds);
    const Pose X_WA = draw.pose(0.2);
    Pose X_WB = draw.pose(0.2);
    const DistanceResult deep = distance_of(a, X_WA, b, X_WB);
    X_WB.p -= deep.distance * deep.n_W;
    const DistanceResult touching = distance_of(a, X_WA, b, X_WB);
    EXPECT_NEAR(touching.distance, 0, 2e-15) << shape_type_name(a) << " " << shape_type_name(b);
    expect_consistent(touching, a, X_WA, b, X_WB);
  }
}

TEST(Penetration, OfCoincidentShapesIsTheirSmallestWidth) {
  const Pose X = {rotation_matrix(rotation_exp(Vec3(0.3, -0.7, 1.1))), Vec3(0.1, 0.2, 0.3)};
  const auto depth = [&](const Shape& shape) {
    const DistanceResult r = distance_of(shape, X, shape, X);
    expect_consistent(r, shape, X, shape, X);
    return -r.distance;
  };
  EXPECT_NEAR(depth(Sphere{0.5}), 1, 1e-15);
  EXPECT_NEAR(depth(Box{Vec3(0.5, 0.25, 0.75)}), 0.5, 1e-15);
  EXPECT_NEAR(depth(Box{Vec3::Constant(0.5)}), 1, 1e-15);
  EXPECT_NEAR(depth(Capsule{0.25, 1}), 0.5, 1e-15);
  EXPECT_NEAR(depth(Cylinder{0.25, 0.05}), 0.1, 1e-15);
  EXPECT_NEAR(depth(Cylinder{0.25, 1}), 0.5, 1e-15);
  EXPECT_NEAR(depth(Ellipsoid{Vec3(0.3, 0.4, 0.5)}), 0.6, 1e-15);
  EXPECT_NEAR(depth(Ellipsoid{Vec3(0.3, 0.3, 0.3)}), 0.6, 1e-15);
  // The width of a slender cone is that of its section, 2 r cos of the half angle.
  EXPECT_NEAR(depth(Cone{0.25, 0.5}), 0.5 / std::hypot(1, 0.25), 1e-15);
}

TEST(Penetration, OfEqualSpheresAtOnePlaceHasAFixedUnitNormal) {
  const DistanceResult r = distance_of(Sphere{0.5}, moved(1, 2, 3), Sphere{0.5}, moved(1, 2, 3));
  EXPECT_EQ(r.distance, -1);
  EXPECT_EQ(r.n_W.norm(), 1);
}

TEST(Penetration, OfASphereInsideACylinderMayLeadThroughTheCap) {
  // To the side r - ρ, to the cap l - |z|; libraries forget the cap.
  for (const double z : {-0.2, 0.1, 0.25}) {
    for (const double x : {0.0, 0.1, 0.3, 0.41}) {
      const DistanceResult r =
          distance_of(Sphere{0.3154}, moved(x, 0, z), Cylinder{0.4179, 0.2888}, moved(0, 0, 0));
      EXPECT_NEAR(r.distance, -(0.3154 + std::min(0.4179 - x, 0.2888 - std::abs(z))), 1e-15);
    }
  }
}

TEST(Penetration, OfASphereInsideAConeIsTheNearerOfSideAndBase) {
  const double slant = std::hypot(0.5, 2.0);
  for (const double z : {-0.95, -0.5, 0.0, 0.9}) {
    const DistanceResult r = distance_of(Sphere{0.1}, moved(0.01, 0, z), Cone{0.5, 1}, moved(0, 0, 0));
    const double to_side = ((1 - z) * 0.5 - 0.01 * 2) / slant;
    EXPECT_NEAR(r.distance, -(0.1 + std::min(to_side, z + 1)), 1e-15);
  }
}

TEST(Penetration, OfConcentricEllipsoidsIsTheSumOfTheirShortestRadii) {
  const Ellipsoid a{Vec3(0.3, 0.5, 0.7)};
  const Ellipsoid b{Vec3(0.42, 0.6, 0.45)};
  EXPECT_NEAR(distance_of(a, moved(0, 0, 0), b, moved(0, 0, 0)).distance, -0.72, 1e-15);
  // And of an ellipsoid about a small ball at its centre, as an ellipsoid or as a sphere.
  const Ellipsoid ball{Vec3::Constant(0.1)};
  EXPECT_NEAR(distance_of(a, moved(0, 0, 0), ball, moved(0, 0, 0)).distance, -0.4, 1e-15);
  EXPECT_NEAR(distance_of(a, moved(0, 0, 0), Sphere{0.1}, moved(0, 0, 0)).distance, -0.4, 1e-15);
}

TEST(Penetration, OfAlignedBoxesIsAlongAnAxis) {
  const Box one{Vec3::Constant(1)};
  const DistanceResult r = distance_of(one, moved(0, 0, 0), one, moved(0, 0, 1.9));
  EXPECT_NEAR(r.distance, -0.1, 1e-15);
  EXPECT_EQ(r.n_W, Vec3(0, 0, 1));
  const DistanceResult shallow = distance_of(one, moved(0, 0, 0), one, moved(1.9999, 0, 0));
  EXPECT_NEAR(shallow.distance, -1e-4, 1e-15);
  EXPECT_EQ(shallow.n_W, Vec3(1, 0, 0));
  const Box small{Vec3::Constant(0.2)};
  const Box half{Vec3::Constant(0.5)};
  EXPECT_NEAR(distance_of(half, moved(0, 0, 0), small, moved(0.4, 0.4, 0.4)).distance, -0.3, 1e-15);
}

TEST(Penetration, OfParallelCylindersIsTheSmallerOverlap) {
  const Cylinder disk{0.25, 0.05};
  for (int i = -49; i < 50; ++i) {
    const double x = 0.01 * i;
    const DistanceResult r = distance_of(disk, moved(0, 0, 0), disk, moved(x, 0, 0));
    EXPECT_NEAR(r.distance, -std::min(0.1, 0.5 - std::abs(x)), 1e-15);
    expect_consistent(r, disk, moved(0, 0, 0), disk, moved(x, 0, 0));
  }
}

TEST(Penetration, OfThinCrossedCylindersIsTheSumOfTheRadii) {
  const Pose lying{rotation_matrix(rotation_exp(Vec3(std::numbers::pi / 2, 0, 0)))};
  const Cylinder rod{0.01, 0.5};
  const DistanceResult r = distance_of(rod, moved(0, 0, 0), rod, lying);
  EXPECT_NEAR(r.distance, -0.02, 1e-15);
  EXPECT_NEAR(std::abs(r.n_W.x()), 1, 1e-15);
}

TEST(Penetration, OfTwoTipsIsAcrossTheirSides) {
  // Apexes δ past each other: out along the normal of a side, n_z = sin of the half angle.
  const double delta = 1e-3;
  const Pose upside_down{rotation_matrix(rotation_exp(Vec3(std::numbers::pi, 0, 0))), Vec3(0, 0, 1 - delta)};
  const DistanceResult r = distance_of(Cone{0.3, 0.5}, moved(0, 0, 0), Cone{0.3, 0.5}, upside_down);
  EXPECT_NEAR(r.distance, -delta * 0.3 / std::hypot(0.3, 1), 1e-15);
}

TEST(Penetration, OfAFlatTriangleIsItsWayOut) {
  const std::array<Vec3, 3> corners{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  const ConvexCore triangle = make_points_core(corners);
  const Box box{Vec3::Constant(0.5)};
  for (const double z : {0.2, 1e-9, 0.0, -1e-9, -0.3}) {
    const DistanceResult r = convex_distance(triangle, {}, make_core(box), moved(0.2, 0.2, z + 0.5));
    EXPECT_NEAR(r.distance, z, 1e-16);
    EXPECT_EQ(r.n_W, Vec3(0, 0, 1));
  }
  // Sphere, capsule and triangle in its plane: no thickness there.
  EXPECT_EQ(convex_distance(triangle, {}, make_core(Sphere{0.1}), moved(0.2, 0.2, 0)).distance, -0.1);
  EXPECT_NEAR(convex_distance(triangle, {}, triangle, moved(0.2, 0.2, 0)).distance, 0, 1e-16);
  const Pose lying{rotation_matrix(rotation_exp(Vec3(std::numbers::pi / 2, 0, 0))), Vec3(0.2, 0.2, 0)};
  EXPECT_NEAR(convex_distance(triangle, {}, make_core(Capsule{0.1, 0.5}), lying).distance, -0.1, 1e-15);
}

TEST(Penetration, OfCrossingAndCollinearSegmentsIsZeroBeforeTheirRadii) {
  const Capsule capsule{0.1, 0.5};
  const Pose across{rotation_matrix(rotation_exp(Vec3(0, std::numbers::pi / 2, 0))), Vec3(0, 0, 0.1)};
  const DistanceResult crossing = distance_of(capsule, moved(0, 0, 0), capsule, across);
  EXPECT_NEAR(crossing.distance, -0.2, 1e-16);
  EXPECT_NEAR(std::abs(crossing.n_W.y()), 1, 1e-15);
  const DistanceResult collinear = distance_of(capsule, moved(0, 0, 0), capsule, moved(0, 0, 0.3));
  EXPECT_NEAR(collinear.distance, -0.2, 1e-16);
  EXPECT_NEAR(collinear.n_W.z(), 0, 1e-15);
}

TEST(ExpandingPolytope, GrowsTowardsTheBoundaryAndStaysClosed) {
  Draw draw(5);
  const Ellipsoid shape{Vec3(0.3, 0.4, 0.5)};
  const ConvexCore core = make_core(shape);
  const CorePair pair(core, core, {});
  ExpandingPolytope polytope(pair, Vec3::UnitX());
  ASSERT_FALSE(polytope.is_flat());
  double height = polytope.facet(polytope.lowest_facet().value()).height;
  for (int i = 0; i < 100; ++i) {
    const int lowest = polytope.lowest_facet().value();
    const ExpandingPolytope::Facet facet = polytope.facet(lowest);
    EXPECT_GE(facet.height, height - 1e-15);
    height = facet.height;
    for (std::size_t k = 0; k < 3; ++k) {
      const ExpandingPolytope::Facet& across = polytope.facet(facet.across[k]);
      EXPECT_FALSE(across.is_removed);
      EXPECT_NE(std::find(across.v.begin(), across.v.end(), facet.v[k]), across.v.end());
      EXPECT_NE(std::find(across.v.begin(), across.v.end(), facet.v[(k + 1) % 3]), across.v.end());
    }
    ASSERT_TRUE(polytope.expand(lowest, pair.lowest(-facet.m)));
  }
  EXPECT_GT(height, 0.55);
}

TEST(PolishSeparation, FindsTheMaximumFromARoughDirection) {
  // Two balls as ellipsoids, centres c apart: s is largest along c, c - r1 - r2, whatever its sign.
  const ConvexCore a = make_core(Ellipsoid{Vec3::Constant(1)});
  const ConvexCore b = make_core(Ellipsoid{Vec3::Constant(2)});
  for (const double c : {5.0, 3.0, 2.9}) {
    const CorePair pair(a, b, moved(0, 0, c));
    const Vec3 rough = Vec3(0.2, -0.1, 1).normalized();
    const std::array<DifferencePoint, 1> points{pair.lowest(rough)};
    const std::array<double, 1> weights{1};
    const std::optional<Separation> polished = polish_separation(pair, rough, {points, weights});
    ASSERT_TRUE(polished);
    EXPECT_NEAR(polished->value, c - 3, 1e-15);
    EXPECT_LT((polished->n - Vec3::UnitZ()).norm(), 1e-15);
    EXPECT_LT((polished->a - Vec3(0, 0, 1)).norm(), 1e-15);
    EXPECT_LT((polished->b - Vec3(0, 0, c - 2)).norm(), 1e-15);
  }
}

}  // namespace
}  // namespace rigor::penetration_test
