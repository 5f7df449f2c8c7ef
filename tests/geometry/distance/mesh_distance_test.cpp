#include "rigor/geometry/distance/mesh_distance.hpp"
#include "rigor/geometry/distance/distance.hpp"

#include "rigor/geometry/decomposition/make_mesh.hpp"
#include "rigor/geometry/mesh/mesh_point.hpp"
#include "rigor/geometry/mesh/triangle_tree.hpp"
#include "rigor/geometry/shape/convex_hull.hpp"
#include "rigor/geometry/shape/triangle_mesh.hpp"
#include "rigor/math/rotation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace rigor::mesh_distance_test {
namespace {

constexpr double kRounding = 1e-14;  ///< A few rounding errors of coordinates near 1 m.

Mesh make(const TriangleMesh& mesh) {
  return make_mesh(std::make_shared<TriangleMesh>(mesh));
}

/// The box as 12 triangles.
TriangleMesh box_mesh(const Vec3& half_extents) {
  const ConvexHull hull = make_box_hull(half_extents);
  TriangleMesh mesh{hull.vertices, {}};
  for (const std::vector<int>& face : hull.faces) {
    mesh.triangles.push_back({face[0], face[1], face[2]});
    mesh.triangles.push_back({face[0], face[2], face[3]});
  }
  return mesh;
}

/// Octahedron whose triangles are cut in four `level` times, with its vertices on the ball of radius 1.
TriangleMesh ball_mesh(int level) {
  TriangleMesh mesh{{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
                    {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
  for (int round = 0; round < level; ++round) {
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b) {
      const auto [entry, is_new] =
          middles.try_emplace(std::minmax(a, b), static_cast<int>(mesh.vertices.size()));
      if (is_new) {
        const Vec3 p =
            mesh.vertices[static_cast<std::size_t>(a)] + mesh.vertices[static_cast<std::size_t>(b)];
        mesh.vertices.push_back(p.normalized());
      }
      return entry->second;
    };
    std::vector<std::array<int, 3>> triangles;
    for (const auto& [a, b, c] : mesh.triangles) {
      const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      for (const std::array<int, 3>& t : {std::array{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}}) {
        triangles.push_back(t);
      }
    }
    mesh.triangles = triangles;
  }
  return mesh;
}

Pose random_pose(std::mt19937& engine, double reach) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  const Vec3 phi(uniform(engine), uniform(engine), uniform(engine));
  return {rotation_matrix(rotation_exp(3 * phi)),
          reach * Vec3(uniform(engine), uniform(engine), uniform(engine))};
}

TEST(TriangleTree, KnowsTheEdgesOfABox) {
  const Mesh mesh = make(box_mesh(Vec3(1, 2, 3)));
  EXPECT_TRUE(mesh.tree->is_closed);
  EXPECT_EQ(mesh.tree->size, 6);
  int flat = 0, convex = 0;
  for (const TriangleTree::Triangle& t : mesh.tree->triangles) {
    for (const MeshEdgeKind kind : t.edge) {
      flat += kind == MeshEdgeKind::flat;
      convex += kind == MeshEdgeKind::convex;
    }
    for (const bool is_corner : t.is_patch_corner) EXPECT_TRUE(is_corner);
  }
  EXPECT_EQ(flat, 6 * 2);     // The diagonal of each face, from both sides.
  EXPECT_EQ(convex, 12 * 2);  // The edges of the box.
  for (const bool is_corner : mesh.tree->is_crease_corner) EXPECT_TRUE(is_corner);
}

TEST(TriangleTree, TellsConcaveFromConvexEdgesAndOpenFromClosedSurfaces) {
  // A valley and a ridge: two triangles that share the edge along y.
  const auto fold = [](double rise) {
    return TriangleMesh{{{0, 0, 0}, {0, 1, 0}, {1, 0, rise}, {-1, 0, rise}}, {{0, 2, 1}, {0, 1, 3}}};
  };
  EXPECT_EQ(make(fold(0.5)).tree->triangles[0].edge[2], MeshEdgeKind::concave);
  EXPECT_EQ(make(fold(-0.5)).tree->triangles[0].edge[2], MeshEdgeKind::convex);
  EXPECT_EQ(make(fold(0)).tree->triangles[0].edge[2], MeshEdgeKind::flat);
  EXPECT_EQ(make(fold(0.5)).tree->triangles[0].edge[0], MeshEdgeKind::boundary);
  EXPECT_FALSE(make(fold(0)).tree->is_closed);
}

TEST(TriangleTree, FindsTheTrianglesWhoseBoxesOverlap) {
  const TriangleMesh triangles = ball_mesh(3);
  const Mesh mesh = make(triangles);
  std::mt19937 engine(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int trial = 0; trial < 50; ++trial) {
    const Vec3 center(uniform(engine), uniform(engine), uniform(engine));
    const Aabb query{center - Vec3::Constant(0.2), center + Vec3::Constant(0.2)};
    std::vector<int> expected;
    for (int t = 0; t < static_cast<int>(triangles.triangles.size()); ++t) {
      Aabb box{Vec3::Constant(10), Vec3::Constant(-10)};
      for (const int v : triangles.triangles[static_cast<std::size_t>(t)]) {
        const Vec3& p = triangles.vertices[static_cast<std::size_t>(v)];
        box = box.united({p, p});
      }
      if (box.overlaps(query)) expected.push_back(t);
    }
    // The tree may add triangles of the same leaf.
    const std::vector<int> found = mesh.tree->overlapping(query);
    EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
    EXPECT_TRUE(std::includes(found.begin(), found.end(), expected.begin(), expected.end()));
    EXPECT_LE(found.size(), expected.size() + 40);
  }
}

TEST(NearestMeshPoint, IsTheNearestAndTellsTheSide) {
  const Mesh mesh = make(box_mesh(Vec3(1, 2, 3)));
  std::mt19937 engine(4);
  std::uniform_real_distribution<double> uniform(-4, 4);
  for (int trial = 0; trial < 200; ++trial) {
    const Vec3 q(uniform(engine), uniform(engine), uniform(engine));
    const Vec3 beyond = q.cwiseAbs() - Vec3(1, 2, 3);
    const bool is_inside = beyond.maxCoeff() < 0;
    const MeshPoint nearest = nearest_mesh_point(mesh, q);
    const double expected = is_inside ? -beyond.maxCoeff() : beyond.cwiseMax(0.0).norm();
    EXPECT_NEAR(nearest.distance, expected, kRounding);
    EXPECT_EQ((q - nearest.p_M).dot(nearest.normal_M) < 0, is_inside);
  }
}

TEST(MeshDistance, OfABoxMeshIsThatOfTheBox) {
  const Vec3 half_extents(1, 0.5, 0.25);
  const Mesh mesh = make(box_mesh(half_extents));
  std::mt19937 engine(5);
  const std::vector<Shape> shapes = {Sphere{0.3}, Box{Vec3(0.2, 0.3, 0.4)}, Capsule{0.1, 0.3},
                                     Cylinder{0.2, 0.3}, Ellipsoid{Vec3(0.1, 0.2, 0.3)}};
  int separate_count = 0;
  for (int trial = 0; trial < 100; ++trial) {
    const Pose X_WM = random_pose(engine, 1), X_WB = random_pose(engine, 3);
    for (const Shape& shape : shapes) {
      const DistanceResult of_box = signed_distance(Box{half_extents}, X_WM, shape, X_WB);
      const DistanceResult of_mesh = mesh_signed_distance(mesh, X_WM, shape, X_WB);
      EXPECT_EQ(of_box.distance > 0, of_mesh.distance > 0);
      if (of_box.distance <= 0) continue;
      ++separate_count;
      EXPECT_NEAR(of_mesh.distance, of_box.distance, 1e-12);
      EXPECT_NEAR((of_mesh.p_WB - of_mesh.p_WA - of_mesh.distance * of_mesh.n_W).norm(), 0, 1e-12);
      EXPECT_LE(of_mesh.lower, of_mesh.distance);
      EXPECT_GE(of_mesh.upper, of_mesh.distance);
    }
  }
  EXPECT_GT(separate_count, 200);
}

TEST(MeshDistance, OfABallPressedIntoABoxMeshIsItsDepth) {
  // Above the middle of the top, from 1 above to the centre 0.1 below: the depth grows evenly through all
  // cases.
  const Mesh mesh = make(box_mesh(Vec3(1, 1, 0.5)));
  for (const double height : {1.0, 0.3, 0.2, 0.1, 1e-6, -1e-6, -0.1}) {
    const Pose X_WB{Mat3::Identity(), Vec3(0.1, 0.2, 0.5 + height)};
    const DistanceResult d = mesh_signed_distance(mesh, Pose{}, Sphere{0.2}, X_WB);
    EXPECT_NEAR(d.distance, height - 0.2, kRounding);
    EXPECT_NEAR((d.n_W - Vec3::UnitZ()).norm(), 0, 1e-9);
  }
  // A small ball deep inside cuts no triangle, and is negative all the same.
  const DistanceResult inside =
      mesh_signed_distance(mesh, Pose{}, Sphere{0.05}, {Mat3::Identity(), Vec3(0, 0, 0.2)});
  EXPECT_NEAR(inside.distance, -0.35, kRounding);
}

TEST(MeshDistance, IsPositiveInsideAnOpenBowl) {
  TriangleMesh bowl = box_mesh(Vec3::Ones());
  std::erase_if(bowl.triangles, [&](const std::array<int, 3>& t) {
    return std::all_of(t.begin(), t.end(),
                       [&](int v) { return bowl.vertices[static_cast<std::size_t>(v)].z() > 0; });
  });
  const DistanceResult d =
      mesh_signed_distance(make(bowl), Pose{}, Sphere{0.2}, {Mat3::Identity(), Vec3(0.5, 0, 0)});
  EXPECT_NEAR(d.distance, 0.3, kRounding);
  EXPECT_NEAR((d.n_W + Vec3::UnitX()).norm(), 0, kRounding);
}

TEST(MeshDistance, OfABallInTheNotchOfAnLIsTheWayToItsWall) {
  // An L: the square [0, 2]² without its upper right quarter, from z = -1 to 1. A ball in the notch.
  const std::vector<Vec2> outline = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  TriangleMesh mesh;
  for (const double z : {-1.0, 1.0}) {
    for (const Vec2& p : outline) mesh.vertices.emplace_back(p.x(), p.y(), z);
  }
  for (int k = 0; k < 6; ++k) {
    const int next = (k + 1) % 6;
    mesh.triangles.push_back({k, next, next + 6});
    mesh.triangles.push_back({k, next + 6, k + 6});
  }
  for (const std::array<int, 3>& t : {std::array{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}}) {
    mesh.triangles.push_back({t[0] + 6, t[1] + 6, t[2] + 6});
    mesh.triangles.push_back({t[0], t[2], t[1]});
  }
  const Mesh notch = make(mesh);
  ASSERT_TRUE(notch.tree->is_closed);
  const DistanceResult d =
      mesh_signed_distance(notch, Pose{}, Sphere{0.25}, {Mat3::Identity(), Vec3(1.4, 1.5, 0)});
  EXPECT_NEAR(d.distance, 0.4 - 0.25, kRounding);
  EXPECT_NEAR((d.n_W - Vec3::UnitX()).norm(), 0, kRounding);
}

TEST(MeshDistance, OfAPlaneIsTheLowestVertex) {
  const Mesh mesh = make(ball_mesh(2));
  std::mt19937 engine(6);
  const HalfSpace plane{Vec3(0.6, 0, 0.8), 0.3};
  for (int trial = 0; trial < 20; ++trial) {
    const Pose X_WM = random_pose(engine, 2), X_WB = random_pose(engine, 2);
    double expected = 10;
    for (const Vec3& v : mesh.mesh->vertices) {
      expected = std::min(expected, plane.normal.dot(X_WB.inverse() * (X_WM * v)) - plane.offset);
    }
    const DistanceResult d = mesh_signed_distance(mesh, X_WM, plane, X_WB);
    EXPECT_NEAR(d.distance, expected, kRounding);
    EXPECT_NEAR((d.n_W + X_WB.R * plane.normal).norm(), 0, kRounding);
    EXPECT_NEAR((d.p_WB - d.p_WA - d.distance * d.n_W).norm(), 0, kRounding);
  }
}

TEST(MeshDistance, OfATessellatedBallVisitsFewTriangles) {
  // 32,768 triangles: hundreds of queries would take seconds if each triangle were tried.
  const Mesh mesh = make(ball_mesh(6));
  std::mt19937 engine(7);
  for (int trial = 0; trial < 300; ++trial) {
    const Pose X_WB = random_pose(engine, 3);
    const double distance = X_WB.p.norm() - 1 - 0.1;
    if (distance < 0.1) continue;
    const DistanceResult d = mesh_signed_distance(mesh, Pose{}, Sphere{0.1}, X_WB);
    // The faces lie between the ball and 1 - r²/2 below it, r ≤ 0.03 the radius about a triangle.
    EXPECT_GE(d.distance, distance - kRounding);
    EXPECT_LE(d.distance, distance + 4.5e-4);
  }
}

}  // namespace
}  // namespace rigor::mesh_distance_test
