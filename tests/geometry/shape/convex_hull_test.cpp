#include "rigor/geometry/shape/convex_hull.hpp"

#include "geometry/mesh_shapes.hpp"
#include "rigor/geometry/mass/mass_properties.hpp"
#include "rigor/math/rotation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <set>

namespace rigor::convex_hull_test {
namespace {

std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

ConvexHull hull_of(const std::vector<Vec3>& points) {
  std::variant<ConvexHull, std::string> result = make_convex_hull(points);
  if (const std::string* reason = std::get_if<std::string>(&result)) {
    ADD_FAILURE() << *reason;
    return {};
  }
  return std::get<ConvexHull>(result);
}

std::string reason_of(const std::vector<Vec3>& points) {
  const std::variant<ConvexHull, std::string> result = make_convex_hull(points);
  return std::holds_alternative<std::string>(result) ? std::get<std::string>(result) : "a hull";
}

/// The promises of the header: planar convex faces that hold all points behind them, edges and neighbours
/// that agree.
void expect_hull(const ConvexHull& hull, const std::vector<Vec3>& points, double tolerance) {
  EXPECT_EQ(hull.vertices.size() + hull.faces.size(), hull.edges.size() + 2);
  ASSERT_EQ(hull.faces.size(), hull.face_normals.size());
  std::size_t corners = 0;
  for (std::size_t f = 0; f < hull.faces.size(); ++f) {
    const Vec3& n = hull.face_normals[f];
    EXPECT_NEAR(n.norm(), 1, 1e-15);
    const Vec3& p0 = hull.vertices[index(hull.faces[f][0])];
    for (const Vec3& p : points) ASSERT_LE(n.dot(p - p0), tolerance);
    for (const int v : hull.faces[f]) ASSERT_GE(n.dot(hull.vertices[index(v)] - p0), -tolerance);
    corners += hull.faces[f].size();
  }
  EXPECT_EQ(corners, 2 * hull.edges.size());
  for (const ConvexHull::Edge& edge : hull.edges) {
    const auto runs = [&](int face, int from, int to) {
      const std::vector<int>& loop = hull.faces[index(face)];
      for (std::size_t i = 0; i < loop.size(); ++i) {
        if (loop[i] == from && loop[(i + 1) % loop.size()] == to) return true;
      }
      return false;
    };
    EXPECT_TRUE(runs(edge.f0, edge.v0, edge.v1));
    EXPECT_TRUE(runs(edge.f1, edge.v1, edge.v0));
  }
  std::size_t neighbours = 0;
  for (const std::vector<int>& list : hull.vertex_neighbours) {
    EXPECT_GE(list.size(), 3u);
    neighbours += list.size();
  }
  EXPECT_EQ(neighbours, 2 * hull.edges.size());
}

std::vector<Vec3> points_on_sphere(int count, double radius) {
  // Spiral of equal areas: heights in equal steps, turned by the golden angle.
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i) {
    const double z = 1 - (2.0 * i + 1) / count, r = std::sqrt(1 - z * z),
                 angle = std::numbers::pi * (3 - std::sqrt(5.0)) * i;
    points.push_back(radius * Vec3(r * std::cos(angle), r * std::sin(angle), z));
  }
  return points;
}

TEST(ConvexHull, OfACubeHasSixQuadsAndMatchesTheBoxHull) {
  const ConvexHull box = make_box_hull({1, 2, 3});
  expect_hull(box, box.vertices, 0);
  const ConvexHull hull = hull_of(box.vertices);
  EXPECT_EQ(hull.vertices, box.vertices);
  EXPECT_EQ(hull.faces, box.faces);
  EXPECT_EQ(hull.face_normals, box.face_normals);
  EXPECT_EQ(hull.vertex_neighbours, box.vertex_neighbours);
}

TEST(ConvexHull, OfABoxNumbersVerticesBySignBits) {
  const ConvexHull box = make_box_hull({1, 2, 3});
  EXPECT_EQ(box.vertices[0], Vec3(-1, -2, -3));
  EXPECT_EQ(box.vertices[1], Vec3(1, -2, -3));
  EXPECT_EQ(box.vertices[2], Vec3(-1, 2, -3));
  EXPECT_EQ(box.vertices[7], Vec3(1, 2, 3));
}

TEST(ConvexHull, DropsPointsInsideOnFacesOnEdgesAndDoubles) {
  // A grid of 5 x 5 x 5 points, each twice, turned so that nothing is exactly coplanar.
  const Pose X{rotation_matrix(rotation_exp({0.3, -0.7, 1.9})), {100, -200, 50}};
  std::vector<Vec3> points;
  for (int i = 0; i < 250; ++i) points.push_back(X * Vec3(i % 5, (i / 5) % 5, (i / 25) % 5));
  const ConvexHull hull = hull_of(points);
  EXPECT_EQ(hull.vertices.size(), 8u);
  EXPECT_EQ(hull.faces.size(), 6u);
  EXPECT_EQ(hull.edges.size(), 12u);
  expect_hull(hull, points, 1e-12);
}

TEST(ConvexHull, MergesTheTrianglesOfRegularPolygons) {
  std::vector<Vec3> points;
  for (int i = 0; i < 100; ++i) {
    for (const double z : {-1.0, 1.0})
      points.emplace_back(std::cos(2 * std::numbers::pi * i / 100), std::sin(2 * std::numbers::pi * i / 100),
                          z);
  }
  const Pose X{rotation_matrix(rotation_exp({1, 1, 0.3})), Vec3::Zero()};
  for (Vec3& p : points) p = X * p;
  const ConvexHull hull = hull_of(points);
  EXPECT_EQ(hull.faces.size(), 102u);
  EXPECT_EQ(hull.vertices.size(), 200u);
  expect_hull(hull, points, 1e-14);
}

TEST(ConvexHull, KeepsAllPointsOfASphere) {
  const std::vector<Vec3> points = points_on_sphere(2000, 0.3);
  const ConvexHull hull = hull_of(points);
  EXPECT_EQ(hull.vertices, points);
  EXPECT_EQ(hull.faces.size(), 3996u);
  expect_hull(hull, hull.vertices, 1e-15);
}

TEST(ConvexHull, OfRandomPointsHoldsThemAll) {
  std::mt19937_64 random(5);
  const auto coordinate = [&random] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  for (int i = 0; i < 20; ++i) {
    std::vector<Vec3> points;
    for (int k = 0; k < 4 + 20 * i; ++k) points.emplace_back(coordinate(), coordinate(), 1e-3 * coordinate());
    expect_hull(hull_of(points), points, 1e-14);
  }
}

TEST(ConvexHull, DoesNotDependOnTheUnitOfLength) {
  std::vector<Vec3> points = points_on_sphere(200, 1);
  const ConvexHull hull = hull_of(points);
  for (const double factor : {0x1p-60, 0x1p60}) {
    std::vector<Vec3> scaled = points;
    for (Vec3& p : scaled) p *= factor;
    const ConvexHull other = hull_of(scaled);
    EXPECT_EQ(other.vertices, scaled);
    EXPECT_EQ(other.faces, hull.faces);
    EXPECT_EQ(other.face_normals, hull.face_normals);
  }
}

TEST(ConvexHull, FindsTheSameFacesFarFromTheOrigin) {
  std::vector<Vec3> points = points_on_sphere(50, 1);
  for (Vec3& p : points) p = p.unaryExpr([](double x) { return std::round(x * 1024) / 1024; });
  const ConvexHull hull = hull_of(points);
  for (Vec3& p : points) p += Vec3(0x1p30, -0x1p29, 0x1p28);
  EXPECT_EQ(hull_of(points).faces, hull.faces);
}

TEST(ConvexHull, SaysWhyThereIsNone) {
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(reason_of({}), "0 points have no convex hull with a volume, at least 4 are needed");
  EXPECT_EQ(reason_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}),
            "3 points have no convex hull with a volume, at least 4 are needed");
  EXPECT_EQ(reason_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, nan, 1}}), "point 3 is not finite");
  EXPECT_EQ(reason_of({{0, 0, infinity}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}), "point 0 is not finite");
  const std::vector<Vec3> equal(8, Vec3(0.1, 0.1, 0.1));
  EXPECT_EQ(reason_of(equal), "all 8 points are equal; they have no convex hull with a volume");
  const std::string flat = "all 5 points lie in one plane or on one line; their convex hull has no volume";
  EXPECT_EQ(reason_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0.3, 0.2, 0}}), flat);
  EXPECT_EQ(reason_of({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}, {4, 4, 4}}), flat);
  EXPECT_EQ(reason_of({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}, {4, 4, 4.0000000000000009}}), flat);
}

TEST(ConvexHull, NeverPrints) {
  ::testing::internal::CaptureStderr();
  ::testing::internal::CaptureStdout();
  reason_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}});
  hull_of(points_on_sphere(20, 1));
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
}

}  // namespace
}  // namespace rigor::convex_hull_test
