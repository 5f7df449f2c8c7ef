#include "rigor/geometry/shape/convex_hull.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/model/model_builder.hpp"
#include "rigor/sim/event_driven/event_driven_stepper.hpp"
#include "rigor/sim/report/energy.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace rigor::mechanisms_test {
namespace {

constexpr double g = 9.81;
using JointDescription = ModelBuilder::JointDescription;

ModelBuilder empty_scene(const Vec3& gravity = Vec3(0, 0, -g)) {
  ModelBuilder builder;
  builder.set_gravity(gravity);
  return builder;
}

BodyDescription body_of(const std::string& name, const Vec3& x, double mass, const Vec3& moments) {
  BodyDescription body;
  body.name = name;
  body.p_WU = x;
  body.inertia = GivenInertia{mass, Vec3::Zero(), moments, Vec3::Zero()};
  return body;
}

/// A thin rod of length and mass 1 along the direction, with its middle at x.
BodyDescription rod(const std::string& name, const Vec3& x, const Vec3& direction) {
  BodyDescription body = body_of(name, x, 1, Vec3(1.0 / 12, 1.0 / 12, 1e-4));
  body.q_WU = quaternion_of(frame_with_z(direction));
  return body;
}

JointDescription joint(const std::string& name, JointType type, const std::string& a, const std::string& b,
                       const Vec3& anchor, const Vec3& axis = Vec3::UnitZ()) {
  JointDescription description;
  description.name = name;
  description.type = type;
  description.bodies = {a, b};
  description.anchors = {anchor};
  description.axis = axis;
  return description;
}

struct Outcome {
  State state;
  AdvanceReport report;
};

Outcome simulate(const std::shared_ptr<const Model>& model, double duration, double tolerance, double step) {
  Method method;
  method.tolerance = tolerance;
  EventDrivenStepper stepper(model, method, step);
  Outcome run{make_initial_state(*model), {}};
  run.report = stepper.advance(run.state, duration);
  EXPECT_EQ(run.report.reason, StopReason::reached_end) << run.report.detail;
  return run;
}

TEST(Mechanisms, ALightBobSwingsLikeAPoint) {
  ModelBuilder builder = empty_scene(Vec3(0, -g, 0));
  // A rod's moment about the pivot, (I + m l²) / (m l) = 1 m: swings like a point on a string of that length.
  builder.add_body(body_of("bob", Vec3(-0.5, 0, 0), 1, Vec3::Constant(0.25)));
  builder.add_joint(joint("pivot", JointType::hinge, "world", "bob", Vec3::Zero()));
  const Outcome run = simulate(builder.build(), 10, 1e-12, 0.1);
  EXPECT_NEAR(run.state.position(0).x(), 0.5 * -0.27508746257611686, 1e-9);
  EXPECT_NEAR(run.state.position(0).y(), 0.5 * -0.96141920509912506, 1e-9);
  EXPECT_LE(run.report.max_joint_drift, 1e-14);
}

/// Kinetic energy after a double pendulum's tip struck a rough floor, against that before.
double energy_ratio_of_struck_pendulum(RestitutionLaw law, double friction, double restitution) {
  const double angles[] = {20 * std::numbers::pi / 180, 30 * std::numbers::pi / 180};
  const double rates[] = {-0.1, -0.2};
  ModelBuilder builder = empty_scene(Vec3::Zero());
  builder.add_material({"rough", 1000, friction, restitution});
  Vec3 end = Vec3::Zero(), end_velocity = Vec3::Zero();
  for (int i = 0; i < 2; ++i) {
    const Vec3 direction(std::sin(angles[i]), 0, -std::cos(angles[i]));
    const Vec3 w(0, -rates[i], 0);
    BodyDescription body = rod(i == 0 ? "upper" : "lower", end + 0.5 * direction, direction);
    body.angular_velocity = w;
    body.velocity = end_velocity + w.cross(0.5 * direction);
    if (i == 1) {
      // A corner of a slim tetrahedron is the tip.
      const std::vector<Vec3> corners = {Vec3(0, 0, 0.5), Vec3(0.01, 0, 0.4), Vec3(-0.01, 0.01, 0.4),
                                         Vec3(-0.01, -0.01, 0.4)};
      const Convex tip{std::make_shared<const ConvexHull>(std::get<ConvexHull>(make_convex_hull(corners)))};
      body.shapes.push_back({tip, Vec3::Zero(), Quat::Identity(), "rough", ""});
    }
    builder.add_body(body);
    builder.add_joint(joint(i == 0 ? "top" : "middle", JointType::hinge, i == 0 ? "world" : "upper",
                            i == 0 ? "upper" : "lower", end, Vec3::UnitY()));
    end += direction;
    end_velocity += w.cross(direction);
  }
  BodyDescription floor;
  floor.name = "floor";
  floor.motion = MotionType::fixed;
  floor.shapes.push_back({HalfSpace{Vec3::UnitZ(), end.z()}, Vec3::Zero(), Quat::Identity(), "rough", ""});
  builder.add_body(floor);
  const std::shared_ptr<const Model> model = builder.build();
  Method method;
  method.impact = law;
  EventDrivenStepper stepper(model, method, 0.01);
  State state = make_initial_state(*model);
  const Environment environment(*model);
  const double before = mechanical_energy(*model, environment, state).kinetic;
  EXPECT_NEAR(before, 0.023181410863455414, 1e-15);
  const AdvanceReport report = stepper.advance(state, 1e-9);
  EXPECT_EQ(report.impacts, 1);
  return mechanical_energy(*model, environment, state).kinetic / before;
}

TEST(Mechanisms, AnImpactGoesThroughTheJointsOfKanesPendulum) {
  // Kane and Levinson's example, the reference in 128 bits: Newton's law gains energy, the others do not.
  EXPECT_NEAR(energy_ratio_of_struck_pendulum(RestitutionLaw::newton, 0.7, 0.7), 3.111489586, 2e-9);
  EXPECT_NEAR(energy_ratio_of_struck_pendulum(RestitutionLaw::poisson, 0.7, 0.7), 0.5385416068, 1e-9);
  EXPECT_NEAR(energy_ratio_of_struck_pendulum(RestitutionLaw::stronge, 0.7, 0.7), 0.5707831253, 1e-9);
  EXPECT_NEAR(energy_ratio_of_struck_pendulum(RestitutionLaw::newton, 0.5, 1), 1.469142335, 2e-9);
  EXPECT_NEAR(energy_ratio_of_struck_pendulum(RestitutionLaw::stronge, 0.5, 1), 0.6907862943, 1e-9);
}

}  // namespace
}  // namespace rigor::mechanisms_test
