// Whole runs by time stepping: walls, stacks, rolling, orders of convergence, laws of energy and momentum.

#include "rigor/sim/make_stepper.hpp"
#include "sim/time_stepping_scenes.hpp"

#include "rigor/sim/event_driven/event_driven_stepper.hpp"
#include "rigor/sim/report/energy.hpp"
#include "rigor/sim/simulation.hpp"
#include "rigor/sim/time_stepping/time_stepper.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace rigor::time_stepping_runs_test {
namespace {

constexpr double g = 9.81;

Method stepping(SimultaneousLaw simultaneous = SimultaneousLaw::reflections) {
  Method method;
  method.scheme = Scheme::time_stepping;
  method.simultaneous = simultaneous;
  return method;
}

/// A body that flies along x at `speed` against a wall at x = 1, turning at `spin` about y.
std::shared_ptr<const Model> wall_scene(const Shape& shape, double wall, double speed, double spin) {
  ModelBuilder builder;
  builder.set_gravity(Vec3::Zero());
  builder.add_material({"m", 1000, 0.3, 0.5});
  BodyDescription plate;
  plate.name = "wall";
  plate.motion = MotionType::fixed;
  plate.p_WU = Vec3(1, 0, 0);
  plate.shapes.push_back({Box{Vec3(0.5 * wall, 2, 2)}, Vec3::Zero(), Quat::Identity(), "m", ""});
  builder.add_body(plate);
  BodyDescription body = test::stepping_body("body", shape, Vec3::Zero());
  body.velocity = Vec3(speed, 0, 0);
  body.angular_velocity = Vec3(0, spin, 0.3 * spin);
  builder.add_body(body);
  return builder.build();
}

TEST(TimeSteppingRuns, NothingPassesAThinWallAndNothingStopsBeforeIt) {
  int cases = 0;
  for (const Shape& shape :
       {Shape{Sphere{0.05}}, Shape{Box{Vec3(0.05, 0.05, 0.05)}}, Shape{Capsule{0.01, 0.2}},
        Shape{Cylinder{0.05, 0.02}}, Shape{Box{Vec3(0.2, 0.005, 0.01)}}}) {
    for (const double wall : {1e-3, 0.02, 0.1}) {
      for (const double speed : {5.0, 20.0, 100.0, 400.0}) {
        for (const double spin : {0.0, 50.0}) {
          ++cases;
          const std::shared_ptr<const Model> model = wall_scene(shape, wall, speed, spin);
          State state = make_initial_state(*model);
          TimeStepper stepper(model, stepping(), 1.0 / 60);
          AdvanceReport report;
          for (int k = 1; state.t < 1.2 / speed + 2.0 / 60; ++k) {
            report.add(stepper.advance(state, k / 60.0));
            ASSERT_LT(state.position(1).x(), 1) << "case " << cases << " t " << state.t;
          }
          EXPECT_GE(report.impacts, 1) << cases;
          EXPECT_LT(state.linear_momentum(1).x(), 0.9 * speed) << cases;
          EXPECT_LE(report.max_penetration, 1e-6) << cases;
        }
      }
    }
  }
  EXPECT_EQ(cases, 120);
}

TEST(TimeSteppingRuns, StacksStandAtSixtyStepsASecondWithAnyLoadOnTop) {
  for (const auto& [count, top] : {std::pair{20, 1.0}, std::pair{10, 100.0}, std::pair{10, 1e6}}) {
    ModelBuilder builder = test::stepping_builder(0, 0.5, Vec3(0, 0, -g));
    for (int k = 0; k < count; ++k) {
      BodyDescription cube = test::stepping_body("cube" + std::to_string(k), Box{Vec3(0.1, 0.1, 0.1)},
                                                 Vec3(0, 0, 0.1 + 0.2 * k));
      if (k + 1 == count) cube.mass = top;
      builder.add_body(cube);
    }
    const std::shared_ptr<const Model> model = builder.build();
    State state = make_initial_state(*model);
    const AdvanceReport report = TimeStepper(model, stepping(), 1.0 / 60).advance(state, 1);
    for (int k = 0; k < count; ++k)
      EXPECT_LT((state.position(k + 1) - Vec3(0, 0, 0.1 + 0.2 * k)).norm(), 1e-9) << count << " " << top;
    EXPECT_EQ(report.fallbacks, 0);
  }
}

/// A box of 10 kg on the ground with balls of 1 kg on it, pushed by 150 N (SimBenchmark, rolling).
std::shared_ptr<const Model> rolling_scene(const Vec3& direction) {
  ModelBuilder builder;
  builder.set_gravity(Vec3(0, 0, -g));
  for (const char* name : {"ground", "box", "ball"}) builder.add_material({name, 1000, 0, 0});
  builder.set_pair("ground", "box", {0.4, 0});
  builder.set_pair("box", "ball", {0.8, 0});
  BodyDescription ground;
  ground.name = "ground";
  ground.motion = MotionType::fixed;
  ground.shapes.push_back({HalfSpace{Vec3::UnitZ(), 0}, Vec3::Zero(), Quat::Identity(), "ground", ""});
  builder.add_body(ground);
  BodyDescription box = test::stepping_body("box", Box{Vec3(10, 10, 0.5)}, Vec3(0, 0, 0.5));
  box.mass = 10;
  box.shapes[0].material = "box";
  builder.add_body(box);
  for (int i = 0; i < 25; ++i) {
    BodyDescription ball = test::stepping_body("ball" + std::to_string(i), Sphere{0.5},
                                               Vec3(2 * (i % 5) - 4, 2 * (i / 5) - 4, 1.5));
    ball.shapes[0].material = "ball";
    builder.add_body(ball);
  }
  ModelBuilder::ForceDescription force{ModelBuilder::ForceDescription::Type::constant, {"box"}, {}};
  force.vector = 150 * direction;
  builder.add_force(force);
  return builder.build();
}

TEST(TimeSteppingRuns, BallsRollOnAPushedBoxAlikeInAllDirections) {
  const double M = 10, m = 1, n = 25;
  const double f1 = 0.4 * (M + n * m) * g, f2 = (150 - f1) / M / (3.5 / m + n / M);
  const double a_box = (150 - f1 - n * f2) / M, a_ball = f2 / m;
  for (const Vec3& direction : {Vec3(0, 1, 0), Vec3(0.5, std::sqrt(0.75), 0)}) {
    const std::shared_ptr<const Model> model = rolling_scene(direction);
    State state = make_initial_state(*model);
    TimeStepper stepper(model, stepping(), 1e-3);
    double sum = 0;
    constexpr int steps = 50;
    for (int k = 1; k <= steps; ++k) {
      stepper.advance(state, 1e-3 * k);
      sum += (linear_velocity(*model, state, 1) - a_box * state.t * direction).squaredNorm() +
             (linear_velocity(*model, state, 2) - a_ball * state.t * direction).squaredNorm();
    }
    EXPECT_LT(sum / steps, 1e-20);
  }
}

/// Three balls in a row that touch: 10, 10/9 and 10 kg at 1, 0 and 1/2 m/s, e = 1.
double energy_ratio_of_three_balls(SimultaneousLaw simultaneous) {
  ModelBuilder builder;
  builder.set_gravity(Vec3::Zero());
  builder.add_material({"m", 1000, 0, 1});
  for (int i = 0; i < 3; ++i) {
    BodyDescription ball =
        test::stepping_body("ball" + std::to_string(i), Sphere{0.125}, Vec3(0.25 * i, 0, 0));
    ball.mass = i == 1 ? 10.0 / 9 : 10;
    ball.velocity = Vec3(i == 0 ? 1 : i == 1 ? 0 : 0.5, 0, 0);
    builder.add_body(ball);
  }
  const std::shared_ptr<const Model> model = builder.build();
  State state = make_initial_state(*model);
  TimeStepper(model, stepping(simultaneous), 0.01).advance(state, 0.01);
  double energy = 0;
  for (int i = 0; i < 3; ++i) energy += 0.5 * state.linear_momentum(i).squaredNorm() / model->body(i).mass;
  return energy / (0.5 * 10 * (1 + 0.25));
}

TEST(TimeSteppingRuns, NewtonsLawOnAllContactsAtOnceGainsEnergyAndReflectionsDoNot) {
  // LCP_ENERGY_GAIN of the reference catalogue.
  EXPECT_NEAR(energy_ratio_of_three_balls(SimultaneousLaw::lcp), 1.273684210526, 1e-12);
  EXPECT_NEAR(energy_ratio_of_three_balls(SimultaneousLaw::reflections), 1, 1e-12);
}

TEST(TimeSteppingRuns, BoxesThatCollideInFreeFlightKeepTheirMomenta) {
  ModelBuilder builder;
  builder.set_gravity(Vec3::Zero());
  builder.add_material({"m", 1000, 0.4, 0.3});
  for (int i = 0; i < 4; ++i) {
    BodyDescription box = test::stepping_body("box" + std::to_string(i), Box{Vec3(0.1, 0.15, 0.2)},
                                              0.6 * Vec3(i % 2 - 0.5, i / 2 - 0.5, 0.1 * i));
    box.velocity = -2 * box.p_WU;
    box.angular_velocity = Vec3(1 + i, 2 - i, 0.5 * i);
    builder.add_body(box);
  }
  const std::shared_ptr<const Model> model = builder.build();
  State state = make_initial_state(*model);
  const Momentum before = total_momentum(*model, state);
  const AdvanceReport report = TimeStepper(model, stepping(), 0.01).advance(state, 2);
  const Momentum after = total_momentum(*model, state);
  EXPECT_GT(report.impacts, 0);
  EXPECT_LT((after.linear - before.linear).norm(), 1e-13);
  EXPECT_LT((after.angular - before.angular).norm(), 1e-13);
}

/// Where a ball that rolls down a fixed ball is after 0.4 s, by each scheme.
Vec3 ball_on_ball(Scheme scheme, double h) {
  ModelBuilder builder;
  builder.set_gravity(Vec3(0, 0, -g));
  builder.add_material({"m", 1000, 5, 0});
  BodyDescription fixed = test::stepping_body("fixed", Sphere{1}, Vec3::Zero());
  fixed.motion = MotionType::fixed;
  fixed.mass.reset();
  builder.add_body(fixed);
  const double angle = 0.2;
  builder.add_body(
      test::stepping_body("ball", Sphere{0.25}, 1.25 * Vec3(std::sin(angle), 0, std::cos(angle))));
  const std::shared_ptr<const Model> model = builder.build();
  Method method;
  method.scheme = scheme;
  State state = make_initial_state(*model);
  make_stepper(model, method, h)->advance(state, 0.4);
  return state.position(1);
}

TEST(TimeSteppingRuns, RollingIsOfSecondOrder) {
  const Vec3 exact = ball_on_ball(Scheme::event_driven, 0.01);
  const double coarse = (ball_on_ball(Scheme::time_stepping, 0.04) - exact).norm();
  const double fine = (ball_on_ball(Scheme::time_stepping, 0.02) - exact).norm();
  EXPECT_LT(coarse, 2e-4);
  EXPECT_NEAR(std::log2(coarse / fine), 2, 0.2);
  // Down to the overlap that is left as it is, a fifth of the contact tolerance a step.
  EXPECT_LT((ball_on_ball(Scheme::time_stepping, 0.005) - exact).norm(), 1e-5);
}

/// Bodies askew in four columns above the floor, which fall into a heap: boxes alone, or all kinds.
std::shared_ptr<const Model> falling_heap(unsigned seed, bool is_mixed, double restitution) {
  std::mt19937 engine(seed);
  const auto draw = [&](double most) {
    return most * (2 * static_cast<double>(engine()) / static_cast<double>(std::mt19937::max()) - 1);
  };
  const std::vector<Shape> shapes{Box{Vec3(0.075, 0.06, 0.05)}, Cylinder{0.06, 0.05}, Sphere{0.07},
                                  Capsule{0.05, 0.05}};
  ModelBuilder builder = test::stepping_builder(restitution, 0.5, Vec3(0, 0, -g));
  for (int k = 0; k < 12; ++k) {
    BodyDescription body = test::stepping_body(
        "b" + std::to_string(k), shapes[is_mixed ? static_cast<std::size_t>(k / 4 + k) % 4 : 0],
        Vec3(0.25 * (k % 2) + draw(0.02), 0.25 * (k / 2 % 2) + draw(0.02), 0.3 + 0.25 * (k / 4)));
    body.q_WU = Quat(1, draw(0.5), draw(0.5), draw(0.5)).normalized();
    builder.add_body(body);
  }
  return builder.build();
}

TEST(TimeSteppingRuns, HeapsTakeFewStepsOverlapNowhereAndGainNoEnergy) {
  for (const unsigned seed : {1u, 2u}) {
    for (const bool is_mixed : {false, true}) {
      for (const double restitution : {0.0, 0.3}) {
        const std::shared_ptr<const Model> model = falling_heap(seed, is_mixed, restitution);
        const Environment environment(*model);
        State state = make_initial_state(*model);
        TimeStepper stepper(model, stepping(), 0.01);
        AdvanceReport report;
        double energy = mechanical_energy(*model, environment, state).total();
        for (int k = 1; k <= 50; ++k) {
          report.add(stepper.advance(state, 0.01 * k));
          const double now = mechanical_energy(*model, environment, state).total();
          EXPECT_LE(now, energy + 1e-9) << seed << is_mixed << restitution << " t " << state.t;
          energy = now;
        }
        ASSERT_EQ(report.reason, StopReason::reached_end);
        EXPECT_LE(report.max_penetration, 1e-6) << seed << is_mixed << restitution;
        EXPECT_TRUE(find_overlaps(*model, state, 1e-6).empty()) << seed << is_mixed << restitution;
        EXPECT_LT(report.momentum_error.norm(), 1e-11) << seed << is_mixed << restitution;
        EXPECT_LT(report.angular_momentum_error.norm(), 1e-11) << seed << is_mixed << restitution;
        // One problem for each island that touches, of twelve bodies that fall half of the time.
        EXPECT_LT(report.steps, 400) << seed << is_mixed << restitution;
      }
    }
  }
}

/// Where a cube is after two impacts.
Vec3 cube_at(Scheme scheme, double h, double t) {
  const std::shared_ptr<const Model> model = test::stepping_cube(1, 1);
  Method method;
  method.scheme = scheme;
  State state = make_initial_state(*model);
  make_stepper(model, method, h)->advance(state, t);
  return state.position(1);
}

TEST(TimeSteppingRuns, ImpactsAreOfFirstOrder) {
  // The instant of the impact is wrong by up to h, and with it what follows.
  const Vec3 exact = cube_at(Scheme::event_driven, 0.01, 0.3);
  for (const double h : {1e-2, 1e-3, 1e-4})
    EXPECT_LT((cube_at(Scheme::time_stepping, h, 0.3) - exact).norm(), 5 * h) << h;
}

TEST(TimeSteppingRuns, DryFrictionOfAHingeStopsAWheelForGood) {
  // ω = ω₀ - τ t / I until it stands.
  ModelBuilder builder = test::stepping_builder(0, 0, Vec3::Zero());
  BodyDescription wheel = test::stepping_body("wheel", Cylinder{0.2, 0.05}, Vec3(0, 0, 1));
  wheel.angular_velocity = Vec3(0, 0, 10);
  builder.add_body(wheel);
  ModelBuilder::JointDescription hinge;
  hinge.name = "axle";
  hinge.type = JointType::hinge;
  hinge.bodies = {"world", "wheel"};
  hinge.anchors = {Vec3(0, 0, 1)};
  JointAxis axis;
  axis.friction = 0.1;
  hinge.axes = {axis};
  builder.add_joint(hinge);
  const std::shared_ptr<const Model> model = builder.build();
  State state = make_initial_state(*model);
  TimeStepper stepper(model, stepping(), 0.01);
  const double I = 0.5 * 0.2 * 0.2, deceleration = 0.1 / I;
  stepper.advance(state, 1);
  EXPECT_NEAR(angular_velocity(*model, state, 1).z(), 10 - deceleration, 1e-11);
  stepper.advance(state, 4);
  EXPECT_NEAR(angular_velocity(*model, state, 1).z(), 0, 1e-12);
}

}  // namespace
}  // namespace rigor::time_stepping_runs_test
