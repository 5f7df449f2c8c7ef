// What each scheme promises of any run, and that an audit compares with it.

#include "rigor/model/model_builder.hpp"
#include "rigor/sim/audit/audit.hpp"
#include "rigor/sim/audit/promises_of.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace rigor::scheme_promises_test {
namespace {

/// A ball of 1 kg, 0.2 m wide, above a floor, and if wanted a second one on a hinge with a motor.
std::shared_ptr<const Model> scene(double height, bool has_motor = false) {
  ModelBuilder builder;
  BodyDescription floor;
  floor.name = "floor";
  floor.motion = MotionType::fixed;
  ShapeDescription plane;
  plane.shape = HalfSpace{Vec3::UnitZ(), 0};
  floor.shapes = {plane};
  builder.add_body(floor);
  for (const char* name : {"ball", "wheel"}) {
    BodyDescription ball;
    ball.name = name;
    ball.p_WU = Vec3(name[0] == 'b' ? 0 : 1, 0, height);
    ball.mass = 1;
    ShapeDescription sphere;
    sphere.shape = Sphere{0.1};
    ball.shapes = {sphere};
    builder.add_body(ball);
  }
  if (has_motor) {
    ModelBuilder::JointDescription hinge;
    hinge.name = "axle";
    hinge.type = JointType::hinge;
    hinge.bodies = {"world", "wheel"};
    hinge.anchors = {Vec3(1, 0, height)};
    JointAxis axis;
    axis.motor = JointMotor{1, 2};
    hinge.axes = {axis};
    builder.add_joint(hinge);
  }
  return builder.build();
}

Method method_of(Scheme scheme, SolverMethod solver = SolverMethod::exact) {
  Method method;
  method.scheme = scheme;
  method.solver = solver;
  return method;
}

TEST(SchemePromises, SayHowFarEachSchemeIsToBeTrusted) {
  const auto model = scene(1);
  for (const Scheme scheme : {Scheme::event_driven, Scheme::hybrid, Scheme::impulse_based}) {
    const SchemePromises promises = promises_of(*model, method_of(scheme));
    EXPECT_EQ(promises.energy_share, 1e-9);
    EXPECT_EQ(promises.penetration, 1e-6);
    EXPECT_EQ(promises.acts_in_steps, scheme != Scheme::event_driven);
  }
  // Integrators of fixed order, and a tolerance of the user, promise what they can hold.
  Method own = method_of(Scheme::event_driven);
  own.tolerance = 1e-6;
  EXPECT_DOUBLE_EQ(promises_of(*model, own).energy_share, 1e-5);
  own.integrator = IntegratorMethod::rk4;
  EXPECT_EQ(promises_of(*model, own).energy_share, 1e-6);
  const SchemePromises stepping = promises_of(*model, method_of(Scheme::time_stepping));
  EXPECT_EQ(stepping.energy_share, 1e-6);
  EXPECT_EQ(stepping.penetration, 1e-6);
  const SchemePromises penalty = promises_of(*model, method_of(Scheme::penalty));
  EXPECT_EQ(penalty.penetration, 2e-4);
  EXPECT_GT(penalty.weight_share, 0);
  const SchemePromises bulk = promises_of(*model, method_of(Scheme::time_stepping, SolverMethod::substep));
  EXPECT_GT(bulk.rounding_share, 0);
}

TEST(SchemePromises, OverlapsAreJudgedByTheBodiesNotByTheScene) {
  // The same bodies in a scene a thousand times larger: the same promise.
  for (const double height : {1.0, 1e4}) {
    const SchemePromises promises =
        promises_of(*scene(height), method_of(Scheme::time_stepping, SolverMethod::substep));
    EXPECT_EQ(promises.penetration_share, 0.25);
    EXPECT_TRUE(std::isinf(promises.penetration));
  }
}

TEST(SchemePromises, NobodyPromisesEnergyWhoDoesNotKnowTheWork) {
  EXPECT_TRUE(promises_of(*scene(1), method_of(Scheme::time_stepping, SolverMethod::substep)).knows_work);
  EXPECT_FALSE(
      promises_of(*scene(1, true), method_of(Scheme::time_stepping, SolverMethod::substep)).knows_work);
  EXPECT_TRUE(promises_of(*scene(1, true), method_of(Scheme::event_driven)).knows_work);
}

TEST(SchemePromises, TheRiseOfEnergyIsNotKnownWhereWorkIsNot) {
  for (const bool has_motor : {false, true}) {
    const std::shared_ptr<const Model> model = scene(1, has_motor);
    for (const SolverMethod solver : {SolverMethod::exact, SolverMethod::substep}) {
      const Auditor auditor(model, method_of(Scheme::time_stepping, solver), make_initial_state(*model));
      EXPECT_EQ(std::isnan(auditor.max_increase()), has_motor && solver == SolverMethod::substep);
    }
  }
}

TEST(SchemePromises, APenaltyOfGivenStiffnessPromisesNoDepthInMetres) {
  Method method = method_of(Scheme::penalty);
  method.stiffness = 100;
  const SchemePromises promises = promises_of(*scene(1), method);
  EXPECT_TRUE(std::isinf(promises.penetration));
  EXPECT_LT(promises.penetration_share, 1);
}

/// The audit of a run in which this happened.
Audit audit_of(const Method& method, const AdvanceReport& report) {
  const auto model = scene(1);
  const State state = make_initial_state(*model);
  Auditor auditor(model, method, state);
  auditor.observe(state, report);
  return auditor.audit(state);
}

bool has(const std::vector<std::string>& texts, const std::string& part) {
  return std::any_of(texts.begin(), texts.end(),
                     [&](const std::string& text) { return text.find(part) != std::string::npos; });
}

TEST(Auditor, NamesPairAndTimeOfAnOverlapDeeperThanTheThinnerBodyBears) {
  const Method substep = method_of(Scheme::time_stepping, SolverMethod::substep);
  AdvanceReport report;
  report.note_overlap(*scene(1), 0.04, 0, 1, 0.5);
  EXPECT_EQ(audit_of(substep, report).violations, std::vector<std::string>{});
  report.note_overlap(*scene(1), 0.06, 0, 2, 0.7);
  const Audit audit = audit_of(substep, report);
  ASSERT_EQ(audit.violations.size(), 1u);
  EXPECT_EQ(
      audit.violations.front(),
      "penetration of floor and wheel is 0.06 m at t = 0.7 s, 0.3 of the thickness of the thinner body, "
      "the tolerance is 0.25 of it");
}

TEST(Auditor, NamesPairAndTimeOfAnOverlapBeyondTheContactTolerance) {
  AdvanceReport report;
  report.note_overlap(*scene(1), 2e-6, 1, 2, 0.25);
  EXPECT_TRUE(has(audit_of(method_of(Scheme::event_driven), report).violations,
                  "penetration of ball and wheel is 2e-06 m at t = 0.25 s, the tolerance is 1e-06 m"));
}

TEST(Auditor, SaysWhereForcesDoNotDetermineTheMotion) {
  AdvanceReport report;
  report.force_uncertainty = {0.5, 1, 0.125};
  EXPECT_TRUE(has(audit_of(method_of(Scheme::time_stepping), report).violations,
                  "the acceleration of ball at t = 0.125 s"));
  report.force_uncertainty.share = 0.01;
  EXPECT_EQ(audit_of(method_of(Scheme::time_stepping), report).violations, std::vector<std::string>{});
}

TEST(Audit, IsCompleteAtItsDurationOnly) {
  Audit audit = audit_of(method_of(Scheme::event_driven), {});
  audit.duration = 2;
  EXPECT_FALSE(audit.is_complete());
  audit.end_time = 2;
  EXPECT_TRUE(audit.is_complete());
}

}  // namespace
}  // namespace rigor::scheme_promises_test
