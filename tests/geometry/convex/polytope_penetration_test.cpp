#include "rigor/geometry/convex/polytope_penetration.hpp"
#include "rigor/geometry/distance/distance.hpp"

#include "geometry/exact_polytopes.hpp"
#include "geometry/random_pairs.hpp"

#include "rigor/geometry/convex/box_axes.hpp"
#include "rigor/geometry/distance/distance_cache.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <numbers>

namespace rigor::polytope_penetration_test {
namespace {

using nlohmann::json;
using test::Draw;
using test::ExactPolytope;
using test::hull_of;

Shape cube_hull(const Vec3& half_extents) {
  return Convex{std::make_shared<const ConvexHull>(make_box_hull(half_extents))};
}

Vec3 vector_of(const json& v) {
  return {v[0].get<double>(), v[1].get<double>(), v[2].get<double>()};
}

Shape hull_in(const json& vertices) {
  std::vector<Vec3> points;
  for (const json& v : vertices) points.push_back(vector_of(v));
  return hull_of(points);
}

DistanceResult cold_distance(const Shape& a, const Pose& X_WA, const Shape& b, const Pose& X_WB) {
  DistanceCache cache;
  return walked_distance(a, X_WA, b, X_WB, cache);
}

/// Polytopes with many ways to be degenerate: boxes twice, round hulls, tetrahedra, needles, prisms.
Shape polytope_of(int kind, Draw& draw) {
  std::vector<Vec3> points;
  switch (kind % 8) {
    case 0:
      return Box{draw.sizes()};
    case 1:
      return cube_hull(draw.sizes());
    case 2:
      return hull_of({draw.size() * Vec3(1, 0, 0), draw.size() * Vec3(0, 1, 0), draw.size() * Vec3(0, 0, 1),
                      -draw.size() * Vec3(1, 1, 1)});
    case 3:  // a needle of aspect 10⁴
      for (int i = 0; i < 12; ++i) points.push_back(Vec3(1e-4, 1e-4, 1).cwiseProduct(draw.direction()));
      return hull_of(points);
    case 4:  // a prism over a regular hexagon
      for (int i = 0; i < 12; ++i) {
        const double angle = i % 6 * std::numbers::pi / 3;
        points.emplace_back(0.4 * std::cos(angle), 0.4 * std::sin(angle), i < 6 ? 0 : 0.3);
      }
      return hull_of(points);
    default:
      return draw.hull(kind % 8 == 5 ? 8 : kind % 8 == 6 ? 16 : 32);
  }
}

/// Poses that overlap, many of them in special position.
std::array<Pose, 2> special_poses(int kind, Draw& draw) {
  Pose X_WA = draw.pose(0.4), X_WB = draw.pose(0.4);
  if (kind == 1) X_WA.R = X_WB.R = Mat3::Identity();
  if (kind == 2) X_WB = X_WA;
  if (kind == 3) X_WB = {X_WA.R, X_WA.p + 1e-3 * draw.direction()};
  if (kind == 4) X_WB = {X_WA.R * rotation_matrix(rotation_exp(Vec3(0, 0, std::numbers::pi / 2))), X_WA.p};
  if (kind == 5) X_WB = {X_WA.R * rotation_matrix(rotation_exp(1e-9 * draw.direction())), X_WB.p};
  return {X_WA, X_WB};
}

/// Distance, bounds, normal and witness points against the exact depth.
void expect_exact(const DistanceResult& r, const ExactPolytope& a, const ExactPolytope& b) {
  // Some twenty roundings of lengths of about one, as the bounds say.
  constexpr long double tolerance = 1e-14L;
  const long double depth = exact_signed_depth(a, b);
  EXPECT_NEAR(static_cast<double>(r.distance - depth), 0, 2e-15);
  EXPECT_LE(r.lower, depth);
  EXPECT_GE(r.upper, depth);
  EXPECT_LT(r.upper - r.lower, 3 * tolerance);
  EXPECT_NEAR(static_cast<double>(exact_separation(a, b, r.n_W.cast<long double>()) - depth), 0, 4e-15);
  EXPECT_LT((r.p_WB - r.p_WA - r.distance * r.n_W).norm(), 1e-15);
  EXPECT_LT(std::abs(a.height_of(r.p_WA)), tolerance);
  EXPECT_LT(std::abs(b.height_of(r.p_WB)), tolerance);
}

TEST(PolytopePenetration, IsTheExactDepthOfTheReferenceCases) {
  std::ifstream file(RIGOR_TEST_DATA "/distance.json");
  int count = 0;
  const json cases = json::parse(file).at("cases");
  for (const json& c : cases) {
    const double value = c.at("value").get<double>();
    if (value >= 0) continue;
    SCOPED_TRACE(c.at("name"));
    const DistanceResult r = cold_distance(hull_in(c.at("a")), {}, hull_in(c.at("b")), {});
    EXPECT_NEAR(r.distance, value, 1e-15);
    EXPECT_LE(r.lower, value);
    EXPECT_GE(r.upper, value);
    EXPECT_LT((r.n_W - vector_of(c.at("normal"))).norm(), 1e-14);
    ++count;
  }
  EXPECT_EQ(count, 10);
}

TEST(PolytopePenetration, IsTheBestOfAllFaceNormalsAndEdgePairsInAnyPosition) {
  Draw draw(1);
  int count = 0;
  for (int i = 0; i < 1200; ++i) {
    Shape a = polytope_of(i, draw);
    Shape b = polytope_of(i / 8, draw);
    const int kind = i % 7;
    if (kind == 2 || kind == 3) b = a;
    const auto [X_WA, X_WB] = special_poses(kind, draw);
    const DistanceResult r = cold_distance(a, X_WA, b, X_WB);
    if (r.distance > 0) continue;
    SCOPED_TRACE(i);
    expect_exact(r, {a, X_WA}, {b, X_WB});
    // GJK hands overlapping polytopes to the same code.
    EXPECT_NEAR(signed_distance(a, X_WA, b, X_WB).distance, r.distance, 2e-15);
    ++count;
  }
  EXPECT_GT(count, 700);
}

TEST(PolytopePenetration, OfManyVerticesIsTheBestOfAllFaceNormalsAndEdgePairs) {
  Draw draw(2);
  for (const double reach : {0.0, 0.2, 0.4}) {
    const Shape a = draw.hull(128), b = draw.hull(128);
    const Pose X_WA = draw.pose(0.1);
    const Pose X_WB{draw.rotation(), X_WA.p + reach * draw.direction()};
    const DistanceResult r = cold_distance(a, X_WA, b, X_WB);
    ASSERT_LT(r.distance, 0);
    expect_exact(r, {a, X_WA}, {b, X_WB});
  }
}

TEST(PolytopePenetration, DoesNotDependOnTheCache) {
  Draw draw(3);
  for (int i = 0; i < 100; ++i) {
    const Shape a = polytope_of(i, draw), b = polytope_of(i / 8, draw);
    const Pose X_WA = draw.pose(0.1);
    DistanceCache cache;
    for (int k = 0; k < 10; ++k) {
      // Every pose is a jump: features and proof of the last one are wrong here.
      const Pose X_WB = draw.pose(0.5);
      const DistanceResult cold = cold_distance(a, X_WA, b, X_WB);
      const DistanceResult warm = walked_distance(a, X_WA, b, X_WB, cache);
      EXPECT_NEAR(warm.distance, cold.distance, 4e-15);
      EXPECT_LE(warm.lower, cold.distance);
      EXPECT_GE(warm.upper, cold.distance);
    }
  }
}

TEST(PolytopePenetration, GoesOnFromTheLastProofWhereTheMotionIsSmall) {
  Draw draw(4);
  int steps = 0;
  for (int i = 0; i < 10; ++i) {
    const Shape a = draw.hull(32), b = draw.hull(32);
    const Vec3 axis = draw.direction(), step = 0.003 * draw.direction();
    Pose X_WB = draw.pose(0.15);
    DistanceCache cache;
    for (int k = 0; k < 20; ++k) {
      X_WB = {rotation_matrix(rotation_exp(0.01 * axis)) * X_WB.R, X_WB.p + step};
      const DistanceResult r = walked_distance(a, {}, b, X_WB, cache);
      expect_exact(r, {a, {}}, {b, X_WB});
      if (k > 0) steps += cache.steps;
    }
    EXPECT_EQ(cache.fallbacks, 0);
  }
  // Mostly the face of before or a neighbour; a cold climb from the bodies' centres visits about ten.
  EXPECT_LT(steps, 10 * 19 * 3);
}

TEST(PolytopePenetration, FacesThatTouchKeepTheirNormalThroughContact) {
  // Cubes of side 2, one turned about z by an angle that leaves the faces parallel.
  for (const Shape& shape : {Shape(Box{Vec3::Ones()}), cube_hull(Vec3::Ones())}) {
    for (const double angle : {0.0, 0.3}) {
      const Mat3 R = rotation_matrix(rotation_exp(Vec3(0, 0, angle)));
      for (int k = -100; k <= 100; ++k) {
        const double gap = k * 1e-16 * std::pow(10, std::abs(k) % 10);
        const Pose X_WB{R, Vec3(0.3, 0.2, 2 + gap)};
        const DistanceResult r = cold_distance(shape, {}, shape, X_WB);
        EXPECT_NEAR(r.distance, X_WB.p.z() - 2, 1e-15);
        EXPECT_LT((r.n_W - Vec3::UnitZ()).norm(), 1e-15) << gap;
      }
    }
  }
}

TEST(PolytopePenetration, AlignedBoxesPartAlongAnAxis) {
  // Cubes of side 2, apart by less along z; side 1 against 0.4, off along all axes.
  for (const bool is_box : {true, false}) {
    const auto cube = [&](double half) {
      return is_box ? Shape(Box{Vec3::Constant(half)}) : cube_hull(Vec3::Constant(half));
    };
    const DistanceResult z = cold_distance(cube(1), {}, cube(1), {.p = Vec3(0, 0, 1.9)});
    EXPECT_NEAR(z.distance, -0.1, 1e-15);
    EXPECT_LT((z.n_W - Vec3::UnitZ()).norm(), 1e-15);
    const DistanceResult corner = cold_distance(cube(0.5), {}, cube(0.2), {.p = Vec3::Constant(0.4)});
    EXPECT_NEAR(corner.distance, -0.3, 1e-15);
    EXPECT_NEAR(corner.n_W.maxCoeff(), 1, 1e-15);
    EXPECT_NEAR(cold_distance(cube(0.5), {}, cube(0.5), {}).distance, -1, 1e-15);
  }
}

TEST(FindBoxAxis, IsTheBestOfAllFifteen) {
  Draw draw(5);
  for (int i = 0; i < 300; ++i) {
    const Box a{draw.sizes()}, b{draw.sizes()};
    const Pose X_AB = draw.pose(0.3);
    const Polytope polytope_a(a), polytope_b(b);
    const BoxAxis axis = find_box_axis({polytope_a, polytope_b, X_AB}, 1e-15);
    const ExactPolytope exact_a(a, {}), exact_b(b, X_AB);
    const long double depth = exact_signed_depth(exact_a, exact_b);
    if (depth > 0) continue;
    EXPECT_NEAR(static_cast<double>(axis.separation - depth), 0, 1e-15);
  }
}

/// Direction of a face of the difference, in the frame of A.
Vec3 normal_of(const PolytopePair& pair, const FeaturePair& face) {
  const FeatureGraph &a = pair.graph(0), &b = pair.graph(1);
  if (face.a.kind == PolytopeFeature::Kind::face) return a.normal(face.a.index);
  if (face.b.kind == PolytopeFeature::Kind::face) return -(pair.X_AB().R * b.normal(face.b.index));
  const FeatureGraph::HalfEdge& edge = a.half_edge(face.a.index);
  const Vec3 n = edge.direction.cross(pair.X_AB().R * b.half_edge(face.b.index).direction).normalized();
  return n.dot(a.normal(edge.face) + a.normal(a.half_edge(edge.twin).face)) >= 0 ? n : Vec3(-n);
}

TEST(ClimbGaussMap, EndsAtALocalMaximumFromAnywhere) {
  Draw draw(6);
  for (int i = 0; i < 100; ++i) {
    const ConvexHull a = *std::get<Convex>(draw.hull(20)).hull, b = *std::get<Convex>(draw.hull(20)).hull;
    const Polytope polytope_a(a), polytope_b(b);
    const PolytopePair pair(polytope_a, polytope_b, draw.pose(0.1));
    const auto separation = [&](const Vec3& d) {
      const Vec3 d_B = pair.X_AB().R.transpose() * -d;
      return d.dot(pair.vertex(1, polytope_b.farthest(d_B, 0)) -
                   polytope_a.vertex(polytope_a.farthest(d, 0)));
    };
    const Vec3 n = draw.direction();
    const FeaturePair start = face_uphill(pair, n, {0, 0});
    EXPECT_GE(separation(normal_of(pair, start)), separation(n) - 1e-15);
    const GaussPoint top = climb_gauss_map(pair, start, 1e-15);
    ASSERT_TRUE(top.is_maximum);
    EXPECT_GE(top.separation, separation(n) - 1e-15);
    EXPECT_NEAR(top.separation, separation(top.n), 1e-15);
    EXPECT_LT((top.b - top.a - top.separation * top.n).norm(), 1e-15);
    for (int k = 0; k < 50; ++k) {
      EXPECT_LE(separation((top.n + 1e-4 * draw.direction()).normalized()), top.separation + 1e-15);
    }
  }
}

TEST(InnerPolytope, IsNoProofWhereAFacetHasTheOriginOutside) {
  const ConvexHull cube = make_box_hull(Vec3::Ones());
  const Polytope a(cube), b(cube);
  const PolytopePair deep(a, b, {.p = Vec3(0.1, 0.2, 0.3)});
  CachedProof proof;
  const FeaturePair start = face_uphill(deep, Vec3::UnitZ(), {0, 0});
  // A hull whose faces are a box's, but that is not known to be a box: its depth is proved.
  ASSERT_TRUE(find_polytope_penetration(deep, start, 1e-15, proof).has_value());
  ASSERT_GE(proof.point_count, 4);
  EXPECT_EQ(proof.facet_count, 2 * proof.point_count - 4);  // Euler
  EXPECT_TRUE(InnerPolytope(deep, 1e-15).begin(proof));
  const PolytopePair apart(a, b, {.p = Vec3(2.1, 0.2, 0.3)});
  EXPECT_FALSE(InnerPolytope(apart, 1e-15).begin(proof));
}

TEST(PolytopePenetration, OfPosesThatAreNoNumbersEndsWithoutAProof) {
  Draw draw(7);
  const ConvexHull hull = *std::get<Convex>(draw.hull(20)).hull;
  const Polytope a(hull), b(Box{draw.sizes()});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const PolytopePair sound(a, b, {}), broken(a, b, {.p = Vec3(nan, 0, 0)});
  CachedProof proof;
  const FeaturePair start = face_uphill(sound, Vec3::UnitX(), {0, 0});
  ASSERT_TRUE(find_polytope_penetration(sound, start, 1e-15, proof).has_value());
  EXPECT_FALSE(find_polytope_penetration(broken, start, 1e-15, proof).has_value());
  EXPECT_EQ(proof.point_count, 0);
}

}  // namespace
}  // namespace rigor::polytope_penetration_test
