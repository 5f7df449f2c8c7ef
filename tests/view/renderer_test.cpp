#include "rigor/view/3d/renderer.hpp"

#include "view/view_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace rigor::renderer_test {
namespace {

const Camera from_the_south{Vec3(0, -4, 1.5), Vec3(0, 0, 0.3), Vec3::UnitZ(), M_PI / 4};
const std::string ground =
    "  - {name: g, motion: static, shapes: [{type: plane, normal: [0, 0, 1], offset: 0}]}\n";

Image drawn(const std::string& bodies, const Camera& camera = from_the_south, int width = 320,
            int height = 180) {
  const Scene scene = scene_of(bodies);
  return Renderer().draw(make_drawn_scene(*scene.model), start_poses(*scene.model), camera, width, height);
}

int brightness(const Image& image, const Vec2& at) {
  const std::uint8_t* const pixel = image.pixel(static_cast<int>(at.x()), static_cast<int>(at.y()));
  return pixel[0] + pixel[1] + pixel[2];
}
Vec2 place_of(const Vec3& p_W, const Image& image, const Camera& camera) {
  const Projection projection(camera, image.width, image.height);
  const PicturePoint point = projection.project(projection.X_KW() * p_W);
  return {point.x, point.y};
}

TEST(Renderer, TheSameInputGivesTheSameBitsAlsoFromAUsedRenderer) {
  const Scene scene = scene_of(
      ground +
      "  - {name: box, position: [-0.5, 0, 0.4], rpy: [0.3, 0.4, 0.5], mass: 1, shapes: [{type: box, size: "
      "[0.3, 0.4, 0.5]}]}\n"
      "  - {name: can, position: [0.3, 0, 0.4], rpy: [1, 0, 0], mass: 1, shapes: [{type: cylinder, radius: "
      "0.2, length: 0.4}]}\n"
      "  - {name: ball, position: [0.9, 0.2, 0.4], mass: 1, shapes: [{type: sphere, radius: 0.2}]}\n");
  const DrawnScene drawn_scene = make_drawn_scene(*scene.model);
  const std::vector<Pose> poses = start_poses(*scene.model);
  Renderer used;
  const Image first = used.draw(drawn_scene, poses, from_the_south, 320, 180);
  used.draw(drawn_scene, poses, Camera{}, 100, 50);
  EXPECT_EQ(used.draw(drawn_scene, poses, from_the_south, 320, 180), first);
  EXPECT_EQ(Renderer().draw(drawn_scene, poses, from_the_south, 320, 180), first);
}

TEST(Renderer, WhatIsNearerHidesWhatIsBehindInAnyOrder) {
  const std::string red =
      "  - {name: red, position: [0, -1, 0.5], mass: 1, shapes: [{type: box, size: [1, 0.1, 1], color: "
      "\"#f00\"}]}\n";
  const std::string blue =
      "  - {name: blue, position: [0, 1, 0.5], mass: 1, shapes: [{type: sphere, radius: 0.4, color: "
      "\"#00f\"}]}\n";
  const Camera level{Vec3(0, -4, 0.5), Vec3(0, 0, 0.5), Vec3::UnitZ(), M_PI / 4};
  for (const std::string& bodies : {red + blue, blue + red}) {
    const Image image = drawn(bodies, level);
    const std::uint8_t* const middle = image.pixel(160, 90);
    EXPECT_GT(middle[0], 100);
    EXPECT_EQ(middle[2], 0);
  }
  EXPECT_GT(drawn(blue, level).pixel(160, 90)[2], 100);
}

TEST(Renderer, ABallThrowsItsShadowAwayFromTheSun) {
  const Vec3 center(0, 0, 0.8);
  const Image image = drawn(
      ground + "  - {name: b, position: [0, 0, 0.8], mass: 1, shapes: [{type: sphere, radius: 0.2}]}\n");
  const Vec3 sun = sun_direction(from_the_south, Vec3::UnitZ());
  const Vec3 shadow = center - center.z() / sun.z() * sun;
  ASSERT_NEAR(shadow.z(), 0, 1e-12);
  // The same ground without the ball.
  const Image empty = drawn(ground);
  const Vec2 in_shadow = place_of(shadow, image, from_the_south);
  EXPECT_LT(brightness(image, in_shadow), 0.8 * brightness(empty, in_shadow));
  // Two radii beside the shadow's middle it is as light as without the ball; the ball's radius is 0.2 m, its
  // shadow an ellipse of 0.2 m and 0.2 m / sin(height of the sun).
  for (const Vec3& aside : {Vec3(0.55, 0, 0), Vec3(-0.55, 0, 0), Vec3(0, 0.55, 0)}) {
    const Vec2 at = place_of(shadow + aside, image, from_the_south);
    EXPECT_EQ(brightness(image, at), brightness(empty, at));
  }
}

TEST(Renderer, EdgesAreMixedBySharesOfTheirPixel) {
  // A black wall whose edge crosses the picture slightly inclined: pixels along it take several shades.
  const Camera level{Vec3(0, -4, 0), Vec3::Zero(), Vec3::UnitZ(), M_PI / 4};
  const Image image = drawn(
      "  - {name: w, position: [0, 0, -1], rpy: [0, 0.05, 0], motion: static, shapes: [{type: box, size: [9, "
      "0.1, 2], color: \"#000\"}]}\n",
      level);
  int shades = 0;
  for (int x = 0; x < image.width; ++x) {
    for (int y = 0; y < image.height; ++y) shades += image.pixel(x, y)[0] > 20 && image.pixel(x, y)[0] < 210;
  }
  // One pixel in each column is crossed by the edge, and of those most are neither all black nor all light.
  EXPECT_GT(shades, image.width / 2);
  EXPECT_LT(shades, 2 * image.width);
}

TEST(Renderer, CornersBehindTheEyeAreCutOff) {
  // The eye is above a board that reaches behind it.
  const Camera above{Vec3(0, -1, 0.5), Vec3(0, 1, 0), Vec3::UnitZ(), M_PI / 3};
  const Image image = drawn(
      "  - {name: b, motion: static, position: [0, 0, -0.05], shapes: [{type: box, size: [20, 20, 0.1], "
      "color: \"#0f0\"}]}\n",
      above);
  for (int x = 0; x < image.width; x += 7) {
    const std::uint8_t* const pixel = image.pixel(x, image.height - 1);
    EXPECT_GT(pixel[1], 100);
    EXPECT_EQ(pixel[0], 0);
  }
}

TEST(Renderer, APlaneSeenFromBelowHidesNothing) {
  const Camera below{Vec3(0, -4, -1), Vec3(0, 0, 0.5), Vec3::UnitZ(), M_PI / 4};
  const std::string ball =
      "  - {name: b, position: [0, 0, 0.5], mass: 1, shapes: [{type: sphere, radius: 0.3}]}\n";
  EXPECT_EQ(drawn(ground + ball, below).pixel(160, 90)[0],
            drawn("  - {name: g, motion: static}\n" + ball, below).pixel(160, 90)[0]);
}

TEST(ShadowMap, LightIsNothingBehindABallAllBesideItAndHalfAtItsEdge) {
  const Scene scene =
      scene_of("  - {name: b, position: [0, 0, 2], mass: 1, shapes: [{type: sphere, radius: 0.5}]}\n");
  const DrawnScene drawn_scene = make_drawn_scene(*scene.model);
  const std::vector<ShownShape> placed = {{&drawn_scene.shapes[0], Pose{Mat3::Identity(), Vec3(0, 0, 2)}}};
  ShadowMap map;
  map.draw(placed, Vec3::UnitZ(), {Vec3(0, 0, 1), 4}, 512);
  map.set_camera(Pose{});
  const auto light = [&](double x, double z) {
    return map.light(Eigen::Vector3f(static_cast<float>(x), 0, static_cast<float>(z)),
                     Eigen::Vector3f::UnitZ());
  };
  const double texel = 8.0 / 512;
  EXPECT_EQ(light(0, 0), 0);
  EXPECT_EQ(light(0.5 - 3 * texel, 0), 0);
  EXPECT_EQ(light(0.5 + 3 * texel, 0), 1);
  EXPECT_NEAR(light(0.5, 0), 0.5, 0.25);
  EXPECT_EQ(light(0, 2.6), 1);
  // Outside the map, and below it where it knows of nothing.
  EXPECT_EQ(light(100, 0), 1);
  EXPECT_EQ(light(2, -50), 1);
}

}  // namespace
}  // namespace rigor::renderer_test
