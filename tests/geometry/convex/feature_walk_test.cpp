#include "rigor/geometry/convex/feature_walk.hpp"
#include "rigor/geometry/distance/distance.hpp"

#include "geometry/exact_polytopes.hpp"
#include "geometry/random_pairs.hpp"

#include "rigor/geometry/distance/distance_cache.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>

namespace rigor::feature_walk_test {
namespace {

using nlohmann::json;
using test::Draw;
using test::ExactPolytope;
using test::hull_of;
using Kind = PolytopeFeature::Kind;

Vec3 vector_of(const json& v) {
  return {v[0].get<double>(), v[1].get<double>(), v[2].get<double>()};
}

Shape hull_in(const json& vertices) {
  std::vector<Vec3> points;
  for (const json& v : vertices) points.push_back(vector_of(v));
  return hull_of(points);
}

/// PolytopeFeature number i of all of a polytope's.
PolytopeFeature feature_of(const FeatureGraph& graph, int i) {
  const int vertices = graph.vertex_count(), edges = static_cast<int>(graph.half_edges.size());
  i %= vertices + edges + graph.face_count();
  if (i < vertices) return {Kind::vertex, i};
  if (i < vertices + edges) return {Kind::edge, i - vertices};
  return {Kind::face, i - vertices - edges};
}

const FeatureGraph& graph_of(const Shape& hull) {
  return std::get<Convex>(hull).hull->features;
}

/// The bounds hold, and the points that prove them are on the bodies.
void expect_proved(const DistanceResult& r, const ExactPolytope& a, const ExactPolytope& b) {
  EXPECT_LE(r.lower, r.distance);
  EXPECT_LE(r.distance, r.upper);
  EXPECT_LT(r.upper - r.lower, 1e-13);
  EXPECT_LE(r.lower, exact_separation(a, b, r.n_W.cast<long double>()));
  EXPECT_NEAR(static_cast<double>(exact_separation(a, b, r.n_W.cast<long double>())), r.distance, 4e-15);
  EXPECT_LT((r.p_WB - r.p_WA - r.distance * r.n_W).norm(), 1e-15);
  EXPECT_LT(std::abs(a.height_of(r.p_WA)), 1e-14L);
  EXPECT_LT(std::abs(b.height_of(r.p_WB)), 1e-14L);
}

TEST(FeatureGraph, HalfEdgesSpokesAndLoopsClose) {
  Draw draw(1);
  const Shape hull = draw.hull(40);
  const FeatureGraph& graph = graph_of(hull);
  for (int h = 0; h < static_cast<int>(graph.half_edges.size()); ++h) {
    const FeatureGraph::HalfEdge& edge = graph.half_edge(h);
    const FeatureGraph::HalfEdge& twin = graph.half_edge(edge.twin);
    EXPECT_EQ(twin.twin, h);
    EXPECT_EQ(edge.from, twin.to);
    EXPECT_EQ(edge.direction, -twin.direction);
    EXPECT_GE(h, graph.first_of_face(edge.face));
    EXPECT_LT(h, graph.first_of_face(edge.face + 1));
    // Into the face, and below the plane of the other: the edge is convex.
    EXPECT_LT(graph.normal(twin.face).dot(edge.side), 0);
  }
  for (int v = 0; v < graph.vertex_count(); ++v) {
    for (int k = graph.first_of_vertex(v); k < graph.first_of_vertex(v + 1); ++k) {
      const int next = k + 1 < graph.first_of_vertex(v + 1) ? k + 1 : graph.first_of_vertex(v);
      const FeatureGraph::HalfEdge& edge =
          graph.half_edge(graph.outgoing[static_cast<std::size_t>(k)].half_edge);
      const FeatureGraph::HalfEdge& after =
          graph.half_edge(graph.outgoing[static_cast<std::size_t>(next)].half_edge);
      EXPECT_EQ(edge.from, v);
      EXPECT_EQ(graph.half_edge(after.twin).face, edge.face);  // Neighbours around v share a face.
    }
  }
}

TEST(FeatureWalk, IsTheExactDistanceOfTheReferenceCases) {
  std::ifstream file(RIGOR_TEST_DATA "/distance.json");
  int count = 0;
  const json cases = json::parse(file).at("cases");
  for (const json& c : cases) {
    const double value = c.at("value").get<double>();
    if (value < 0) continue;
    SCOPED_TRACE(c.at("name"));
    DistanceCache cache;
    const DistanceResult r = walked_distance(hull_in(c.at("a")), {}, hull_in(c.at("b")), {}, cache);
    // Coordinates are near one but for the large plate's, 4096 from the pebble.
    const double size = c.at("name") == "SPEC_large_vs_small" ? 4096 : 1;
    EXPECT_NEAR(r.distance, value, 1e-15 * size);
    EXPECT_LE(r.lower, value);
    EXPECT_GE(r.upper, value);
    EXPECT_LT(r.upper - r.lower, 1e-13 * size);
    if (c.contains("p_WA")) {
      EXPECT_LT((r.p_WA - vector_of(c.at("p_WA"))).norm(), 1e-13);
      EXPECT_LT((r.p_WB - vector_of(c.at("p_WB"))).norm(), 1e-13);
    }
    ++count;
  }
  EXPECT_EQ(count, 26);
}

TEST(FeatureWalk, EndsAtTheKindsOfFeaturesThatFaceEachOther) {
  // Unit cubes: corner to corner, corner to edge, corner to face, edge to edge.
  const Mat3 on_corner = rotation_matrix(rotation_exp(Vec3(std::atan(std::sqrt(2.0)), 0, 0))) *
                         rotation_matrix(rotation_exp(Vec3(0, 0, std::atan(1.0))));
  const Mat3 on_edge = rotation_matrix(rotation_exp(Vec3(std::atan(1.0), 0, 0)));
  const Mat3 across = rotation_matrix(rotation_exp(Vec3(0, 0, 2 * std::atan(1.0))));
  const auto kinds = [](const Pose& X_WA, const Pose& X_WB) {
    const Polytope a(Box{Vec3::Constant(0.5)}), b(Box{Vec3::Constant(0.5)});
    const Pose X_AW = X_WA.inverse();
    const PolytopePair pair(a, b, X_AW * X_WB);
    const FeatureWalk walk = walk_features(pair, facing_vertices(pair), 1e-15);
    EXPECT_EQ(walk.outcome, FeatureWalk::Outcome::apart);
    return std::pair{walk.nearest.a.kind, walk.nearest.b.kind};
  };
  const Vec3 up(0, 0, 3);
  EXPECT_EQ(kinds({on_corner, Vec3::Zero()}, {on_corner, up}), (std::pair{Kind::vertex, Kind::vertex}));
  EXPECT_EQ(kinds({on_corner, Vec3::Zero()}, {on_edge, up}), (std::pair{Kind::vertex, Kind::edge}));
  EXPECT_EQ(kinds({on_corner, Vec3::Zero()}, {Mat3::Identity(), up}), (std::pair{Kind::vertex, Kind::face}));
  EXPECT_EQ(kinds({Mat3::Identity(), Vec3::Zero()}, {on_corner, up}), (std::pair{Kind::face, Kind::vertex}));
  EXPECT_EQ(kinds({on_edge, Vec3::Zero()}, {across * on_edge, up}), (std::pair{Kind::edge, Kind::edge}));
}

TEST(FeatureWalk, FindsTheSameDistanceFromAnyPairOfFeatures) {
  Draw draw(2);
  for (int i = 0; i < 200; ++i) {
    const Shape a = draw.hull(8 + i % 40), b = draw.hull(8 + i % 17);
    const Pose X_WA = draw.pose(0.2);
    const Pose X_WB{draw.rotation(), X_WA.p + draw.uniform(0.8, 2) * draw.direction()};
    const DistanceResult gjk = signed_distance(a, X_WA, b, X_WB);
    if (gjk.distance <= 0) continue;
    for (int k = 0; k < 20; ++k) {
      DistanceCache cache;
      cache.is_known = true;
      cache.features.a = feature_of(graph_of(a), static_cast<int>(draw.uniform(0, 1e6)));
      cache.features.b = feature_of(graph_of(b), static_cast<int>(draw.uniform(0, 1e6)));
      const DistanceResult r = walked_distance(a, X_WA, b, X_WB, cache);
      EXPECT_NEAR(r.distance, gjk.distance, 4e-15);
      EXPECT_EQ(cache.fallbacks, 0);
      if (k == 0) expect_proved(r, {a, X_WA}, {b, X_WB});
    }
  }
}

TEST(FeatureWalk, OfTouchingAndOverlappingBodiesEndsFromAnyPairOfFeatures) {
  Draw draw(3);
  for (int i = 0; i < 2000; ++i) {
    const Shape a = draw.hull(8 + i % 25), b = i % 5 ? draw.hull(8 + i % 17) : a;
    const Polytope polytope_a(*std::get<Convex>(a).hull), polytope_b(*std::get<Convex>(b).hull);
    // Far inside, at the surface, and in place.
    const Pose X_AB = i % 5 == 0 ? Pose{} : draw.pose(i % 2 ? 0.1 : 0.6);
    const PolytopePair pair(polytope_a, polytope_b, X_AB);
    const FeaturePair start{feature_of(graph_of(a), static_cast<int>(draw.uniform(0, 1e6))),
                            feature_of(graph_of(b), static_cast<int>(draw.uniform(0, 1e6)))};
    const FeatureWalk walk = walk_features(pair, start, 1e-15);
    const double distance = signed_distance(a, {}, b, X_AB).distance;
    if (std::abs(distance) > 1e-14) {
      EXPECT_EQ(walk.outcome, distance > 0 ? FeatureWalk::Outcome::apart : FeatureWalk::Outcome::overlapping);
    }
    EXPECT_LT(walk.steps, 100);
  }
}

TEST(FeatureWalk, OfNeedlesIsProved) {
  Draw draw(4);
  for (int i = 0; i < 200; ++i) {
    std::vector<Vec3> points;
    for (int k = 0; k < 16; ++k) points.push_back(Vec3(1e-4, 1e-4, 1).cwiseProduct(draw.direction()));
    const Shape needle = hull_of(points), other = i % 2 ? needle : draw.hull(32);
    const Pose X_WA = draw.pose(0.3), X_WB = draw.pose(0.8);
    DistanceCache cache;
    const DistanceResult r = walked_distance(needle, X_WA, other, X_WB, cache);
    EXPECT_NEAR(r.distance, signed_distance(needle, X_WA, other, X_WB).distance, 4e-15);
    if (r.distance > 0) expect_proved(r, {needle, X_WA}, {other, X_WB});
  }
}

TEST(FeatureWalk, ParallelFacesAndEdgesHaveTheirDistance) {
  // Boxes over each other, turned about the vertical: all pairs of the lower face are as near.
  Draw draw(5);
  for (int i = 0; i < 100; ++i) {
    const Box a{draw.sizes()}, b{draw.sizes()};
    const Mat3 R = rotation_matrix(rotation_exp(Vec3(0, 0, i % 2 ? draw.uniform(0, 6) : 0.0)));
    const double gap = i % 3 ? draw.uniform(0.01, 1) : 1e-9;
    const double z = a.half_extents.z() + b.half_extents.z() + gap;
    const Pose X_WB{R, Vec3(0.1 * draw.uniform(-1, 1), 0.1 * draw.uniform(-1, 1), z)};
    DistanceCache cache;
    const DistanceResult r = walked_distance(a, {}, b, X_WB, cache);
    EXPECT_NEAR(r.distance, gap, 1e-15);
    EXPECT_LT((r.n_W - Vec3::UnitZ()).norm(), 1e-15);
    EXPECT_EQ(cache.fallbacks, 0);
  }
}

TEST(WalkedDistance, FollowsAMotionThroughAnOverlapAndBack) {
  Draw draw(6);
  int overlaps = 0;
  for (int i = 0; i < 30; ++i) {
    const Shape a = i % 3 ? draw.hull(32) : Shape(Box{draw.sizes()});
    const Shape b = draw.hull(20);
    const Vec3 axis = draw.direction(), direction = draw.direction();
    const Vec3 past = 0.1 * draw.direction();
    DistanceCache cache;
    double before = 0;
    for (int k = 0; k <= 200; ++k) {
      const Pose X_WB{rotation_matrix(rotation_exp(0.01 * k * axis)), (0.016 * k - 1.6) * direction + past};
      const DistanceResult r = walked_distance(a, {}, b, X_WB, cache);
      DistanceCache fresh;
      EXPECT_NEAR(r.distance, walked_distance(a, {}, b, X_WB, fresh).distance, 4e-15);
      EXPECT_NEAR(r.distance, signed_distance(a, {}, b, X_WB).distance, 4e-15);
      // No point of b moves by more.
      EXPECT_LE(std::abs(r.distance - before), k > 0 ? 0.016 + 0.01 * 0.7 : 10);
      before = r.distance;
      overlaps += r.distance < 0;
    }
    EXPECT_EQ(cache.fallbacks, 0);
  }
  EXPECT_GT(overlaps, 1000);
}

TEST(WalkedDistance, VisitsFewFeaturesHoweverManyThereAre) {
  Draw draw(7);
  for (const int vertices : {8, 32, 128, 512}) {
    const Shape a = draw.hull(vertices), b = draw.hull(vertices);
    const Vec3 axis = draw.direction();
    DistanceCache cache;
    int steps = 0;
    for (int k = 0; k < 100; ++k) {
      const Pose X_WB{rotation_matrix(rotation_exp(0.01 * k * axis)), Vec3(1.5, 0.003 * k, 0)};
      walked_distance(a, {}, b, X_WB, cache);
      if (k > 0) steps += cache.steps;
    }
    EXPECT_LT(steps, 100) << vertices;  // Less than one a query of 0.6 degrees and 3 mm.
  }
}

TEST(WalkedDistance, OfOtherShapesIsThatOfGjk) {
  Draw draw(8);
  for (int kind = 0; kind < 6; ++kind) {
    const Shape a = draw.shape(kind), b = draw.hull(8);
    const Pose X_WA = draw.pose(0.5), X_WB = draw.pose(1.5);
    DistanceCache cache;
    if (kind == 1) continue;  // a box
    EXPECT_EQ(walked_distance(a, X_WA, b, X_WB, cache).distance, signed_distance(a, X_WA, b, X_WB).distance);
  }
}

TEST(WalkedDistance, OfATinyGapFarFromTheOriginIsRight) {
  // 1 mm between faces at 10⁶ m from the origin: the poses are exact.
  const Box cube{Vec3::Constant(0.5)};
  const Pose X_WA{.p = Vec3(1e6, 1e6, 1e6)};
  const Pose X_WB{.p = X_WA.p + Vec3(0, 0, 1 + 0x1p-10)};
  DistanceCache cache;
  EXPECT_EQ(walked_distance(cube, X_WA, cube, X_WB, cache).distance, 0x1p-10);
}

TEST(FeatureWalk, OfPosesThatAreNoNumbersIsUndecided) {
  Draw draw(9);
  const ConvexHull hull = *std::get<Convex>(draw.hull(20)).hull;
  const Polytope a(hull), b(Box{draw.sizes()});
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    for (const PolytopePair& pair :
         {PolytopePair(a, b, {.p = Vec3(bad, 0, 0)}), PolytopePair(a, a, {.p = Vec3(0, bad, 0)}),
          PolytopePair(b, b, {.p = Vec3(0, 0, bad)})}) {
      EXPECT_EQ(walk_features(pair, facing_vertices(pair), 1e-15).outcome, FeatureWalk::Outcome::undecided);
    }
  }
}

}  // namespace
}  // namespace rigor::feature_walk_test
