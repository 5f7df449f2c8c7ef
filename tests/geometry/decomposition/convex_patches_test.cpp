#include "rigor/geometry/decomposition/convex_patches.hpp"

#include "geometry/solid_shapes.hpp"

#include <gtest/gtest.h>

namespace rigor::convex_patches_test {
namespace {

using namespace test;

/// Every triangle is in one patch and lies on the patch's hull: no corner of the patch is in front of it.
std::vector<ConvexPatch> expect_patches(const TriangleMesh& mesh) {
  const std::vector<ConvexPatch> patches = find_convex_patches(mesh);
  std::vector<int> seen(mesh.triangles.size(), 0);
  for (const ConvexPatch& patch : patches) {
    for (const int t : patch.triangles) {
      ++seen[static_cast<std::size_t>(t)];
      const auto corner = [&](int triangle, std::size_t k) -> Vec3 {
        return mesh.vertices[static_cast<std::size_t>(mesh.triangles[static_cast<std::size_t>(triangle)][k])];
      };
      const Vec3 normal = (corner(t, 1) - corner(t, 0)).cross(corner(t, 2) - corner(t, 0)).normalized();
      for (const int other : patch.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
          EXPECT_LT(normal.dot(corner(other, k) - corner(t, 0)), 1e-12);
        }
      }
    }
    EXPECT_EQ(patch.real_share.size(), patch.hull ? patch.hull->faces.size() : 0u);
  }
  for (const int count : seen) EXPECT_EQ(count, 1);
  return patches;
}

TEST(ConvexPatches, AConvexSurfaceIsOnePatchWithoutVirtualFaces) {
  const std::vector<ConvexPatch> patches = expect_patches(make_icosphere(2));
  ASSERT_EQ(patches.size(), 1u);
  for (const double share : patches[0].real_share) EXPECT_EQ(share, 1);
}

TEST(ConvexPatches, TheWallsOfAHoleAreFlatPatches) {
  // Outside one patch: a cube with its hole in two faces. In the hole each wall bends away from the next.
  const std::vector<ConvexPatch> patches = expect_patches(triangulated(cube_with_hole()));
  EXPECT_EQ(patches.size(), 5u);
  int flat = 0;
  for (const ConvexPatch& patch : patches) {
    if (!patch.hull) {
      ++flat;
      continue;
    }
    // The hole's openings are a quarter of two of its faces.
    double missing = 0;
    for (const double share : patch.real_share) missing += 1 - share;
    EXPECT_NEAR(missing, 0.5, 1e-12);
  }
  EXPECT_EQ(flat, 4);
}

TEST(ConvexPatches, CoverSurfacesThatAreNotConvex) {
  EXPECT_LE(expect_patches(triangulated(l_solid())).size(), 4u);
  const TriangleMesh torus = triangulated(torus_solid(0.4, 16, 12));
  EXPECT_LT(expect_patches(torus).size(), torus.triangles.size() / 4);
  const TriangleMesh ball = bumpy_ball(2, 0.3);
  EXPECT_LT(expect_patches(ball).size(), ball.triangles.size() / 3);
}

TEST(ConvexPatches, AreCountedWithoutTheirHulls) {
  for (const TriangleMesh& mesh : {triangulated(torus_solid(0.4, 16, 12)), bumpy_ball(2, 0.3),
                                   triangulated(cube_with_hole()), make_icosphere(1)}) {
    const std::size_t count = find_convex_patches(mesh).size();
    EXPECT_FALSE(has_more_convex_patches(mesh, count));
    EXPECT_TRUE(has_more_convex_patches(mesh, count - 1));
    EXPECT_TRUE(has_more_convex_patches(mesh, 0));
  }
}

}  // namespace
}  // namespace rigor::convex_patches_test
