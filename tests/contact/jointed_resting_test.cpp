#include "rigor/contact/impact/joint_stops.hpp"
#include "rigor/contact/resting/resting.hpp"
#include "rigor/model/model_builder.hpp"

#include "random_vectors.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rigor::jointed_resting_test {
namespace {

constexpr double g = 9.81;

struct Scene {
  std::shared_ptr<const Model> model;
  ContactSystem system;
  std::vector<Wrench> wrenches;
};

/// Boxes of edge 1 in a row on the floor, 1.5 m apart, with hinges about y between them whose axes are as
/// given; their stops are contacts too.
Scene hinged_boxes(int boxes, const JointAxis& axis) {
  ModelBuilder builder;
  builder.set_gravity(Vec3(0, 0, -g));
  builder.add_material({"m", 1, 0.4, 0});
  BodyDescription floor;
  floor.name = "floor";
  floor.motion = MotionType::fixed;
  floor.shapes.push_back({HalfSpace{Vec3::UnitZ(), 0}, Vec3::Zero(), Quat::Identity(), "m", ""});
  builder.add_body(floor);
  for (int i = 0; i < boxes; ++i) {
    BodyDescription box;
    box.name = "box" + std::to_string(i);
    box.p_WU = Vec3(1.5 * i, 0, 0.5);
    box.shapes.push_back({Box{Vec3(0.5, 0.5, 0.5)}, Vec3::Zero(), Quat::Identity(), "m", ""});
    builder.add_body(box);
    if (i == 0) continue;
    ModelBuilder::JointDescription joint;
    joint.name = "hinge" + std::to_string(i);
    joint.type = JointType::hinge;
    joint.bodies = {"box" + std::to_string(i - 1), "box" + std::to_string(i)};
    joint.anchors = {Vec3(1.5 * i - 0.75, 0, 0.5)};
    joint.axis = Vec3::UnitY();
    joint.axes = {axis};
    builder.add_joint(joint);
  }
  Scene scene{builder.build(), {}, {}};
  std::vector<int> bodies = {0}, joints;
  std::vector<BodyKinetics> kinetics = {BodyKinetics{}};
  std::vector<Contact> contacts;
  for (int i = 0; i < boxes; ++i) {
    const Body& body = scene.model->body(i + 1);
    const BodyPhase phase{Vec3(1.5 * i, 0, 0.5), body.q_WB, Vec3::Zero(), Vec3::Zero()};
    bodies.push_back(i + 1);
    kinetics.push_back(dynamic_kinetics(body, phase));
    if (i > 0) joints.push_back(i - 1);
    for (const Contact& contact :
         find_contacts(*scene.model, 0, i + 1, kinetics[0].pose(), kinetics.back().pose(), 1e-6))
      contacts.push_back(contact);
  }
  for (const Contact& stop : joint_stops(*scene.model, joints, bodies, kinetics, 1e-6))
    contacts.push_back(stop);
  scene.system = make_contact_system(*scene.model, contacts, bodies, kinetics,
                                     std::make_shared<JointSystem>(*scene.model, joints, bodies, kinetics));
  scene.wrenches.resize(bodies.size());
  for (std::size_t i = 1; i < bodies.size(); ++i)
    scene.wrenches[i].f_W = Vec3(0, 0, -g / scene.system.kinetics[i].inverse_mass);
  return scene;
}

/// Accelerations and forces of both spaces; motion space must not have handed over.
void expect_same(const Scene& scene) {
  const RestingSolution motion = solve_resting(scene.system, scene.wrenches, 1e-9);
  const RestingSolution contact =
      solve_resting(scene.system, scene.wrenches, 1e-9, {RestingSpace::contact, LcpName::dantzig});
  EXPECT_TRUE(motion.forces.method == "motion" || motion.forces.method == "proximal motion" ||
              motion.forces.method == "least constraint")
      << motion.forces.method;
  ASSERT_TRUE(motion.forces.converged && contact.forces.converged);
  const double weight = g / scene.system.kinetics[1].inverse_mass;
  EXPECT_LE((motion.forces.w - contact.forces.w).cwiseAbs().maxCoeff(), 1e-10 * g);
  EXPECT_LE((motion.forces.lambda - contact.forces.lambda).norm(), 1e-9 * weight);
}

TEST(JointedResting, ContactsThroughHingesAreTheSameInBothSpaces) {
  Scene scene = hinged_boxes(3, JointAxis{});
  ASSERT_EQ(scene.system.contacts.size(), 12u);
  expect_same(scene);
  // One box is pulled up and the hinges with it; a torque turns the first over.
  scene.wrenches[2].f_W += Vec3(0, 0, 1.7 * g / scene.system.kinetics[2].inverse_mass);
  expect_same(scene);
  scene.wrenches[1].tau_W += Vec3(0.2, 3, 0.1) * g / scene.system.kinetics[1].inverse_mass;
  expect_same(scene);
}

TEST(JointedResting, DryFrictionMotorsAndLimitsAreTheSameInBothSpaces) {
  const double mass = 1 / hinged_boxes(1, {}).system.kinetics[1].inverse_mass;
  JointAxis rubs;
  rubs.friction = 0.3 * mass;
  JointAxis driven;
  driven.motor = JointMotor{.velocity = 0.5, .max_force = 0.4 * mass};
  JointAxis limited;
  limited.lower = 0;
  limited.friction = 0.1 * mass;
  test::Random random(4);
  for (const JointAxis& axis : {rubs, driven, limited}) {
    for (int trial = 0; trial < 6; ++trial) {
      Scene scene = hinged_boxes(3, axis);
      EXPECT_GT(scene.system.contacts.size(), 12u);
      for (std::size_t i = 1; i < scene.wrenches.size(); ++i) {
        scene.wrenches[i].f_W += 0.04 * trial * mass * g * random.vector();
        scene.wrenches[i].tau_W += 0.02 * trial * mass * g * random.vector();
      }
      SCOPED_TRACE(trial);
      expect_same(scene);
    }
  }
}

}  // namespace
}  // namespace rigor::jointed_resting_test
