#include "rigor/dynamics/environment.hpp"

#include "rigor/math/rotation.hpp"
#include "rigor/model/model_builder.hpp"

#include <gtest/gtest.h>

namespace rigor::environment_test {
namespace {

using Force = ModelBuilder::ForceDescription;

BodyDescription ball(const std::string& name, const Vec3& x) {
  BodyDescription body;
  body.name = name;
  body.p_WU = x;
  body.mass = 2;
  body.shapes.push_back({Sphere{0.1}});
  return body;
}

Force force(Force::Type type, std::vector<std::string> bodies) {
  Force result{};
  result.type = type;
  result.bodies = std::move(bodies);
  return result;
}

Environment::BodyView at(const Vec3& x, const Vec3& v = Vec3::Zero(), const Vec3& w = Vec3::Zero(),
                         const Mat3& R = Mat3::Identity()) {
  return {x, v, w, R, true};
}

Wrench wrench_on(const Environment& environment, int body, const std::vector<Environment::BodyView>& views) {
  std::vector<Wrench> wrenches(1);
  const auto view = [&](int i) { return views[static_cast<std::size_t>(i)]; };
  environment.apply_env_forces(std::vector<int>{body}, view, wrenches);
  return wrenches.front();
}

TEST(Environment, GravityAndForcesAtTheCentreGiveASteadyAcceleration) {
  ModelBuilder builder;
  builder.set_gravity(Vec3(0, 0, -9.81));
  builder.add_body(ball("a", Vec3::Zero()));
  Force push = force(Force::Type::constant, {"a"});
  push.vector = Vec3(4, 0, 0);
  builder.add_force(push);
  const auto model = builder.build();
  const Environment environment(*model);
  EXPECT_EQ(environment.steady_acceleration(0), Vec3(2, 0, -9.81));
  EXPECT_FALSE(environment.is_forced(0));
  const Wrench wrench = wrench_on(environment, 0, {at(Vec3::Zero())});
  EXPECT_EQ(wrench.f_W, Vec3(4, 0, -2 * 9.81));
  EXPECT_TRUE(wrench.tau_W.isZero(0));
  // The potential falls by the work of the forces.
  EXPECT_DOUBLE_EQ(environment.potential(0, Vec3(1, 0, 3)) - environment.potential(0, Vec3::Zero()),
                   2 * 9.81 * 3 - 4);
}

TEST(Environment, AForceFixedInTheBodyTurnsWithIt) {
  ModelBuilder builder;
  builder.set_gravity(Vec3::Zero());
  builder.add_body(ball("a", Vec3::Zero()));
  Force push = force(Force::Type::constant, {"a"});
  push.vector = Vec3(1, 0, 0);
  push.frame_is_body = true;
  push.points = {Vec3(0, 0.05, 0)};
  builder.add_force(push);
  const auto model = builder.build();
  const Environment environment(*model);
  EXPECT_TRUE(environment.is_forced(0));
  const Mat3 R = rotation_matrix(rotation_exp(Vec3(0, 0, M_PI / 2)));
  const Environment::BodyView view = at(Vec3(1, 2, 3), Vec3(0, 5, 0), Vec3(0, 0, 2), R);
  const Wrench wrench = wrench_on(environment, 0, {view});
  EXPECT_LE((wrench.f_W - Vec3(0, 1, 0)).norm(), 1e-15);
  // Arm R (0, 0.05, 0) = (-0.05, 0, 0): torque (-0.05, 0, 0) × (0, 1, 0) = (0, 0, -0.05).
  EXPECT_LE((wrench.tau_W - Vec3(0, 0, -0.05)).norm(), 1e-15);
  EXPECT_NEAR(environment.supplied_power(0, view), 5 - 0.05 * 2, 1e-14);
}

TEST(Environment, SpringsPullBothEndsAndStoreWhatTheyTake) {
  ModelBuilder builder;
  builder.set_gravity(Vec3::Zero());
  builder.add_body(ball("a", Vec3::Zero()));
  builder.add_body(ball("b", Vec3(1, 0, 0)));
  Force spring = force(Force::Type::spring, {"a", "b"});
  spring.points = {Vec3(0, 0.02, 0), Vec3(0, 0, 0.03)};
  spring.stiffness = 100;
  spring.damping = 0;
  spring.length = 0.4;
  builder.add_force(spring);
  const auto model = builder.build();
  const Environment environment(*model);
  EXPECT_EQ(environment.spring_partners(0), std::vector<int>{1});
  EXPECT_EQ(environment.spring_partners(1), std::vector<int>{0});

  const std::vector<Environment::BodyView> views = {
      at(Vec3(0.1, 0, 0.2), Vec3::Zero(), Vec3::Zero(), rotation_matrix(rotation_exp(Vec3(0.3, 0.1, -0.2)))),
      at(Vec3(1, 0.4, 0), Vec3::Zero(), Vec3::Zero(), rotation_matrix(rotation_exp(Vec3(0, -0.7, 0.1))))};
  const Wrench on_a = wrench_on(environment, 0, views), on_b = wrench_on(environment, 1, views);
  EXPECT_LE((on_a.f_W + on_b.f_W).norm(), 1e-14);
  const Vec3 moment = on_a.tau_W + on_b.tau_W + views[0].x.cross(on_a.f_W) + views[1].x.cross(on_b.f_W);
  EXPECT_LE(moment.norm(), 1e-13);

  // f = -∂E/∂x and τ = -∂E/∂φ, by central differences.
  constexpr double d = 1e-5;
  for (int body = 0; body < 2; ++body) {
    const std::size_t i = static_cast<std::size_t>(body);
    const Wrench wrench = body == 0 ? on_a : on_b;
    for (int axis = 0; axis < 3; ++axis) {
      const auto energy = [&](double shift, double turn) {
        std::vector<Environment::BodyView> moved = views;
        moved[i].x += shift * Vec3::Unit(axis);
        moved[i].R = rotation_matrix(rotation_exp(turn * Vec3::Unit(axis))) * moved[i].R;
        return environment.spring_energy([&](int k) { return moved[static_cast<std::size_t>(k)]; });
      };
      EXPECT_NEAR(-(energy(d, 0) - energy(-d, 0)) / (2 * d), wrench.f_W[axis], 1e-7);
      EXPECT_NEAR(-(energy(0, d) - energy(0, -d)) / (2 * d), wrench.tau_W[axis], 1e-7);
    }
  }
}

TEST(Environment, DampersAndDragOnlyTakePower) {
  ModelBuilder builder;
  builder.set_gravity(Vec3::Zero());
  BodyDescription slow = ball("a", Vec3::Zero());
  slow.linear_drag = 0.5;
  slow.angular_drag = 0.25;
  builder.add_body(slow);
  Force spring = force(Force::Type::spring, {"world", "a"});
  spring.points = {Vec3(0, 0, 1), Vec3::Zero()};
  spring.damping = 3;
  spring.length = 1;
  builder.add_force(spring);
  const auto model = builder.build();
  const Environment environment(*model);
  const Vec3 v(1, -2, 0.5), w(0.3, 0.2, -4);
  const Wrench wrench = wrench_on(environment, 0, {at(Vec3::Zero(), v, w)});
  // Drag -c v - (0, 0, 3 v_z) along the damper.
  EXPECT_LE((wrench.f_W - (-0.5 * v - Vec3(0, 0, 3 * 0.5))).norm(), 1e-14);
  EXPECT_LE((wrench.tau_W + 0.25 * w).norm(), 1e-14);
  EXPECT_EQ(environment.supplied_power(0, at(Vec3::Zero(), v, w)), 0);
}

using JointDescription = ModelBuilder::JointDescription;

JointDescription joint(const std::string& name, JointType type, std::vector<std::string> bodies,
                       const Vec3& anchor) {
  JointDescription result;
  result.name = name;
  result.type = type;
  result.bodies = std::move(bodies);
  result.anchors = {anchor};
  return result;
}

TEST(Environment, JointsTieTheirBodiesAndMakeThemForced) {
  ModelBuilder builder;
  for (const char* name : {"a", "b", "c", "d", "alone"}) builder.add_body(ball(name, Vec3::Zero()));
  BodyDescription wall = ball("wall", Vec3::Zero());
  wall.motion = MotionType::fixed;
  builder.add_body(wall);
  builder.add_joint(joint("1", JointType::hinge, {"c", "a"}, Vec3::Zero()));
  builder.add_joint(joint("2", JointType::fixed, {"a", "b"}, Vec3::Zero()));
  builder.add_joint(joint("3", JointType::hinge, {"wall", "d"}, Vec3::Zero()));
  builder.add_joint(joint("4", JointType::slider, {"world", "d"}, Vec3::Zero()));
  JointDescription gear;
  gear.name = "5";
  gear.type = JointType::gear;
  gear.joints = {"1", "3"};
  gear.parameter = -1;
  builder.add_joint(gear);
  const auto model = builder.build();
  const Environment environment(*model);
  EXPECT_EQ(environment.joint_partners(0), (std::vector<int>{1, 2, 3}));
  EXPECT_EQ(environment.joint_partners(1), (std::vector<int>{0}));
  EXPECT_EQ(environment.joint_partners(2), (std::vector<int>{0, 3}));
  EXPECT_EQ(environment.joint_partners(3), (std::vector<int>{0, 2}));
  EXPECT_TRUE(environment.joint_partners(4).empty());
  EXPECT_TRUE(environment.joint_partners(5).empty());
  for (int body = 0; body < 6; ++body) EXPECT_EQ(environment.is_forced(body), body < 4) << body;
}

TEST(Environment, SpringsOfJointsActOnBothBodiesAndTheirEnergyCounts) {
  ModelBuilder builder;
  builder.set_gravity(Vec3::Zero());
  builder.add_body(ball("a", Vec3::Zero()));
  builder.add_body(ball("b", Vec3(1, 0, 0)));
  JointAxis spring;
  spring.stiffness = 10;
  spring.damping = 2;
  JointDescription slider = joint("slider", JointType::slider, {"a", "b"}, Vec3(1, 0, 0));
  slider.axis = Vec3(1, 0, 0);
  slider.axes = {spring};
  builder.add_joint(slider);
  JointDescription hinge = joint("hinge", JointType::hinge, {"b", "world"}, Vec3(1, 0, 0));
  hinge.axes = {spring};
  builder.add_joint(hinge);
  const auto model = builder.build();
  const Environment environment(*model);
  // b is 0.1 m further out at 0.5 m/s, and turned against the world by 0.3 rad at 2 rad/s: of the world
  // against b the angle is -0.3.
  const std::vector<Environment::BodyView> views = {
      at(Vec3::Zero(), Vec3::Zero(), Vec3::Zero()),
      at(Vec3(1.1, 0, 0), Vec3(0.5, 0, 0), Vec3(0, 0, 2), rotation_matrix(rotation_exp(Vec3(0, 0, 0.3))))};
  const Wrench on_a = wrench_on(environment, 0, views), on_b = wrench_on(environment, 1, views);
  EXPECT_LE((on_a.f_W - Vec3(10 * 0.1 + 2 * 0.5, 0, 0)).norm(), 1e-14);
  EXPECT_LE((on_b.f_W + on_a.f_W).norm(), 1e-14);
  EXPECT_LE((on_b.tau_W - Vec3(0, 0, -10 * 0.3 - 2 * 2)).norm(), 1e-14);
  const double energy = environment.spring_energy([&](int i) { return views[static_cast<std::size_t>(i)]; });
  EXPECT_NEAR(energy, 5 * 0.1 * 0.1 + 5 * 0.3 * 0.3, 1e-15);
  EXPECT_EQ(environment.supplied_power(1, views[1]), 0);
}

}  // namespace
}  // namespace rigor::environment_test
