#include "rigor/view/3d/framing.hpp"

#include "view/view_scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rigor::framing_test {
namespace {

TEST(Framing, OneBallFillsThePictureButForTheMargin) {
  // From the distance d a ball of radius r is seen at the half angle asin(r/d); it should be that of the
  // picture less 7 % of its tangent.
  const FramedBall ball{Vec3(1, 2, 3), 0.5};
  const double angle = 40 * M_PI / 180;
  const Camera camera = framing_camera({&ball, 1}, Vec3::UnitY(), Vec3::UnitZ(), angle, 1.5);
  const double half = std::atan(0.93 * std::tan(angle / 2));
  EXPECT_NEAR((camera.eye - ball.p_W).norm(), ball.radius / std::sin(half), 1e-9);
  EXPECT_LT((camera.target - ball.p_W).norm(), 1e-9);
}

TEST(Framing, ManyPointsTouchTheMarginOnBothSidesOfOneDirection) {
  const std::vector<FramedBall> points = {{Vec3(-3, 0, 0), 0}, {Vec3(3, 1, 0.2), 0}, {Vec3(0, -1, 0.5), 0}};
  const Camera camera = framing_camera(points, Vec3(0.2, 1, -0.3), Vec3::UnitZ(), 0.6, 16.0 / 9);
  const Projection projection(camera, 1600, 900);
  double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
  for (const FramedBall& point : points) {
    const PicturePoint seen = projection.project(projection.X_KW() * point.p_W);
    left = std::min(left, seen.x), right = std::max(right, seen.x);
    top = std::min(top, seen.y), bottom = std::max(bottom, seen.y);
  }
  EXPECT_NEAR(left, 800 * 0.07, 1e-6);
  EXPECT_NEAR(right, 1600 - 800 * 0.07, 1e-6);
  EXPECT_NEAR(top - 0, 900 - bottom, 1e-6);
}

/// Five balls within a metre; the last flies off at v for 10 s.
Camera camera_of_flight(double v) {
  std::string bodies;
  for (int i = 0; i < 5; ++i)
    bodies += "  - {name: b" + std::to_string(i) + ", mass: 1, position: [" + std::to_string(0.25 * i) +
              ", 0, 0], shapes: [{type: sphere, radius: 0.1}]}\n";
  const Scene scene = scene_of(bodies);
  std::vector<Pose> poses;
  for (int k = 0; k <= 100; ++k) {
    for (int i = 0; i < 5; ++i)
      poses.push_back({Mat3::Identity(), Vec3(0.25 * i + (i == 4 ? v * 0.1 * k : 0), 0, 0)});
  }
  return make_camera(make_drawn_scene(*scene.model), poses, {}, 16.0 / 9);
}

TEST(Framing, ABodyThatFliesOffDoesNotMakeTheRestTiny) {
  const Camera near = camera_of_flight(0.1), far = camera_of_flight(1e6);
  const double near_distance = (near.eye - near.target).norm(), far_distance = (far.eye - far.target).norm();
  EXPECT_LT(far_distance, 4 * near_distance);
  // The slow one is in the picture till its end, at x = 2 m.
  const Projection projection(near, 1600, 900);
  const PicturePoint seen = projection.project(projection.X_KW() * Vec3(2, 0, 0));
  EXPECT_GT(seen.x, 0);
  EXPECT_LT(seen.x, 1600);
}

TEST(Framing, WishesAreFollowed) {
  const Scene scene = scene_of(two_balls);
  const DrawnScene drawn = make_drawn_scene(*scene.model);
  const std::vector<Pose> poses = start_poses(*scene.model);
  const Camera camera = make_camera(drawn, poses, {Vec3(1, 2, 3), Vec3(0, 0, 1), 0.7}, 1);
  EXPECT_EQ(camera.eye, Vec3(1, 2, 3));
  EXPECT_EQ(camera.target, Vec3(0, 0, 1));
  EXPECT_EQ(camera.field_of_view, 0.7);
  const Camera at_eye = make_camera(drawn, poses, {Vec3(1, 2, 3), Vec3(1, 2, 3), {}}, 1);
  EXPECT_NE(at_eye.eye, at_eye.target);
}

TEST(Framing, ASceneWithNothingToSeeHasACamera) {
  const Scene scene =
      scene_of("  - {name: g, motion: static, shapes: [{type: plane, normal: [0, 0, 1], offset: 0}]}\n");
  const Camera camera = make_camera(make_drawn_scene(*scene.model), start_poses(*scene.model), {}, 1);
  EXPECT_TRUE(camera.eye.allFinite() && camera.target.allFinite());
}

}  // namespace
}  // namespace rigor::framing_test
