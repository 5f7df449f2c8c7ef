#include "rigor/contact/resting/resting.hpp"

#include "rigor/math/rotation.hpp"
#include "rigor/model/model_builder.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rigor::resting_test {
namespace {

constexpr double g = 9.81;

struct Scene {
  std::shared_ptr<const Model> model;
  ContactSystem system;
  std::vector<Wrench> wrenches;
};

/// Boxes of edge 1 and mass 1 in a stack on the floor z = 0, with gravity tilted by an angle about y.
Scene stack(int boxes, double mu, double tilt, const Vec3& v = Vec3::Zero()) {
  ModelBuilder builder;
  builder.set_gravity(Vec3(0, 0, -g));
  builder.add_material({"m", 1, mu, 0});
  BodyDescription floor;
  floor.name = "floor";
  floor.motion = MotionType::fixed;
  floor.shapes.push_back({HalfSpace{Vec3::UnitZ(), 0}, Vec3::Zero(), Quat::Identity(), "m", ""});
  builder.add_body(floor);
  for (int i = 0; i < boxes; ++i) {
    BodyDescription box;
    box.name = "box" + std::to_string(i);
    box.p_WU = Vec3(0, 0, 0.5 + i);
    box.velocity = v;
    box.shapes.push_back({Box{Vec3(0.5, 0.5, 0.5)}, Vec3::Zero(), Quat::Identity(), "m", ""});
    builder.add_body(box);
  }
  Scene scene{builder.build(), {}, {}};
  std::vector<int> bodies = {0};
  std::vector<BodyKinetics> kinetics = {BodyKinetics{}};
  std::vector<Contact> contacts;
  for (int i = 0; i < boxes; ++i) {
    const Body& body = scene.model->body(i + 1);
    const BodyPhase phase{Vec3(0, 0, 0.5 + i), body.q_WB, v, Vec3::Zero()};
    bodies.push_back(i + 1);
    kinetics.push_back(dynamic_kinetics(body, phase));
    const Pose below = kinetics[static_cast<std::size_t>(i)].pose();
    for (const Contact& contact :
         find_contacts(*scene.model, i, i + 1, below, kinetics.back().pose(), 1e-6)) {
      contacts.push_back(contact);
    }
  }
  scene.system = make_contact_system(contacts, bodies, kinetics);
  scene.wrenches.resize(bodies.size());
  for (std::size_t i = 1; i < bodies.size(); ++i)
    scene.wrenches[i].f_W = g * Vec3(std::sin(tilt), 0, -std::cos(tilt));
  return scene;
}

/// Force on body i by the contacts and the wrenches together.
Wrench net(const Scene& scene, const VecX& lambda, int body) {
  std::vector<Wrench> wrenches = scene.wrenches;
  add_contact_wrenches(scene.system, lambda, wrenches);
  return wrenches[static_cast<std::size_t>(body)];
}

TEST(Resting, AStackCarriesItsWeightWithForcesThatFollowItsSymmetry) {
  const int n = 4;
  const Scene scene = stack(n, 0.5, 0);
  ASSERT_EQ(scene.system.contacts.size(), static_cast<std::size_t>(4 * n));
  const RestingSolution resting = solve_resting(scene.system, scene.wrenches, 1e-9);
  ASSERT_TRUE(resting.forces.converged);
  for (std::size_t i = 0; i < scene.system.contacts.size(); ++i) {
    // Each of the four corners carries a quarter of what stands above it.
    const double above = n - static_cast<double>(i / 4);
    EXPECT_NEAR(resting.forces.lambda[3 * static_cast<Eigen::Index>(i) + 2], above * g / 4, 1e-10);
    EXPECT_NE(resting.states[i].mode, ContactMode::open);
  }
  for (int i = 1; i <= n; ++i) {
    const Wrench left = net(scene, resting.forces.lambda, i);
    EXPECT_LE(left.f_W.norm() + left.tau_W.norm(), 1e-10);
  }
}

TEST(Resting, ABlockSticksBelowTheAngleOfFrictionAndSlidesAboveIt) {
  const double mu = 0.4, limit = std::atan(mu);
  for (const double tilt : {0.5 * limit, 0.999 * limit}) {
    const Scene scene = stack(1, mu, tilt);
    const RestingSolution resting = solve_resting(scene.system, scene.wrenches, 1e-9);
    for (const ContactState& state : resting.states) EXPECT_EQ(state.mode, ContactMode::stick);
    const Wrench left = net(scene, resting.forces.lambda, 1);
    EXPECT_LE(left.f_W.norm() + left.tau_W.norm(), 1e-11);
  }
  for (const double tilt : {1.001 * limit, 1.5 * limit}) {
    const Scene scene = stack(1, mu, tilt);
    const RestingSolution resting = solve_resting(scene.system, scene.wrenches, 1e-9);
    for (const ContactState& state : resting.states) {
      EXPECT_EQ(state.mode, ContactMode::slide);
      EXPECT_LE((state.slip_W - Vec3::UnitX()).norm(), 1e-9);
    }
    const Wrench left = net(scene, resting.forces.lambda, 1);
    EXPECT_NEAR(left.f_W.x(), g * (std::sin(tilt) - mu * std::cos(tilt)), 1e-11);
    EXPECT_LE(left.tau_W.norm(), 1e-11);
    // The known modes give the same forces again.
    const VecX again = contact_forces(scene.system, resting.states, scene.wrenches, 1e-6);
    EXPECT_LE((net(scene, again, 1).f_W - left.f_W).norm(), 1e-11);
  }
}

TEST(Resting, FrictionOpposesTheSlipThatIsThere) {
  const Vec3 v(0.3, -0.4, 0);
  const Scene scene = stack(1, 0.4, 0, v);
  const RestingSolution resting = solve_resting(scene.system, scene.wrenches, 1e-9);
  for (const ContactState& state : resting.states) {
    EXPECT_EQ(state.mode, ContactMode::slide);
    EXPECT_LE((state.slip_W - v / 0.5).norm(), 1e-14);
  }
  EXPECT_LE((net(scene, resting.forces.lambda, 1).f_W + 0.4 * g * v / 0.5).norm(), 1e-11);
}

TEST(Resting, SlowSlipKeepsItsDirectionAndReversedSlipItsSide) {
  Scene scene = stack(1, 0.4, 0, Vec3(1e-8, 0, 0));
  const std::vector<ContactState> states(4, ContactState{ContactMode::slide, Vec3::UnitY()});
  // Slower than the tolerance: along the old direction.
  EXPECT_LE(
      (net(scene, contact_forces(scene.system, states, scene.wrenches, 1e-6), 1).f_W - Vec3(0, -0.4 * g, 0))
          .norm(),
      1e-11);
  // Faster: along u_t, on the side where it was.
  EXPECT_LE(
      (net(scene, contact_forces(scene.system, states, scene.wrenches, 1e-9), 1).f_W - Vec3(-0.4 * g, 0, 0))
          .norm(),
      1e-11);
  scene = stack(1, 0.4, 0, Vec3(0, -1e-3, 0));
  EXPECT_LE(
      (net(scene, contact_forces(scene.system, states, scene.wrenches, 1e-6), 1).f_W - Vec3(0, -0.4 * g, 0))
          .norm(),
      1e-11);
}

TEST(Resting, ProjectionPutsVelocitiesOnWhatTheModesAllow) {
  Scene scene = stack(2, 0.4, 0);
  scene.system.kinetics[1].v = Vec3(1e-4, 2e-4, -3e-4);
  scene.system.kinetics[2].w = Vec3(2e-4, -1e-4, 1e-4);
  const double before = kinetic_energy(scene.system);
  std::vector<ContactState> states(8, ContactState{ContactMode::stick, Vec3::Zero()});
  for (std::size_t i = 4; i < 8; ++i) states[i] = {ContactMode::slide, Vec3::UnitX()};
  apply_impulses(projection_impulses(scene.system, states), scene.system);
  EXPECT_LE(kinetic_energy(scene.system), before);
  const VecX u = relative_velocities(scene.system);
  for (Eigen::Index i = 0; i < 8; ++i) {
    EXPECT_LE(std::abs(u[3 * i + 2]), 1e-18);
    if (i < 4) {
      EXPECT_LE(u.segment<2>(3 * i).norm(), 1e-18);
    }
  }
}

TEST(FindContacts, ListsACornerThatTwoShapesShareOnce) {
  ModelBuilder builder;
  BodyDescription floor, ell;
  floor.name = "floor";
  floor.motion = MotionType::fixed;
  floor.shapes.push_back({HalfSpace{Vec3::UnitZ(), 0}});
  builder.add_body(floor);
  ell.name = "ell";
  // Two unit cubes side by side: six corners at the bottom, two of them shared.
  for (const double x : {-0.5, 0.5}) ell.shapes.push_back({Box{Vec3(0.5, 0.5, 0.5)}, Vec3(x, 0, 0.5)});
  builder.add_body(ell);
  const auto model = builder.build();
  const Pose X_WB{rotation_matrix(model->body(1).q_WB), model->body(1).p_WB};
  const std::vector<Contact> contacts = find_contacts(*model, 0, 1, Pose{}, X_WB, 1e-6);
  EXPECT_EQ(contacts.size(), 6u);
}

}  // namespace
}  // namespace rigor::resting_test
