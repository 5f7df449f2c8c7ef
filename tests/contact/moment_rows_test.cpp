#include "rigor/contact/resting/rolling_friction.hpp"
#include "rigor/contact/system/motion_rows.hpp"
#include "rigor/model/model_builder.hpp"
#include "rigor/solver/coulomb/rolling_friction_problem.hpp"

#include <gtest/gtest.h>

namespace rigor::moment_rows_test {
namespace {

/// A ball of radius 0.1 m on the floor, the floor second, so that the normal points down.
ContactSystem ball_on_floor(const Vec3& v, const Vec3& omega) {
  ModelBuilder builder;
  builder.add_material({"m", 1000, 0.3, 0});
  BodyDescription ball;
  ball.name = "ball";
  ball.p_WU = Vec3(0, 0, 0.1);
  ball.shapes.push_back({Sphere{0.1}, Vec3::Zero(), Quat::Identity(), "m", ""});
  builder.add_body(ball);
  BodyDescription floor;
  floor.name = "floor";
  floor.motion = MotionType::fixed;
  floor.shapes.push_back({HalfSpace{Vec3::UnitZ(), 0}, Vec3::Zero(), Quat::Identity(), "m", ""});
  builder.add_body(floor);
  const std::shared_ptr<const Model> model = builder.build();
  const Body& body = model->body(0);
  std::vector<BodyKinetics> kinetics = {
      dynamic_kinetics(body, BodyPhase{Vec3(0, 0, 0.1), body.q_WB, Vec3::Zero(), Vec3::Zero()}),
      BodyKinetics{}};
  kinetics[0].v = v;
  kinetics[0].w = omega;
  return make_contact_system(find_contacts(*model, 0, 1, kinetics[0].pose(), kinetics[1].pose(), 1e-6),
                             {0, 1}, kinetics);
}

TEST(MomentRows, FormTheResponseOfForcesAndMoments) {
  const ContactSystem system = ball_on_floor(Vec3::Zero(), Vec3::Zero());
  ASSERT_EQ(system.contacts.size(), 1u);
  const MatX A = contact_response(moment_rows(system));
  EXPECT_LE((A - rolling_friction_delassus(system, 0)).norm(), 1e-13 * A.norm());
}

/// A rod whose lower end, a ball, touches the floor, hinged to the world by its upper end.
std::shared_ptr<const Model> hinged_rod() {
  ModelBuilder builder;
  builder.add_material(
      {.name = "m", .friction = 1.2, .restitution = 0, .rolling_friction = 0.01, .torsional_friction = 0.02});
  BodyDescription rod;
  rod.name = "rod";
  rod.p_WU = Vec3(0, 0, 0.6);
  rod.mass = 2;
  rod.shapes.push_back({Capsule{0.1, 0.5}, Vec3::Zero(), Quat::Identity(), "m", ""});
  builder.add_body(rod);
  BodyDescription floor;
  floor.name = "floor";
  floor.motion = MotionType::fixed;
  floor.shapes.push_back({HalfSpace{Vec3::UnitZ(), 0}, Vec3::Zero(), Quat::Identity(), "m", ""});
  builder.add_body(floor);
  ModelBuilder::JointDescription hinge;
  hinge.name = "hinge";
  hinge.type = JointType::hinge;
  hinge.bodies = {"world", "rod"};
  hinge.anchors = {Vec3(0.4, 0, 1.1)};
  hinge.axis = Vec3(0, 1, 0.3);
  builder.add_joint(hinge);
  return builder.build();
}

// An impact through a joint ends in one go: the response that it was solved with is the one that it has.
TEST(MomentRows, ResponseOfOneContactHasWhatJointsDo) {
  const std::shared_ptr<const Model> model = hinged_rod();
  const std::vector<int> bodies = {0, 1};
  BodyKinetics rod = dynamic_kinetics(
      model->body(0), BodyPhase{Vec3(0, 0, 0.6), model->body(0).q_WB, Vec3::Zero(), Vec3::Zero()});
  const std::vector<BodyKinetics> kinetics = {rod, BodyKinetics{}};
  ContactSystem system = make_contact_system(
      *model, find_contacts(*model, 0, 1, kinetics[0].pose(), kinetics[1].pose(), 1e-6), bodies, kinetics,
      std::make_shared<JointSystem>(*model, std::vector<int>{0}, bodies, kinetics));
  ASSERT_EQ(system.contacts.size(), 1u);
  const Mat6 K = rolling_friction_delassus(system, 0);
  for (int column = 0; column < 6; ++column) {
    Vec6 unit = Vec6::Zero();
    unit[column] = 1;
    std::vector<Wrench> impulses = contact_wrenches(system, unit.head<3>());
    // The rod is the contact's A.
    impulses[0].tau_W -= system.frames[0] * unit.tail<3>();
    const JointReactions total =
        with_joint_impulses(system, impulses, VecX::Zero(system.joints->residuals().size()));
    ContactSystem moved = system;
    moved.kinetics[0].v = rod.inverse_mass * total.wrenches[0].f_W;
    moved.kinetics[0].w = rod.inverse_inertia * total.wrenches[0].tau_W;
    Vec6 change;
    change << relative_velocities(moved), relative_angular_velocity(moved, 0);
    EXPECT_LE((change - K.col(column)).norm(), 1e-12 * K.norm()) << column;
  }
}

// 5/7 ρ g h / R, whichever of the two bodies comes first.
TEST(MomentRows, ARollingBallIsBrakedByRollingFriction) {
  const double g = 9.81, h = 0.01, rho = 1e-3, v = 0.5, R = 0.1;
  const ContactSystem system = ball_on_floor(Vec3(v, 0, -g * h), Vec3(0, v / R, 0));
  RollingFrictionProblem problem{contact_response(moment_rows(system)), VecX(6), {0.3}, {rho}, {0}};
  problem.b << relative_velocities(system), relative_angular_velocity(system, 0);
  const RollingFrictionSolution solution = solve_rolling_friction(problem);
  ASSERT_TRUE(solution.converged);
  EXPECT_NEAR(solution.w.segment<2>(3).norm(), (v - 5.0 / 7 * rho * g * h / R) / R, 1e-12);
}

}  // namespace
}  // namespace rigor::moment_rows_test
