// The penalty scheme on scenes with closed forms.

#include "rigor/sim/penalty/penalty_stepper.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/model/model_builder.hpp"
#include "rigor/sim/make_stepper.hpp"
#include "rigor/sim/simulation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace rigor::penalty_stepper_test {
namespace {

constexpr double g = 9.81;
constexpr double pi = 3.14159265358979323846;

Method penalty_method(PenaltyMethod form, PenaltyLaw law = PenaltyLaw::linear) {
  Method method;
  method.scheme = Scheme::penalty;
  method.penalty = form;
  method.penalty_law = law;
  return method;
}

struct Surface {
  double friction = 0;
  double restitution = 0;
  double rolling_friction = 0;
};

/// A floor z = 0 and one body of 1 kg.
std::shared_ptr<const Model> body_on_floor(const Shape& shape, const Vec3& x, const Vec3& v,
                                           const Surface& surface, const Vec3& g_W) {
  ModelBuilder builder;
  builder.set_gravity(g_W);
  Material material{"m", 1000, surface.friction, surface.restitution};
  material.rolling_friction = surface.rolling_friction;
  builder.add_material(material);
  BodyDescription floor;
  floor.name = "floor";
  floor.motion = MotionType::fixed;
  floor.shapes.push_back({HalfSpace{Vec3::UnitZ(), 0}, Vec3::Zero(), Quat::Identity(), "m", ""});
  builder.add_body(floor);
  BodyDescription body;
  body.name = "body";
  body.mass = 1;
  body.p_WU = x;
  body.velocity = v;
  body.shapes.push_back({shape, Vec3::Zero(), Quat::Identity(), "m", ""});
  builder.add_body(body);
  return builder.build();
}

struct PenaltyRun {
  State state;
  Audit audit;
  std::vector<State> states;
};

PenaltyRun run_penalty(const std::shared_ptr<const Model>& model, const Method& method, double duration,
                       double step, double interval) {
  PenaltyRun result;
  const RunSettings settings{.duration = duration, .step = step, .output_interval = interval};
  const Observer observer = [&](const State& state, const AdvanceReport&, const Auditor&) {
    result.states.push_back(state);
    return true;
  };
  const RunResult end = run_simulation(model, method, settings, std::nullopt, observer);
  result.state = end.state;
  result.audit = end.audit;
  EXPECT_EQ(end.audit.report.reason, StopReason::reached_end) << end.audit.report.detail;
  return result;
}

const std::vector<PenaltyMethod> kForms = {PenaltyMethod::local, PenaltyMethod::global};
const std::vector<PenaltyLaw> kLaws = {PenaltyLaw::linear, PenaltyLaw::hunt_crossley};

/// Speed after over speed before of a ball that hits the floor in no gravity.
double measured_restitution(const Method& method, double e) {
  const std::shared_ptr<const Model> model =
      body_on_floor(Sphere{0.1}, Vec3(0, 0, 0.15), Vec3(0, 0, -2), {0, e}, Vec3::Zero());
  const PenaltyRun result = run_penalty(model, method, 0.05, 0.01, 0.05);
  return result.state.linear_momentum(1).z() / 2;
}

TEST(PenaltyStepper, ABallComesBackWithItsRestitution) {
  for (const PenaltyLaw law : kLaws) {
    for (const double e : {1.0, 0.9, 0.6, 0.3, 0.1}) {
      // Of second order: steps of a fifth of 1/ω.
      EXPECT_NEAR(measured_restitution(penalty_method(PenaltyMethod::local, law), e), e, 0.01)
          << "law " << static_cast<int>(law);
    }
    // Strong dampers are resolved to their rate only.
    const double least = law == PenaltyLaw::linear ? 0.01 : 0.05;
    EXPECT_NEAR(measured_restitution(penalty_method(PenaltyMethod::local, law), 0), least, 0.04);
  }
  for (const double e : {1.0, 0.9, 0.6, 0.3})
    EXPECT_NEAR(measured_restitution(penalty_method(PenaltyMethod::global), e), e, 0.05);
}

TEST(PenaltyStepper, AnElasticBallKeepsItsEnergyOverManyBounces) {
  const std::shared_ptr<const Model> model =
      body_on_floor(Sphere{0.1}, Vec3(0, 0, 1.1), Vec3::Zero(), {0, 1}, Vec3(0, 0, -g));
  for (const PenaltyLaw law : kLaws) {
    const PenaltyRun result = run_penalty(model, penalty_method(PenaltyMethod::local, law), 5, 0.01, 0.05);
    EXPECT_GE(result.audit.report.impacts, 5);
    // Five or six bounces; each misses its begin and end by 0.02/ω, which costs ½ (0.02)² of its energy.
    const double share = 6 * 0.5 * 0.02 * 0.02;
    for (const State& state : result.states) {
      double elastic = 0;
      for (const ContactMemory& contact : state.contacts) elastic += contact.energy;
      const double energy = state.linear_momentum(1).squaredNorm() / 2 + g * state.position(1).z() + elastic;
      EXPECT_NEAR(energy, g * 1.1, share * g) << state.t;
    }
    EXPECT_LE(result.audit.report.max_penetration, 1.1e-4);
  }
}

/// Energy error [J] of one undamped oscillation of a mass that stays on its spring, pressed by gravity, at n
/// steps a period.
double position_error(IntegratorMethod integrator, double steps) {
  // k = 1e4 N/m, m = 1 kg: ω = 100. Released at depth 2 m g / k, it moves as m g / k (1 + cos ω t).
  const double k = 1e4, sag = g / k, omega = 100;
  const std::shared_ptr<const Model> model =
      body_on_floor(Sphere{0.1}, Vec3(0, 0, 0.1 - 1.5 * sag), Vec3::Zero(), {0, 1}, Vec3(0, 0, -g));
  Method method = penalty_method(PenaltyMethod::local);
  method.integrator = integrator;
  method.stiffness = k;
  method.damping = 1e-12;
  method.penalty_depth = 1;
  const double end = 0.04;
  const PenaltyRun result = run_penalty(model, method, end, end / steps, end);
  return std::abs(result.state.position(1).z() - (0.1 - sag - 0.5 * sag * std::cos(omega * end)));
}

TEST(PenaltyStepper, OrdersOfItsIntegratorsOnSmoothMotion) {
  const double exact =
      position_error(IntegratorMethod::exact, 100) / position_error(IntegratorMethod::exact, 200);
  EXPECT_NEAR(exact, 4, 0.2);
  const double euler = position_error(IntegratorMethod::semi_implicit_euler, 100) /
                       position_error(IntegratorMethod::semi_implicit_euler, 200);
  EXPECT_NEAR(euler, 2, 0.3);
}

TEST(PenaltyStepper, ABlockThatFrictionHoldsDoesNotCreep) {
  // 20 degrees, μ = 1.01 tan: the springs are loaded once, then nothing moves.
  const double angle = 20 * pi / 180;
  const Vec3 tilted = g * Vec3(std::sin(angle), 0, -std::cos(angle));
  const std::shared_ptr<const Model> model = body_on_floor(Box{Vec3(0.2, 0.2, 0.1)}, Vec3(0, 0, 0.1),
                                                           Vec3::Zero(), {1.01 * std::tan(angle), 0}, tilted);
  for (const PenaltyMethod form : kForms) {
    const PenaltyRun result = run_penalty(model, penalty_method(form), 1, 0.01, 0.1);
    const Vec3 loaded = result.states[3].position(1), end = result.state.position(1);
    EXPECT_LE((end - loaded).norm(), 1e-12);
    EXPECT_LE((end - Vec3(0, 0, 0.1)).norm(), 1e-5);
    EXPECT_LE(result.state.linear_momentum(1).norm(), 1e-12);
  }
}

TEST(PenaltyStepper, ABlockThatFrictionDoesNotHoldSlidesAsCoulombSays) {
  const double angle = 20 * pi / 180, mu = 0.5 * std::tan(angle);
  const Vec3 tilted = g * Vec3(std::sin(angle), 0, -std::cos(angle));
  const std::shared_ptr<const Model> model =
      body_on_floor(Box{Vec3(0.2, 0.2, 0.1)}, Vec3(0, 0, 0.1), Vec3::Zero(), {mu, 0}, tilted);
  const double expected = 0.5 * g * (std::sin(angle) - mu * std::cos(angle)) * 1;
  for (const PenaltyMethod form : kForms) {
    const PenaltyRun result = run_penalty(model, penalty_method(form), 1, 0.01, 0.1);
    // The first moments, in which the springs are loaded, are missing: some 1e-2 s at most.
    EXPECT_NEAR(result.state.position(1).x() / expected, 1, form == PenaltyMethod::local ? 1e-3 : 1e-2);
  }
}

TEST(PenaltyStepper, ABallThatSlidesComesToRoll) {
  // v0 = 7 m/s, μ = 0.2: rolls at 5/7 v0 from t = 2 v0 / (7 μ g) = 1.019 s on.
  const std::shared_ptr<const Model> model =
      body_on_floor(Sphere{0.1}, Vec3(0, 0, 0.1), Vec3(7, 0, 0), {0.2, 0}, Vec3(0, 0, -g));
  // Friction acts half way down the depth, here a half of 1e-6 m of an arm of 0.1 m.
  for (const PenaltyMethod form : kForms) {
    const PenaltyRun result = run_penalty(model, penalty_method(form), 1.5, 0.01, 0.1);
    EXPECT_NEAR(result.state.linear_momentum(1).x(), 5, 5e-3);
    EXPECT_NEAR(angular_velocity(*model, result.state, 1).y() * 0.1, result.state.linear_momentum(1).x(),
                5e-5);
  }
}

TEST(PenaltyStepper, RollingFrictionBrakesAsItsArmSays) {
  // Solid ball: a = -(5/7) ρ g / r.
  const double rho = 1e-3;
  const std::shared_ptr<const Model> model =
      body_on_floor(Sphere{0.1}, Vec3(0, 0, 0.1), Vec3(1, 0, 0), {0.8, 0, rho}, Vec3(0, 0, -g));
  for (const PenaltyMethod form : kForms) {
    const PenaltyRun result = run_penalty(model, penalty_method(form), 1, 0.01, 0.1);
    const double a =
        (result.states[10].linear_momentum(1).x() - result.states[4].linear_momentum(1).x()) / 0.6;
    EXPECT_NEAR(a / (-5.0 / 7 * rho * g / 0.1), 1, 0.02);
  }
}

TEST(PenaltyStepper, BooksOfMomentumCloseToRounding) {
  const std::shared_ptr<const Model> model =
      body_on_floor(Box{Vec3(0.1, 0.15, 0.2)}, Vec3(0, 0, 0.5), Vec3(1, 2, -1), {0.4, 0.3}, Vec3(0, 0, -g));
  for (const PenaltyMethod form : kForms) {
    const PenaltyRun result = run_penalty(model, penalty_method(form), 0.5, 0.01, 0.05);
    EXPECT_LE(result.audit.linear_momentum_error, 1e-13);
    EXPECT_LE(result.audit.angular_momentum_error, 1e-13);
    const AdvanceReport& report = result.audit.report;
    // What was lost is what dampers and sliders took, but for the error of the integration.
    EXPECT_NEAR(report.damping_loss + report.friction_loss, result.audit.dissipated, 0.06);
  }
}

TEST(PenaltyStepper, AFreshStepperGoesOnBitForBit) {
  const std::shared_ptr<const Model> model =
      body_on_floor(Box{Vec3(0.1, 0.15, 0.2)}, Vec3(0, 0, 0.25), Vec3(1, 2, -1), {0.4, 0.3}, Vec3(0, 0, -g));
  for (const PenaltyMethod form : kForms) {
    const Method method = penalty_method(form);
    const std::unique_ptr<Stepper> stepper = make_stepper(model, method, 0.01);
    State state = make_initial_state(*model);
    bool had_contacts = false;
    for (int k = 1; k <= 20; ++k) {
      State other = deserialise(serialise(state));
      had_contacts = had_contacts || !state.contacts.empty();
      stepper->advance(state, 0.02 * k);
      make_stepper(model, method, 0.01)->advance(other, 0.02 * k);
      ASSERT_EQ(state, other) << k;
    }
    EXPECT_TRUE(had_contacts);
  }
}

TEST(PenaltyStepper, BodiesThatBeginInsideEachOtherAreNotThrownApart) {
  const std::shared_ptr<const Model> model =
      body_on_floor(Sphere{0.1}, Vec3(0, 0, 0.05), Vec3::Zero(), {0.3, 0}, Vec3(0, 0, -g));
  for (const PenaltyMethod form : kForms) {
    const PenaltyRun result = run_penalty(model, penalty_method(form), 0.5, 0.01, 0.1);
    EXPECT_LE(result.audit.max_increase, 1e-3 * g);
    EXPECT_NEAR(result.state.position(1).z(), 0.05, 2e-4);
  }
}

// What lies under another body's impact has springs that were made for its own weight.
TEST(PenaltyStepper, ALightBallUnderAHeavyOneIsNotPressedThroughTheFloor) {
  for (const PenaltyLaw law : {PenaltyLaw::linear, PenaltyLaw::hunt_crossley}) {
    ModelBuilder builder;
    builder.set_gravity(Vec3(0, 0, -g));
    builder.add_material({"m", 1000, 0.5, 0});
    BodyDescription floor;
    floor.name = "floor";
    floor.motion = MotionType::fixed;
    floor.shapes.push_back({HalfSpace{Vec3::UnitZ(), 0}, Vec3::Zero(), Quat::Identity(), "m", ""});
    builder.add_body(floor);
    const auto add_ball = [&](const char* name, double mass, double radius, double z, double v_z) {
      BodyDescription ball;
      ball.name = name;
      ball.mass = mass;
      ball.p_WU = Vec3(0, 0, z);
      ball.velocity = Vec3(0, 0, v_z);
      ball.shapes.push_back({Sphere{radius}, Vec3::Zero(), Quat::Identity(), "m", ""});
      builder.add_body(ball);
    };
    add_ball("light", 1, 0.05, 0.05, 0);
    add_ball("heavy", 300, 0.2, 0.4, -3);
    const PenaltyRun run =
        run_penalty(builder.build(), penalty_method(PenaltyMethod::local, law), 0.1, 0.01, 0.01);
    // 2,700 times the kinetic energy that the light ball's spring is made for presses by √2700 d without
    // hardening.
    EXPECT_LE(run.audit.report.max_penetration, 2 * Method{}.penalty_depth);
    EXPECT_GT(run.audit.report.max_penetration, Method{}.penalty_depth);
    EXPECT_EQ(run.audit.violations, std::vector<std::string>{});
  }
}

TEST(PenaltyStepper, OtherIntegratorsAreRefused) {
  Method method = penalty_method(PenaltyMethod::local);
  EXPECT_TRUE(check_combination(method).empty());
  method.integrator = IntegratorMethod::semi_implicit_euler;
  EXPECT_TRUE(check_combination(method).empty());
  method.penalty = PenaltyMethod::global;
  ASSERT_EQ(check_combination(method).size(), 1u);
  EXPECT_EQ(check_combination(method)[0],
            "scheme 'penalty' with penalty 'global' does not go with integrator 'semi-implicit-euler'; "
            "integrators that do: exact");
  method.penalty = PenaltyMethod::local;
  method.integrator = IntegratorMethod::rk4;
  ASSERT_EQ(check_combination(method).size(), 1u);
  method.integrator = IntegratorMethod::semi_implicit_euler;
  method.orientation = OrientationForm::matrix;
  ASSERT_EQ(check_combination(method).size(), 1u);
}

TEST(PenaltyStepper, AStateThatIsNotFiniteStopsItWithTheBody) {
  const std::shared_ptr<const Model> model =
      body_on_floor(Sphere{0.1}, Vec3(0, 0, 0.5), Vec3::Zero(), {0.3, 0}, Vec3(0, 0, -g));
  for (const PenaltyMethod form : kForms) {
    State state = make_initial_state(*model);
    state.P[3] = std::numeric_limits<double>::max();
    state.anchor_here();
    const AdvanceReport report = make_stepper(model, penalty_method(form), 10)->advance(state, 1e3);
    EXPECT_EQ(report.reason, StopReason::not_finite);
    EXPECT_EQ(report.bodies, std::vector<int>{1});
    EXPECT_NE(report.detail.find("'body'"), std::string::npos);
  }
}

}  // namespace
}  // namespace rigor::penalty_stepper_test
