#include "rigor/view/3d/camera.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rigor::camera_test {
namespace {

const Camera from_the_south{Vec3(0, -2, 0), Vec3::Zero(), Vec3::UnitZ(), M_PI / 2};

TEST(Projection, PointsAreWhereSimilarTrianglesPutThem) {
  // 90 degrees over 200 pixels: f = 100 px; at a depth of 2 m one metre is 50 px.
  const Projection projection(from_the_south, 400, 200);
  EXPECT_NEAR(projection.focal_length(), 100, 1e-12);
  const PicturePoint middle = projection.project(projection.X_KW() * Vec3(0, 0, 0));
  EXPECT_NEAR(middle.x, 200, 1e-12);
  EXPECT_NEAR(middle.y, 100, 1e-12);
  EXPECT_NEAR(middle.nearness, 0.5, 1e-15);
  const PicturePoint upper_right = projection.project(projection.X_KW() * Vec3(1, 0, 0.5));
  EXPECT_NEAR(upper_right.x, 250, 1e-12);
  EXPECT_NEAR(upper_right.y, 75, 1e-12);
  // Twice as far: half as large.
  EXPECT_NEAR(projection.project(projection.X_KW() * Vec3(1, 2, 0)).x, 225, 1e-12);
}

TEST(Projection, NearnessOfAPlaneIsThatOfItsPoints) {
  const Projection projection(from_the_south, 320, 200);
  const Vec3 normal_W = Vec3(0.3, -0.8, 0.5).normalized();
  const Vec3 normal = projection.X_KW().R * normal_W;
  const double offset = normal.dot(projection.X_KW() * Vec3(0, 0.5, 0));
  const NearnessPlane plane = projection.nearness_of_plane(normal, offset);
  for (const Vec3& along : {Vec3(0, 0, 0), Vec3(1, 0, 0.2), Vec3(-0.4, 0, 0.6)}) {
    // A point of the plane.
    const Vec3 p_W = Vec3(0, 0.5, 0) + along - normal_W.dot(along) * normal_W;
    const PicturePoint seen = projection.project(projection.X_KW() * p_W);
    EXPECT_NEAR(plane.constant + plane.along_x * seen.x + plane.along_y * seen.y, seen.nearness, 1e-14);
  }
}

TEST(CameraAxes, AreRightDownForwardAndDefinedForALookStraightDown) {
  EXPECT_TRUE(camera_axes(Vec3::UnitY(), Vec3::UnitZ())
                  .isApprox((Mat3() << 1, 0, 0, 0, 0, 1, 0, -1, 0).finished(), 1e-15));
  const Mat3 down = camera_axes(-Vec3::UnitZ(), Vec3::UnitZ());
  EXPECT_TRUE((down.transpose() * down).isApprox(Mat3::Identity(), 1e-15));
  EXPECT_NEAR(down.determinant(), 1, 1e-15);
}

}  // namespace
}  // namespace rigor::camera_test
