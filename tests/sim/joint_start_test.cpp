// A scene may give bodies velocities that their joints do not allow: they are put right at the start, in the
// books.

#include "sim/time_stepping_scenes.hpp"

#include "rigor/sim/audit/audit.hpp"
#include "rigor/sim/make_stepper.hpp"

#include <gtest/gtest.h>

namespace rigor::joint_start_test {
namespace {

class VelocitiesThatJointsForbid : public testing::TestWithParam<Scheme> {};

TEST_P(VelocitiesThatJointsForbid, ArePutRightByTheImpulseOfTheJoint) {
  ModelBuilder builder;
  builder.set_gravity(Vec3::Zero());
  builder.add_material({"m", 1000, 0, 0});
  BodyDescription ball = test::stepping_body("ball", Sphere{0.1}, Vec3(-0.25, -0.25, 0.5));
  ball.velocity = Vec3(1, 2, -1);
  ball.angular_velocity = Vec3(3, 4, -2);
  builder.add_body(ball);
  ModelBuilder::JointDescription slider;
  slider.name = "slider";
  slider.type = JointType::slider;
  slider.bodies = {"world", "ball"};
  slider.anchors = {Vec3(0.1, -0.2, 0.4)};
  slider.axis = Vec3(0.3, 0.2, 1).normalized();
  builder.add_joint(slider);
  const std::shared_ptr<const Model> model = builder.build();
  Method method;
  method.scheme = GetParam();
  State state = make_initial_state(*model);
  Auditor auditor(model, method, state);
  auditor.observe(state, make_stepper(model, method, 0.01)->advance(state, 0.5));
  // What is left is the velocity along the axis, and it lasts.
  const Vec3 along = slider.axis.dot(ball.velocity) * slider.axis;
  EXPECT_LE((linear_velocity(*model, state, 0) - along).norm(), 1e-12);
  EXPECT_LE(angular_velocity(*model, state, 0).norm(), 1e-12);
  EXPECT_LE((state.position(0) - ball.p_WU - 0.5 * along).norm(), 1e-12);
  const Audit audit = auditor.audit(state);
  EXPECT_LE(audit.linear_momentum_error, 1e-12);
  EXPECT_LE(audit.angular_momentum_error, 1e-12);
  EXPECT_LE(audit.max_increase, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Schemes, VelocitiesThatJointsForbid,
                         testing::Values(Scheme::event_driven, Scheme::time_stepping, Scheme::penalty,
                                         Scheme::impulse_based, Scheme::hybrid));

}  // namespace
}  // namespace rigor::joint_start_test
