#include "rigor/geometry/mesh_penetration/mesh_penetration.hpp"
#include "rigor/geometry/distance/distance.hpp"

#include "geometry/solid_shapes.hpp"
#include "rigor/geometry/decomposition/mesh_solid.hpp"
#include "rigor/geometry/mesh_penetration/point_depth.hpp"
#include "rigor/geometry/shape/height_field.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

namespace rigor::mesh_penetration_test {
namespace {

using namespace test;

constexpr double kRounding = 1e-12;  ///< Of cuts and of the convex distances, for sizes near 1 m.

Pose at(double x, double y, double z) {
  return {Mat3::Identity(), Vec3(x, y, z)};
}

/// The hull as a mesh, and the same as a convex shape.
struct BothKinds {
  Mesh mesh;
  Shape convex;
};
BothKinds random_hull(Draw& draw) {
  const Shape convex = draw.hull(20);
  const ConvexHull& hull = *std::get<Convex>(convex).hull;
  PolygonMesh polygons{hull.vertices, hull.faces};
  return {as_mesh(polygons), convex};
}

TEST(MeshPenetration, OfConvexMeshesIsTheConvexSignedDistance) {
  Draw draw(5);
  int overlapping = 0;
  for (int i = 0; i < 60; ++i) {
    const BothKinds a = random_hull(draw), b = random_hull(draw);
    const Pose X_WA = draw.pose(0.5), X_WB = draw.pose(0.5);
    const DistanceResult expected = signed_distance(a.convex, X_WA, b.convex, X_WB);
    const DistanceResult d = mesh_penetration(a.mesh, X_WA, b.mesh, X_WB);
    EXPECT_NEAR(d.distance, expected.distance, kRounding);
    EXPECT_NEAR(mesh_penetration(a.mesh, X_WA, b.convex, X_WB).distance, expected.distance, kRounding);
    EXPECT_LE(d.lower, d.distance);
    EXPECT_GE(d.upper, d.distance);
    EXPECT_LT(d.upper - d.lower, 1e-9);
    EXPECT_LT((d.p_WB - d.p_WA - d.distance * d.n_W).norm(), kRounding);
    if (d.distance < 0) ++overlapping;
  }
  EXPECT_GT(overlapping, 20);
}

TEST(MeshPenetration, KnownDepths) {
  const Mesh l = as_mesh(l_solid());
  // A cube of side 0.2 in the middle of the corner cube of the L: the way out is 0.5 + 0.1 long.
  const Mesh cube = as_mesh(make_box_mesh(Vec3::Constant(-0.1), Vec3::Constant(0.1)));
  EXPECT_NEAR(mesh_penetration(l, {}, cube, at(0.5, 0.5, 0.5)).distance, -0.6, kRounding);
  // In the notch, 0.3 from both its walls: apart. On a wall, and 1 mm inside.
  EXPECT_NEAR(mesh_penetration(l, {}, cube, at(1.4, 1.6, 0.5)).distance, 0.3, kRounding);
  EXPECT_NEAR(mesh_penetration(l, {}, cube, at(1.6, 1.1, 0.5)).distance, 0, kRounding);
  EXPECT_NEAR(mesh_penetration(l, {}, cube, at(1.6, 1.099, 0.5)).distance, -0.001, kRounding);
  // In the cavity of a cube: nothing is penetrated.
  const Mesh hollow = as_mesh(cube_with_cavity());
  EXPECT_NEAR(mesh_penetration(hollow, {}, cube, {}).distance, 0.4, kRounding);
  const Shape ball = Sphere{0.1};
  EXPECT_NEAR(mesh_penetration(hollow, {}, ball, {}).distance, 0.4, kRounding);
  EXPECT_NEAR(mesh_penetration(hollow, {}, ball, at(0.75, 0, 0)).distance, -0.35, kRounding);
  EXPECT_NEAR(mesh_penetration(hollow, {}, HalfSpace{Vec3::UnitZ(), -0.9}, {}).distance, -0.1, kRounding);
}

/// Signed distances along a way that both lead through contact: neighbours differ by no more than the step.
void expect_continuous(const std::function<DistanceResult(double)>& distance, double length) {
  constexpr int kSteps = 1000;
  const double step = length / kSteps;
  double before = distance(0).distance;
  bool was_apart = before > 0, was_inside = before < 0;
  for (int i = 1; i <= kSteps; ++i) {
    const double d = distance(step * i).distance;
    EXPECT_LE(std::abs(d - before), step + kRounding) << "after " << step * i;
    was_apart = was_apart || d > 0;
    was_inside = was_inside || d < 0;
    before = d;
  }
  EXPECT_TRUE(was_apart && was_inside);
}

TEST(MeshPenetration, ChangesByNoMoreThanTheMotionThroughContact) {
  const Mesh gear = as_mesh(gear_solid(6)), l = as_mesh(l_solid()), hole = as_mesh(cube_with_hole());
  Draw draw(7);
  const Pose X_WA = draw.pose(1);
  const Mat3 R = draw.rotation();
  const Vec3 way = draw.direction();
  const auto along = [&](double s) { return Pose{R, X_WA.p + (s - 2.5) * way}; };
  expect_continuous([&](double s) { return mesh_penetration(gear, X_WA, l, along(s)); }, 2.5);
  // A peg through a hole, along its axis.
  const Shape peg = Capsule{0.3, 1};
  expect_continuous([&](double s) { return mesh_penetration(hole, {}, peg, at(s - 1, 0.1, 0.2)); }, 2);
}

TEST(MeshPenetration, IsSymmetricAndInvariantUnderRigidMotion) {
  const Mesh gear = as_mesh(gear_solid(6)), star = as_mesh(star_solid(5, 0.4));
  Draw draw(11);
  int overlapping = 0;
  for (int i = 0; i < 30; ++i) {
    const Pose X_WA = draw.pose(0.6), X_WB = draw.pose(0.6), X_VW = draw.pose(2);
    const DistanceResult ab = mesh_penetration(gear, X_WA, star, X_WB);
    const DistanceResult ba = mesh_penetration(star, X_WB, gear, X_WA);
    EXPECT_EQ(ab.distance, ba.distance);
    EXPECT_NEAR(mesh_penetration(gear, X_VW * X_WA, star, X_VW * X_WB).distance, ab.distance, kRounding);
    if (ab.distance < 0) ++overlapping;
  }
  EXPECT_GT(overlapping, 10);
}

TEST(MeshPenetration, NoShorterTranslationPartsTheSolids) {
  const Mesh gear = as_mesh(gear_solid(6)), l = as_mesh(l_solid());
  Draw draw(13);
  for (int i = 0; i < 10; ++i) {
    const Pose X_WA = draw.pose(0.4), X_WB = draw.pose(0.4);
    const double depth = -mesh_penetration(gear, X_WA, l, X_WB).distance;
    if (depth <= 0) continue;
    for (int k = 0; k < 30; ++k) {
      const Pose moved_B{X_WB.R, X_WB.p + 0.999 * depth * draw.direction()};
      EXPECT_LT(mesh_penetration(gear, X_WA, l, moved_B).distance, 0);
    }
  }
}

TEST(MeshPenetration, TwoPlacesOfOverlapAreTwoRegions) {
  // A bar across both arms of a U, 0.01 and, as it is tilted, deeper in the other.
  const Mesh u = as_mesh(make_prism({{0, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, 1));
  const Shape bar = Box{{2, 0.1, 0.1}};
  const Pose X_WB{rotation_matrix(rotation_exp(Vec3(0, 0, 0.01))), Vec3(1.5, 2.08, 0.5)};
  const std::vector<OverlapRegion> regions = find_overlap_regions(u, {}, bar, X_WB);
  ASSERT_EQ(regions.size(), 2u);
  EXPECT_LT(regions[0].deepest.distance, regions[1].deepest.distance);
  EXPECT_EQ(regions[0].deepest.distance, mesh_penetration(u, {}, bar, X_WB).distance);
  EXPECT_LT(regions[0].deepest.p_WA.x(), 1.5);
  EXPECT_GT(regions[1].deepest.p_WA.x(), 1.5);
  // Down in the bottom they are one.
  const std::vector<OverlapRegion> one = find_overlap_regions(u, {}, bar, at(1.5, 0.9, 0.5));
  EXPECT_EQ(one.size(), 1u);
  EXPECT_TRUE(find_overlap_regions(u, {}, bar, at(1.5, 2.2, 0.5)).empty());
}

TEST(PointDepth, EnclosesTheDepthOfTheDeepestPoint) {
  // A ball of radius 0.2 inside a cube of side 2, 0.5 from a wall: its nearest points are 0.7 to 1 deep; the
  // point on its far side is the deepest, 0.7 + 0.2 from the wall.
  const Mesh cube = as_mesh(make_box_mesh(Vec3::Constant(-1), Vec3::Constant(1)));
  const Shape ball = Sphere{0.2};
  const DistanceResult d = deepest_point(cube, {}, ball, at(0.3, 0, 0));
  EXPECT_GE(-d.lower, 0.9 - kRounding);
  EXPECT_LE(-d.upper, 0.9 + kRounding);
  EXPECT_LE(-d.lower, 1.02 * -d.upper);
  EXPECT_LT((d.p_WB - d.p_WA - d.distance * d.n_W).norm(), kRounding);
  // A tooth 0.1 long in the wall.
  const Mesh tooth = as_mesh(make_box_mesh({0.9, -0.5, -0.5}, {2, 0.5, 0.5}));
  const DistanceResult shallow = deepest_point(cube, {}, tooth, {});
  EXPECT_NEAR(shallow.distance, -0.1, kRounding);  // at its corners
  EXPECT_LE(shallow.lower, -0.1 + kRounding);
  // Apart.
  const DistanceResult apart = deepest_point(cube, {}, tooth, at(0.2, 0, 0));
  EXPECT_EQ(apart.distance, 0);
  EXPECT_EQ(apart.upper, std::numeric_limits<double>::infinity());
}

TEST(MeshSolid, IsComputedOnceAndShared) {
  const Mesh mesh = as_mesh(l_solid());
  const Mesh copy = mesh;
  EXPECT_EQ(solid_of(mesh).get(), solid_of(copy).get());
  EXPECT_EQ(mesh.solid->pieces().size(), 2u);
  EXPECT_EQ(&mesh.solid->pieces(), &copy.solid->pieces());
  ASSERT_EQ(mesh.solid->touching_pieces().size(), 1u);
  EXPECT_EQ(mesh.solid->winding()(Vec3(0.5, 0.5, 0.5)), 1);
  // An open mesh has no inside.
  PolygonMesh open = make_box_mesh(Vec3::Zero(), Vec3::Ones());
  open.faces.pop_back();
  EXPECT_TRUE(as_mesh(open).solid->pieces().empty());
}

/// A ground of so many cells a side.
Mesh field(int cells, const std::function<double(double x, double y)>& height) {
  const std::size_t points = static_cast<std::size_t>(cells) + 1;
  HeightField field{HeightRows(points, std::vector<double>(points)), Vec2(3, 3), 0.3};
  for (std::size_t i = 0; i < points; ++i) {
    for (std::size_t k = 0; k < points; ++k)
      field.rows[i][k] =
          height(3 * static_cast<double>(k) / cells - 1.5, 3 * static_cast<double>(i) / cells - 1.5);
  }
  return as_mesh(make_height_field_mesh(field));
}

TEST(MeshSolid, HowFinelyARegularSolidIsCutIntoTrianglesDoesNotMatter) {
  // More than twice as many inward edges as pieces are kept, but in rows: of straight edges, and around a
  // ring. Each slice of the ring is convex, and each ridge of a washboard (four rows of cells bend inwards in
  // each trough).
  const auto inward_edges = [](const Mesh& mesh) {
    long sides = 0;
    for (const TriangleTree::Triangle& triangle : mesh.tree->triangles)
      sides += std::ranges::count(triangle.edge, MeshEdgeKind::concave);
    return sides / 2;
  };
  const Mesh ring = as_mesh(torus_solid(0.35, 70, 40));
  EXPECT_GT(inward_edges(ring), 2 * MeshSolid::kMostPieces);
  EXPECT_EQ(ring.solid->pieces().size(), 70u);
  const Mesh washboard = field(60, [](double x, double) { return 0.1 * std::sin(6 * x); });
  EXPECT_GT(inward_edges(washboard), 2 * MeshSolid::kMostPieces);
  const std::size_t pieces = washboard.solid->pieces().size();
  EXPECT_GT(pieces, 5u);
  EXPECT_LT(pieces, 60u);
}

TEST(MeshSolid, GroundsThatAreCurvedEverywhereHaveNoPieces) {
  const auto hills = [](double x, double y) { return 0.1 * std::sin(2.5 * x) * std::cos(2.5 * y); };
  EXPECT_FALSE(field(16, hills).solid->pieces().empty());
  EXPECT_TRUE(field(44, hills).solid->pieces().empty());
  // A bowl is convex nowhere: each of its cells is one or two pieces.
  const auto bowl = [](double x, double y) { return 0.1 * (x * x + y * y); };
  EXPECT_EQ(field(16, bowl).solid->pieces().size(), 256u);
  EXPECT_TRUE(field(40, bowl).solid->pieces().empty());
}

}  // namespace
}  // namespace rigor::mesh_penetration_test
