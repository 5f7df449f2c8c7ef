#include "rigor/view/3d/surface.hpp"

#include "rigor/geometry/mass/mass_properties.hpp"
#include "rigor/geometry/shape/convex_hull.hpp"
#include "rigor/geometry/shape/triangle_mesh.hpp"
#include "rigor/view/3d/bowl.hpp"
#include "view/view_scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rigor::surface_test {
namespace {

/// Sums over the faces: six times the volume, and the area vectors, which cancel on a closed surface.
struct Sums {
  double volume = 0, area = 0;
  Vec3 area_vector = Vec3::Zero();
};
Sums sums_of(const Surface& surface) {
  Sums sums;
  for (const Surface::Face& face : surface.faces) {
    const auto vertex = [&](int i) {
      return surface
          .vertices[static_cast<std::size_t>(surface.corners[static_cast<std::size_t>(face.begin + i)])];
    };
    for (int i = 1; i + 1 < face.count; ++i) {
      const Vec3 area = 0.5 * (vertex(i) - vertex(0)).cross(vertex(i + 1) - vertex(0));
      sums.volume += area.dot(vertex(0)) / 3;
      sums.area += area.norm();
      sums.area_vector += area;
    }
  }
  return sums;
}

/// Inscribed polygons of n = 96 sides lose a share of (2 π / n)² / 6 of the area, 0.0007; as much again for
/// the rings from pole to pole.
TEST(Surface, OfEveryShapeIsClosedAndHoldsItsVolume) {
  const double pi = M_PI;
  const std::vector<std::pair<Shape, double>> cases = {
      {Box{Vec3(0.5, 1, 1.5)}, 6.0},
      {Cylinder{0.5, 1}, 2 * pi * 0.25},
      {Cone{0.5, 1}, pi * 0.25 * 2 / 3},
      {Capsule{0.5, 1}, pi * 0.25 * 2 + 4 * pi / 3 * 0.125},
      {Ellipsoid{Vec3(0.5, 1, 2)}, 4 * pi / 3},
  };
  for (const auto& [shape, volume] : cases) {
    const Sums sums = sums_of(make_surface(shape));
    EXPECT_NEAR(sums.volume, volume, 0.003 * volume) << shape_type_name(shape);
    EXPECT_LT(sums.area_vector.norm(), 1e-12 * sums.area) << shape_type_name(shape);
  }
}

TEST(Surface, NormalsOfCurvedShapesAreThoseOfTheTrueSurface) {
  const Vec3 radii(0.5, 1, 2);
  const Surface surface = make_surface(Ellipsoid{radii});
  int poles = 0;
  for (const Surface::Face& face : surface.faces) {
    for (int i = face.begin; i < face.begin + face.count; ++i) {
      const Vec3 p = surface.vertices[static_cast<std::size_t>(surface.corners[static_cast<std::size_t>(i)])];
      const Vec3 normal = surface.corner_normals[static_cast<std::size_t>(i)];
      // (x/a)² + (y/b)² + (z/c)² = 1 has the gradient (x/a², y/b², z/c²).
      const Vec3 gradient = p.cwiseQuotient(radii).cwiseQuotient(radii).normalized();
      if (p.head<2>().norm() == 0) ++poles;
      EXPECT_LT((normal - gradient).norm(), 1e-12);
    }
    EXPECT_GT(face.normal.dot(surface.vertices[static_cast<std::size_t>(
                  surface.corners[static_cast<std::size_t>(face.begin)])]),
              0);
  }
  EXPECT_EQ(poles, 2 * 96);
}

TEST(Surface, AMeshIsSmoothOverFlatEdgesAndSharpOverSteepOnes) {
  // Two triangles fold by 10 degrees, then by 60.
  for (const double angle : {10 * M_PI / 180, 60 * M_PI / 180}) {
    TriangleMesh mesh;
    mesh.vertices = {Vec3(0, 0, 0), Vec3(0, 1, 0), Vec3(-1, 0, 0),
                     Vec3(std::cos(angle), 0, -std::sin(angle))};
    mesh.triangles = {{0, 1, 2}, {0, 3, 1}};
    const Surface surface = make_surface(Mesh{std::make_shared<const TriangleMesh>(mesh), nullptr});
    const Vec3 first = surface.corner_normals[0],
               expected = angle < 0.5 ? Vec3(std::sin(angle / 2), 0, std::cos(angle / 2)) : Vec3::UnitZ();
    EXPECT_LT((first - expected).norm(), 1e-12) << angle;
  }
}

TEST(Surface, AFaceWithManyCornersIsDrawnInParts) {
  std::vector<Vec3> points;
  for (int k = 0; k < 300; ++k) {
    for (const double z : {0.0, 1.0})
      points.push_back({std::cos(2 * M_PI * k / 300), std::sin(2 * M_PI * k / 300), z});
  }
  const auto hull = make_convex_hull(points);
  ASSERT_TRUE(std::holds_alternative<ConvexHull>(hull));
  const Surface surface =
      make_surface(Convex{std::make_shared<const ConvexHull>(std::get<ConvexHull>(hull))});
  for (const Surface::Face& face : surface.faces) EXPECT_LE(face.count, 48);
  // Area of the regular polygon times the height.
  EXPECT_NEAR(sums_of(surface).volume, 150 * std::sin(2 * M_PI / 300), 1e-9);
}

TEST(DrawnScene, ABodyWithoutShapesIsTheBoxOfItsInertia) {
  // A box of the sides 1, 2, 3 m and the mass 12 kg has the moments 4 + 9, 1 + 9, 1 + 4 kg m².
  const Scene scene = scene_of(
      "  - {name: r, inertia: {mass: 12, center: [0, 0, 0], moments: [13, 10, 5], products: [0, 0, 0]}}\n");
  const DrawnScene drawn = make_drawn_scene(*scene.model);
  ASSERT_EQ(drawn.shapes.size(), 1u);
  const DrawnShape& shape = drawn.shapes[0];
  ASSERT_TRUE(std::holds_alternative<Box>(shape.shape));
  // In the user's frame, whatever the order of the principal axes.
  const Vec3 sides = 2 * (shape.X_US.R * std::get<Box>(shape.shape).half_extents).cwiseAbs();
  EXPECT_LT((sides - Vec3(1, 2, 3)).norm(), 1e-12);
}

TEST(DrawnScene, EqualShapesShareTheirSurface) {
  const Scene scene = scene_of(
      "  - {name: a, mass: 1, shapes: [{type: box, size: [1, 2, 3]}]}\n"
      "  - {name: b, mass: 1, position: [9, 0, 0], shapes: [{type: box, size: [1, 2, 3]}, {type: box, size: "
      "[1, 2, 4]}]}\n");
  const DrawnScene drawn = make_drawn_scene(*scene.model);
  ASSERT_EQ(drawn.shapes.size(), 3u);
  EXPECT_EQ(drawn.shapes[0].surface, drawn.shapes[1].surface);
  EXPECT_NE(drawn.shapes[0].surface, drawn.shapes[2].surface);
}

TEST(DrawnForm, RodsAreThickEnoughToBeSeenAndOtherShapesStay) {
  const Shape thread = drawn_form(Capsule{1e-9, 0.5}), bar = drawn_form(Cylinder{0.1, 0.5});
  EXPECT_DOUBLE_EQ(std::get<Capsule>(thread).radius, 0.5 / 150);
  EXPECT_EQ(std::get<Capsule>(thread).half_length, 0.5);
  EXPECT_EQ(std::get<Cylinder>(bar).radius, 0.1);
}

}  // namespace
}  // namespace rigor::surface_test
