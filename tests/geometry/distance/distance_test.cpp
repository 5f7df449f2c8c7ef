#include "rigor/geometry/distance/distance.hpp"

#include "geometry/random_pairs.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>

namespace rigor::distance_test {
namespace {

using nlohmann::json;
using test::Draw;
using test::hull_of;
using test::separation_along;
Pose moved(double x, double y, double z) {
  return {.p = Vec3(x, y, z)};
}

Vec3 vector_of(const json& v) {
  return {v[0].get<double>(), v[1].get<double>(), v[2].get<double>()};
}

Shape hull_in(const json& vertices) {
  std::vector<Vec3> points;
  for (const json& v : vertices) points.push_back(vector_of(v));
  return hull_of(points);
}

json reference_cases() {
  std::ifstream file(RIGOR_TEST_DATA "/distance.json");
  return json::parse(file).at("cases");
}

/// Largest coordinate of a case: what its size is.
double size_of(const json& c) {
  double size = 0;
  for (const char* side : {"a", "b"}) {
    for (const json& v : c.at(side)) size = std::max(size, vector_of(v).cwiseAbs().maxCoeff());
  }
  return size;
}

TEST(Distance, OfPolyhedraIsTheExactOne) {
  int count = 0;
  for (const json& c : reference_cases()) {
    SCOPED_TRACE(c.at("name"));
    const double value = c.at("value").get<double>();
    // The large plate's vertices are 4096 from the pebble; its distance is exact all the same.
    const double tolerance = 1e-15 * std::max(1.0, std::min(size_of(c), 4.0));
    const DistanceResult r = signed_distance(hull_in(c.at("a")), {}, hull_in(c.at("b")), {});
    EXPECT_NEAR(r.distance, value, tolerance);
    EXPECT_LE(r.lower, value);
    EXPECT_GE(r.upper, value);
    EXPECT_LT(r.upper - r.lower, 1e-13 * size_of(c));
    if (c.contains("normal")) {
      // Normals are cross products of edges no shorter than a tenth.
      EXPECT_LT((r.n_W - vector_of(c.at("normal"))).norm(), 1e-14);
    }
    if (c.contains("p_WA")) {
      EXPECT_LT((r.p_WA - vector_of(c.at("p_WA"))).norm(), 1e-13);
      EXPECT_LT((r.p_WB - vector_of(c.at("p_WB"))).norm(), 1e-13);
    }
    ++count;
  }
  EXPECT_EQ(count, 36);
}

TEST(Distance, OfPolyhedraAnywhereIsTheExactOneToTheRoundingOfThePose) {
  Draw draw(1);
  for (const json& c : reference_cases()) {
    SCOPED_TRACE(c.at("name"));
    const Shape a = hull_in(c.at("a"));
    const Shape b = hull_in(c.at("b"));
    for (int i = 0; i < 10; ++i) {
      const Pose X = draw.pose(2);
      const DistanceResult r = signed_distance(a, X, b, X);
      EXPECT_NEAR(r.distance, c.at("value").get<double>(), 4e-15 * size_of(c));
    }
  }
}

TEST(Distance, IsTheSameBothWaysBitForBit) {
  Draw draw(2);
  for (int i = 0; i < 81 * 4; ++i) {
    const Shape a = draw.shape(i % Draw::kKinds);
    const Shape b = draw.shape(i / Draw::kKinds % Draw::kKinds);
    const Pose X_WA = draw.pose(0.7);
    const Pose X_WB = draw.pose(0.7);
    const DistanceResult ab = signed_distance(a, X_WA, b, X_WB);
    const DistanceResult ba = signed_distance(b, X_WB, a, X_WA);
    EXPECT_EQ(ab.distance, ba.distance);
    EXPECT_EQ(ab.lower, ba.lower);
    EXPECT_EQ(ab.upper, ba.upper);
    EXPECT_EQ(ab.p_WA, ba.p_WB);
    EXPECT_EQ(ab.p_WB, ba.p_WA);
    EXPECT_EQ(ab.n_W, -ba.n_W);
  }
}

TEST(Distance, OfOneShapeTwiceIsTheSameBothWays) {
  Draw draw(3);
  for (int kind = 0; kind < Draw::kKinds; ++kind) {
    const Shape shape = draw.shape(kind);
    for (int i = 0; i < 10; ++i) {
      const Pose X_WA = draw.pose(0.7);
      const Pose X_WB{i % 2 ? X_WA.R : draw.rotation(), i % 3 ? X_WA.p : draw.pose(1).p};
      const DistanceResult ab = signed_distance(shape, X_WA, shape, X_WB);
      const DistanceResult ba = signed_distance(shape, X_WB, shape, X_WA);
      EXPECT_EQ(ab.distance, ba.distance);
    }
  }
}

TEST(Distance, ApartIsProvedByAPlaneAndByTwoPoints) {
  Draw draw(4);
  for (int i = 0; i < 81 * 4; ++i) {
    const Shape a = draw.shape(i % Draw::kKinds);
    const Shape b = draw.shape(i / Draw::kKinds % Draw::kKinds);
    SCOPED_TRACE(std::string(shape_type_name(a)) + " " + shape_type_name(b));
    const Pose X_WA = draw.pose(0.5);
    const Pose X_WB{draw.rotation(), X_WA.p + draw.uniform(1.6, 2.6) * draw.direction()};
    const DistanceResult r = signed_distance(a, X_WA, b, X_WB);
    if (r.distance <= 0) continue;
    EXPECT_LE(r.lower, r.distance);
    EXPECT_LE(r.distance, r.upper);
    EXPECT_LT(r.upper - r.lower, 3e-14);
    EXPECT_NEAR(r.n_W.norm(), 1, 1e-15);
    // The separating plane: the bodies are that far apart along n. The points are on the bodies.
    EXPECT_NEAR(separation_along(r.n_W, a, X_WA, b, X_WB), r.distance, 4e-15);
    EXPECT_LT((r.p_WB - r.p_WA - r.distance * r.n_W).norm(), 1e-15);
    EXPECT_NEAR(signed_distance(a, X_WA, Sphere{1e-3}, {.p = r.p_WA}).distance, -1e-3, 1e-14);
    EXPECT_NEAR(signed_distance(b, X_WB, Sphere{1e-3}, {.p = r.p_WB}).distance, -1e-3, 1e-14);
    for (int k = 0; k < 100; ++k) {
      EXPECT_LE(separation_along(draw.direction(), a, X_WA, b, X_WB), r.upper);
    }
  }
}

/// Moves b along a line until the pair is `gap` apart.
Pose moved_near(const Shape& a, const Pose& X_WA, const Shape& b, Pose X_WB, double gap) {
  for (int i = 0; i < 60; ++i) {
    const DistanceResult r = signed_distance(a, X_WA, b, X_WB);
    X_WB.p -= (r.distance - gap) * r.n_W;
    if (std::abs(r.distance - gap) < 1e-3 * gap) break;
  }
  return X_WB;
}

TEST(Distance, NearTouchingTheNormalStillProvesTheDistance) {
  Draw draw(5);
  for (int i = 0; i < 81 * 2; ++i) {
    const Shape a = draw.shape(i % Draw::kKinds);
    const Shape b = draw.shape(i / Draw::kKinds % Draw::kKinds);
    SCOPED_TRACE(std::string(shape_type_name(a)) + " " + shape_type_name(b));
    const Pose X_WA = draw.pose(0.5);
    Pose X_WB{draw.rotation(), X_WA.p + 2 * draw.direction()};
    for (const double gap : {1e-6, 1e-8, 1e-10, 1e-12}) {
      X_WB = moved_near(a, X_WA, b, X_WB, gap);
      const DistanceResult r = signed_distance(a, X_WA, b, X_WB);
      // A rim a hair from a corner: the witnesses come from a simplex of points that are nearly one (bar:
      // 1e-12).
      const bool is_curved = std::holds_alternative<Cylinder>(a) || std::holds_alternative<Cone>(a) ||
                             std::holds_alternative<Cylinder>(b) || std::holds_alternative<Cone>(b);
      EXPECT_NEAR(r.distance, gap, 1e-3 * gap + (is_curved ? 2e-13 : 2e-15));
      EXPECT_NEAR(separation_along(r.n_W, a, X_WA, b, X_WB), r.distance, 2e-15);
      EXPECT_LT(r.upper - r.lower, 5e-14);
    }
  }
}

TEST(Distance, OfABoxLyingOnABoxIsZeroWithTheFaceNormal) {
  const Box box{Vec3::Constant(0.5)};
  Draw draw(6);
  for (int i = 0; i < 300; ++i) {
    // Face on face at any offset and angle about the normal, also edge over edge and corner over corner.
    const double gap = i % 3 == 0 ? 0 : std::pow(10, draw.uniform(-17, -8)) * (i % 3 == 1 ? 1 : -1);
    const bool is_aligned = i % 4 == 0;
    const Mat3 turn =
        is_aligned ? Mat3(Mat3::Identity()) : rotation_matrix(rotation_exp(Vec3(0, 0, draw.uniform(0, 6))));
    const double offset = is_aligned ? 0 : draw.uniform(-0.5, 0.5);
    const DistanceResult r = signed_distance(box, {}, box, {turn, Vec3(offset, -offset, 1 + gap)});
    EXPECT_NEAR(r.distance, (1 + gap) - 1, 1.2e-16);
    EXPECT_LT((r.n_W - Vec3::UnitZ()).norm(), 1e-15);
    EXPECT_NEAR(r.p_WA.z(), 0.5, 1e-15);
  }
}

TEST(Distance, OfATurnedBoxLyingOnATurnedBoxIsZeroWithTheFaceNormal) {
  const Box box{Vec3::Constant(0.5)};
  Draw draw(7);
  for (int i = 0; i < 300; ++i) {
    const Mat3 R = draw.rotation();
    const Vec3 p = draw.pose(2).p;
    const Pose X_WB{R, p + R * Vec3(draw.uniform(-0.9, 0.9), draw.uniform(-0.9, 0.9), 1)};
    const DistanceResult r = signed_distance(box, {R, p}, box, X_WB);
    // The position of B is rounded by half an ulp of 4 to 8 m an axis.
    EXPECT_LE(std::abs(r.distance), 2e-15);
    EXPECT_LT((r.n_W - R.col(2)).norm(), 1e-15);
  }
}

TEST(Distance, OfRoundBodiesOnABoxHasTheFaceNormal) {
  const Box box{Vec3::Constant(0.5)};
  const Mat3 lying = rotation_matrix(rotation_exp(Vec3(std::numbers::pi / 2, 0, 0)));
  const Mat3 upside_down = rotation_matrix(rotation_exp(Vec3(std::numbers::pi, 0, 0)));
  for (const double gap : {-1e-3, -1e-9, -1e-13, 0.0, 1e-16, 1e-14, 1e-12, 1e-10, 1e-8, 1e-6, 1e-3}) {
    SCOPED_TRACE(gap);
    const auto expect_on_top = [&](const Shape& shape, const Mat3& R, double height) {
      const DistanceResult r = signed_distance(box, {}, shape, {R, Vec3(0.1, 0.05, 0.5 + height + gap)});
      EXPECT_NEAR(r.distance, gap, 3e-16) << shape_type_name(shape);
      EXPECT_LT((r.n_W - Vec3::UnitZ()).norm(), 1e-15) << shape_type_name(shape);
    };
    expect_on_top(Sphere{0.25}, Mat3::Identity(), 0.25);
    expect_on_top(Capsule{0.25, 0.5}, Mat3::Identity(), 0.75);
    expect_on_top(Capsule{0.25, 0.2}, lying, 0.25);
    expect_on_top(Cylinder{0.25, 0.5}, Mat3::Identity(), 0.5);
    expect_on_top(Cylinder{0.25, 0.2}, lying, 0.25);
    expect_on_top(Cone{0.25, 0.5}, Mat3::Identity(), 0.5);
    expect_on_top(Cone{0.25, 0.5}, upside_down, 0.5);
    expect_on_top(Ellipsoid{Vec3(0.3, 0.4, 0.5)}, Mat3::Identity(), 0.5);
  }
}

TEST(Distance, OfParallelAndCrossedCylinders) {
  const Cylinder cylinder{0.25, 0.5};
  const Mat3 lying = rotation_matrix(rotation_exp(Vec3(0, std::numbers::pi / 2, 0)));
  for (const double gap : {-1e-3, -1e-10, 0.0, 1e-14, 1e-12, 1e-8, 1e-4, 1.0}) {
    const DistanceResult parallel = signed_distance(cylinder, {}, cylinder, moved(0.5 + gap, 0, 0.3));
    EXPECT_NEAR(parallel.distance, gap, 3e-16);
    EXPECT_LT((parallel.n_W - Vec3::UnitX()).norm(), 1e-15);
    const DistanceResult crossed =
        signed_distance(cylinder, {}, cylinder, {lying, Vec3(0.05, 0.5 + gap, 0.1)});
    EXPECT_NEAR(crossed.distance, gap, 3e-16);
    EXPECT_LT((crossed.n_W - Vec3::UnitY()).norm(), 1e-15);
  }
}

TEST(Distance, OfSpheresCapsulesAndBoxesIsTheirFormula) {
  Draw draw(8);
  for (int i = 0; i < 300; ++i) {
    const Pose X_WA = draw.pose(1);
    const Pose X_WB = draw.pose(1);
    const Vec3 p_AB = X_WA.R.transpose() * (X_WB.p - X_WA.p);
    const double r = draw.size();
    const double l = draw.size();
    const Vec3 h = draw.sizes();
    const Sphere sphere{draw.size()};
    const double tolerance = 4e-15;  // Positions up to 3.5 apart.
    EXPECT_NEAR(signed_distance(Sphere{r}, X_WA, sphere, X_WB).distance, p_AB.norm() - r - sphere.radius,
                tolerance);
    const Vec3 from_segment(p_AB.x(), p_AB.y(), p_AB.z() - std::clamp(p_AB.z(), -l, l));
    EXPECT_NEAR(signed_distance(Capsule{r, l}, X_WA, sphere, X_WB).distance,
                from_segment.norm() - r - sphere.radius, tolerance);
    const Vec3 over = p_AB.cwiseAbs() - h;
    const double to_box = over.maxCoeff() > 0 ? over.cwiseMax(0).norm() : over.maxCoeff();
    EXPECT_NEAR(signed_distance(Box{h}, X_WA, sphere, X_WB).distance, to_box - sphere.radius, tolerance);
  }
}

TEST(Distance, FromAPlaneIsThatOfTheLowestPoint) {
  Draw draw(9);
  for (int i = 0; i < 9 * 10; ++i) {
    const Shape shape = draw.shape(i % Draw::kKinds);
    const HalfSpace plane{draw.direction(), draw.uniform(-1, 1)};
    const Pose X_WA = draw.pose(1);
    const Pose X_WB = draw.pose(1);
    const Vec3 n_W = X_WA.R * plane.normal;
    const Vec3 lowest = X_WB * support_point(shape, X_WB.R.transpose() * -n_W);
    const DistanceResult r = signed_distance(plane, X_WA, shape, X_WB);
    EXPECT_NEAR(r.distance, n_W.dot(lowest - X_WA.p) - plane.offset, 2e-15);
    EXPECT_EQ(r.n_W, n_W);
    EXPECT_LT((r.p_WB - lowest).norm(), 2e-15);
    EXPECT_LE(r.lower, r.distance);
    EXPECT_GE(r.upper, r.distance);
    EXPECT_EQ(signed_distance(shape, X_WB, plane, X_WA).distance, r.distance);
  }
}

TEST(Distance, FarFromTheOriginLosesNothingButTheRoundingOfThePositions) {
  Draw draw(10);
  const Vec3 far(1e6, -2e6, 3e6);
  for (int i = 0; i < 81 * 2; ++i) {
    const Shape a = draw.shape(i % Draw::kKinds);
    const Shape b = draw.shape(i / Draw::kKinds % Draw::kKinds);
    // Positions on a grid of 2⁻²⁰, so that adding the offset is exact.
    const auto on_grid = [](const Vec3& p) -> Vec3 {
      return (p * 0x1p20).array().round().matrix() * 0x1p-20;
    };
    Pose X_WA = draw.pose(0.7);
    Pose X_WB = draw.pose(0.7);
    X_WA.p = on_grid(X_WA.p);
    X_WB.p = on_grid(X_WB.p);
    const DistanceResult here = signed_distance(a, X_WA, b, X_WB);
    const DistanceResult there = signed_distance(a, {X_WA.R, X_WA.p + far}, b, {X_WB.R, X_WB.p + far});
    EXPECT_EQ(there.distance, here.distance);
    EXPECT_EQ(there.n_W, here.n_W);
    EXPECT_LT((there.p_WA - far - here.p_WA).norm(), 1e-9);  // Unit in the last place of 3e6: 5e-10.
  }
  // Two boxes a millimetre apart at 1e6 m (their positions are exact there).
  const Box box{Vec3::Constant(0.5)};
  EXPECT_NEAR(signed_distance(box, moved(1e6, 0, 0), box, moved(1e6 + 1 + 0x1p-10, 0, 0)).distance, 0x1p-10,
              1e-16);
}

Shape scaled_shape(const Shape& shape, double s) {
  struct Scale {
    double s;
    Shape operator()(const Sphere& x) const { return Sphere{s * x.radius}; }
    Shape operator()(const Box& x) const { return Box{s * x.half_extents}; }
    Shape operator()(const Capsule& x) const { return Capsule{s * x.radius, s * x.half_length}; }
    Shape operator()(const Cylinder& x) const { return Cylinder{s * x.radius, s * x.half_length}; }
    Shape operator()(const Cone& x) const { return Cone{s * x.radius, s * x.half_length}; }
    Shape operator()(const Ellipsoid& x) const { return Ellipsoid{s * x.radii}; }
    Shape operator()(const HalfSpace& x) const { return HalfSpace{x.normal, s * x.offset}; }
    Shape operator()(const Cavity& x) const { return Cavity{s * x.radius}; }
    Shape operator()(const Mesh& x) const { return x; }
    Shape operator()(const Revolution& x) const { return test::scaled(x, s); }
    Shape operator()(const Convex& x) const {
      ConvexHull hull = *x.hull;
      for (Vec3& v : hull.vertices) v *= s;
      hull.support_table = make_support_table(hull);
      hull.extent *= s;
      return Convex{std::make_shared<const ConvexHull>(hull)};
    }
  };
  return std::visit(Scale{s}, shape);
}

TEST(Distance, ScalesWithTheShapesBitForBit) {
  Draw draw(11);
  for (int i = 0; i < 81 * 3; ++i) {
    const Shape a = draw.shape(i % Draw::kKinds);
    const Shape b = draw.shape(i / Draw::kKinds % Draw::kKinds);
    const double reach = i % 3 == 0 ? 0.2 : 0.8;
    const Pose X_WA = draw.pose(reach);
    const Pose X_WB = draw.pose(reach);
    const DistanceResult r = signed_distance(a, X_WA, b, X_WB);
    for (const double s : {0x1p20, 0x1p-20}) {
      const DistanceResult q =
          signed_distance(scaled_shape(a, s), {X_WA.R, s * X_WA.p}, scaled_shape(b, s), {X_WB.R, s * X_WB.p});
      EXPECT_EQ(q.distance, s * r.distance);
      EXPECT_EQ(q.lower, s * r.lower);
      EXPECT_EQ(q.upper, s * r.upper);
      EXPECT_EQ(q.n_W, r.n_W);
      EXPECT_EQ(q.p_WA, s * r.p_WA);
    }
  }
}

TEST(Distance, OfAPebbleOnAMountain) {
  // Sizes 1e4 : 1. The mountain's vertices are rounded at 1e-12, the pebble's distance not much more.
  Draw draw(12);
  const Box ground{Vec3(1e4, 1e4, 1)};
  const Box pebble{Vec3::Constant(0.5)};
  for (const double gap : {-1e-2, -1e-8, 0.0, 1e-12, 1e-8, 1e-3, 1.0}) {
    for (int i = 0; i < 20; ++i) {
      const Mat3 turn = rotation_matrix(rotation_exp(Vec3(0, 0, draw.uniform(0, 6))));
      const double x = draw.uniform(-9e3, 9e3);
      const DistanceResult r =
          signed_distance(ground, moved(0, 0, -1), pebble, {turn, Vec3(x, -x, 0.5 + gap)});
      EXPECT_NEAR(r.distance, gap, 1e-15);
      EXPECT_EQ(r.n_W, Vec3(0, 0, 1));
    }
  }
  const Cylinder mill{1e4, 1e4};
  const DistanceResult r = signed_distance(mill, {}, Sphere{1}, moved(6e3 + 0.9, 8e3 + 1.2, 17));
  EXPECT_NEAR(r.distance, 0.5, 4e-12);
}

TEST(Distance, OfANeedleAspectTenThousandIsExact) {
  // A needle along x and a box under its thick end, which is 2.5e-5 wide.
  const Shape needle = hull_of({Vec3(0, 0, 0), Vec3(1, 1e-4, 0), Vec3(1, -1e-4, 0), Vec3(1, 0, 1e-4)});
  const DistanceResult r =
      signed_distance(needle, {}, Box{Vec3::Constant(0.5)}, moved(0.75, 0, -0.5 - 0x1p-13));
  EXPECT_NEAR(r.distance, 0x1p-13, 1e-16);
  EXPECT_LT((r.n_W + Vec3::UnitZ()).norm(), 1e-11);  // Rounding over the needle's thickness.
}

TEST(Distance, OfUnitBoxesThreeApartIsThree) {
  const Box box{Vec3::Constant(0.5)};
  const DistanceResult r = signed_distance(box, moved(0, 4, 0), box, {});
  EXPECT_EQ(r.distance, 3);
  EXPECT_EQ(r.n_W, Vec3(0, -1, 0));
  EXPECT_EQ(r.p_WA.y(), 3.5);
  EXPECT_EQ(r.p_WB.y(), 0.5);
}

TEST(Distance, ChangesSignContinuouslyAsBodiesMeet) {
  // A sweep through contact: the distance falls with the gap, the normal never flips.
  const Box box{Vec3(0.5, 0.4, 0.3)};
  const Mat3 R = rotation_matrix(rotation_exp(Vec3(0.3, 0.5, -0.2)));
  const Ellipsoid egg{Vec3(0.2, 0.3, 0.4)};
  for (const Shape& b : {Shape(box), Shape(egg), Shape(Cylinder{0.3, 0.4}), Shape(Cone{0.3, 0.4})}) {
    const Pose X_far{R, Vec3(0.1, -0.05, 3)};
    const double height = 3 - signed_distance(box, {}, b, X_far).distance;
    double previous = 1;
    for (int i = 50; i >= -50; --i) {
      const double gap = 1e-4 * i;
      const DistanceResult r = signed_distance(box, {}, b, {R, Vec3(0.1, -0.05, height + gap)});
      EXPECT_NEAR(r.distance, gap, 1e-15);
      EXPECT_LT(r.distance, previous);
      EXPECT_LT((r.n_W - Vec3::UnitZ()).norm(), 1e-14);
      previous = r.distance;
    }
  }
}
}  // namespace
}  // namespace rigor::distance_test
