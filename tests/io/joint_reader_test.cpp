#include "rigor/core/input_error.hpp"
#include "rigor/io/scene/scene_reader.hpp"
#include "rigor/io/trajectory/fingerprint.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <string>
#include <vector>

namespace rigor::joint_reader_test {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
/// Of an angle that goes from degrees to radians in one product and one quotient.
constexpr double kRounding = 1e-15;

/// Bodies `a` at (1, 0, 0) and `b` at (0, 2, 0), and these joints.
std::string with_joints(const std::string& joints) {
  return "rigor: 1\nbodies:\n"
         "  - {name: a, position: [1, 0, 0], shapes: [{type: sphere, radius: 0.1}]}\n"
         "  - {name: b, position: [0, 2, 0], shapes: [{type: sphere, radius: 0.1}]}\n"
         "joints: [" +
         joints + "]\n";
}

Scene scene_of(const std::string& text, const std::vector<std::string>& overrides = {}) {
  return parse_scene(text, "s.yaml", ".", overrides);
}

Joint joint_of(const std::string& keys) {
  return scene_of(with_joints("{name: j, " + keys + "}")).model->joint(0);
}

std::string message_of(const std::string& joints) {
  try {
    scene_of(with_joints(joints));
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(JointReader, ReadsTheContractsExampleOfAHinge) {
  const Joint joint = joint_of(
      "type: hinge, bodies: [a, b], anchor: [0, 0, 1], axis: [0, 1, 0], limits: [-30 deg, 90 deg], motor: "
      "{velocity: 2, max_force: 5}, stiffness: 3, rest: 10 deg, damping: 4, friction: 6, restitution: 0.5, "
      "collide: false");
  EXPECT_EQ(joint.name, "j");
  EXPECT_EQ(joint.type, JointType::hinge);
  EXPECT_EQ(joint.body_A, 0);
  EXPECT_EQ(joint.body_B, 1);
  // The bodies lie along the world's axes, so only their places count.
  EXPECT_LT((joint.X_AF.p - Vec3(-1, 0, 1)).norm(), kRounding);
  EXPECT_LT((joint.X_BK.p - Vec3(0, -2, 1)).norm(), kRounding);
  EXPECT_LT((joint.X_AF.R.col(2) - Vec3::UnitY()).norm(), kRounding);
  ASSERT_EQ(joint.axes.size(), 1u);
  const JointAxis& axis = joint.axes[0];
  EXPECT_NEAR(axis.lower, -30 * kDegree, kRounding);
  EXPECT_NEAR(axis.upper, 90 * kDegree, kRounding);
  EXPECT_EQ(axis.motor->velocity, 2);
  EXPECT_EQ(axis.motor->max_force, 5);
  EXPECT_EQ(axis.stiffness, 3);
  EXPECT_NEAR(axis.rest, 10 * kDegree, kRounding);
  EXPECT_EQ(axis.damping, 4);
  EXPECT_EQ(axis.friction, 6);
  EXPECT_EQ(axis.restitution, 0.5);
}

TEST(JointReader, ReadsEveryType) {
  const std::string two = ", bodies: [a, b]", at = ", anchor: [0, 0, 0]", axis = ", axis: [0, 0, 2]";
  EXPECT_EQ(joint_of("type: fixed" + two).type, JointType::fixed);
  EXPECT_EQ(joint_of("type: ball" + two + at + ", limits: [0, 1]").axes[0].upper, 1);
  EXPECT_EQ(joint_of("type: slider" + two + axis + ", limits: [-1, 2]").axes[0].lower, -1);
  EXPECT_EQ(joint_of("type: screw" + two + at + axis + ", pitch: 0.5").parameter, 0.5);
  EXPECT_EQ(joint_of("type: cylindrical" + two + at + axis).axes.size(), 2u);
  const Joint universal = joint_of("type: universal" + two + at + axis + ", second_axis: [0, 3, 0]");
  EXPECT_LT((universal.X_BK.R.col(0) - Vec3::UnitY()).norm(), kRounding);
  const Joint planar = joint_of("type: planar" + two + axis + ", second_axis: [0, 3, 0]");
  EXPECT_LT((planar.X_AF.R.col(0) - Vec3::UnitY()).norm(), kRounding);
  const Scene geared = scene_of(with_joints("{name: p, type: hinge, bodies: [world, a], anchor: [1, 0, 0]" +
                                            axis + "}, {name: q, type: slider, bodies: [world, b]" + axis +
                                            "}, {name: g, type: gear, joints: [p, q], ratio: -0.5}"));
  EXPECT_EQ(geared.model->joint(2).type, JointType::gear);
  EXPECT_EQ(geared.model->joint(2).second_joint, 1);
  EXPECT_EQ(geared.model->joint(2).parameter, -0.5);
  EXPECT_EQ(geared.model->joint(0).body_A, -1);
}

TEST(JointReader, ADistanceJointsSpringRestsWhereItStarts) {
  const std::string keys = "type: distance, bodies: [a, b], anchors: [[1, 0, 0], [1, 3, 4]]";
  EXPECT_EQ(joint_of(keys).length, 5);
  EXPECT_EQ(joint_of(keys + ", limits: [1, 6], stiffness: 2").axes[0].rest, 5);
  EXPECT_EQ(joint_of(keys + ", limits: [1, 6], stiffness: 2, rest: 3").axes[0].rest, 3);
}

TEST(JointReader, CoordinatesAreReadInTheirOrder) {
  const Joint joint = joint_of(
      "type: planar, bodies: [a, b], axis: [0, 0, 1], coordinates: [{limits: [-1, 1]}, {}, {limits: [-90 "
      "deg, "
      "90 deg], motor: {velocity: 7}}]");
  ASSERT_EQ(joint.axes.size(), 3u);
  EXPECT_EQ(joint.axes[0].upper, 1);
  EXPECT_FALSE(joint.axes[1].is_limited());
  EXPECT_NEAR(joint.axes[2].upper, 90 * kDegree, kRounding);
  EXPECT_EQ(joint.axes[2].motor->velocity, 7);
  EXPECT_EQ(joint.axes[2].motor->max_force, std::numeric_limits<double>::infinity());
}

TEST(JointReader, CollideDecidesWhetherTheBodiesMayTouch) {
  const std::string keys = "{name: j, type: ball, bodies: [a, b], anchor: [0, 0, 0]";
  EXPECT_FALSE(scene_of(with_joints(keys + "}")).model->may_collide(0, 1));
  EXPECT_FALSE(scene_of(with_joints(keys + ", collide: false}")).model->may_collide(0, 1));
  EXPECT_TRUE(scene_of(with_joints(keys + ", collide: true}")).model->may_collide(0, 1));
}

TEST(JointReader, IsChangedByName) {
  const Scene scene = scene_of(with_joints("{name: j, type: slider, bodies: [a, b], axis: [0, 0, 1]}"),
                               {"joints.j.motor.velocity=3"});
  EXPECT_EQ(scene.model->joint(0).axes[0].motor->velocity, 3);
}

const char* const kChain = R"(
rigor: 1
bodies:
  - name: link
    position: [0.5, 0, 0]
    repeat: {count: [1000, 1, 1], spacing: [1, 0, 0]}
    shapes: [{type: box, size: [0.5, 0.1, 0.1]}]
joints:
  - {name: hook, type: ball, bodies: [world, "link[0,0,0]"], anchor: [0, 0, 0]}
  - {name: pin, type: ball, bodies: ["link[i,0,0]", "link[i+1,0,0]"], anchor: [1, 0, 0],
     repeat: {count: [999, 1, 1], spacing: [1, 0, 0]}}
)";

TEST(JointRepeat, MakesAChainOfRepeatedBodies) {
  const std::shared_ptr<const Model> model = scene_of(kChain).model;
  ASSERT_EQ(model->joints().size(), 1000u);
  for (int i = 1; i < 1000; ++i) {
    const Joint& joint = model->joint(i);
    EXPECT_EQ(joint.name, "pin[" + std::to_string(i - 1) + ",0,0]");
    EXPECT_EQ(joint.body_A, i - 1);
    EXPECT_EQ(joint.body_B, i);
    // Each pin is half a link from either centre of mass, up to the rounding of places up to 1000 m.
    EXPECT_LT((joint.X_AF.p.cwiseAbs() - Vec3(0.5, 0, 0)).norm(), 1e-12);
    EXPECT_LT((joint.X_BK.p.cwiseAbs() - Vec3(0.5, 0, 0)).norm(), 1e-12);
  }
}

TEST(JointRepeat, IndicesStandForLettersInAllPlaces) {
  const Scene scene = scene_of(
      R"(
rigor: 1
bodies:
  - {name: knot, repeat: {count: [2, 3, 2], spacing: [1, 1, 1]}, shapes: [{type: sphere, radius: 0.1}]}
joints:
  - {name: x, type: ball, bodies: ["knot[i,j,k]", "knot[i+1,2-0,k]"], anchor: [0, 0, 0]}
)",
      {"joints.x.bodies=[\"knot[k,j+2,i]\", \"knot[1,j-0,i]\"]", "joints.x.repeat={count: [2, 1, 1]}"});
  const Model& model = *scene.model;
  ASSERT_EQ(model.joints().size(), 2u);
  EXPECT_EQ(model.body(model.joint(1).body_A).name, "knot[0,2,1]");
  EXPECT_EQ(model.body(model.joint(1).body_B).name, "knot[1,0,1]");
}

TEST(JointRepeat, RefusesIndicesWithoutABodyOnce) {
  std::string text = kChain;
  text.replace(text.find("999"), 3, "1001");
  try {
    scene_of(text);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    ASSERT_EQ(error.messages().size(), 1u);
    EXPECT_TRUE(error.messages()[0].starts_with(
        "s.yaml:10:5: joint 'pin[999,0,0]': unknown body 'link[1000,0,0]'; did you mean 'link["))
        << error.what();
  }
}

TEST(JointRefused, InAFile) {
  const std::string two = "bodies: [a, b]", at = ", anchor: [0, 0, 0]", axis = ", axis: [0, 0, 1]";
  const std::vector<std::pair<std::string, std::string>> mistakes = {
      {"{name: j}",
       "s.yaml:5:10: joint 'j': the key 'type' is missing; one of: fixed, ball, hinge, slider, universal, "
       "cylindrical, planar, distance, screw, gear, point_on_line"},
      {"{name: j, type: hing}", "s.yaml:5:26: joint 'j': unknown type 'hing'; did you mean 'hinge'?"},
      {"{type: fixed, " + two + "}", "s.yaml:5:10: joint 0 (fixed): the key 'name' is missing: a text"},
      {"{name: j, type: ball, " + two + "}",
       "s.yaml:5:10: joint 'j' (ball): the key 'anchor' is missing: 3 numbers [x, y, z] (m)"},
      {"{name: j, type: ball, bodies: [a, bb]" + at + "}",
       "s.yaml:5:10: joint 'j': unknown body 'bb'; did you mean 'b'?"},
      {"{name: j, type: ball, " + two + at + ", motor: {}}",
       "s.yaml:5:67: unknown key 'motor' in joint 'j' (ball); it is a key of a hinge; one of: type, name, "
       "bodies, anchor, limits, restitution, stiffness, rest, damping, collide, repeat"},
      {"{name: j, type: cylindrical, " + two + at + axis + ", limits: [0, 1]}",
       "s.yaml:5:91: unknown key 'limits' in joint 'j' (cylindrical); it has several coordinates: write it "
       "in "
       "'coordinates', a list of one mapping for each"},
      {"{name: j, type: cylindrical, " + two + at + axis + ", coordinates: [{}]}",
       "s.yaml:5:104: joint 'j' (cylindrical): coordinates has 1 entries, must have 2: displacement, angle"},
      {"{name: j, type: cylindrical, " + two + at + axis + ", coordinates: [{limits: [0, 30 deg]}, {}]}",
       "s.yaml:5:118: coordinate 0 of joint 'j' (cylindrical): limits must be 2 numbers [lowest, highest] "
       "(m), found the text '30 deg'"},
      {"{name: j, type: hinge, " + two + at + axis + ", limits: 30 deg}",
       "s.yaml:5:93: joint 'j' (hinge): limits must be 2 angles [lowest, highest]: numbers (rad) or texts "
       "such as 30 deg, found the text '30 deg'"},
      {"{name: j, type: hinge, " + two + at + axis + ", limits: [10 deg, 20 deg]}",
       "s.yaml:5:10: joint 'j': limits are [10 deg, 20 deg], must hold the coordinate at t = 0, 0 deg"},
      {"{name: j, type: hinge, " + two + at + axis + ", collide: 1}",
       "s.yaml:5:94: joint 'j' (hinge): collide must be true or false, found the number '1'"},
      {"{name: j, type: hinge, " + two + at + axis + ", motor: {velocty: 1}}",
       "s.yaml:5:93: unknown key 'velocty' in motor of joint 'j' (hinge); did you mean 'velocity'?"},
      {"{name: j, type: distance, " + two + ", anchors: [[0, 0, 0]]}",
       "s.yaml:5:61: joint 'j' (distance): anchors has 1 points, must have 2"},
      {"{name: j, type: fixed, " + two + ", repeat: {count: [100000, 2, 1]}}",
       "s.yaml:5:57: joint 'j' (fixed): with it the scene has 200000 joints, must be at most 100000"},
      {"5", "s.yaml:5:10: joint 0: must be a mapping of keys, found the number '5'"},
      // A gear is not blamed for a joint that cannot be read.
      {"{name: j, type: slider, " + two + "}, {name: g, type: gear, joints: [j, k], ratio: 1}",
       "s.yaml:5:10: joint 'j' (slider): the key 'axis' is missing: 3 numbers [x, y, z]"},
  };
  for (const auto& [joints, message] : mistakes) EXPECT_EQ(message_of(joints), message) << joints;
}

TEST(JointReader, ABodyWithoutShapesIsMeantWhereAJointSpeaksOfIt) {
  const std::string bodies = "rigor: 1\nbodies:\n  - {name: a, inertia: {mass: 1, moments: [1, 1, 1]}";
  const std::string one = "}\njoints: [{name: j, type: ball, bodies: [world, a], anchor: [0, 0, 0]}]\n";
  const std::string grid =
      ", repeat: {count: [2, 1, 1]}}\njoints: [{name: j, type: ball, bodies: [world, \"a[0,0,0]\"], anchor: "
      "[0, 0, 0]}]\n";
  EXPECT_EQ(scene_of(bodies + one).warnings, std::vector<std::string>{});
  EXPECT_EQ(scene_of(bodies + grid).warnings, std::vector<std::string>{});
  EXPECT_EQ(scene_of(bodies + "}\n").warnings.size(), 1u);
}

TEST(JointReader, AMotorWithoutABoundAgainstALimitIsWarnedOf) {
  const auto warnings = [](const std::string& limits, const std::string& motor) {
    return scene_of(
               "rigor: 1\nbodies: [{name: a, position: [1, 0, 0], shapes: [{type: sphere, radius: 0.1}]}]\n"
               "joints: [{name: j, type: hinge, bodies: [world, a], anchor: [0, 0, 0], axis: [0, 1, 0]" +
               limits + ", motor: {velocity: " + motor + "}}]\n")
        .warnings;
  };
  for (const char* const speed : {"-3", "3"}) {
    const std::vector<std::string> told = warnings(", limits: [-0.2, 0.5]", speed);
    ASSERT_EQ(told.size(), 1u);
    EXPECT_NE(told.front().find("motor of joint 'j' (hinge) has no max_force"), std::string::npos)
        << told.front();
  }
  EXPECT_TRUE(warnings(", limits: [-0.2, 0.5]", "3, max_force: 5").empty());
  EXPECT_TRUE(warnings("", "3").empty());
}

TEST(Fingerprint, DiffersWithEveryPropertyOfAJoint) {
  const std::string front =
      "rigor: 1\nbodies:\n"
      "  - {name: a, shapes: [{type: sphere, radius: 0.1}]}\n"
      "  - {name: b, position: [0, 2, 0], shapes: [{type: sphere, radius: 0.1}]}\n";
  const std::string hinge = "type: hinge, bodies: [a, b], ", place = "anchor: [0, 0, 0], axis: [0, 0, 1]";
  std::set<std::uint64_t> prints;
  const std::vector<std::string> joints = {
      "",
      "{name: j, " + hinge + place + "}",
      "{name: k, " + hinge + place + "}",
      "{name: j, type: cylindrical, bodies: [a, b], " + place + "}",
      "{name: j, type: hinge, bodies: [b, a], " + place + "}",
      "{name: j, " + hinge + "anchor: [0, 0, 0.5], axis: [0, 0, 1]}",
      "{name: j, " + hinge + "anchor: [0, 0, 0], axis: [0, 1, 1]}",
      "{name: j, " + hinge + place + ", collide: true}",
      "{name: j, " + hinge + place + ", limits: [-1, 1]}",
      "{name: j, " + hinge + place + ", limits: [-1, 2]}",
      "{name: j, " + hinge + place + ", limits: [-1, 2], restitution: 0.5}",
      "{name: j, " + hinge + place + ", stiffness: 1}",
      "{name: j, " + hinge + place + ", stiffness: 1, rest: 0.5}",
      "{name: j, " + hinge + place + ", damping: 1}",
      "{name: j, " + hinge + place + ", friction: 1}",
      "{name: j, " + hinge + place + ", motor: {}}",
      "{name: j, " + hinge + place + ", motor: {velocity: 1}}",
      "{name: j, " + hinge + place + ", motor: {max_force: 1}}",
      "{name: j, type: screw, bodies: [a, b], pitch: 1, " + place + "}",
      "{name: j, type: screw, bodies: [a, b], pitch: 2, " + place + "}",
  };
  for (const std::string& joint : joints) {
    const Scene scene = scene_of(front + "joints: [" + joint + "]\n");
    EXPECT_TRUE(prints.insert(fingerprint(*scene.model, scene.method, 0.01)).second) << joint;
  }
}

}  // namespace
}  // namespace rigor::joint_reader_test
