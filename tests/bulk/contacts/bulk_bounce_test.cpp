// Restitution on the many-body path: what it gives back, and that it gives no more than was taken.

#include "rigor/bulk/bulk_world.hpp"
#include "rigor/bulk/contacts/manifold_bounce.hpp"
#include "rigor/dynamics/body_phase.hpp"
#include "rigor/model/model_builder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <random>
#include <span>
#include <string>
#include <vector>

namespace rigor::bulk_bounce_test {
namespace {

constexpr double kStep = 1.0 / 60;
constexpr double kGravity = 9.81;

BodyDescription bounce_body(const std::string& name, const Shape& shape, const Vec3& p_W) {
  BodyDescription body;
  body.name = name;
  body.p_WU = p_W;
  body.mass = 1;
  body.shapes.push_back({shape, Vec3::Zero(), Quat::Identity(), "m", ""});
  return body;
}

/// A shaft of 3 m by 3 m.
ModelBuilder shaft(double e, double friction) {
  ModelBuilder builder;
  builder.set_gravity(Vec3(0, 0, -kGravity));
  builder.add_material({"m", 1000, friction, e});
  const std::array<Vec3, 5> normals{Vec3::UnitZ(), Vec3::UnitX(), -Vec3::UnitX(), Vec3::UnitY(),
                                    -Vec3::UnitY()};
  for (std::size_t i = 0; i < normals.size(); ++i) {
    BodyDescription wall =
        bounce_body("wall " + std::to_string(i), HalfSpace{normals[i], i == 0 ? 0 : -1.5}, Vec3::Zero());
    wall.mass.reset();
    wall.motion = MotionType::fixed;
    builder.add_body(wall);
  }
  return builder;
}

enum class HeapKind { balls, boxes, capsules, mixed };

/// 27 bodies of 1 kg that fall and tumble in a shaft.
std::shared_ptr<const Model> heap(HeapKind kind, double e, double friction, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-1, 1);
  ModelBuilder builder = shaft(e, friction);
  for (int i = 0; i < 27; ++i) {
    const double r = 0.05 * number(random);
    const std::array<Shape, 3> shapes{Shape{Sphere{0.25 + r}}, Shape{Box{Vec3(0.25 + r, 0.2, 0.12)}},
                                      Shape{Capsule{0.12, 0.2}}};
    const std::size_t which =
        kind == HeapKind::mixed ? static_cast<std::size_t>(i % 3) : static_cast<std::size_t>(kind);
    BodyDescription body = bounce_body("b" + std::to_string(i), shapes[which],
                                       Vec3(0.9 * (i % 3 - 1), 0.9 * (i / 3 % 3 - 1), 0.6 + 0.9 * (i / 9)));
    body.q_WU = Quat(number(random), number(random), number(random), number(random)).normalized();
    body.velocity = Vec3(number(random), number(random), number(random));
    body.angular_velocity = 3 * Vec3(number(random), number(random), number(random));
    builder.add_body(body);
  }
  return builder.build();
}

double energy_of(const Model& model, const State& state) {
  double energy = 0;
  for (int i = 0; i < model.body_count(); ++i) {
    const Body& body = model.body(i);
    if (body.motion != MotionType::dynamic) continue;
    const BodyPhase phase{state.position(i), state.orientation(i), state.linear_momentum(i),
                          state.angular_momentum(i)};
    energy +=
        kinetic_energy(BodyInertia{body.mass, body.moments}, phase) + body.mass * kGravity * phase.x.z();
  }
  return energy;
}

/// The largest rise of the energy over what it was before, as a part of its largest fall.
double largest_rise(const std::shared_ptr<const Model>& model, double duration) {
  State state = make_initial_state(*model);
  BulkWorld world(model, BulkSettings{});
  world.read(state);
  const double first = energy_of(*model, state);
  double lowest = first, rise = 0;
  while (world.time() < duration) {
    world.step(kStep);
    world.write(state);
    const double energy = energy_of(*model, state);
    lowest = std::min(lowest, energy);
    rise = std::max(rise, energy - lowest);
  }
  return rise / (first - lowest);
}

TEST(BulkBounce, HeapsDoNotGainEnergy) {
  // Springs that push overlaps back and bodies that turn within a step are worth some parts in ten thousand;
  // restitution that is not bounded gave boxes without friction and with e = 1 a fifth.
  for (const HeapKind kind : {HeapKind::balls, HeapKind::boxes, HeapKind::capsules, HeapKind::mixed}) {
    for (const double e : {0.3, 0.8, 1.0}) {
      for (const double friction : {0.0, 0.5}) {
        for (unsigned seed = 1; seed <= 2; ++seed) {
          EXPECT_LT(largest_rise(heap(kind, e, friction, seed), 3), 2e-3)
              << static_cast<int>(kind) << " e " << e << " friction " << friction << " seed " << seed;
        }
      }
    }
  }
}

TEST(BulkBounce, AStackThatABallHitsDoesNotGainEnergy) {
  for (const double friction : {0.0, 0.5}) {
    ModelBuilder builder = shaft(1, friction);
    for (int i = 0; i < 5; ++i) {
      builder.add_body(bounce_body("c" + std::to_string(i), Box{Vec3(0.5, 0.5, 0.5)}, Vec3(0, 0, 0.5 + i)));
    }
    BodyDescription ball = bounce_body("ball", Sphere{0.4}, Vec3(0.1, 0.05, 7));
    ball.velocity = Vec3(0, 0, -8);
    builder.add_body(ball);
    // Unbounded: 0.09 and 0.4.
    EXPECT_LT(largest_rise(builder.build(), 3), 1e-3);
  }
}

TEST(BulkBounce, ABallComesBackFromAnyWallAtItsRestitution) {
  for (const double e : {0.25, 0.5, 1.0}) {
    for (const double wall_speed : {-2.0, 0.0, 3.0}) {
      for (const double phase : {0.0, 0.37, 1.1, 2.23, 2.9, 3.51, 4.44}) {
        ModelBuilder builder;
        builder.set_gravity(Vec3::Zero());
        builder.add_material({"m", 1000, 0.5, e});
        BodyDescription wall = bounce_body("wall", Box{Vec3(0.5, 2, 2)}, Vec3::Zero());
        wall.mass.reset();
        wall.motion = MotionType::kinematic;
        wall.velocity = Vec3(wall_speed, 0, 0);
        builder.add_body(wall);
        // Not at the begin of a step, and within a substep, so that it is stopped in two steps.
        BodyDescription ball = bounce_body("ball", Sphere{0.2}, Vec3(1 + phase * kStep, 0, 0));
        ball.velocity = Vec3(-5, 0, 0);
        builder.add_body(ball);
        const std::shared_ptr<const Model> model = builder.build();
        State state = make_initial_state(*model);
        BulkWorld world(model, BulkSettings{});
        world.read(state);
        for (int k = 0; k < 30; ++k) world.step(kStep);
        world.write(state);
        // To the rounding of 32 bits: relative to the wall it comes with 5 + V and goes with e of it.
        EXPECT_NEAR(state.linear_momentum(1).x(), wall_speed + e * (5 + wall_speed), 1e-5)
            << e << " " << wall_speed << " " << phase;
      }
    }
  }
}

TEST(BulkBounce, HasTheSameBitsOnAnyNumberOfThreads) {
  const std::shared_ptr<const Model> model = heap(HeapKind::mixed, 0.8, 0.3, 5);
  std::vector<State> ends;
  for (const int threads : {1, 2, 3}) {
    State state = make_initial_state(*model);
    BulkSettings settings;
    settings.threads = threads;
    BulkWorld world(model, settings);
    world.read(state);
    for (int k = 0; k < 90; ++k) world.step(kStep);
    world.write(state);
    ends.push_back(state);
  }
  EXPECT_TRUE(ends[0] == ends[1]);
  EXPECT_TRUE(ends[0] == ends[2]);
}

/// Velocity and angular velocity of a body that has struck the plane z = 0 without weight.
struct AfterStrike {
  Vec3 v, w;
};
AfterStrike strike_plane(const BodyDescription& body, double friction, double e, double h) {
  ModelBuilder builder;
  builder.set_gravity(Vec3::Zero());
  builder.add_material({"m", 1000, friction, e});
  BodyDescription floor = bounce_body("floor", HalfSpace{Vec3::UnitZ(), 0}, Vec3::Zero());
  floor.mass.reset();
  floor.motion = MotionType::fixed;
  builder.add_body(floor);
  builder.add_body(body);
  const std::shared_ptr<const Model> model = builder.build();
  State state = make_initial_state(*model);
  BulkWorld world(model, BulkSettings{});
  world.read(state);
  for (int k = 0; k < 12; ++k) world.step(h);
  world.write(state);
  const Mat3 R = state.orientation(1).toRotationMatrix();
  const Vec3 L_B = R.transpose() * state.angular_momentum(1);
  return {state.linear_momentum(1) / model->body(1).mass, R * L_B.cwiseQuotient(model->body(1).moments)};
}

TEST(BulkBounce, FrictionOfAnImpactIsThatOfAllItsImpulse) {
  // Newton and Coulomb in closed form: a ball whose slip is s loses min(mu (1 + e) u_n, 2 s / 7) of its
  // speed. (Without friction in the bounce, and at an impact in the last substep without most of it, half of
  // it was missing.) Arms are those of the beginning of the step, too long by half the gap.
  std::mt19937 random(20261128);
  std::uniform_real_distribution<double> part(0, 1);
  for (int trial = 0; trial < 200; ++trial) {
    const double r = 0.05 + 0.4 * part(random), e = part(random), friction = part(random),
                 u_n = 0.5 + 4 * part(random), h = 1e-4, gap = (0.5 + 4 * part(random)) * u_n * h;
    BodyDescription ball = bounce_body("ball", Sphere{r}, Vec3(0, 0, r + gap));
    const double speed = 10 * (2 * part(random) - 1), spin = 10 / r * (2 * part(random) - 1);
    ball.velocity = Vec3(speed, 0, -u_n);
    ball.angular_velocity = Vec3(0, spin, 0);
    const AfterStrike after = strike_plane(ball, friction, e, h);
    const double slip = speed - spin * r;
    const double lost = std::copysign(std::min(friction * (1 + e) * u_n, 2 * std::abs(slip) / 7), slip);
    const double error_of_arm = u_n * h / r;
    EXPECT_NEAR(after.v.z(), e * u_n, 1e-5 * u_n) << trial;
    EXPECT_NEAR(after.v.x(), speed - lost, 1e-4 + error_of_arm * (std::abs(speed) + std::abs(spin * r)))
        << trial;
    EXPECT_NEAR(after.w.y() * r, spin * r + 2.5 * lost,
                1e-4 + 3 * error_of_arm * (std::abs(speed) + std::abs(spin * r)))
        << trial;
  }
}

TEST(BulkBounce, BoxesThatLandFlatSlideOnWithoutATurn) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> part(0, 1);
  for (int trial = 0; trial < 50; ++trial) {
    const Vec3 half = Vec3(0.05, 0.05, 0.05) + 0.3 * Vec3(part(random), part(random), 0.3 * part(random));
    const double e = 0.2 + 0.8 * part(random), friction = 0.4 * part(random), u_n = 0.5 + 2 * part(random),
                 h = 1e-3, angle = 6.28 * part(random);
    BodyDescription box =
        bounce_body("box", Box{half}, Vec3(0, 0, half.z() + (0.5 + 4 * part(random)) * u_n * h));
    const Vec3 along(std::cos(angle), std::sin(angle), 0);
    box.velocity = 10 * along - Vec3(0, 0, u_n);
    const AfterStrike after = strike_plane(box, friction, e, h);
    EXPECT_NEAR(after.v.dot(along), 10 - friction * (1 + e) * u_n, 2e-3 * (1 + e) * u_n) << trial;
    EXPECT_NEAR(after.v.z(), e * u_n, 2e-3 * u_n) << trial;
    EXPECT_LT(after.w.norm() * half.norm(), 1e-2 * u_n) << trial;
  }
}

/// No accelerations by forces.
std::vector<MotionRow> weightless(const BulkBodies& bodies) {
  return std::vector<MotionRow>(bodies.x.size(), MotionRow{});
}

/// A cube of 1 kg, turned and turning, that was stopped on a fixed floor: what bounce() is given.
struct StoppedCube {
  std::shared_ptr<const Model> model;
  BulkBodies bodies;
  SolvedManifold manifold;

  explicit StoppedCube(double e) {
    ModelBuilder builder = shaft(e, 0);
    BodyDescription cube = bounce_body("cube", Box{Vec3(0.3, 0.2, 0.1)}, Vec3(0, 0, 0.1));
    cube.velocity = Vec3(0.3, 0, -2);
    cube.angular_velocity = Vec3(1, 0.5, 0.2);
    builder.add_body(cube);
    model = builder.build();
    bodies = read_bulk_bodies(*model, make_initial_state(*model));
    begin_bulk_step(*model, Executor(1), bodies);
    Manifold found{{0, 0, 1}, 4, {}};
    for (std::size_t k = 0; k < 4; ++k) {
      const float x = k % 2 == 0 ? 0.3F : -0.3F, y = k < 2 ? 0.2F : -0.2F;
      found.points[k] = {{x, y, 0}, 0, static_cast<std::uint32_t>(k)};
    }
    const ManifoldSurface surface{.friction = 0, .restitution = static_cast<float>(e)};
    const Softness softness;
    const BlockLane own = {ManifoldView(found), &surface, &softness, {}, 0, 5};
    ManifoldBlock<BlockKind{4, false, false}> block;
    fill_block(best_lane_target(), std::span(&own, 1), bodies, block);
    for (int k = 0; k < 20; ++k) solve_block(best_lane_target(), BlockPass::relax, 1e-3F, block, bodies);
    manifold = read_manifold(block, block.impulses, 0);
    manifold.restitution = e;
  }
};

TEST(BulkBounce, AManifoldTakesWhatItLacksAfterwards) {
  StoppedCube cube(0.5);
  StoppedCube before(0.5);
  const double start = kinetic_energy_now(*before.model, 5,
                                          read_bulk_bodies(*before.model, make_initial_state(*before.model)));
  const double now = kinetic_energy_now(*cube.model, 5, cube.bodies);
  EXPECT_TRUE(bounces(cube.manifold));
  EXPECT_NEAR(energy_taken(cube.manifold, weightless(cube.bodies), cube.bodies), start - now, 1e-5);
  // Stopped flat: all that moved along the normal is gone.
  EXPECT_GT(start - now, 1.9);
}

TEST(BulkBounce, GivesNotMoreThanTheEnergyThatItMay) {
  for (const double most : {0.0, 0.01, 0.1, 0.4, 100.0}) {
    StoppedCube cube(0.5);
    const double taken = energy_taken(cube.manifold, weightless(cube.bodies), cube.bodies);
    const double before = kinetic_energy_now(*cube.model, 5, cube.bodies);
    HeldBodies held(*cube.model);
    bounce(*cube.model, cube.manifold, most, weightless(cube.bodies), held, cube.bodies);
    const double gained = kinetic_energy_now(*cube.model, 5, cube.bodies) - before;
    // Newton's law with e = 0.5 asks for a quarter of what was taken.
    EXPECT_NEAR(gained, std::min(most, 0.25 * taken), 2e-6 + 1e-5 * taken) << most;
  }
}

}  // namespace
}  // namespace rigor::bulk_bounce_test
