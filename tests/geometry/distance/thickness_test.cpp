#include "rigor/geometry/distance/thickness.hpp"
#include "geometry/mesh_shapes.hpp"
#include "geometry/random_pairs.hpp"
#include "rigor/geometry/decomposition/make_mesh.hpp"
#include "rigor/geometry/shape/convex_hull.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <variant>

#include <gtest/gtest.h>

namespace rigor::thickness_test {
namespace {

using namespace rigor::test;

Mesh as_mesh(const TriangleMesh& mesh) {
  return make_mesh(std::make_shared<const TriangleMesh>(mesh));
}

TEST(Thickness, OfABoxIsThatOfTheSameBoxAsHullAndAsMesh) {
  Draw draw(1);
  for (int i = 0; i < 50; ++i) {
    const Vec3 half(draw.size(), draw.size(), draw.size());
    const double thickness = thickness_of(Box{half});
    EXPECT_DOUBLE_EQ(thickness, half.minCoeff());
    EXPECT_NEAR(thickness_of(Convex{std::make_shared<const ConvexHull>(make_box_hull(half))}), thickness,
                1e-12 * thickness);
    EXPECT_NEAR(thickness_of(as_mesh(make_grid_box(half, 3))), thickness, 1e-12 * thickness);
  }
}

/// A slab with a post on it and one with a fin: a quarter of the thinnest part, whatever the box about them
/// is.
TEST(Thickness, OfASolidThatIsNotConvexIsOfItsThinnestPart) {
  for (const double fin : {1.0, 0.25, 0.15, 0.02}) {
    TriangleMesh mesh = make_cube_mesh({4, 4, 3}, [](int i, int, int k) { return k == 0 || i == 1; });
    // The wall of cubes on the slab from x = 1 to 2 becomes a fin.
    for (Vec3& v : mesh.vertices) {
      if (v.x() == 2) v.x() = 1 + fin;
    }
    EXPECT_NEAR(thickness_of(as_mesh(mesh)), std::max(0.25 * fin, 0.03), 1e-12);
  }
}

/// A closed mesh of a polyhedron is the polyhedron; without a side it encloses nothing.
TEST(Thickness, OfAnOpenMeshIsAHundredthOfItsWidth) {
  TriangleMesh mesh = make_grid_box(Vec3(1, 1, 1), 4);
  mesh.triangles.pop_back();
  EXPECT_DOUBLE_EQ(thickness_of(as_mesh(mesh)), 0.02);
}

/// No ball of the thickness is larger than what fits into a pointed hull: a tetrahedron's inscribed ball.
TEST(Thickness, OfATetrahedronIsTheRadiusOfItsInscribedBall) {
  const auto hull = make_convex_hull({Vec3(1, 1, 1), Vec3(1, -1, -1), Vec3(-1, 1, -1), Vec3(-1, -1, 1)});
  const double edge = 2 * std::sqrt(2);
  EXPECT_NEAR(thickness_of(Convex{std::make_shared<const ConvexHull>(std::get<ConvexHull>(hull))}),
              edge / (2 * std::sqrt(6)), 1e-12);
}

}  // namespace
}  // namespace rigor::thickness_test
