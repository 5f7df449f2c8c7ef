#include "model/joint_samples.hpp"

#include "rigor/model/limits.hpp"

#include <gtest/gtest.h>
#include <cmath>

namespace rigor::joint_builder_test {
namespace {

using samples::body_of;
using samples::joint_of;
using samples::JointDescription;
using samples::jointed_bodies;

constexpr JointType kWithFrames[] = {JointType::fixed,  JointType::ball,      JointType::hinge,
                                     JointType::slider, JointType::universal, JointType::cylindrical,
                                     JointType::planar, JointType::screw,     JointType::point_on_line};
/// Of positions of a few metres that went through two rotations.
constexpr double kRounding = 1e-14;

std::shared_ptr<const Model> model_with(const JointDescription& joint) {
  ModelBuilder builder = jointed_bodies();
  builder.add_joint(joint);
  return builder.build();
}

/// Pose in W at t = 0 of a frame that is given on a body.
Pose start_pose(const Model& model, int body, const Pose& X_BF) {
  if (body == world_body) return X_BF;
  return Pose{rotation_matrix(model.body(body).q_WB), model.body(body).p_WB} * X_BF;
}

TEST(JointBuilder, BothFramesAreAtTheAnchorAlongTheAxisAtTheStart) {
  for (const JointType type : kWithFrames) {
    JointDescription description = joint_of(type);
    description.axis = Vec3(0, 3, 4);
    const std::shared_ptr<const Model> model = model_with(description);
    const Joint& joint = model->joint(0);
    const Pose X_WF = start_pose(*model, joint.body_A, joint.X_AF);
    const Pose X_WK = start_pose(*model, joint.body_B, joint.X_BK);
    EXPECT_LT((X_WF.p - Vec3(1, 1, 1)).norm(), kRounding) << joint_type_name(type);
    EXPECT_LT((X_WF.R.col(2) - Vec3(0, 0.6, 0.8)).norm(), kRounding) << joint_type_name(type);
    EXPECT_LT((X_WF.p - X_WK.p).norm(), kRounding) << joint_type_name(type);
    EXPECT_LT((X_WF.R - X_WK.R).norm(), kRounding) << joint_type_name(type);
    EXPECT_NEAR(X_WF.R.determinant(), 1, kRounding) << joint_type_name(type);
  }
}

TEST(JointBuilder, TheSecondAxisIsTheFramesX) {
  for (const JointType type : {JointType::universal, JointType::planar}) {
    JointDescription description = joint_of(type);
    description.axis = Vec3(0, 3, 4);
    // Off by 1e-4 rad as rounded numbers in a file are: the frame is orthonormal nevertheless.
    description.second_axis = Vec3(0, 8, -6 + 1e-3);
    const std::shared_ptr<const Model> model = model_with(description);
    const Pose X_WF = start_pose(*model, 0, model->joint(0).X_AF);
    EXPECT_LT((X_WF.R.col(0) - Vec3(0, 0.8, -0.6)).norm(), kRounding);
    EXPECT_LT((X_WF.R.transpose() * X_WF.R - Mat3::Identity()).norm(), kRounding);
  }
}

TEST(JointBuilder, APlanarJointsXIsTheWorldsWhereItCanBe) {
  JointDescription description = joint_of(JointType::planar);
  std::shared_ptr<const Model> model = model_with(description);
  EXPECT_LT((start_pose(*model, 0, model->joint(0).X_AF).R - Mat3::Identity()).norm(), kRounding);
  description.axis = Vec3(1, 0, 0);
  model = model_with(description);
  EXPECT_LT((start_pose(*model, 0, model->joint(0).X_AF).R.col(0) - Vec3::UnitY()).norm(), kRounding);
}

TEST(JointBuilder, ADistanceJointHasItsAnchorsOnTheBodiesAndTheLengthOfTheStart) {
  const std::shared_ptr<const Model> model = model_with(joint_of(JointType::distance));
  const Joint& joint = model->joint(0);
  EXPECT_LT((start_pose(*model, 0, joint.X_AF).p - Vec3(1, 1, 1)).norm(), kRounding);
  EXPECT_LT((start_pose(*model, 1, joint.X_BK).p - Vec3(4, 5, 1)).norm(), kRounding);
  EXPECT_EQ(joint.length, 5);
}

TEST(JointBuilder, AJointToTheWorldHasItsFrameInTheWorld) {
  JointDescription description = joint_of(JointType::hinge);
  description.bodies = {"world", "b"};
  const std::shared_ptr<const Model> model = model_with(description);
  const Joint& joint = model->joint(0);
  EXPECT_EQ(joint.body_A, world_body);
  EXPECT_EQ(joint.body_B, 1);
  EXPECT_EQ(joint.X_AF.p, Vec3(1, 1, 1));
}

TEST(JointBuilder, WithoutAnAnchorItIsAtTheCentreOfMassOfTheDynamicBody) {
  for (const JointType type : {JointType::fixed, JointType::slider, JointType::planar}) {
    JointDescription description = joint_of(type);
    description.anchors.clear();
    EXPECT_LT(model_with(description)->joint(0).X_BK.p.norm(), kRounding);
    description.bodies = {"a", "world"};
    EXPECT_LT(model_with(description)->joint(0).X_AF.p.norm(), kRounding);
    description.bodies = {"a", "wall"};
    EXPECT_LT(model_with(description)->joint(0).X_AF.p.norm(), kRounding);
  }
}

TEST(JointBuilder, MissingCoordinatesAreFree) {
  const std::shared_ptr<const Model> model = model_with(joint_of(JointType::planar));
  ASSERT_EQ(model->joint(0).axes.size(), 3u);
  for (const JointAxis& axis : model->joint(0).axes) {
    EXPECT_FALSE(axis.is_limited());
    EXPECT_FALSE(axis.motor);
    EXPECT_EQ(axis.stiffness + axis.damping + axis.friction, 0);
  }
}

TEST(JointBuilder, ABallJointsAngleHasNoLowerLimit) {
  JointDescription description = joint_of(JointType::ball);
  description.axes = {JointAxis{.lower = 0, .upper = 1}};
  const JointAxis axis = model_with(description)->joint(0).axes[0];
  EXPECT_EQ(axis.lower, -limits::infinity);
  EXPECT_EQ(axis.upper, 1);
}

TEST(JointBuilder, LimitsMayBeginAtTheStartAndReachHalfATurn) {
  JointDescription description = joint_of(JointType::hinge);
  const double half_turn = std::acos(-1.0);
  description.axes = {JointAxis{.lower = 0, .upper = half_turn, .motor = JointMotor{3}}};
  const JointAxis axis = model_with(description)->joint(0).axes[0];
  EXPECT_EQ(axis.lower, 0);
  EXPECT_EQ(axis.upper, half_turn);
  EXPECT_EQ(axis.motor->max_force, limits::infinity);
}

TEST(JointBuilder, AGearTiesJointsByTheirPlaceInTheSceneWhateverTheOrder) {
  ModelBuilder builder = jointed_bodies();
  JointDescription gear;
  gear.name = "gear";
  gear.type = JointType::gear;
  gear.joints = {"second", "first"};
  gear.parameter = -2;
  builder.add_joint(gear);
  JointDescription hinge = joint_of(JointType::hinge);
  hinge.name = "first";
  builder.add_joint(hinge);
  JointDescription slider = joint_of(JointType::slider);
  slider.name = "second";
  slider.bodies = {"world", "a"};
  builder.add_joint(slider);
  const std::shared_ptr<const Model> model = builder.build();
  const Joint& joint = model->joint(0);
  EXPECT_EQ(joint.first_joint, 2);
  EXPECT_EQ(joint.second_joint, 1);
  EXPECT_EQ(joint.parameter, -2);
  EXPECT_EQ(joint.body_A, world_body);
  EXPECT_EQ(joint.body_B, world_body);
  EXPECT_EQ(model->joint(1).name, "first");
}

TEST(JointBuilder, TheBodiesOfAJointDoNotCollideUnlessItSaysSo) {
  ModelBuilder builder;
  for (const char* const name : {"a", "b", "c", "d"}) builder.add_body(body_of(Sphere{1}, name));
  JointDescription ball = joint_of(JointType::ball);
  ball.name = "last_pair";
  ball.bodies = {"d", "c"};
  builder.add_joint(ball);
  ball.name = "first_pair";
  ball.bodies = {"c", "a"};
  builder.add_joint(ball);
  ball.name = "colliding";
  ball.bodies = {"b", "c"};
  ball.collide = true;
  builder.add_joint(ball);
  const std::shared_ptr<const Model> model = builder.build();
  EXPECT_TRUE(model->may_collide(0, 1));
  EXPECT_FALSE(model->may_collide(0, 2));
  EXPECT_FALSE(model->may_collide(2, 0));
  EXPECT_TRUE(model->may_collide(1, 2));
  EXPECT_FALSE(model->may_collide(2, 3));
}

}  // namespace
}  // namespace rigor::joint_builder_test
