#include "rigor/geometry/distance/point_distance.hpp"

#include "geometry/mesh_shapes.hpp"
#include "geometry/random_pairs.hpp"
#include "rigor/geometry/decomposition/make_mesh.hpp"
#include "rigor/geometry/distance/distance.hpp"
#include "rigor/geometry/mesh/triangle_tree.hpp"
#include "rigor/geometry/shape/containment.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rigor::point_distance_test {
namespace {

using test::Draw;

TEST(PointDistance, AgreesWithTheDistanceOfASmallBall) {
  Draw draw(21);
  for (int kind = 0; kind < Draw::kKinds; ++kind) {
    for (int trial = 0; trial < 100; ++trial) {
      const Shape shape = draw.shape(kind);
      const Pose X_WS = draw.pose(2);
      const Vec3 p_W = X_WS.p + draw.uniform(0, 1.5) * draw.direction();
      const PointDistance found = point_distance(shape, X_WS, p_W);
      const Pose X_WP{Mat3::Identity(), p_W};
      const double r = 0.1;
      const double of_ball = signed_distance(shape, X_WS, Sphere{r}, X_WP).distance;
      EXPECT_NEAR(found.distance - r, of_ball, 1e-12) << shape_type_name(shape);
      const Vec3 p_S = X_WS.inverse() * p_W;
      if (std::abs(found.distance) > 1e-12) {
        EXPECT_EQ(found.distance < 0, contains(shape, p_S));
      }
    }
  }
}

TEST(PointDistance, OfAnEllipsoidIsItsNearestPointAlsoOnItsPlanesOfSymmetry) {
  // The nearest point is a foot of the normal, and no point of the surface is nearer.
  Draw draw(22);
  for (int trial = 0; trial < 300; ++trial) {
    Vec3 radii = draw.sizes();
    if (trial % 3 == 1) radii.y() = radii.x();
    if (trial % 7 == 2) radii *= 1e-4;
    Vec3 p = draw.uniform(0, 2) * radii.maxCoeff() * draw.direction();
    for (int axis = 0; axis < 3; ++axis) {
      if ((trial >> axis) & 1) p(axis) = 0;
    }
    const PointDistance found = point_distance(Ellipsoid{radii}, Pose{}, p);
    const double size = radii.maxCoeff();
    EXPECT_NEAR(found.p_W.cwiseQuotient(radii).norm(), 1, 1e-13 * size / radii.minCoeff());
    EXPECT_NEAR((p - found.p_W - found.distance * found.n_W).norm(), 0, 1e-15 * size);
    for (int k = 0; k < 40; ++k) {
      const Vec3 on_surface = radii.cwiseProduct(draw.direction());
      EXPECT_GE((on_surface - p).norm(), std::abs(found.distance) - 1e-14 * size);
    }
  }
  // From the middle the shortest radius leads out.
  EXPECT_EQ(point_distance(Ellipsoid{Vec3(3, 1, 2)}, Pose{}, Vec3::Zero()).distance, -1);
  EXPECT_EQ(point_distance(Ellipsoid{Vec3(2, 2, 2)}, Pose{}, Vec3::Zero()).distance, -2);
}

TEST(PointDistance, OfAMeshChangesItsSignAtTheSurface) {
  const Mesh cube = make_mesh(
      std::make_shared<const TriangleMesh>(triangulated(make_box_mesh(Vec3(-1, -1, -1), Vec3(1, 1, 1)))));
  Draw draw(23);
  for (int trial = 0; trial < 500; ++trial) {
    const Vec3 p = 2 * Vec3(draw.uniform(-1, 1), draw.uniform(-1, 1), draw.uniform(-1, 1));
    const PointDistance of_mesh = point_distance(cube, Pose{}, p);
    const PointDistance of_box = point_distance(Box{Vec3(1, 1, 1)}, Pose{}, p);
    EXPECT_NEAR(of_mesh.distance, of_box.distance, 1e-15);
    EXPECT_NEAR((of_mesh.n_W - of_box.n_W).norm(), 0, 1e-12);
  }
  EXPECT_EQ(point_distance(HalfSpace{Vec3::UnitZ(), 1}, Pose{}, Vec3(5, 5, 3)).distance, 2);
}

}  // namespace
}  // namespace rigor::point_distance_test
