#include "rigor/geometry/shape/aabb.hpp"

#include "rigor/geometry/mesh/triangle_tree.hpp"
#include "rigor/geometry/shape/convex_hull.hpp"
#include "rigor/math/rotation.hpp"

#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace rigor::aabb_test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Farthest value along each axis of W of points spread over the surface, as a lower bound of the true box.
Aabb sampled_box(const std::vector<Vec3>& points_S, const Pose& X_WS) {
  Aabb box{Vec3::Constant(kInfinity), Vec3::Constant(-kInfinity)};
  for (const Vec3& p_S : points_S) {
    const Vec3 p_W = X_WS * p_S;
    box = box.united({p_W, p_W});
  }
  return box;
}

Pose random_pose(std::mt19937& engine) {
  std::normal_distribution<double> normal;
  const Quat q(normal(engine), normal(engine), normal(engine), normal(engine));
  return {rotation_matrix(q), Vec3(normal(engine), normal(engine), normal(engine))};
}

std::vector<Vec3> circle(double radius, double z, int count) {
  std::vector<Vec3> points;
  for (int k = 0; k < count; ++k) {
    const double angle = 2 * std::numbers::pi * k / count;
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
  }
  return points;
}

void append(const std::vector<Vec3>& more, std::vector<Vec3>& points) {
  points.insert(points.end(), more.begin(), more.end());
}

/// Points on ellipsoid rings; with radius r for all axes a sphere.
std::vector<Vec3> ellipsoid_points(const Vec3& radii) {
  std::vector<Vec3> points;
  for (int k = 0; k <= 300; ++k) {
    const double polar = std::numbers::pi * k / 300;
    for (const Vec3& p : circle(std::sin(polar), std::cos(polar), 300))
      points.push_back(radii.cwiseProduct(p));
  }
  return points;
}

/// The box must hold all points and exceed their box by no more than the sampling can miss.
void expect_tight(const Shape& shape, const std::vector<Vec3>& points_S, double sampling,
                  std::mt19937& engine) {
  for (int trial = 0; trial < 5; ++trial) {
    const Pose X_WS = random_pose(engine);
    const Aabb box = axis_aligned_box(shape, X_WS);
    const Aabb sampled = sampled_box(points_S, X_WS);
    EXPECT_TRUE(box.grown(1e-14).contains(sampled)) << shape_type_name(shape);
    EXPECT_LE((box.upper - sampled.upper).maxCoeff(), sampling + 1e-14) << shape_type_name(shape);
    EXPECT_LE((sampled.lower - box.lower).maxCoeff(), sampling + 1e-14) << shape_type_name(shape);
  }
}

TEST(AxisAlignedBox, IsTightForEveryBoundedShape) {
  std::mt19937 engine(5);
  // A circle sampled every δ is missed by R (1 - cos(δ/2)) at most; two such angles on spheres.
  const double circle_miss = 1 - std::cos(std::numbers::pi / 2000);
  const double sphere_miss = 2 * (1 - std::cos(std::numbers::pi / 300));

  expect_tight(Sphere{0.7}, ellipsoid_points(Vec3::Constant(0.7)), 0.7 * sphere_miss, engine);
  expect_tight(Ellipsoid{Vec3(0.3, 1.0, 2.0)}, ellipsoid_points(Vec3(0.3, 1.0, 2.0)), 2 * sphere_miss,
               engine);

  const std::vector<Vec3> box_corners = make_box_hull(Vec3(0.5, 1, 2)).vertices;
  expect_tight(Box{Vec3(0.5, 1, 2)}, box_corners, 0, engine);
  expect_tight(Convex{std::make_shared<ConvexHull>(make_box_hull(Vec3(0.5, 1, 2)))}, box_corners, 0, engine);

  std::vector<Vec3> cylinder = circle(0.6, 1.5, 2000);
  append(circle(0.6, -1.5, 2000), cylinder);
  expect_tight(Cylinder{0.6, 1.5}, cylinder, 0.6 * circle_miss, engine);

  std::vector<Vec3> cone = circle(0.6, -1.5, 2000);
  cone.emplace_back(0, 0, 1.5);
  expect_tight(Cone{0.6, 1.5}, cone, 0.6 * circle_miss, engine);

  std::vector<Vec3> capsule;
  for (const Vec3& p : ellipsoid_points(Vec3::Constant(0.4))) {
    capsule.push_back(p + Vec3(0, 0, 1.1));
    capsule.push_back(p - Vec3(0, 0, 1.1));
  }
  expect_tight(Capsule{0.4, 1.1}, capsule, 0.4 * sphere_miss, engine);

  TriangleMesh mesh;
  mesh.vertices = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 2, 0), Vec3(0, 0, 3)};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  expect_tight(Mesh{std::make_shared<TriangleMesh>(mesh), nullptr}, mesh.vertices, 0, engine);
}

TEST(AxisAlignedBox, OfAPlaneBoundsOneSideOnlyIfItsNormalIsAnAxis) {
  const Aabb level = axis_aligned_box(HalfSpace{Vec3::UnitZ(), 2}, {Mat3::Identity(), Vec3(5, 6, 7)});
  EXPECT_EQ(level.upper, Vec3(kInfinity, kInfinity, 9));
  EXPECT_EQ(level.lower, Vec3::Constant(-kInfinity));

  const Aabb wall = axis_aligned_box(HalfSpace{-Vec3::UnitX(), 2}, {Mat3::Identity(), Vec3(5, 6, 7)});
  EXPECT_EQ(wall.lower, Vec3(3, -kInfinity, -kInfinity));  // -x ≤ 2 about x = 5.
  EXPECT_EQ(wall.upper, Vec3::Constant(kInfinity));

  const Aabb slope = axis_aligned_box(HalfSpace{Vec3(0.6, 0, 0.8), 2}, Pose{});
  EXPECT_EQ(slope.lower, Vec3::Constant(-kInfinity));
  EXPECT_EQ(slope.upper, Vec3::Constant(kInfinity));
}

TEST(AxisAlignedBox, ScalesWithAllLengthsBitForBit) {
  std::mt19937 engine(9);
  const Pose X = random_pose(engine);
  const Pose X_scaled{X.R, 1024 * X.p};
  const Aabb box = axis_aligned_box(Ellipsoid{Vec3(0.3, 1.0, 2.0)}, X);
  const Aabb scaled = axis_aligned_box(Ellipsoid{1024 * Vec3(0.3, 1.0, 2.0)}, X_scaled);
  EXPECT_EQ(scaled.lower, 1024 * box.lower);
  EXPECT_EQ(scaled.upper, 1024 * box.upper);
}

}  // namespace
}  // namespace rigor::aabb_test
