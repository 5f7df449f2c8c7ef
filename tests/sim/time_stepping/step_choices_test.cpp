// What solvers, cones and kinds of friction do through the whole time stepper, against formulas.

#include "rigor/sim/time_stepping/time_stepper.hpp"

#include "sim/time_stepping_scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rigor::step_choices_test {
namespace {

constexpr double g = 9.81, radius = 0.1;

Method stepping() {
  Method method;
  method.scheme = Scheme::time_stepping;
  return method;
}

/// A floor and one body, both of this material; gravity leans by `slope` [rad] towards x.
std::shared_ptr<const Model> model_of(Material material, BodyDescription body, double slope = 0) {
  ModelBuilder builder;
  builder.set_gravity(g * Vec3(std::sin(slope), 0, -std::cos(slope)));
  material.name = "m";
  builder.add_material(material);
  BodyDescription floor;
  floor.name = "floor";
  floor.motion = MotionType::fixed;
  floor.shapes.push_back({HalfSpace{Vec3::UnitZ(), 0}, Vec3::Zero(), Quat::Identity(), "m", ""});
  builder.add_body(floor);
  builder.add_body(std::move(body));
  return builder.build();
}

BodyDescription ball(double v, double spin) {
  BodyDescription body = test::stepping_body("ball", Sphere{radius}, Vec3(0, 0, radius));
  body.velocity = Vec3(v, 0, 0);
  body.angular_velocity = Vec3(0, v / radius, spin);
  return body;
}

BodyDescription block(const Vec3& v) {
  BodyDescription body = test::stepping_body("block", Box{Vec3(0.2, 0.2, 0.1)}, Vec3(0, 0, 0.1));
  body.velocity = v;
  return body;
}

State run(const std::shared_ptr<const Model>& model, const Method& method, double h, double t) {
  State state = make_initial_state(*model);
  EXPECT_EQ(TimeStepper(model, method, h).advance(state, t).reason, StopReason::reached_end);
  return state;
}

TEST(StepChoices, RollingFrictionStopsABallWhereItsLawSays) {
  // (1 + 2/5) m a R = ρ m g.
  const double rho = 1e-3, v = 0.1, a = 5.0 / 7 * rho * g / radius;
  const std::shared_ptr<const Model> model = model_of({.friction = 0.5, .rolling_friction = rho}, ball(v, 0));
  for (const double h : {0.1, 0.01}) {
    const State rolling = run(model, stepping(), h, 1);
    EXPECT_NEAR(rolling.linear_momentum(1).x(), v - a, 1e-10) << h;
    EXPECT_NEAR(rolling.position(1).x(), v - 0.5 * a, 1e-10) << h;
    // The stop is somewhere within a step, which it takes evenly: a way of at most a h² / 8 more.
    const State stopped = run(model, stepping(), h, 2);
    EXPECT_NEAR(stopped.position(1).x(), v * v / (2 * a), a * h * h / 8) << h;
    EXPECT_LT(stopped.linear_momentum(1).norm(), 1e-12) << h;
  }
}

TEST(StepChoices, RollingFrictionHoldsABallOnASlopeUpToItsArm) {
  const double rho = 2e-3;
  for (const double share : {0.99, 1.01}) {
    // It tips about a point that is ρ ahead: tan α = ρ / R.
    const double slope = std::atan(share * rho / radius);
    const std::shared_ptr<const Model> model =
        model_of({.friction = 0.5, .rolling_friction = rho}, ball(0, 0), slope);
    const double a = 5.0 / 7 * g * (std::sin(slope) - rho / radius * std::cos(slope));
    EXPECT_NEAR(run(model, stepping(), 0.01, 1).position(1).x(), share < 1 ? 0 : 0.5 * a, 1e-10) << share;
  }
}

TEST(StepChoices, TorsionalFrictionStopsASpinningBall) {
  const double sigma = 1e-3, spin = 5, alpha = sigma * g / (0.4 * radius * radius);
  const std::shared_ptr<const Model> model =
      model_of({.friction = 0.5, .torsional_friction = sigma}, ball(0, spin));
  const State turning = run(model, stepping(), 0.01, 1);
  EXPECT_NEAR(turning.angular_momentum(1).z(), 0.4 * radius * radius * (spin - alpha), 1e-12);
  EXPECT_LT(run(model, stepping(), 0.01, 3).angular_momentum(1).norm(), 1e-13);
}

TEST(StepChoices, StaticFrictionHoldsABlockThatKineticFrictionDoesNot) {
  const double slope = 20 * M_PI / 180, mu = 0.5 * std::tan(slope);
  Material material{.friction = mu};
  const double a = g * (std::sin(slope) - mu * std::cos(slope));
  EXPECT_NEAR(run(model_of(material, block(Vec3::Zero()), slope), stepping(), 0.01, 1).position(1).x(),
              0.5 * a, 1e-10);
  material.static_friction = 1.01 * std::tan(slope);
  for (const double h : {0.1, 0.01}) {
    const State held = run(model_of(material, block(Vec3::Zero()), slope), stepping(), h, 2);
    EXPECT_LT((held.position(1) - Vec3(0, 0, 0.1)).norm(), 1e-13) << h;
  }
  material.static_friction = 0.99 * std::tan(slope);
  EXPECT_NEAR(run(model_of(material, block(Vec3::Zero()), slope), stepping(), 0.01, 1).position(1).x(),
              0.5 * a, 1e-10);
}

TEST(StepChoices, PushedBlockSlidesByItsKineticFrictionAndIsHeldOnceItStops) {
  const double slope = 20 * M_PI / 180, mu = 0.5 * std::tan(slope), v = 0.5, h = 0.01;
  const Material material{.friction = mu, .static_friction = 1.01 * std::tan(slope)};
  const double down = g * (std::sin(slope) - mu * std::cos(slope));
  const State slid = run(model_of(material, block(Vec3(v, 0, 0)), slope), stepping(), h, 1);
  EXPECT_NEAR(slid.position(1).x(), v + 0.5 * down, 1e-10);
  // Up the slope it stops, and stays there by its static friction.
  const double up = g * (std::sin(slope) + mu * std::cos(slope));
  const std::shared_ptr<const Model> model = model_of(material, block(Vec3(-v, 0, 0)), slope);
  const State stopped = run(model, stepping(), h, 0.5), later = run(model, stepping(), h, 2);
  EXPECT_NEAR(stopped.position(1).x(), -v * v / (2 * up), up * h * h / 8);
  EXPECT_LT((later.position(1) - stopped.position(1)).norm(), 1e-13);
}

TEST(StepChoices, ConvexConeLiftsWhatSlidesByAGapThatTheExactConeDoesNotOpen) {
  // Down a slope from rest. De Saxcé's correction keeps w_n = 0; without it w_n = u_n + gap / h = μ |u_t|,
  // and the gap follows h μ |u_t| with u_n = h μ a.
  const double slope = M_PI / 6, mu = 0.3, t = 0.5, a = g * (std::sin(slope) - mu * std::cos(slope));
  const std::shared_ptr<const Model> model = model_of({.friction = mu}, block(Vec3::Zero()), slope);
  for (const double h : {0.01, 0.005}) {
    Method method = stepping();
    const State exact = run(model, method, h, t);
    EXPECT_LT(std::abs(exact.position(1).z() - 0.1), 1e-13) << h;
    EXPECT_NEAR(exact.position(1).x(), 0.5 * a * t * t, 1e-10) << h;
    method.cone = ConeMethod::convex;
    const State lifted = run(model, method, h, t);
    const double u = lifted.linear_momentum(1).x();
    EXPECT_NEAR(u, a * t, 2 * h * a) << h;
    EXPECT_NEAR(lifted.position(1).z() - 0.1, h * mu * u, 2 * h * h * mu * a) << h;
  }
}

TEST(StepChoices, ConvexConeThrowsUpWhatIsSetSliding) {
  // It leaves the floor with μ |u_t|, whatever the step.
  const double mu = 0.3, v = 3, h = 0.001;
  const std::shared_ptr<const Model> model = model_of({.friction = mu}, block(Vec3(v, 0, 0)));
  Method method = stepping();
  method.cone = ConeMethod::convex;
  const Vec3 P = run(model, method, h, h).linear_momentum(1);
  EXPECT_NEAR(P.z(), mu * P.x(), 1e-9);
  EXPECT_GT(P.z(), 0.8);
}

TEST(StepChoices, PyramidBrakesTheDiagonalByTheCosineOf45DegreesTooLittle) {
  const double mu = 0.3, v = 3, t = 0.5;
  for (const auto& [direction, factor] :
       {std::pair{Vec3(1, 0, 0), 1.0}, std::pair{Vec3(std::sqrt(0.5), std::sqrt(0.5), 0), std::sqrt(0.5)}}) {
    const std::shared_ptr<const Model> model = model_of({.friction = mu}, block(v * direction));
    Method method = stepping();
    EXPECT_NEAR(run(model, method, 0.01, t).linear_momentum(1).dot(direction), v - mu * g * t, 1e-10);
    method.cone = ConeMethod::pyramid;
    const Vec3 P = run(model, method, 0.01, t).linear_momentum(1);
    EXPECT_NEAR(P.dot(direction), v - factor * mu * g * t, 1e-10);
    EXPECT_LT(P.cross(direction).norm(), 1e-10);
  }
}

TEST(StepChoices, ProjectedGaussSeidelConvergesToExactWithItsSweeps) {
  // A column of blocks whose lowest one is pulled out of it.
  ModelBuilder builder = test::stepping_builder(0, 0.4, Vec3(0, 0, -g));
  for (int i = 0; i < 4; ++i) {
    BodyDescription body = block(Vec3(i == 0 ? 1 : 0, 0, 0));
    body.name += std::to_string(i);
    body.p_WU.z() += 0.2 * i;
    builder.add_body(body);
  }
  const std::shared_ptr<const Model> model = builder.build();
  const double h = 0.01, t = 0.1;
  const State exact = run(model, stepping(), h, t);
  const auto error = [&](double sweeps) {
    Method method = stepping();
    method.solver = SolverMethod::pgs;
    method.iterations = sweeps;
    const State state = run(model, method, h, t);
    double largest = 0;
    for (int i = 1; i <= 4; ++i) largest = std::max(largest, (state.position(i) - exact.position(i)).norm());
    return largest;
  };
  const double few = error(10), more = error(300), many = error(3000);
  EXPECT_GT(few, 1e-4);
  EXPECT_LT(more, 0.3 * few);
  EXPECT_LT(many, 0.3 * more);
}

TEST(StepChoices, ProjectedGaussSeidelTellsWhatItHasNotSolved) {
  ModelBuilder builder = test::stepping_builder(0, 0.4, Vec3(0, 0, -g));
  builder.add_body(block(Vec3(1, 0, 0)));
  const std::shared_ptr<const Model> model = builder.build();
  Method method = stepping();
  method.solver = SolverMethod::pgs;
  method.iterations = 1;
  State state = make_initial_state(*model);
  const AdvanceReport report = TimeStepper(model, method, 0.01).advance(state, 0.1);
  EXPECT_GT(report.max_residual, 1e-3);
  EXPECT_GE(report.fallbacks, 10);
  EXPECT_EQ(report.max_iterations, 1);
}

TEST(StepChoices, ElasticBallsKeepTheirEnergyWhereverTheirStepsFall) {
  // One ball in a hundred is so near the floor that only its weight brings it there within the step.
  ModelBuilder builder = test::stepping_builder(1, 0, Vec3(0, 0, -g));
  const int count = 200;
  for (int i = 0; i < count; ++i) {
    BodyDescription body = ball(0, 0);
    body.name += std::to_string(i);
    body.p_WU = Vec3(i, 0, 1 + 0.001 * i);
    builder.add_body(body);
  }
  const std::shared_ptr<const Model> model = builder.build();
  const State state = run(model, stepping(), 0.01, 1.2);
  for (int i = 0; i < count; ++i) {
    const double height = state.position(1 + i).z(), speed = state.linear_momentum(1 + i).norm();
    EXPECT_NEAR(0.5 * speed * speed + g * height, g * (1 + 0.001 * i), 1e-11) << i;
  }
}

TEST(StepChoices, ReportTellsContactsThatEndAndBeginToLast) {
  // A ball rolls off a table, faster than it could roll over the edge (v² > g R), and lands on the floor.
  const double height = 0.5, way = 0.2, v = 1, h = 0.01;
  ModelBuilder builder = test::stepping_builder(0, 0.5, Vec3(0, 0, -g));
  BodyDescription table = test::stepping_body("table", Box{Vec3(0.5, 0.5, 0.25)}, Vec3(-0.5, 0, 0.25));
  table.motion = MotionType::fixed;
  table.mass.reset();
  builder.add_body(table);
  BodyDescription rolling = ball(v, 0);
  rolling.p_WU = Vec3(-way, 0, height + radius);
  builder.add_body(rolling);
  const std::shared_ptr<const Model> model = builder.build();
  State state = make_initial_state(*model);
  const AdvanceReport report = TimeStepper(model, stepping(), h).advance(state, 1);
  EXPECT_EQ(report.separations, 1);
  EXPECT_EQ(report.resting, 1);
  std::vector<MotionEvent> events = report.events;
  std::erase_if(events, [](const MotionEvent& event) { return event.kind == MotionEvent::Kind::impact; });
  ASSERT_EQ(events.size(), 2u);
  EXPECT_EQ(events[0].kind, MotionEvent::Kind::separation);
  EXPECT_EQ(std::pair(events[0].body_A, events[0].body_B), std::pair(1, 2));
  EXPECT_NEAR(events[0].time, way / v, 2 * h);
  EXPECT_EQ(events[1].kind, MotionEvent::Kind::rest);
  EXPECT_EQ(std::pair(events[1].body_A, events[1].body_B), std::pair(0, 2));
  // It lands within a step, and rests in the next one.
  EXPECT_NEAR(events[1].time, way / v + std::sqrt(2 * height / g), 3 * h);
}

}  // namespace
}  // namespace rigor::step_choices_test
