#include "rigor/view/3d/drawn_joints.hpp"

#include "rigor/view/3d/framing.hpp"
#include "rigor/view/3d/renderer.hpp"
#include "rigor/view/page/page_run.hpp"
#include "view/page_reading.hpp"
#include "view/view_scenes.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace rigor::drawn_joints_test {
namespace {

using Json = nlohmann::json;

/// Places of a few metres after two rotations.
constexpr double kRounding = 1e-14;

/// A turned bob whose centre of mass is off its origin, and a block; joints end the scene.
Scene jointed_scene(const std::string& rest) {
  return scene_of(
      "  - {name: bob, position: [1, 2, 3], rpy: [0.1, 0.2, 0.3],\n"
      "     inertia: {mass: 1, center: [0.1, 0, 0], moments: [1e-9, 2e-9, 2e-9]}}\n"
      "  - {name: block, position: [4, 2, 3], shapes: [{type: box, size: [1, 1, 1]}]}\n"
      "  - {name: wall, motion: static, position: [0, 9, 0], shapes: [{type: box, size: [1, 1, 1]}]}\n" +
      rest);
}

const std::string pivot = "joints: [{name: pivot, type: ball, bodies: [world, bob], anchor: [1, 2, 5]}]\n";

std::vector<DrawnShape> joint_parts(const DrawnScene& drawn) {
  std::vector<DrawnShape> parts;
  for (const DrawnShape& shape : drawn.shapes) {
    if (shape.is_joint) parts.push_back(shape);
  }
  return parts;
}

TEST(DrawnJoints, ARodGoesFromTheCentreOfMassToABallAtTheAnchor) {
  const Scene scene = jointed_scene(pivot);
  const std::vector<DrawnShape> parts = joint_parts(make_drawn_scene(*scene.model));
  ASSERT_EQ(parts.size(), 2u);
  const std::vector<Pose> X_WU = start_poses(*scene.model);
  const Pose X_WR = X_WU[0] * parts[0].X_US;
  const Cylinder& rod = std::get<Cylinder>(parts[0].shape);
  const Vec3 center = scene.model->body(0).p_WB, anchor(1, 2, 5);
  EXPECT_LT((X_WR * Vec3(0, 0, -rod.half_length) - center).norm(), kRounding);
  EXPECT_LT((X_WR * Vec3(0, 0, rod.half_length) - anchor).norm(), kRounding);
  EXPECT_LT(rod.radius, 0.02 * rod.half_length * 2);
  EXPECT_NEAR(parts[0].radius, std::hypot(rod.radius, rod.half_length), kRounding);
  ASSERT_TRUE(std::holds_alternative<Sphere>(parts[1].shape));
  EXPECT_LT((X_WU[0] * parts[1].X_US.p - anchor).norm(), kRounding);
  EXPECT_GT(std::get<Sphere>(parts[1].shape).radius, rod.radius);
}

TEST(DrawnJoints, RodsAreOnTheBodiesThatMoveOnly) {
  const Scene scene = jointed_scene(
      "joints: [{name: j, type: hinge, bodies: [block, wall], anchor: [4, 2, 5], axis: [1, 0, 0]}]\n");
  const std::vector<DrawnShape> parts = joint_parts(make_drawn_scene(*scene.model));
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].body, 1);
  EXPECT_EQ(parts[1].body, 1);
}

TEST(DrawnJoints, AJointAtBothCentresOfMassHasNoRod) {
  const Scene scene =
      jointed_scene("joints: [{name: j, type: slider, bodies: [world, block], axis: [1, 0, 0]}]\n");
  EXPECT_TRUE(joint_parts(make_drawn_scene(*scene.model)).empty());
}

TEST(DrawnJoints, APointOnARodIsSeenAsABall) {
  const DrawnScene drawn = make_drawn_scene(*jointed_scene(pivot).model);
  ASSERT_EQ(drawn.shapes[0].body, 0);
  ASSERT_TRUE(std::holds_alternative<Sphere>(drawn.shapes[0].shape));
  const Scene scene = jointed_scene(pivot);
  const double reach = (Vec3(1, 2, 5) - scene.model->body(0).p_WB).norm();
  EXPECT_NEAR(std::get<Sphere>(drawn.shapes[0].shape).radius, 0.05 * reach, kRounding);
}

TEST(DrawnJoints, ADistanceJointAndASpringAreLinesBetweenTheirPoints) {
  const Scene scene = jointed_scene(
      "joints: [{name: d, type: distance, bodies: [bob, block], anchors: [[1, 2, 4], [4, 3, 3]]}]\n"
      "forces: [{type: spring, between: [world, block], points: [[5, 5, 5], [0.5, 0, 0]], stiffness: 1}]\n");
  const DrawnScene drawn = make_drawn_scene(*scene.model);
  ASSERT_EQ(drawn.lines.size(), 2u);
  std::vector<Pose> X_WU = start_poses(*scene.model);
  EXPECT_LT((drawn.lines[0].ends(X_WU)[0] - Vec3(1, 2, 4)).norm(), kRounding);
  EXPECT_LT((drawn.lines[0].ends(X_WU)[1] - Vec3(4, 3, 3)).norm(), kRounding);
  EXPECT_EQ(drawn.lines[1].ends(X_WU)[0], Vec3(5, 5, 5));
  EXPECT_LT((drawn.lines[1].ends(X_WU)[1] - Vec3(4.5, 2, 3)).norm(), kRounding);
  X_WU[1].p += Vec3(0, 0, 1);
  EXPECT_LT((drawn.lines[1].ends(X_WU)[1] - Vec3(4.5, 2, 4)).norm(), kRounding) << "they go with the bodies";
}

TEST(DrawnJoints, ALineIsSeenInThePictureAndItsWorldsEndIsInIt) {
  const std::string body = "  - {name: b, mass: 1, shapes: [{type: sphere, radius: 0.1}]}\n";
  const Scene bare = scene_of(body);
  const Scene hung = scene_of(
      body + "joints: [{name: d, type: distance, bodies: [world, b], anchors: [[0, 0, 0.4], [0, 0, 0]]}]\n");
  const DrawnScene drawn = make_drawn_scene(*hung.model);
  const std::vector<Pose> poses = start_poses(*hung.model);
  const Camera camera = make_camera(drawn, poses, {}, 1);
  constexpr int size = 200;
  const Projection projection(camera, size, size);
  const PicturePoint end = projection.project(projection.X_KW() * Vec3(0, 0, 0.4));
  EXPECT_GT(end.y, 0);
  EXPECT_LT(end.y, size);
  const Image with = Renderer().draw(drawn, poses, camera, size, size);
  const Image without = Renderer().draw(make_drawn_scene(*bare.model), poses, camera, size, size);
  // Half way up, where the ball does not reach, the line is all that there is.
  const PicturePoint middle = projection.project(projection.X_KW() * Vec3(0, 0, 0.25));
  const int x = static_cast<int>(middle.x), y = static_cast<int>(middle.y);
  EXPECT_FALSE(std::equal(with.pixel(x, y), with.pixel(x, y) + 3, without.pixel(x, y)));
  EXPECT_TRUE(std::equal(with.pixel(5, y), with.pixel(5, y) + 3, without.pixel(5, y)));
}

TEST(PageRun, TellsWhereTheJointsAreAndTheirAxes) {
  const Scene scene = jointed_scene(
      "joints:\n"
      "  - {name: h, type: hinge, bodies: [world, block], anchor: [4, 2, 5], axis: [0, 3, 4]}\n"
      "  - {name: u, type: universal, bodies: [wall, block], anchor: [4, 2, 5], axis: [0, 0, 1], "
      "second_axis: "
      "[1, 0, 0]}\n"
      "  - {name: b, type: ball, bodies: [world, bob], anchor: [1, 2, 5]}\n"
      "  - {name: g, type: gear, joints: [h, u], ratio: 2}\n");
  PageRun run(scene, make_initial_state(*scene.model));
  run.add(make_initial_state(*scene.model), {}, {});
  const Json joints = Json::parse(test::inflated(run.finish({}).at(0)))["joints"];
  ASSERT_EQ(joints.size(), 3u) << "a gear has no place";
  EXPECT_EQ(joints[0]["name"], "h");
  EXPECT_EQ(joints[0]["type"], "hinge");
  EXPECT_EQ(joints[0]["bodies"], (Json{-1, 1}));
  EXPECT_EQ(joints[0]["points"][0], (Json{4.0, 2.0, 5.0}));
  EXPECT_NEAR(joints[0]["axes"][0][1].get<double>(), 0.6, kRounding);
  EXPECT_TRUE(joints[0]["axes"][1].is_null());
  const Vec3 p_BK = scene.model->joint(1).X_BK.p;
  EXPECT_EQ(joints[1]["points"][1], (Json{p_BK.x(), p_BK.y(), p_BK.z()}));
  EXPECT_NEAR(joints[1]["axes"][1][0].get<double>(), 1, kRounding);
  EXPECT_TRUE(joints[2]["axes"][0].is_null());
}

}  // namespace
}  // namespace rigor::drawn_joints_test
