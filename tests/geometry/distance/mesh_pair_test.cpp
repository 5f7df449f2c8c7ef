#include "rigor/geometry/distance/mesh_pair.hpp"

#include "geometry/mesh_shapes.hpp"
#include "rigor/geometry/convex/convex_distance.hpp"
#include "rigor/geometry/decomposition/make_mesh.hpp"
#include "rigor/geometry/mesh/triangle_pair.hpp"
#include "rigor/geometry/mesh/triangle_tree.hpp"
#include "rigor/math/rotation.hpp"

#include <algorithm>
#include <limits>
#include <memory>
#include <random>

#include <gtest/gtest.h>

namespace rigor::mesh_pair_test {
namespace {

Mesh make(const TriangleMesh& mesh) {
  return make_mesh(std::make_shared<TriangleMesh>(mesh));
}

/// A ball with bumps: neither convex nor symmetric.
TriangleMesh bumpy_ball(int levels, double phase) {
  TriangleMesh mesh = make_icosphere(levels);
  for (Vec3& v : mesh.vertices) v *= 1 + 0.2 * std::sin(5 * v.x() + phase) * std::sin(4 * v.y());
  return mesh;
}

class Random {
 public:
  Vec3 vector() { return Vec3(normal_(engine_), normal_(engine_), normal_(engine_)); }
  Pose pose(double place) {
    return {rotation_matrix(rotation_exp(3 * vector())), place * vector().normalized()};
  }
  TriangleCorners triangle(double size) {
    const Vec3 p = 0.3 * vector();
    return {p + size * vector(), p + size * vector(), p + size * vector()};
  }

 private:
  std::mt19937 engine_{3};
  std::normal_distribution<double> normal_;
};

TriangleCorners corners(const Mesh& mesh, int t, const Pose& X) {
  TriangleCorners result;
  for (std::size_t k = 0; k < 3; ++k) {
    const int v = mesh.mesh->triangles[static_cast<std::size_t>(t)][k];
    result[k] = X * mesh.mesh->vertices[static_cast<std::size_t>(v)];
  }
  return result;
}

int triangle_count(const Mesh& mesh) {
  return static_cast<int>(mesh.mesh->triangles.size());
}

TEST(TriangleDistance, IsThatOfTheDistanceAlgorithmForConvexShapes) {
  Random random;
  int apart = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const TriangleCorners a = random.triangle(0.5), b = random.triangle(trial % 2 == 0 ? 0.5 : 5);
    const TriangleDistance found = triangle_distance(a, b);
    const DistanceResult expected = convex_distance(make_points_core(a), Pose{}, make_points_core(b), Pose{});
    EXPECT_EQ(found.squared == 0, triangles_meet(a, b));
    EXPECT_NEAR(std::sqrt(found.squared), std::max(0.0, expected.distance), 1e-13);
    const auto [p, q] = nearest_points(a, b, found.feature);
    EXPECT_NEAR((q - p).norm(), std::sqrt(found.squared), 1e-14);
    apart += found.squared > 0;
  }
  EXPECT_GT(apart, 200);
  EXPECT_LT(apart, 1900);
}

TEST(TriangleDistance, KeepsItsDigitsWhereEdgesAreNearlyParallel) {
  // Two edges along x cross at the angle 1e-8 and the height 1e-9: the lines are nearest at x = 0.3.
  const double angle = 1e-8, height = 1e-9;
  const TriangleCorners a = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0.5, 0, -1)};
  const TriangleCorners b = {Vec3(0, -0.3 * angle, height), Vec3(1, 0.7 * angle, height), Vec3(0.5, 0, 1)};
  EXPECT_NEAR(std::sqrt(triangle_distance(a, b).squared), height, 4e-16);
}

TEST(TriangleDistance, HasTheSameBitsWithAllInstructions) {
  Random random;
  for (int trial = 0; trial < 500; ++trial) {
    const TriangleCorners a = random.triangle(1), b = random.triangle(1);
    const TriangleDistance best = triangle_distance(a, b);
    const TriangleDistance portable = triangle_distance(a, b, LaneTarget::portable);
    EXPECT_EQ(best.squared, portable.squared);
    EXPECT_EQ(best.feature, portable.feature);
  }
}

TEST(WideTree, HoldsEachTriangleOnceAndInAllBoxesAboveIt) {
  const Mesh mesh = make(bumpy_ball(3, 0.3));
  const WideTree& tree = mesh.tree->wide;
  std::vector<int> seen(mesh.mesh->triangles.size());
  struct Step {
    int place;
    std::vector<int> above;
  };
  std::vector<Step> todo = {{-1, {}}};
  while (!todo.empty()) {
    Step step = todo.back();
    todo.pop_back();
    step.above.push_back(step.place);
    const int child = tree.child_at(step.place);
    if (child >= 0) {
      for (int k = 0; k < tree.nodes[static_cast<std::size_t>(child)].count; ++k)
        todo.push_back({child * WideTree::kWidth + k, step.above});
      continue;
    }
    ++seen[static_cast<std::size_t>(~child)];
    for (const int place : step.above) {
      const OrientedBox box = tree.box_at(place);
      for (const Vec3& p : corners(mesh, ~child, Pose{})) {
        const Vec3 inside = (box.axes.transpose() * (p - box.center)).cwiseAbs() - box.half;
        EXPECT_LE(inside.maxCoeff(), 0);
      }
    }
  }
  EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), static_cast<long>(seen.size()));
}

TEST(WideTree, TakesNoMoreThanSixtyFourBytesATriangle) {
  const Mesh mesh = make(bumpy_ball(4, 0.3));
  EXPECT_LE(sizeof(WideTree::Node) * mesh.tree->wide.nodes.size(), 64 * mesh.mesh->triangles.size());
}

TEST(WideTree, BoundsAreNeverAboveTheDistanceAndHaveTheSameBitsWithAllInstructions) {
  const Mesh a = make(bumpy_ball(2, 0.3)), b = make(bumpy_ball(2, 1));
  Random random;
  int positive = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const Pose X = random.pose(2.5);
    const int t = trial;
    const OrientedBox box = b.tree->wide.box_at(trial % 64);
    const int child = b.tree->wide.child_at(trial % 64);
    if (child >= 0) continue;
    const OtherBox other{{X * box.center, X.R * box.axes, box.half}, random.vector().normalized(), 0};
    const WideTree::Node& node = a.tree->wide.nodes[static_cast<std::size_t>(t) % a.tree->wide.nodes.size()];
    const ChildBounds bounds = child_bounds(node, other);
    EXPECT_EQ(bounds, child_bounds(node, other, LaneTarget::portable));
    for (std::size_t k = 0; k < static_cast<std::size_t>(node.count); ++k) {
      if (node.child[k] >= 0) continue;
      const TriangleDistance exact =
          triangle_distance(corners(a, ~node.child[k], Pose{}), corners(b, ~child, X));
      EXPECT_LE(bounds[k], exact.squared + 1e-14);
      positive += bounds[k] > 0;
    }
  }
  EXPECT_GT(positive, 100);
}

TEST(MeshPair, DistanceIsTheLeastOverAllTriangles) {
  const Mesh a = make(bumpy_ball(2, 0.3)), b = make(bumpy_ball(2, 1));
  Random random;
  for (int trial = 0; trial < 12; ++trial) {
    const Pose X = random.pose(1.9 + 0.2 * trial);
    double least = std::numeric_limits<double>::infinity();
    for (int t = 0; t < triangle_count(a); ++t) {
      for (int u = 0; u < triangle_count(b); ++u)
        least = std::min(least, triangle_distance(corners(a, t, Pose{}), corners(b, u, X)).squared);
    }
    const MeshPairDistance found = mesh_pair_distance(a, b, X);
    EXPECT_EQ(found.distance, std::sqrt(least));
    EXPECT_EQ(found.distance == 0, surfaces_meet(a, b, X));
    EXPECT_NEAR((found.p_AQ - found.p_AP).norm(), found.distance, 1e-14);
  }
}

TEST(MeshPair, ACacheChangesNoBit) {
  const Mesh a = make(bumpy_ball(3, 0.3)), b = make(bumpy_ball(3, 1));
  MeshPairCache cache;
  Pose X{Mat3::Identity(), Vec3(2.6, 0.1, 0.2)};
  const Mat3 turn = rotation_matrix(rotation_exp(Vec3(0.01, 0.02, -0.005)));
  int fronts = 0;
  for (int step = 0; step < 150; ++step) {
    // Nearer, into contact and out again, with a jump once in a while.
    X = {turn * X.R, X.p + Vec3(step < 90 ? -0.006 : 0.006, 0.002, 0)};
    if (step % 40 == 39) X.R = turn * turn * turn * turn * turn * X.R;
    const Pose made_at = cache.X_AB;
    const MeshPairDistance warm = mesh_pair_distance(a, b, X, &cache);
    const MeshPairDistance cold = mesh_pair_distance(a, b, X);
    ASSERT_EQ(warm.distance, cold.distance) << step;
    if (cold.distance > 0) {
      EXPECT_EQ(warm.triangle_A, cold.triangle_A);
      EXPECT_EQ(warm.triangle_B, cold.triangle_B);
      EXPECT_EQ(warm.p_AP, cold.p_AP);
    }
    fronts += made_at.p != cache.X_AB.p;
  }
  EXPECT_LT(fronts, 90);  // Else nothing was followed.
}

TEST(MeshPair, NearAndMeetingTrianglesAreThoseOfAllPairs) {
  const Mesh a = make(bumpy_ball(2, 0.3)), b = make(bumpy_ball(2, 1));
  Random random;
  for (int trial = 0; trial < 6; ++trial) {
    const Pose X = random.pose(1.5);
    std::vector<std::array<int, 2>> meeting, near;
    for (int t = 0; t < triangle_count(a); ++t) {
      for (int u = 0; u < triangle_count(b); ++u) {
        const TriangleCorners p = corners(a, t, Pose{}), q = corners(b, u, X);
        if (triangles_meet(p, q)) meeting.push_back({t, u});
        if (triangle_distance(p, q).squared <= 0.03 * 0.03) near.push_back({t, u});
      }
    }
    EXPECT_EQ(find_meeting_triangles(a, b, X), meeting);
    EXPECT_EQ(find_near_triangles(a, b, X, 0.03), near);
    EXPECT_EQ(surfaces_meet(a, b, X), !meeting.empty());
    EXPECT_FALSE(meeting.empty());
  }
}

TEST(MeshPair, DistanceHoldsFarFromTheOriginAndAtAllScales) {
  for (const double scale : {1e-6, 1.0, 1e6}) {
    TriangleMesh cube = triangulated(make_box_mesh(Vec3::Constant(-scale), Vec3::Constant(scale)));
    const Mesh a = make(cube), b = make(cube);
    const Pose X_WA{Mat3::Identity(), Vec3(1e6, -2e6, 3e5) * scale};
    const Pose X_WB{Mat3::Identity(), X_WA.p + Vec3(2.25, 0.5, 0.25) * scale};
    const MeshPairDistance found = mesh_pair_distance(a, b, relative_pose(X_WA, X_WB));
    EXPECT_NEAR(found.distance, 0.25 * scale, 1e-9 * scale);  // Places hold 1e6 * 2e-16 each.
  }
}

TEST(MeshPair, WithoutTrianglesIsInfinitelyFar) {
  const Mesh a = make(make_icosphere(0)), none = make(TriangleMesh{});
  EXPECT_EQ(mesh_pair_distance(a, none, Pose{}).distance, std::numeric_limits<double>::infinity());
  EXPECT_FALSE(surfaces_meet(none, a, Pose{}));
}

}  // namespace
}  // namespace rigor::mesh_pair_test
