#include "rigor/sim/time_stepping/time_stepper.hpp"

#include "rigor/contact/time_of_impact.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/sim/pairs/near_pairs.hpp"
#include "rigor/sim/time_stepping/part_memory.hpp"
#include "rigor/sim/time_stepping/trial_path.hpp"
#include "sim/time_stepping_scenes.hpp"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace rigor::time_stepper_test {
namespace {

constexpr double g = 9.81;

Method stepping() {
  Method method;
  method.scheme = Scheme::time_stepping;
  return method;
}

/// A block on a plane of 20 degrees whose friction is `share` of its tangent; the fall line is 30 degrees off
/// the block's axes.
std::shared_ptr<const Model> ramp(double share) {
  const double alpha = 20 * M_PI / 180, beta = 30 * M_PI / 180;
  const Vec3 down(std::sin(alpha) * std::cos(beta), std::sin(alpha) * std::sin(beta), -std::cos(alpha));
  ModelBuilder builder = test::stepping_builder(0, share * std::tan(alpha), g * down);
  builder.add_body(test::stepping_body("block", Box{Vec3(0.2, 0.2, 0.1)}, Vec3(0, 0, 0.1)));
  return builder.build();
}

TEST(TimeStepper, BlockOnARampWithEnoughFrictionDoesNotCreepAtAnyStep) {
  for (const double h : {0.1, 1e-2, 1e-3}) {
    const std::shared_ptr<const Model> model = ramp(1.01);
    State state = make_initial_state(*model);
    TimeStepper(model, stepping(), h).advance(state, h == 1e-3 ? 1 : 10);
    EXPECT_LT((state.position(1) - Vec3(0, 0, 0.1)).norm(), 1e-13) << h;
  }
}

TEST(TimeStepper, BlockSlidesDownARampAlongTheFallLineAtAnyStep) {
  // a = g (sin α - μ cos α) with μ = 0.99 tan α.
  const double a = g * std::sin(20 * M_PI / 180) * 0.01, t = 10;
  for (const double h : {0.1, 1e-2}) {
    const std::shared_ptr<const Model> model = ramp(0.99);
    State state = make_initial_state(*model);
    TimeStepper(model, stepping(), h).advance(state, t);
    const Vec3 way = state.position(1) - Vec3(0, 0, 0.1);
    const double beta = 30 * M_PI / 180;
    EXPECT_LT((way - 0.5 * a * t * t * Vec3(std::cos(beta), std::sin(beta), 0)).norm(), 1e-9) << h;
  }
}

TEST(TimeStepper, ElasticBallKeepsItsEnergyToRounding) {
  ModelBuilder builder = test::stepping_builder(1, 0, Vec3(0, 0, -g));
  builder.add_body(test::stepping_body("ball", Sphere{0.1}, Vec3(0, 0, 1.1)));
  const std::shared_ptr<const Model> model = builder.build();
  State state = make_initial_state(*model);
  const AdvanceReport report = TimeStepper(model, stepping(), 0.01).advance(state, 10);
  // The 11th bounce is at (2 · 11 - 1) √(2 h / g) = 9.48 s.
  EXPECT_EQ(report.impacts, 11);
  EXPECT_NEAR(0.5 * state.linear_momentum(1).squaredNorm() + g * state.position(1).z(), g * 1.1, 1e-12);
}

TEST(TimeStepper, FreshStepperContinuesBitForBit) {
  const std::shared_ptr<const Model> model = test::stepping_cube(1, 1);
  State state = make_initial_state(*model);
  TimeStepper stepper(model, stepping(), 0.01);
  for (int k = 1; k <= 40; ++k) {
    State copy = state;
    TimeStepper fresh(model, stepping(), 0.01);
    fresh.advance(copy, 0.05 * k);
    EXPECT_EQ(stepper.advance(state, 0.05 * k).reason, StopReason::reached_end);
    ASSERT_EQ(state, copy) << "at t = " << state.t;
  }
}

TEST(TimeStepper, ScenesScaledByPowersOfTwoGiveScaledBits) {
  const double length = std::ldexp(1.0, 20), time = std::ldexp(1.0, 10);
  const std::shared_ptr<const Model> small = test::stepping_cube(1, 1),
                                     large = test::stepping_cube(length, time);
  Method method = stepping(), scaled = method;
  scaled.contact_tolerance = length * method.contact_tolerance;
  scaled.time_tolerance = time * method.time_tolerance;
  scaled.resting_velocity = length / time * method.resting_velocity;
  State a = make_initial_state(*small), b = make_initial_state(*large);
  TimeStepper of_small(small, method, 0.01), of_large(large, scaled, 0.01 * time);
  // Until the cube lies: motion space weighs lengths against turns by rounding that does not scale.
  for (int k = 1; k <= 6; ++k) {
    of_small.advance(a, 0.125 * k);
    of_large.advance(b, 0.125 * k * time);
    EXPECT_EQ(Vec3(length * a.position(1)), b.position(1)) << k;
    EXPECT_EQ(a.orientation(1).coeffs(), b.orientation(1).coeffs()) << k;
    EXPECT_EQ(Vec3(length / time * a.linear_momentum(1)), b.linear_momentum(1)) << k;
  }
}

std::vector<Aabb> boxes_at_start(const Model& model) {
  const State state = make_initial_state(model);
  std::vector<Aabb> boxes;
  for (int i = 0; i < model.body_count(); ++i) boxes.push_back(body_box(model, state, i));
  return boxes;
}

/// Pairs of all shapes in flight at random: what boxes and the line between the centres tell of those that
/// keep apart is what the search finds, and some meet.
TEST(TrialPath, SaysOfPairsThatKeepApartWhatTheSearchFinds) {
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto vector = [&](double size) {
    return Vec3(size * Vec3::NullaryExpr([&] { return uniform(generator); }));
  };
  const double h = 0.01;
  int meetings = 0;
  const std::vector<Shape> shapes{Box{Vec3(0.1, 0.05, 0.02)}, Sphere{0.07}, Capsule{0.04, 0.08},
                                  Cylinder{0.06, 0.05}};
  for (int example = 0; example < 1200; ++example) {
    const Shape &of_a = shapes[static_cast<std::size_t>(example) % 4],
                &of_b = shapes[static_cast<std::size_t>(example) / 4 % 4];
    ModelBuilder builder = test::stepping_builder(0, 0, Vec3(0, 0, -g));
    builder.add_body(test::stepping_body("a", of_a, Vec3(0, 0, 5)));
    builder.add_body(test::stepping_body("b", of_b, Vec3(0.15, 0, 5) + vector(0.1)));
    const std::shared_ptr<const Model> model = builder.build();
    const Environment environment(*model);
    const std::vector<Aabb> boxes = boxes_at_start(*model);
    const State state = make_initial_state(*model);

    // Both bodies fly for h, seldom fast.
    const double size = example % 3 == 0 ? 20 : 1;
    Cluster start{0, {1, 2}, {}, {}};
    std::vector<Motion> motions;
    for (const int i : start.bodies) {
      const Body& body = model->body(i);
      start.phases.push_back({state.position(i), state.orientation(i), body.mass * vector(size),
                              body.moments.maxCoeff() * vector(size)});
      const BodyInertia inertia{body.mass, body.moments};
      motions.push_back(Motion::flight(
          FreeFlight(inertia, start.phases.back(), 0, environment.steady_acceleration(i)), inertia));
    }
    Cluster end = start;
    end.t = h;
    for (int k = 0; k < 2; ++k)
      end.phases[static_cast<std::size_t>(k)] = motions[static_cast<std::size_t>(k)].phase(h);

    const ToiOptions options;
    const std::array<Pose, 2> poses{pose_of(state, 1), pose_of(state, 2)};
    if (!find_contacts(*model, 1, 2, poses[0], poses[1], 0).empty()) continue;
    const TimeOfImpact found =
        find_time_of_impact(model->body(1), motions[0], model->body(2), motions[1], 0, h, options);
    TrialPath path({*model, environment, boxes}, options, start, end, h);
    EXPECT_EQ(path.first_meeting({1, 2}), found.is_contact ? found.time : h) << example;
    if (found.is_contact) ++meetings;
  }
  EXPECT_GT(meetings, 40);
  EXPECT_LT(meetings, 1000);
}

TEST(TrialPath, WhatSlidesIsClearToTheEndWhateverTheTimeIs) {
  ModelBuilder builder = test::stepping_builder(0, 0, Vec3(0, 0, -g));
  builder.add_body(test::stepping_body("block", Box{Vec3(0.2, 0.2, 0.1)}, Vec3(0, 0, 0.1)));
  const std::shared_ptr<const Model> model = builder.build();
  const Environment environment(*model);
  const std::vector<Aabb> boxes = boxes_at_start(*model);
  const ToiOptions options;
  const double h = 0.01;
  for (const double t : {0.0, 0.1, 0.44, 1000.3}) {
    const Vec3 v(3, 1, 0);
    const Cluster start{t, {1}, {{Vec3(0, 0, 0.1), Quat::Identity(), v, Vec3::Zero()}}, {}};
    Cluster end = start;
    end.t += h;
    end.phases[0].x += h * v;
    TrialPath path({*model, environment, boxes}, options, start, end, h);
    EXPECT_EQ(path.without_overlap({0, 1}, 1e-3), h) << t;
    // It sinks by 5 mm: the slack is used up after a fifth of the step at the latest.
    end.phases[0].x.z() -= 0.005;
    TrialPath sinking({*model, environment, boxes}, options, start, end, h);
    const double until = sinking.without_overlap({0, 1}, 1e-3);
    EXPECT_GT(until, 0) << t;
    EXPECT_LE(sinking.poses({0, 1}, until)[1].p.z(), 0.1) << t;
    EXPECT_GE(sinking.poses({0, 1}, until)[1].p.z(), 0.1 - 1e-3 - 1e-9) << t;
  }
}

TEST(PartMemory, MovesAPartOnceAsLongAsItIsTheSameProblem) {
  PartMemory memory;
  int moves = 0;
  StepAccuracy wanted = StepAccuracy::exact, found = StepAccuracy::exact;
  const auto ask = [&](double h, double theta, const Cluster& part) {
    const auto move = [&](const Cluster& moving) {
      ++moves;
      return MovedPart{moving.phases, moving.phases, {}, {}, found};
    };
    return memory.moved(h, theta, wanted, {part}, move, Executor(1)).front()->end[0].x;
  };
  Cluster part{0, {1}, {{Vec3(1, 2, 3), Quat::Identity(), Vec3::Zero(), Vec3::Zero()}}, {}};
  for (int k = 0; k < 3; ++k) EXPECT_EQ(ask(0.01, 0.5, part), Vec3(1, 2, 3));
  EXPECT_EQ(moves, 1);

  // Another step, another share, another body, a contact, and the same contact with another gap.
  ask(0.005, 0.5, part);
  ask(0.01, 1, part);
  Cluster other = part;
  other.bodies = {2};
  ask(0.01, 0.5, other);
  EXPECT_EQ(moves, 4);
  Contact contact{};
  contact.body_B = 1;
  for (const double gap : {0.0, 1e-12}) {
    contact.point = {Vec3::Zero(), Vec3::Zero(), Vec3::UnitZ(), gap, 0, {}, {}};
    part.contacts = {contact};
    ask(0.01, 0.5, part);
    ask(0.01, 0.5, part);
  }
  EXPECT_EQ(moves, 6);
  memory.clear();
  ask(0.01, 0.5, part);
  EXPECT_EQ(moves, 7);

  // An exact answer serves rough tries; a rough one does not serve exact tries.
  wanted = StepAccuracy::rough;
  ask(0.01, 0.5, part);
  EXPECT_EQ(moves, 7);
  memory.clear();
  found = StepAccuracy::rough;
  ask(0.01, 0.5, part);
  ask(0.01, 0.5, part);
  EXPECT_EQ(moves, 8);
  wanted = found = StepAccuracy::exact;
  ask(0.01, 0.5, part);
  ask(0.01, 0.5, part);
  EXPECT_EQ(moves, 9);
}

/// Boxes in layers that fall into each other, askew.
std::shared_ptr<const Model> heap_of_boxes(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-1, 1);
  ModelBuilder builder = test::stepping_builder(0, 0.5, Vec3(0, 0, -9.81));
  for (int k = 0; k < count; ++k) {
    BodyDescription body =
        test::stepping_body("b" + std::to_string(k), Box{Vec3(0.075, 0.06, 0.05)},
                            Vec3(0.25 * (k % 3), 0.25 * (k / 3 % 3), 0.2 + 0.25 * (k / 9)));
    body.q_WU = rotation_exp(Vec3(number(random), number(random), number(random)));
    builder.add_body(body);
  }
  return builder.build();
}

TEST(TimeStepper, ManyContactsAreForeseenByRoughTriesAndSolvedExactly) {
  for (const unsigned seed : {1U, 2U}) {
    const std::shared_ptr<const Model> model = heap_of_boxes(63, seed);
    State state = make_initial_state(*model);
    const AdvanceReport report = TimeStepper(model, stepping(), 0.01).advance(state, 0.5);
    EXPECT_EQ(report.reason, StopReason::reached_end);
    EXPECT_EQ(report.fallbacks, 0) << seed;
    EXPECT_LE(report.max_residual, 1e-10) << seed;
    EXPECT_LE(report.max_penetration, 1e-6) << seed;
  }
}

/// Small heaps far apart: balls and boxes that fall into each other, askew.
std::shared_ptr<const Model> separate_heaps(int heaps) {
  std::mt19937 random(29);
  std::uniform_real_distribution<double> number(-1, 1);
  ModelBuilder builder = test::stepping_builder(0.2, 0.5, Vec3(0, 0, -9.81));
  for (int k = 0; k < 5 * heaps; ++k) {
    const Shape shape = k % 3 == 0 ? Shape(Sphere{0.07}) : Shape(Box{Vec3(0.08, 0.06, 0.05)});
    const Vec3 x(3.0 * (k / 5) + 0.05 * number(random), 0.05 * number(random), 0.2 + 0.22 * (k % 5));
    BodyDescription body = test::stepping_body("body" + std::to_string(k), shape, x);
    body.velocity = Vec3(0, 0, -2);
    body.angular_velocity = 2 * Vec3(number(random), number(random), number(random));
    builder.add_body(body);
  }
  return builder.build();
}

TEST(TimeStepper, HeapsOnSeveralThreadsMoveByTheSameBits) {
  const std::shared_ptr<const Model> model = separate_heaps(6);
  const auto run_on = [&](int threads) {
    State state = make_initial_state(*model);
    TimeStepper stepper(model, stepping(), 0.01, threads);
    const AdvanceReport report = stepper.advance(state, 0.4);
    EXPECT_EQ(report.reason, StopReason::reached_end);
    return std::pair{state, report.impact_loss + report.friction_loss};
  };
  const auto [alone, loss] = run_on(1);
  EXPECT_GT(loss, 0);
  for (const int threads : {2, 5}) EXPECT_EQ(run_on(threads), std::pair(alone, loss)) << threads;
}

TEST(TimeStepper, AnInterruptEndsTheThreadsOfAStep) {
  const std::shared_ptr<const Model> model = separate_heaps(6);
  State state = make_initial_state(*model);
  TimeStepper stepper(model, stepping(), 0.01, 2);
  std::atomic<int> asked = 0;
  stepper.set_interrupt([&] { return ++asked > 500; });
  EXPECT_EQ(stepper.advance(state, 10).reason, StopReason::interrupted);
}

}  // namespace
}  // namespace rigor::time_stepper_test
