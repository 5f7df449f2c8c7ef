#include "model/joint_samples.hpp"

#include "rigor/model/drives.hpp"
#include "rigor/model/limits.hpp"

#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace rigor::joint_refusals_test {
namespace {

using samples::errors_of;
using samples::joint_of;
using samples::JointDescription;
using samples::jointed_bodies;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kDegree = std::numbers::pi / 180;

std::string errors_with(JointType type, const JointAxis& axis) {
  JointDescription joint = joint_of(type);
  joint.axes = {axis};
  return errors_of(joint);
}

TEST(JointRefused, ForItsBodies) {
  JointDescription joint = joint_of(JointType::ball);
  joint.bodies = {"a", "wal"};
  EXPECT_EQ(errors_of(joint), "joint 'j': unknown body 'wal'; did you mean 'wall'?\n");
  joint.bodies = {"a", "a"};
  EXPECT_EQ(errors_of(joint), "joint 'j': both ends are on the same body\n");
  joint.bodies = {"world", "wall"};
  EXPECT_EQ(errors_of(joint), "joint 'j': it moves nothing: none of its bodies is dynamic\n");
  joint.bodies = {"a"};
  EXPECT_EQ(errors_of(joint), "joint 'j': it names 1 bodies, must name 2\n");
}

TEST(JointRefused, ForItsName) {
  JointDescription joint = joint_of(JointType::ball);
  joint.name = "";
  EXPECT_EQ(errors_of(joint), "joint '': the name is empty\n");
  ModelBuilder builder = jointed_bodies();
  builder.add_joint(joint_of(JointType::ball), "1: ");
  builder.add_joint(joint_of(JointType::hinge), "2: ");
  EXPECT_EQ(builder.check(),
            (std::vector<std::string>{"2: joint 'j': there is already a joint of this name"}));
}

TEST(JointRefused, ForItsAnchors) {
  JointDescription joint = joint_of(JointType::hinge);
  joint.anchors.clear();
  EXPECT_EQ(errors_of(joint), "joint 'j': it has 0 anchors, must have 1\n");
  joint.anchors = {Vec3(0, kNan, 0)};
  EXPECT_EQ(errors_of(joint),
            "joint 'j': anchor is [0, nan, 0] m, each number must be from -1e+09 to 1e+09 m\n");
  joint = joint_of(JointType::distance);
  joint.anchors[1] = joint.anchors[0];
  EXPECT_EQ(errors_of(joint), "joint 'j': distance of its anchors is 0 m, must be from 1e-09 to 1e+09 m\n");
  joint.anchors.pop_back();
  EXPECT_EQ(errors_of(joint), "joint 'j': it has 1 anchors, must have 2\n");
}

TEST(JointRefused, ForItsAxes) {
  JointDescription joint = joint_of(JointType::hinge);
  joint.axis = Vec3::Zero();
  EXPECT_EQ(errors_of(joint), "joint 'j': axis is [0, 0, 0], must have a direction\n");
  joint.axis = Vec3(0, 0, kNan);
  EXPECT_EQ(errors_of(joint), "joint 'j': axis is [0, 0, nan], each number must be from -1e+09 to 1e+09\n");
  joint = joint_of(JointType::hinge);
  joint.second_axis = Vec3::UnitX();
  EXPECT_EQ(errors_of(joint), "joint 'j': only universal and planar joints have a second_axis\n");
  joint = joint_of(JointType::universal);
  joint.second_axis.reset();
  EXPECT_EQ(errors_of(joint),
            "joint 'j': second_axis is missing: the axis on the second body, perpendicular to axis\n");
  joint.second_axis = Vec3::Zero();
  EXPECT_EQ(errors_of(joint), "joint 'j': second_axis is [0, 0, 0], must have a direction\n");
  joint.second_axis = Vec3(1, 0, 1);
  EXPECT_EQ(errors_of(joint),
            "joint 'j': second_axis [1, 0, 1] is at 45 deg to axis [0, 0, 1], must be perpendicular\n");
}

TEST(JointRefused, ForItsPitch) {
  JointDescription joint = joint_of(JointType::screw);
  joint.parameter = 0;
  EXPECT_EQ(errors_of(joint), "joint 'j': pitch is 0 m, must not be 0; a hinge turns without sliding\n");
  joint.parameter = kNan;
  EXPECT_EQ(errors_of(joint), "joint 'j': pitch is nan m, must be from -1e+09 to 1e+09 m\n");
}

TEST(JointRefused, ForLimitsOfAnAngle) {
  const auto errors = [](double lower, double upper) {
    return errors_with(JointType::hinge, {.lower = lower * kDegree, .upper = upper * kDegree});
  };
  EXPECT_EQ(errors(10, 90),
            "joint 'j': limits are [10 deg, 90 deg], must hold the coordinate at t = 0, 0 deg\n");
  EXPECT_EQ(errors(-90, -10),
            "joint 'j': limits are [-90 deg, -10 deg], must hold the coordinate at t = 0, 0 deg\n");
  EXPECT_EQ(errors(90, -30),
            "joint 'j': limits are [90 deg, -30 deg], the first must be less than the second\n");
  EXPECT_EQ(errors(0, 0), "joint 'j': limits are [0 deg, 0 deg], the first must be less than the second\n");
  EXPECT_EQ(errors(-200, 30),
            "joint 'j': limits are [-200 deg, 30 deg], both must be from -180 deg to 180 deg\n");
  EXPECT_EQ(errors(-limits::infinity, 30), "");  // From C++ one side can be open.
  EXPECT_EQ(errors(kNan, limits::infinity), "joint 'j': limits are [nan deg, inf deg], must be numbers\n");
}

TEST(JointRefused, ForLimitsOfALength) {
  EXPECT_EQ(errors_with(JointType::slider, {.lower = 0.5, .upper = 1}),
            "joint 'j': limits are [0.5 m, 1 m], must hold the coordinate at t = 0, 0 m\n");
  EXPECT_EQ(errors_with(JointType::distance, {.lower = 0, .upper = 4.5}),
            "joint 'j': limits are [0 m, 4.5 m], must hold the coordinate at t = 0, 5 m\n");
  EXPECT_EQ(errors_with(JointType::distance, {.lower = 0, .upper = 5}), "");
}

TEST(JointRefused, ForLimitsOfABall) {
  const std::string allowed =
      ": the angle of a ball joint begins at 0 deg, so the first must be 0 deg and the second > 0 deg and at "
      "most 180 deg\n";
  EXPECT_EQ(errors_with(JointType::ball, {.lower = 0.5 * kDegree, .upper = 30 * kDegree}),
            "joint 'j': limits are [0.5 deg, 30 deg]" + allowed);
  EXPECT_EQ(errors_with(JointType::ball, {.lower = 0, .upper = 200 * kDegree}),
            "joint 'j': limits are [0 deg, 200 deg]" + allowed);
}

TEST(JointRefused, ForNumbersAlongItsCoordinates) {
  EXPECT_EQ(errors_with(JointType::hinge,
                        {.restitution = 1.5, .stiffness = -1, .rest = 4, .damping = -2, .friction = kNan}),
            "joint 'j': restitution is 1.5, must be from 0 to 1\n"
            "joint 'j': stiffness is -1 N m/rad, must be from 0 to 1e+15 N m/rad\n"
            "joint 'j': damping is -2 N m s/rad, must be from 0 to 1e+15 N m s/rad\n"
            "joint 'j': friction is nan N m, must be from 0 to 1e+15 N m\n"
            "joint 'j': rest is 229.1831181 deg, must be from -180 deg to 180 deg\n");
  EXPECT_EQ(errors_with(JointType::slider, {.motor = JointMotor{kNan, -1}}),
            "joint 'j': velocity of the motor is nan m/s, must be from -1e+08 to 1e+08 m/s\n"
            "joint 'j': max_force of the motor is -1 N, must be at least 0\n");
  JointDescription joint = joint_of(JointType::cylindrical);
  joint.axes = {{}, {.damping = -1}};
  EXPECT_EQ(errors_of(joint),
            "joint 'j': coordinate 1: damping is -1 N m s/rad, must be from 0 to 1e+15 N m s/rad\n");
}

TEST(JointRefused, ForActionsThatItCannotHave) {
  EXPECT_EQ(errors_with(JointType::fixed, {}),
            "joint 'j': it describes 1 coordinates, but a fixed joint has none\n");
  JointDescription joint = joint_of(JointType::universal);
  joint.axes.resize(3);
  EXPECT_EQ(errors_of(joint), "joint 'j': it describes 3 coordinates, but a universal joint has 2\n");
  const std::string of_a_ball =
      "joint 'j': a ball joint has neither a motor nor friction: it turns about no axis of its own; use "
      "damping, or a universal joint\n";
  EXPECT_EQ(errors_with(JointType::ball, {.motor = JointMotor{}}), of_a_ball);
  EXPECT_EQ(errors_with(JointType::ball, {.friction = 1}), of_a_ball);
  EXPECT_EQ(errors_with(JointType::distance, {.stiffness = 1}),
            "joint 'j': it keeps its distance, so motor, stiffness, damping and friction do nothing; give it "
            "limits\n");
  EXPECT_EQ(errors_with(JointType::distance, {.lower = 4, .upper = 6, .stiffness = 1}), "");
}

TEST(JointRefused, ForWhatAGearTies) {
  JointDescription gear;
  gear.name = "gear";
  gear.type = JointType::gear;
  gear.parameter = 2;
  const auto errors = [](const JointDescription& joint) {
    ModelBuilder builder = jointed_bodies();
    for (const JointType type : {JointType::hinge, JointType::slider, JointType::ball, JointType::fixed}) {
      JointDescription tied = joint_of(type);
      tied.name = joint_type_name(type);
      builder.add_joint(tied);
    }
    builder.add_joint(joint);
    std::string text;
    for (const std::string& message : builder.check()) text += message + "\n";
    return text;
  };
  gear.joints = {"hinge", "slider"};
  EXPECT_EQ(errors(gear), "");
  gear.parameter = 0;
  EXPECT_EQ(errors(gear), "joint 'gear': ratio is 0, must not be 0\n");
  gear.parameter = kNan;
  EXPECT_EQ(errors(gear), "joint 'gear': ratio is nan, must be from -1e+06 to 1e+06\n");
  gear.parameter = 1;
  gear.joints = {"hinge", "slidr"};
  EXPECT_EQ(errors(gear), "joint 'gear': unknown joint 'slidr'; did you mean 'slider'?\n");
  gear.joints = {"hinge", "hinge"};
  EXPECT_EQ(errors(gear), "joint 'gear': it ties a joint to itself\n");
  gear.joints = {"hinge"};
  EXPECT_EQ(errors(gear), "joint 'gear': it names 1 joints, must name 2\n");
  const std::string no_coordinate = " joint has no coordinate that a gear can tie\n";
  for (const char* const type : {"ball", "fixed", "gear"}) {
    gear.joints = {"hinge", type};
    EXPECT_EQ(errors(gear),
              "joint 'gear': it ties '" + std::string(type) + "', but a " + type + no_coordinate);
  }
  gear.joints = {"hinge", "slider"};
  gear.bodies = {"a", "b"};
  EXPECT_EQ(errors(gear), "joint 'gear': a gear names joints, not bodies\n");
}

TEST(JointRefused, OnceForAllThatComeFromOnePlace) {
  ModelBuilder builder = jointed_bodies();
  for (int i = 0; i < 3; ++i) {
    JointDescription joint = joint_of(JointType::hinge);
    joint.name += std::to_string(i);
    joint.axis = Vec3::Zero();
    builder.add_joint(joint, "here: ");
  }
  EXPECT_EQ(builder.check(),
            (std::vector<std::string>{"here: joint 'j0': axis is [0, 0, 0], must have a direction"}));
}

TEST(JointRefused, ForTheNumberOfTheirTypeThatIsZeroOrFarOff) {
  for (const JointTraits& traits : joint_table) {
    const JointParameter& own = traits.parameter;
    if (own.key == nullptr || traits.type == JointType::gear) continue;
    JointDescription joint = joint_of(traits.type);
    joint.parameter = 0;
    EXPECT_NE(errors_of(joint).find(std::string(own.key) + " is 0"), std::string::npos) << traits.name;
    joint.parameter = 2 * own.range.highest;
    EXPECT_NE(errors_of(joint).find(std::string(own.key) + " is "), std::string::npos) << traits.name;
    joint.parameter = own.range.highest;
    EXPECT_EQ(errors_of(joint), "") << traits.name;
  }
}

// The table decides; docs/cpp.md and docs/scene.md name the same types.
TEST(Efforts, ActAlongAxesThatAreFixedInBothBodies) {
  EXPECT_EQ(types_that_take_effort(), "hinge, slider, cylindrical, the angle of planar, screw");
}

TEST(JointRefused, BeyondTheLimitOfTheirNumber) {
  ModelBuilder builder;
  for (std::size_t i = 0; i <= limits::joint_count; ++i) builder.add_joint({});
  EXPECT_EQ(builder.check(),
            (std::vector<std::string>{"the scene has 100001 joints, must be at most 100000"}));
}

}  // namespace
}  // namespace rigor::joint_refusals_test
