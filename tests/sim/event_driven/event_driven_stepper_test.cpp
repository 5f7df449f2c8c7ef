#include "rigor/sim/event_driven/event_driven_stepper.hpp"

#include "rigor/model/model_builder.hpp"
#include "rigor/sim/report/energy.hpp"
#include "rigor/sim/report/unresolved.hpp"

#include "sim/time_stepping_scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rigor::event_driven_stepper_test {
namespace {

constexpr double g = 9.81;

/// The cube of the reference catalogue, with all lengths times `length` and all times times `time`.
std::shared_ptr<const Model> cube_drop(double length, double time) {
  ModelBuilder builder = test::stepping_builder(0.6, 0.4, Vec3(0, 0, -g * length / (time * time)));
  BodyDescription cube =
      test::stepping_body("cube", Box{length * Vec3(0.1, 0.1, 0.1)}, length * Vec3(0, 0, 0.5));
  cube.q_WU = Quat(0.9, 0.3, -0.2, 0.1).normalized();
  cube.velocity = length / time * Vec3(0.5, 0.2, 0);
  cube.angular_velocity = Vec3(3, -2, 1) / time;
  builder.add_body(cube);
  return builder.build();
}

TEST(EventDrivenStepper, FirstImpactOfTheTumblingCubeIsThatOfTheReference) {
  const std::shared_ptr<const Model> model = cube_drop(1, 1);
  EventDrivenStepper stepper(model, Method{}, 0.01);
  State state = make_initial_state(*model);
  const AdvanceReport report = stepper.advance(state, 0.4);
  ASSERT_FALSE(report.events.empty());
  // Computed with 128-bit arithmetic: 0.266427487872514 s at vertex 4.
  EXPECT_NEAR(report.events.front().time, 0.266427487872514, 1e-12);
}

TEST(EventDrivenStepper, FreshStepperContinuesBitForBit) {
  const std::shared_ptr<const Model> model = cube_drop(1, 1);
  State state = make_initial_state(*model);
  EventDrivenStepper stepper(model, Method{}, 0.01);
  for (int k = 1; k <= 30; ++k) {
    State copy = state;
    EventDrivenStepper fresh(model, Method{}, 0.01);
    fresh.advance(copy, 0.05 * k);
    EXPECT_EQ(stepper.advance(state, 0.05 * k).reason, StopReason::reached_end);
    ASSERT_EQ(state, copy) << "at t = " << state.t;
  }
}

/// Breaks off within one impact.
class BrokenOff : public EventDrivenStepper {
 public:
  BrokenOff(std::shared_ptr<const Model> model, int impact)
      : EventDrivenStepper(std::move(model), Method{}, 0.01), left_(impact) {}

 private:
  bool apply_impulses(Cluster& part) override {
    if (left_-- == 0) throw Unresolved({1}, "broken off");
    return EventDrivenStepper::apply_impulses(part);
  }
  int left_;
};

TEST(EventDrivenStepper, WhatIsBrokenOffIsDoneAgainFromTheState) {
  const std::shared_ptr<const Model> model = cube_drop(1, 1);
  State whole = make_initial_state(*model);
  EventDrivenStepper undisturbed(model, Method{}, 0.01);
  for (int k = 1; k <= 6; ++k) undisturbed.advance(whole, 0.2 * k);
  for (const int impact : {0, 2, 5, 9}) {
    SCOPED_TRACE(impact);
    BrokenOff stepper(model, impact);
    State state = make_initial_state(*model);
    int breaks = 0;
    for (int k = 1; k <= 6; ++k) {
      if (stepper.advance(state, 0.2 * k).reason == StopReason::reached_end) continue;
      ++breaks;
      EXPECT_EQ(state.t, 0.2 * (k - 1));
      EXPECT_EQ(stepper.advance(state, 0.2 * k).reason, StopReason::reached_end);
    }
    EXPECT_EQ(breaks, 1);
    EXPECT_EQ(state, whole);
  }
}

TEST(EventDrivenStepper, FlightsDoNotDependOnWhereTheyAreLookedAt) {
  ModelBuilder builder = test::stepping_builder(1, 0, Vec3(0, 0, -g));
  builder.add_body(test::stepping_body("ball", Sphere{0.1}, Vec3(0, 0, 1.1)));
  const std::shared_ptr<const Model> model = builder.build();
  State often = make_initial_state(*model), once = often;
  EventDrivenStepper a(model, Method{}, 0.01), b(model, Method{}, 0.01);
  for (int k = 1; k <= 1000; ++k) a.advance(often, 0.01 * k);
  b.advance(once, 10);
  EXPECT_EQ(often, once);
}

TEST(EventDrivenStepper, ScenesScaledByPowersOfTwoGiveScaledBits) {
  const double length = std::ldexp(1.0, 20), time = std::ldexp(1.0, 10);
  const std::shared_ptr<const Model> small = cube_drop(1, 1), large = cube_drop(length, time);
  Method method, scaled;
  scaled.contact_tolerance = length * method.contact_tolerance;
  scaled.time_tolerance = time * method.time_tolerance;
  scaled.resting_velocity = length / time * method.resting_velocity;
  State a = make_initial_state(*small), b = make_initial_state(*large);
  EventDrivenStepper of_small(small, method, 0.01), of_large(large, scaled, 0.01 * time);
  for (int k = 1; k <= 8; ++k) {
    of_small.advance(a, 0.125 * k);
    of_large.advance(b, 0.125 * k * time);
    EXPECT_EQ(Vec3(length * a.position(1)), b.position(1)) << k;
    EXPECT_EQ(a.orientation(1).coeffs(), b.orientation(1).coeffs()) << k;
    EXPECT_EQ(Vec3(length / time * a.linear_momentum(1)), b.linear_momentum(1)) << k;
  }
}

TEST(EventDrivenStepper, ObliqueImpactOfABallSticksOrSlidesByCoulombsLaw) {
  // Stick if μ ≥ (2/7) v_t/((1 + e) v_n): then v_t⁺ = 5/7 v_t; else v_t⁺ = v_t - μ (1 + e) v_n.
  const double e = 0.5, v_n = 2;
  for (const auto& [friction, v_t] : {std::pair{0.5, 3.0}, std::pair{0.1, 3.0}}) {
    ModelBuilder builder = test::stepping_builder(e, friction, Vec3(0, 0, 0));
    BodyDescription ball = test::stepping_body("ball", Sphere{0.1}, Vec3(0, 0, 0.3));
    ball.velocity = Vec3(v_t, 0, -v_n);
    builder.add_body(ball);
    const std::shared_ptr<const Model> model = builder.build();
    State state = make_initial_state(*model);
    EventDrivenStepper(model, Method{}, 0.01).advance(state, 0.5);
    const bool sticks = friction >= 2.0 / 7 * v_t / ((1 + e) * v_n);
    const Vec3 v = linear_velocity(*model, state, 1), w = angular_velocity(*model, state, 1);
    EXPECT_NEAR(v.z(), e * v_n, 1e-14);
    EXPECT_NEAR(v.x(), sticks ? 5.0 / 7 * v_t : v_t - friction * (1 + e) * v_n, 1e-14);
    EXPECT_NEAR(w.y(), (sticks ? 5.0 / 7 * v_t : 2.5 * friction * (1 + e) * v_n) / 0.1, 1e-12);
  }
}

TEST(EventDrivenStepper, ThinRodStrikesTheFloorWithItsTip) {
  // m = L = 1 at 45 degrees: j = (1 + e) v / (1 + 3 cos²θ), ω⁺ = 12 (L/2) cos θ j.
  const double e = 0.5, v = 1;
  ModelBuilder builder = test::stepping_builder(e, 0, Vec3(0, 0, 0));
  BodyDescription rod;
  rod.name = "rod";
  rod.p_WU = Vec3(0, 0, 0.5);
  rod.velocity = Vec3(0, 0, -v);
  rod.inertia = GivenInertia{1, Vec3::Zero(), Vec3(1.0 / 12, 1.0 / 12, 1.0 / 12), Vec3::Zero()};
  // The tip is a ball of radius 0 in the limit; its size only shifts the instant.
  const double c = 0.5 * std::sqrt(0.5);
  rod.shapes.push_back({Sphere{1e-6}, Vec3(c, 0, -c), Quat::Identity(), "m", ""});
  builder.add_body(rod);
  const std::shared_ptr<const Model> model = builder.build();
  State state = make_initial_state(*model);
  const AdvanceReport report = EventDrivenStepper(model, Method{}, 0.01).advance(state, 0.2);
  ASSERT_EQ(report.impacts, 1);
  const double j = (1 + e) * v / 2.5;
  EXPECT_NEAR(report.events.front().j_W.norm(), j, 1e-14);
  EXPECT_NEAR(angular_velocity(*model, state, 1).norm(), 12 * c * j, 1e-13);
}

TEST(EventDrivenStepper, EqualBallsPartAtRightAnglesAfterAnObliqueElasticImpact) {
  ModelBuilder builder;
  builder.set_gravity(Vec3::Zero());
  builder.add_material({"m", 1000, 0, 1});
  BodyDescription a = test::stepping_body("a", Sphere{0.1}, Vec3(-1, 0.07, 0)),
                  b = test::stepping_body("b", Sphere{0.1}, Vec3::Zero());
  a.velocity = Vec3(2, 0, 0);
  builder.add_body(a);
  builder.add_body(b);
  const std::shared_ptr<const Model> model = builder.build();
  State state = make_initial_state(*model);
  EventDrivenStepper(model, Method{}, 0.01).advance(state, 1);
  const Vec3 v_a = linear_velocity(*model, state, 0), v_b = linear_velocity(*model, state, 1);
  EXPECT_GT(v_b.norm(), 0.1);
  EXPECT_NEAR(v_a.dot(v_b), 0, 4e-15);
  EXPECT_LT((v_a + v_b - Vec3(2, 0, 0)).norm(), 4e-15);
}

TEST(EventDrivenStepper, StackOfFiveBoxesStandsStill) {
  ModelBuilder builder = test::stepping_builder(0, 0.5, Vec3(0, 0, -g));
  for (int k = 0; k < 5; ++k)
    builder.add_body(
        test::stepping_body("box" + std::to_string(k), Box{Vec3(0.1, 0.1, 0.1)}, Vec3(0, 0, 0.1 + 0.2 * k)));
  const std::shared_ptr<const Model> model = builder.build();
  State state = make_initial_state(*model);
  const State start = state;
  EventDrivenStepper stepper(model, Method{}, 0.01);
  for (int k = 1; k <= 100; ++k) stepper.advance(state, 0.1 * k);
  EXPECT_EQ(state.x, start.x);
  EXPECT_EQ(state.P, start.P);
}

TEST(EventDrivenStepper, BlockThrownUpARampStopsAndStays) {
  // v₀ = 3 m/s, 25 degrees, μ = 0.6: t = v₀/a, s = v₀²/2a with a = g (sin + μ cos).
  const double angle = 25 * M_PI / 180, a = g * (std::sin(angle) + 0.6 * std::cos(angle));
  ModelBuilder builder = test::stepping_builder(0, 0.6, Vec3(0, 0, -g));
  builder.set_gravity(g * Vec3(-std::sin(angle), 0, -std::cos(angle)));
  BodyDescription block = test::stepping_body("block", Box{Vec3(0.2, 0.2, 0.1)}, Vec3(0, 0, 0.1));
  block.velocity = Vec3(3, 0, 0);
  builder.add_body(block);
  const std::shared_ptr<const Model> model = builder.build();
  State state = make_initial_state(*model);
  const AdvanceReport report = EventDrivenStepper(model, Method{}, 0.01).advance(state, 5);
  double stopped = 0;
  for (const MotionEvent& event : report.events) {
    if (event.kind == MotionEvent::Kind::slip_to_stick) stopped = event.time;
  }
  EXPECT_NEAR(stopped, 3 / a, 1e-9);
  EXPECT_NEAR(state.position(1).x(), 4.5 / a, 1e-9);
  EXPECT_EQ(state.linear_momentum(1).norm(), 0);
}

// T40: 25 degrees, μ = 0.3: a = g (sin - μ cos) = 1.478621330427401 m/s², x(2 s) = 2.957242660854801 m.
TEST(EventDrivenStepper, BlockSlidesDownARampFromRest) {
  const double angle = 25 * M_PI / 180;
  ModelBuilder builder = test::stepping_builder(0, 0.3, Vec3(0, 0, -g));
  builder.set_gravity(g * Vec3(std::sin(angle), 0, -std::cos(angle)));
  builder.add_body(test::stepping_body("block", Box{Vec3(0.2, 0.2, 0.1)}, Vec3(0, 0, 0.1)));
  const std::shared_ptr<const Model> model = builder.build();
  State state = make_initial_state(*model);
  EventDrivenStepper(model, Method{}, 0.01).advance(state, 2);
  EXPECT_NEAR(state.position(1).x(), 2.957242660854801, 1e-8);
  EXPECT_NEAR(state.linear_momentum(1).x() / model->body(1).mass, 2 * 1.478621330427401, 1e-8);
  EXPECT_NEAR(state.position(1).z(), 0.1, 1e-12);
}

// T34: a ball dropped from h with restitution e rests at √(2h/g) (1 + e)/(1 - e), after infinitely many
// bounces of which few are worth an event.
TEST(EventDrivenStepper, BouncesEndAtTheirLimitTime) {
  struct Drop {
    double height, restitution, limit;
  };
  for (const Drop& drop :
       {Drop{1, 0.5, 1.354570922957193}, Drop{2, 0.8, 5.746957711326908}, Drop{1, 0.9, 8.578949178728887}}) {
    ModelBuilder builder = test::stepping_builder(drop.restitution, 0, Vec3(0, 0, -g));
    builder.add_body(test::stepping_body("ball", Sphere{0.1}, Vec3(0, 0, drop.height + 0.1)));
    const std::shared_ptr<const Model> model = builder.build();
    State state = make_initial_state(*model);
    const AdvanceReport report = EventDrivenStepper(model, Method{}, 0.01).advance(state, 10);
    double rested = 0;
    for (const MotionEvent& event : report.events) {
      if (event.kind == MotionEvent::Kind::rest) rested = event.time;
    }
    EXPECT_NEAR(rested, drop.limit, 1e-9);
    // e^k v₀ falls below 1e-3 m/s: 13, 40 and 81 bounces.
    const double v0 = std::sqrt(2 * g * drop.height);
    EXPECT_EQ(report.impacts,
              static_cast<long>(std::ceil(std::log(1e-3 / v0) / std::log(drop.restitution))) + 1);
    EXPECT_NEAR(state.position(1).z(), 0.1, 1e-12);
    EXPECT_EQ(state.linear_momentum(1).norm(), 0);
    EXPECT_LE(report.max_penetration, 1e-12);
  }
}

// Two balls on a spring (reduced mass 1/2, k = 50): a tumbling dumbbell under no other force.
TEST(EventDrivenStepper, BodiesOnASpringKeepEnergyAndMomentum) {
  ModelBuilder builder;
  builder.set_gravity(Vec3::Zero());
  builder.add_material({"m", 1000, 0, 0});
  for (const double x : {-1.0, 1.0}) {
    BodyDescription ball = test::stepping_body(x < 0 ? "a" : "b", Sphere{0.1}, Vec3(x, 0, 0));
    ball.velocity = Vec3(0.3, x, 0.2 * x);
    builder.add_body(ball);
  }
  ModelBuilder::ForceDescription spring{};
  spring.type = ModelBuilder::ForceDescription::Type::spring;
  spring.bodies = {"a", "b"};
  spring.points = {Vec3(0.05, 0, 0), Vec3(0, 0.05, 0)};
  spring.stiffness = 50;
  spring.length = 1.5;
  builder.add_force(spring);
  const std::shared_ptr<const Model> model = builder.build();
  State state = make_initial_state(*model);
  const double before = mechanical_energy(*model, Environment(*model), state).total();
  const AdvanceReport report = EventDrivenStepper(model, Method{}, 0.01).advance(state, 5);
  EXPECT_NEAR(mechanical_energy(*model, Environment(*model), state).total(), before, 1e-8 * before);
  EXPECT_LE((state.linear_momentum(0) + state.linear_momentum(1) - Vec3(0.6, 0, 0)).norm(), 1e-12);
  EXPECT_EQ(report.impacts, 0);
  EXPECT_EQ(report.fallbacks, 0);
  EXPECT_EQ(report.coarse_steps, 0);
}

// What cannot go on says why, and when, and of whom.

TEST(StopReasons, ABallBetweenAWallAndAPistonBouncesEverFaster) {
  ModelBuilder builder = test::stepping_builder(1, 0, Vec3(0, 0, 0));
  BodyDescription piston = test::stepping_body("piston", Box{Vec3(1, 1, 0.05)}, Vec3(0, 0, 1));
  piston.mass.reset();
  piston.motion = MotionType::kinematic;
  piston.velocity = Vec3(0, 0, -1);
  builder.add_body(piston);
  BodyDescription ball = test::stepping_body("ball", Sphere{0.1}, Vec3(0, 0, 0.5));
  ball.velocity = Vec3(0, 0, 0.1);
  builder.add_body(ball);
  const std::shared_ptr<const Model> model = builder.build();
  State state = make_initial_state(*model);
  Method method;
  method.time_tolerance = 1e-9;
  const AdvanceReport report = EventDrivenStepper(model, method, 0.01).advance(state, 2);
  EXPECT_EQ(report.reason, StopReason::events_accumulate);
  // The gap closes at 0.75 s.
  EXPECT_NEAR(state.t, 0.75, 1e-3);
  EXPECT_LT(state.t, 0.75);
  ASSERT_EQ(report.bodies.size(), 2u);
  EXPECT_EQ(report.bodies.back(), 2);
}

TEST(StopReasons, ABoxUnderAPressHasNoWayOut) {
  ModelBuilder builder = test::stepping_builder(0, 0.3, Vec3(0, 0, -g));
  BodyDescription press = test::stepping_body("press", Box{Vec3(1, 1, 0.05)}, Vec3(0, 0, 1));
  press.mass.reset();
  press.motion = MotionType::kinematic;
  press.velocity = Vec3(0, 0, -1);
  builder.add_body(press);
  builder.add_body(test::stepping_body("box", Box{Vec3(0.1, 0.1, 0.1)}, Vec3(0, 0, 0.1)));
  const std::shared_ptr<const Model> model = builder.build();
  State state = make_initial_state(*model);
  const AdvanceReport report = EventDrivenStepper(model, Method{}, 0.01).advance(state, 2);
  EXPECT_EQ(report.reason, StopReason::impact_unsolved);
  EXPECT_NEAR(state.t, 0.75, 1e-9);
  EXPECT_EQ(report.bodies, std::vector<int>{2});
}

TEST(StopReasons, AnUnstableIntegratorEndsAtTheFirstStateThatIsNoNumber) {
  ModelBuilder builder;
  builder.add_material({"m", 1000, 0, 0});
  builder.set_gravity(Vec3::Zero());
  builder.add_body(test::stepping_body("ball", Sphere{0.1}, Vec3(1, 0, 0)));
  ModelBuilder::ForceDescription spring{};
  spring.type = ModelBuilder::ForceDescription::Type::spring;
  spring.bodies = {"world", "ball"};
  spring.points = {Vec3::Zero(), Vec3::Zero()};
  spring.stiffness = 1e15;
  spring.length = 0;
  builder.add_force(spring);
  const std::shared_ptr<const Model> model = builder.build();
  State state = make_initial_state(*model);
  Method method;
  method.integrator = IntegratorMethod::euler;
  const AdvanceReport report = EventDrivenStepper(model, method, 0.1).advance(state, 100);
  EXPECT_EQ(report.reason, StopReason::not_finite);
  EXPECT_EQ(report.bodies, std::vector<int>{0});
  EXPECT_LT(state.t, 100);
  // The state is the last that was one.
  EXPECT_TRUE(state.position(0).allFinite() && state.linear_momentum(0).allFinite());
}

}  // namespace
}  // namespace rigor::event_driven_stepper_test
