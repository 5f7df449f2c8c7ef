// Cases of the course's catalogue by every scheme that carries them: three balls in a row, a block thrown
// across a slope, balls on a pushed box, stacks, many elastic balls, a tower of blocks, scenes in other
// units.

#include "sim/time_stepping_scenes.hpp"

#include "random_vectors.hpp"
#include "rigor/dynamics/environment.hpp"
#include "rigor/sim/audit/audit.hpp"
#include "rigor/sim/audit/contact_snapshot.hpp"
#include "rigor/sim/make_stepper.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace rigor::scheme_catalogue_test {
namespace {

constexpr double g = 9.81;

Method method_of(Scheme scheme) {
  Method method;
  method.scheme = scheme;
  return method;
}

/// A run of a model from its start.
struct SchemeRun {
  State state;
  AdvanceReport report;
};

SchemeRun run(const std::shared_ptr<const Model>& model, const Method& method, double step, double end) {
  SchemeRun run{make_initial_state(*model), {}};
  run.report = make_stepper(model, method, step)->advance(run.state, end);
  EXPECT_EQ(run.report.reason, StopReason::reached_end) << run.report.detail;
  return run;
}

/// Three balls in a row that touch: 10, 10/9 and 10 kg at 1, 0 and 1/2 m/s, e = 1.
std::shared_ptr<const Model> three_balls() {
  ModelBuilder builder;
  builder.set_gravity(Vec3::Zero());
  builder.add_material({"m", 1000, 0, 1});
  const double masses[] = {10, 10.0 / 9, 10}, speeds[] = {1, 0, 0.5};
  for (int i = 0; i < 3; ++i) {
    BodyDescription ball =
        test::stepping_body("ball" + std::to_string(i), Sphere{0.125}, Vec3(0.25 * i, 0, 0));
    ball.mass = masses[i];
    ball.velocity = Vec3(speeds[i], 0, 0);
    builder.add_body(ball);
  }
  return builder.build();
}

// LCP_ENERGY_GAIN of the catalogue: one pair after the other, or reflections, keep the energy.
TEST(SchemeCatalogue, ALightBallBetweenHeavyOnesPassesTheBlowOnWithoutGain) {
  const double expected[] = {0.39968, 0.919296, 0.998176};
  for (const Scheme scheme :
       {Scheme::event_driven, Scheme::time_stepping, Scheme::impulse_based, Scheme::hybrid}) {
    const std::shared_ptr<const Model> model = three_balls();
    const SchemeRun end = run(model, method_of(scheme), 0.01, 0.05);
    for (int i = 0; i < 3; ++i)
      EXPECT_NEAR(linear_velocity(*model, end.state, i).x(), expected[i], 1e-12) << static_cast<int>(scheme);
    EXPECT_LE(end.report.impact_gain, 1e-13);
  }
}

/// A low block on a slope of 20 degrees (gravity is tilted: x down the slope) with friction tan 20°, thrown
/// across with 2 m/s.
std::shared_ptr<const Model> block_thrown_across() {
  const double angle = 20 * std::numbers::pi / 180;
  ModelBuilder builder =
      test::stepping_builder(0, std::tan(angle), g * Vec3(std::sin(angle), 0, -std::cos(angle)));
  BodyDescription block = test::stepping_body("block", Box{Vec3(0.2, 0.2, 0.05)}, Vec3(0, 0, 0.05));
  block.velocity = Vec3(0, 2, 0);
  builder.add_body(block);
  return builder.build();
}

// |v| (1 + cos ψ) = v0 with the angle ψ to the fall line; the reference's velocity and place at 0.5 s. A
// pyramid of friction gives (1, 1).
TEST(SchemeCatalogue, ABlockThrownAcrossASlopeTurnsDownAsTheExactConeSays) {
  const Vec2 velocity(0.913029644640213, 0.589814734844041), place(0.289991605797194, 0.613895542600698);
  const std::shared_ptr<const Model> model = block_thrown_across();
  // What integrators leave; the square of the step, for time stepping; of penalty the bristles, whose slip is
  // not resolved finer than a sub-step; of trains of collisions the flights between them.
  for (const auto& [scheme, step, tolerance] :
       {std::tuple{Scheme::event_driven, 0.01, 1e-10}, std::tuple{Scheme::hybrid, 0.01, 1e-10},
        std::tuple{Scheme::time_stepping, 1e-3, 2e-3}, std::tuple{Scheme::penalty, 1e-3, 2e-3},
        std::tuple{Scheme::impulse_based, 1e-3, 2e-3}}) {
    const SchemeRun end = run(model, method_of(scheme), step, 0.5);
    const Vec2 x = end.state.position(1).head<2>(), v = linear_velocity(*model, end.state, 1).head<2>();
    EXPECT_LE((v - velocity).norm(), tolerance) << static_cast<int>(scheme);
    EXPECT_LE((x - place).norm(), tolerance) << static_cast<int>(scheme);
  }
}

/// Cubes of 0.2 m and 1 kg on top of each other; the topmost of `top` kg.
std::shared_ptr<const Model> stack(int count, double top) {
  ModelBuilder builder = test::stepping_builder(0, 0.5, Vec3(0, 0, -g));
  for (int k = 0; k < count; ++k) {
    BodyDescription cube =
        test::stepping_body("cube" + std::to_string(k), Box{Vec3(0.1, 0.1, 0.1)}, Vec3(0, 0, 0.1 + 0.2 * k));
    if (k + 1 == count) cube.mass = top;
    builder.add_body(cube);
  }
  return builder.build();
}

TEST(SchemeCatalogue, StacksStandAndEveryInterfaceCarriesWhatIsAboveIt) {
  for (const Scheme scheme : {Scheme::event_driven, Scheme::time_stepping, Scheme::hybrid}) {
    for (const auto& [count, top] :
         {std::pair{3, 1.0}, std::pair{10, 1.0}, std::pair{10, 1e3}, std::pair{10, 1e-3}}) {
      const std::shared_ptr<const Model> model = stack(count, top);
      const Method method = method_of(scheme);
      const SchemeRun end = run(model, method, 1.0 / 60, count == 3 ? 100.0 : 1.0);
      std::vector<double> carried(static_cast<std::size_t>(count), 0);
      for (const TouchingPoint& point : contact_snapshot(*model, method, end.state))
        carried[static_cast<std::size_t>(point.body_A)] += point.force_W.z();
      for (int k = 0; k < count; ++k) {
        EXPECT_LE(linear_velocity(*model, end.state, k + 1).norm(), 1e-12) << count << " " << k;
        const double above = (count - 1 - k + top) * g;
        EXPECT_NEAR(carried[static_cast<std::size_t>(k)], above, 1e-12 * (count + top) * g)
            << count << " " << k;
      }
    }
  }
}

/// SimBenchmark, rolling: a box of 10 kg on the ground with 25 balls of 1 kg on it, pushed by 150 N.
std::shared_ptr<const Model> pushed_box(const Vec3& direction) {
  ModelBuilder builder;
  builder.set_gravity(Vec3(0, 0, -g));
  for (const char* name : {"ground", "box", "ball"}) builder.add_material({name, 1000, 0, 0});
  builder.set_pair("ground", "box", {0.4, 0});
  builder.set_pair("box", "ball", {0.8, 0});
  BodyDescription ground = test::stepping_body("ground", HalfSpace{Vec3::UnitZ(), 0}, Vec3::Zero());
  ground.motion = MotionType::fixed;
  ground.mass.reset();
  ground.shapes[0].material = "ground";
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

TEST(SchemeCatalogue, BallsRollOnAPushedBoxAlikeInAllDirections) {
  const double f1 = 0.4 * 35 * g, f2 = (150 - f1) / 10 / (3.5 + 25.0 / 10);
  const double a_box = (150 - f1 - 25 * f2) / 10, a_ball = f2;
  EXPECT_NEAR(a_box, 0.7385, 1e-9);
  EXPECT_NEAR(a_ball, 0.211, 1e-9);
  for (const Vec3& direction : {Vec3(0, 1, 0), Vec3(0.5, std::sqrt(0.75), 0)}) {
    const std::shared_ptr<const Model> model = pushed_box(direction);
    // The event-driven scheme and time stepping have tests of their own.
    const double end = 0.02;
    const SchemeRun at_end = run(model, method_of(Scheme::hybrid), 1e-3, end);
    const auto velocity = [&](int i) { return linear_velocity(*model, at_end.state, i); };
    EXPECT_LE((velocity(1) - a_box * end * direction).norm(), 1e-9);
    for (int i = 2; i < 27; ++i) EXPECT_LE((velocity(i) - a_ball * end * direction).norm(), 1e-9);
  }
}

/// n balls a side, of 10 kg and 0.1 m, `height` above a floor; 0.21 m apart, moved by up to a millimetre.
std::shared_ptr<const Model> cube_of_balls(int n, double height, double restitution) {
  ModelBuilder builder = test::stepping_builder(restitution, 0, Vec3(0, 0, -g));
  test::Random random(1);
  const auto jitter = [&] { return random.uniform(0, 1e-3); };
  for (int k = 0; k < n * n * n; ++k) {
    const double x = 0.21 * (k % n) + jitter(), y = 0.21 * (k / n % n) + jitter();
    BodyDescription ball = test::stepping_body("ball" + std::to_string(k), Sphere{0.1},
                                               Vec3(x, y, height + 0.21 * (k / (n * n)) + jitter()));
    ball.mass = 10;
    builder.add_body(ball);
  }
  return builder.build();
}

TEST(SchemeCatalogue, BallsThatFallWithoutBouncingDoNotSink) {
  const std::shared_ptr<const Model> model = cube_of_balls(2, 0.101, 0);
  for (const Scheme scheme : {Scheme::event_driven, Scheme::time_stepping, Scheme::hybrid, Scheme::penalty}) {
    const Method method = method_of(scheme);
    const SchemeRun end = run(model, method, 1e-2, 0.2);
    // Springs are as stiff as one impact of the fastest body asks for; two may press at once.
    const double deepest = scheme == Scheme::penalty ? 2 * method.penalty_depth : method.contact_tolerance;
    EXPECT_LE(end.report.max_penetration, deepest) << static_cast<int>(scheme);
  }
}

TEST(SchemeCatalogue, BallsThatBounceForTwentySecondsKeepTheirEnergy) {
  ModelBuilder builder = test::stepping_builder(1, 0, Vec3(0, 0, -g));
  for (int k = 0; k < 49; ++k) {
    BodyDescription ball =
        test::stepping_body("ball" + std::to_string(k), Sphere{0.1}, Vec3(0.3 * (k % 7), 0.3 * (k / 7), 5));
    ball.mass = 10;
    builder.add_body(ball);
  }
  const std::shared_ptr<const Model> model = builder.build();
  for (const Scheme scheme :
       {Scheme::event_driven, Scheme::time_stepping, Scheme::impulse_based, Scheme::hybrid}) {
    const SchemeRun end = run(model, method_of(scheme), 1e-2, 20);
    EXPECT_GE(end.report.impacts, 49 * 8);
    const Environment environment(*model);
    EXPECT_NEAR(mechanical_energy(*model, environment, end.state).total(), 49 * 10 * g * 5,
                1e-12 * 49 * 10 * g * 5)
        << static_cast<int>(scheme);
  }
}

/// SimBenchmark, kapla: floors of blocks across and along, 10 kg each; there it has six of eight and nine.
std::shared_ptr<const Model> tower_of_blocks(int floors, int across) {
  ModelBuilder builder = test::stepping_builder(0, 0.5, Vec3(0, 0, -g));
  const int along = across / 2;
  int count = 0;
  const auto add = [&](const Vec3& half_extents, const Vec3& position) {
    BodyDescription block =
        test::stepping_body("block" + std::to_string(count++), Box{half_extents}, position);
    block.mass = 10;
    builder.add_body(block);
  };
  const Vec3 base(0.025, 0.125, 0.05), wall(0.1, 0.025, 0.05);
  for (int i = 0; i < floors; ++i) {
    const double z = 0.05 + 0.2 * i;
    for (int j = 0; j < across; ++j) add(base, Vec3(0.2 * j, 0, z));
    for (int j = 0; j < along; ++j) add(wall, Vec3(0.1 + 0.4 * j, -0.1, z + 0.1));
    for (int j = 0; j < along - 1; ++j) add(wall, Vec3(0.3 + 0.4 * j, 0.1, z + 0.1));
    for (const int j : {0, along - 1}) add(wall, Vec3(0.1 + 0.4 * j, 0.1, z + 0.1));
  }
  EXPECT_EQ(count, floors * (2 * across + 1));
  return builder.build();
}

TEST(SchemeCatalogue, ATowerOfBlocksStands) {
  const std::shared_ptr<const Model> model = tower_of_blocks(2, 4);
  const State start = make_initial_state(*model);
  // What stands costs the event-driven engine nothing; time stepping solves the tower at every step.
  for (const auto& [scheme, duration] :
       {std::pair{Scheme::event_driven, 600.0}, std::pair{Scheme::hybrid, 600.0},
        std::pair{Scheme::time_stepping, 0.1}}) {
    const SchemeRun end = run(model, method_of(scheme), 0.01, duration);
    for (int i = 0; i < model->body_count(); ++i)
      ASSERT_LE((end.state.position(i) - start.position(i)).norm(), 1e-9) << static_cast<int>(scheme) << i;
  }
}

// The catalogue's T64: lengths times 2^20, times times 2^10; every number with a unit is scaled.
TEST(SchemeCatalogue, ScenesScaledByPowersOfTwoGiveScaledBits) {
  const double length = std::ldexp(1.0, 20), time = std::ldexp(1.0, 10);
  const std::shared_ptr<const Model> small = test::stepping_cube(1, 1),
                                     large = test::stepping_cube(length, time);
  for (const auto& [scheme, end] : {std::pair{Scheme::event_driven, 0.75},
                                    std::pair{Scheme::time_stepping, 0.75}, std::pair{Scheme::penalty, 0.5},
                                    std::pair{Scheme::impulse_based, 0.5}, std::pair{Scheme::hybrid, 0.75}}) {
    const Method method = method_of(scheme);
    Method scaled = method;
    scaled.contact_tolerance = length * method.contact_tolerance;
    scaled.penalty_depth = length * method.penalty_depth;
    scaled.time_tolerance = time * method.time_tolerance;
    scaled.resting_velocity = length / time * method.resting_velocity;
    const State a = run(small, method, 0.01, end).state;
    const State b = run(large, scaled, 0.01 * time, end * time).state;
    EXPECT_EQ(Vec3(length * a.position(1)), b.position(1)) << static_cast<int>(scheme);
    EXPECT_EQ(a.orientation(1).coeffs(), b.orientation(1).coeffs()) << static_cast<int>(scheme);
    EXPECT_EQ(Vec3(length / time * a.linear_momentum(1)), b.linear_momentum(1)) << static_cast<int>(scheme);
  }
}

}  // namespace
}  // namespace rigor::scheme_catalogue_test
