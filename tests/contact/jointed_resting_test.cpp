#include "rigor/contact/resting/resting.hpp"

#include "jointed_row.hpp"
#include "random_vectors.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace rigor::jointed_resting_test {
namespace {

constexpr double g = 9.81;

struct Scene {
  std::shared_ptr<const Model> model;
  ContactSystem system;
  std::vector<Wrench> wrenches;
};

/// A row at rest with hinges about y whose axes are as given.
Scene hinged_boxes(int boxes, const JointAxis& axis) {
  ModelBuilder::JointDescription joint;
  joint.type = JointType::hinge;
  joint.axis = Vec3::UnitY();
  joint.axes = {axis};
  test::JointedRow row =
      test::jointed_row(boxes, joint, [] { return std::pair<Vec3, Vec3>(Vec3::Zero(), Vec3::Zero()); });
  Scene scene{std::move(row.model), std::move(row.system), {}};
  scene.wrenches.resize(scene.system.kinetics.size());
  for (std::size_t i = 1; i < scene.wrenches.size(); ++i)
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

/// Whether contacts with these states and forces have the accelerations that their modes say, by Newton's law
/// for the bodies with their joints.
void expect_modes_hold(const Scene& scene, const std::vector<ContactState>& states, const VecX& lambda) {
  std::vector<Wrench> wrenches = scene.wrenches;
  add_contact_wrenches(scene.system, lambda, wrenches);
  const VecX w = free_contact_accelerations(scene.system, wrenches);
  for (std::size_t i = 0; i < states.size(); ++i) {
    const Vec3 of_contact = w.segment<3>(3 * static_cast<Eigen::Index>(i));
    EXPECT_NEAR(of_contact.z(), 0, 1e-11 * g) << i;
    if (states[i].mode == ContactMode::stick) {
      EXPECT_LE(of_contact.norm(), 1e-11 * g) << i;
    }
  }
}

TEST(JointedResting, ForcesOfKnownModesHoldFewAndManyContacts) {
  test::Random random(11);
  for (const int boxes : {2, 3}) {
    Scene scene = hinged_boxes(boxes, JointAxis{});
    const std::size_t count = scene.system.contacts.size();
    ASSERT_EQ(count, 4u * static_cast<std::size_t>(boxes));
    const double weight = g / scene.system.kinetics[1].inverse_mass;

    // At rest each corner bears a quarter of its box, the share of least norm.
    const std::vector<ContactState> sticking(count, {ContactMode::stick, Vec3::Zero()});
    const VecX at_rest = contact_forces(scene.system, sticking, scene.wrenches, 1e-9);
    for (std::size_t i = 0; i < count; ++i) {
      const Vec3 force = at_rest.segment<3>(3 * static_cast<Eigen::Index>(i));
      EXPECT_LE((force - Vec3(0, 0, 0.25 * weight)).norm(), 1e-10 * weight) << i;
    }

    // Pushed and twisted at random, with one box that slides.
    for (std::size_t i = 1; i < scene.wrenches.size(); ++i) {
      scene.wrenches[i].f_W += weight * random.vector();
      scene.wrenches[i].tau_W += 0.3 * weight * random.vector();
    }
    std::vector<ContactState> states = sticking;
    for (std::size_t i = 0; i < 4; ++i) states[i] = {ContactMode::slide, Vec3(1, 0, 0)};
    const VecX pushed = contact_forces(scene.system, states, scene.wrenches, 1e-9);
    expect_modes_hold(scene, states, pushed);
  }
}

TEST(JointedResting, FewContactsAreTheSameInBothSpaces) {
  Scene scene = hinged_boxes(2, JointAxis{});
  ASSERT_EQ(scene.system.contacts.size(), 8u);
  test::Random random(12);
  const double weight = g / scene.system.kinetics[1].inverse_mass;
  for (int trial = 0; trial < 20; ++trial) {
    for (std::size_t i = 1; i < scene.wrenches.size(); ++i) {
      scene.wrenches[i].f_W = weight * (0.4 * random.vector() - Vec3::UnitZ());
      scene.wrenches[i].tau_W = 0.2 * weight * random.vector();
    }
    const RestingSolution few = solve_resting(scene.system, scene.wrenches, 1e-9);
    const RestingSolution contact =
        solve_resting(scene.system, scene.wrenches, 1e-9, {RestingSpace::contact, LcpName::dantzig});
    ASSERT_TRUE(few.forces.converged && contact.forces.converged) << trial;
    EXPECT_LE((few.forces.w - contact.forces.w).cwiseAbs().maxCoeff(), 1e-10 * g) << trial;
    EXPECT_LE((few.forces.lambda - contact.forces.lambda).norm(), 1e-9 * weight) << trial;
  }
}

}  // namespace
}  // namespace rigor::jointed_resting_test
