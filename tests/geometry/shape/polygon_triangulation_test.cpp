#include "rigor/geometry/shape/polygon_triangulation.hpp"

#include "geometry/mesh_shapes.hpp"
#include "rigor/geometry/exact/orientation.hpp"
#include "rigor/geometry/mass/mass_properties.hpp"
#include "rigor/math/rotation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <random>
#include <vector>

namespace rigor::polygon_triangulation_test {
namespace {

using Triangles = std::vector<std::array<int, 3>>;

std::vector<int> loop_of(std::size_t count) {
  std::vector<int> loop(count);
  std::iota(loop.begin(), loop.end(), 0);
  return loop;
}

std::vector<Vec3> in_space(const std::vector<Vec2>& points, const Pose& X = {}) {
  std::vector<Vec3> result;
  for (const Vec2& p : points) result.push_back(X * Vec3(p.x(), p.y(), 0));
  return result;
}

/// n - 2 triangles, none turned backwards or flat, with the polygon as their border: so they cover it once.
void expect_triangulation(const std::vector<Vec2>& points, const Triangles& triangles) {
  ASSERT_EQ(triangles.size(), points.size() - 2);
  std::map<std::pair<int, int>, int> border;
  for (const std::array<int, 3>& t : triangles) {
    const auto p = [&](std::size_t i) -> const Vec2& { return points[static_cast<std::size_t>(t[i])]; };
    EXPECT_EQ(orientation(p(0), p(1), p(2)), 1);
    for (std::size_t i = 0; i < 3; ++i) {
      const int a = t[i], b = t[(i + 1) % 3];
      if (--border[{b, a}] == 0) border.erase({b, a});
      if (++border[{a, b}] == 0) border.erase({a, b});
    }
  }
  std::erase_if(border, [](const auto& entry) { return entry.second <= 0; });
  EXPECT_EQ(border.size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_TRUE(border.contains({static_cast<int>(i), static_cast<int>((i + 1) % points.size())}));
  }
}

/// A star of `spikes` tips with `depth` between its radii.
std::vector<Vec2> star(int spikes, double depth) {
  std::vector<Vec2> points;
  for (int i = 0; i < 2 * spikes; ++i) {
    const double angle = std::numbers::pi * i / spikes, r = i % 2 ? 1 - depth : 1;
    points.emplace_back(r * std::cos(angle), r * std::sin(angle));
  }
  return points;
}

/// A band wound up like a watch spring: nearly every corner hides behind others.
std::vector<Vec2> spiral(int count) {
  std::vector<Vec2> points;
  const int half = count / 2;
  for (int side = 0; side < 2; ++side) {
    for (int k = 0; k < half; ++k) {
      const int i = side == 0 ? k : half - 1 - k;
      const double angle = 0.1 * i, r = 1 + 0.02 * i + (side == 0 ? 0.5 : 0);
      points.emplace_back(r * std::cos(angle), r * std::sin(angle));
    }
  }
  return points;
}

TEST(Triangulation, CoversConcavePolygonsOnce) {
  const std::vector<std::vector<Vec2>> polygons = {
      {{0, 0}, {1, 0}, {1, 1}, {0, 1}},
      {{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 3}, {0, 3}},
      {{0, 0}, {2, 0.5}, {4, 0}, {3.5, 2}, {4, 4}, {2, 3.5}, {0, 4}, {0.5, 2}},
      {{0, 0}, {5, 0}, {5, 3}, {4, 3}, {4, 1}, {3, 1}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}},
      star(50, 0.9),
      star(7, 0.3),
      spiral(200)};
  for (const std::vector<Vec2>& polygon : polygons) {
    expect_triangulation(polygon, triangulated_polygon(in_space(polygon), loop_of(polygon.size())));
  }
}

TEST(Triangulation, MakesNoFlatTriangleOfVerticesInTheMiddleOfSides) {
  std::vector<Vec2> square;
  for (int i = 0; i < 5; ++i) square.emplace_back(i, 0);
  for (int i = 0; i < 5; ++i) square.emplace_back(5, i);
  for (int i = 0; i < 5; ++i) square.emplace_back(5 - i, 5);
  for (int i = 0; i < 5; ++i) square.emplace_back(0, 5 - i);
  expect_triangulation(square, triangulated_polygon(in_space(square), loop_of(20)));
  const std::vector<Vec2> triangle = {{0, 0}, {1, 0}, {2, 0}, {0, 2}};
  expect_triangulation(triangle, triangulated_polygon(in_space(triangle), loop_of(4)));
}

TEST(Triangulation, CoversAPolygonWithAHoleCutOpenAlongABridge) {
  // Outer square, bridge to the hole, hole clockwise, bridge back: two corners stand at each end of the
  // bridge.
  const std::vector<Vec2> keyhole = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0},
                                     {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}};
  expect_triangulation(keyhole, triangulated_polygon(in_space(keyhole), loop_of(keyhole.size())));
}

TEST(Triangulation, IsTheSameInEveryPlane) {
  const std::vector<Vec2> polygon = star(9, 0.6);
  for (const Vec3& turn : {Vec3(0, 0, 0), Vec3(0.3, 1, 2), Vec3(3, 0, 0), Vec3(0, -1.5, 0)}) {
    const Pose X{rotation_matrix(rotation_exp(turn)), {1, 2, 3}};
    expect_triangulation(polygon, triangulated_polygon(in_space(polygon, X), loop_of(polygon.size())));
  }
}

TEST(Triangulation, CoversRandomStarShapedPolygons) {
  std::mt19937_64 random(3);
  for (int round = 0; round < 50; ++round) {
    std::vector<Vec2> polygon;
    const int count = 4 + round;
    for (int i = 0; i < count; ++i) {
      const double r = 0.05 + static_cast<double>(random() % 1000) / 1000,
                   angle = 2 * std::numbers::pi * i / count;
      polygon.emplace_back(r * std::cos(angle), r * std::sin(angle));
    }
    expect_triangulation(polygon, triangulated_polygon(in_space(polygon), loop_of(polygon.size())));
  }
}

TEST(Triangulation, OfTwentyThousandCornersIsQuick) {
  for (const std::vector<Vec2>& polygon : {star(10000, 0.2), spiral(20000), star(10000, 0)}) {
    expect_triangulation(polygon, triangulated_polygon(in_space(polygon), loop_of(polygon.size())));
  }
}

TEST(Triangulation, OfACrossedPolygonKeepsItsBorderAndItsIntegrals) {
  const std::vector<Vec2> tie = {{-1, -1}, {0.5, 0.5}, {0.5, -0.5}, {-1, 1}};
  const PolygonMesh prism = make_prism(tie, 1);
  const TriangleMesh mesh = triangulated(prism);
  EXPECT_EQ(mesh.triangles.size(), 12u);
  const double volume = polyhedron_integrals(prism.vertices, prism.faces).volume;
  EXPECT_NEAR(polyhedron_integrals(mesh.vertices, mesh.triangles).volume, volume, 1e-15);
  EXPECT_NEAR(volume, 0.75, 1e-15);  // areas 1 and -1/4
}

TEST(Triangulation, OfAMeshKeepsItsMassProperties) {
  const PolygonMesh prism = make_prism(star(20, 0.7), 0.5);
  const MassProperties polygons = mass_properties(prism, 1),
                       triangles = mass_properties(triangulated(prism), 1);
  EXPECT_NEAR(triangles.mass, polygons.mass, 1e-15);
  EXPECT_LE((triangles.inertia - polygons.inertia).norm(), 1e-15);
}

TEST(Orientation, InThePlaneIsExactBeyondRounding) {
  // Points a few roundings off a line: exactly, the sign is that of i - j.
  for (int i = 0; i < 16; ++i) {
    for (int j = 0; j < 16; ++j) {
      const Vec2 p(0.5 + i * 0x1p-53, 0.5 + j * 0x1p-53);
      EXPECT_EQ(orientation(p, Vec2(12, 12), Vec2(24, 24)), (i < j) - (i > j)) << i << " " << j;
    }
  }
}

TEST(Orientation, InSpaceIsExactBeyondRounding) {
  // The plane x = y through points far apart; d is off it by one rounding at most.
  const Vec3 a(12, 12, 0), b(24, 24, 1), c(3, 3, 7.3);
  for (int i = 0; i < 8; ++i) {
    for (int j = 0; j < 8; ++j) {
      const Vec3 d(0.5 + i * 0x1p-53, 0.5 + j * 0x1p-53, 0.1);
      const int sign = orientation(a, b, c, d);
      EXPECT_EQ(sign,
                i == j ? 0 : (i > j ? orientation(a, b, c, {1, 0, 0}) : orientation(a, b, c, {0, 1, 0})));
      EXPECT_EQ(orientation(b, a, c, d), -sign);
      EXPECT_EQ(orientation(b, c, d, a), -sign);
    }
  }
  EXPECT_EQ(orientation(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)), 1);
}

}  // namespace
}  // namespace rigor::polygon_triangulation_test
