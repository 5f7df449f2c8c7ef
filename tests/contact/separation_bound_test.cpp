#include "rigor/geometry/motion/separation_bound.hpp"

#include "random_vectors.hpp"
#include "rigor/contact/time_of_impact.hpp"
#include "rigor/dynamics/motion.hpp"
#include "rigor/geometry/distance/distance.hpp"
#include "rigor/geometry/shape/support.hpp"
#include "rigor/math/rotation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace rigor::separation_bound_test {
namespace {

using test::Random;

/// A shape with an offset from its body's centre, and a motion through a given place.
struct Moving {
  BodyShape shape;
  Motion motion;
  Pose pose(double t) const { return motion.sample(t).X_WB * shape.X_BS; }
  MovingCore core() const { return make_moving_core(shape.shape, shape.X_BS, shape.radius, motion); }
};

Moving random_moving(Random& random, const Vec3& x, bool is_step) {
  Moving moving;
  const int kind = static_cast<int>(4 * (random.number() + 1) / 2);
  const double size = 0.3 + 0.1 * random.number();
  moving.shape.shape = kind == 0   ? Shape(Sphere{size})
                       : kind == 1 ? Shape(Capsule{0.5 * size, size})
                       : kind == 2 ? Shape(Ellipsoid{Vec3(size, 0.5 * size, 0.7 * size)})
                                   : Shape(Box{Vec3(size, 0.6 * size, 0.4 * size)});
  moving.shape.X_BS = Pose{rotation_matrix(rotation_exp(3 * random.vector())), 0.2 * random.vector()};
  moving.shape.radius = radius_about(moving.shape.shape, Vec3::Zero());
  const BodyInertia inertia{1, Vec3(0.5, 0.8, 1.1)};
  const BodyPhase start{x, rotation_exp(3 * random.vector()), 2 * random.vector(), 2 * random.vector()};
  if (!is_step) {
    moving.motion = Motion::flight(FreeFlight(inertia, start, 0, Vec3(0, 0, -9.81)), inertia);
    return moving;
  }
  const WrenchField field = [](double, std::span<const BodyPhase> phases, std::span<Wrench> wrenches) {
    wrenches[0] = {Vec3(0, 0, -9.81) - 4 * phases[0].x, Vec3(1, 0, 2)};
  };
  const SystemStep step = integrate_step(IntegratorName::dopri5, OrientationForm::quaternion,
                                         std::span(&inertia, 1), std::span(&start, 1), 0, 0.2, field, {});
  moving.motion = Motion::step(step.dense.front(), 0, 0.2);
  return moving;
}

/// Extent of the shape beyond the origin along a direction of W.
double reach(const Moving& moving, const Vec3& n_W, double t) {
  const Pose X_WS = moving.pose(t);
  return n_W.dot(X_WS.p) + support_value(moving.shape.shape, X_WS.R.transpose() * n_W);
}

TEST(SeparationBound, NeverExceedsTheGapAlongItsNormal) {
  Random random(7);
  int useful = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const Moving A = random_moving(random, Vec3::Zero(), trial % 3 == 0);
    const Moving B = random_moving(random, Vec3(1, 0.4, 0.3) + 0.3 * random.vector(), trial % 2 == 0);
    const double t = 0.05, end = 0.2;
    const DistanceResult now = signed_distance(A.shape.shape, A.pose(t), B.shape.shape, B.pose(t));
    if (now.distance <= 0.01) continue;
    const MovingCore core_A = A.core(), core_B = B.core();
    const SeparationBound bound(core_A, core_B, now.n_W, now.distance, t, end);
    EXPECT_NEAR(bound.at(0), now.distance, 1e-15);
    for (int k = 1; k <= 30; ++k) {
      const double tau = (end - t) * k / 30;
      const double gap = -reach(B, -now.n_W, t + tau) - reach(A, now.n_W, t + tau);
      EXPECT_LE(bound.at(tau), gap + 1e-9);
    }
    const double safe = bound.safe_step(end - t, 0);
    EXPECT_GE(bound.at(safe), 0);
    // Not far from the largest: twice the step breaks the bound, unless the whole span is free.
    EXPECT_TRUE(safe == end - t || bound.at(2 * safe) < 0) << safe;
    useful += safe > 0;
  }
  EXPECT_GT(useful, 200);
}

/// Gap of the shapes along the direction, turned for that time.
double gap_along(const Moving& A, const Moving& B, const PartingDirection& along, double t, double tau) {
  const Vec3 n_W = rotation_exp(tau * along.turn_W) * along.n_W;
  return -reach(B, -n_W, t + tau) - reach(A, n_W, t + tau);
}

TEST(SeparationBound, NeverExceedsTheGapAlongANormalThatTurns) {
  Random random(8);
  int useful = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const Moving A = random_moving(random, Vec3::Zero(), trial % 3 == 0);
    const Moving B = random_moving(random, Vec3(1, 0.4, 0.3) + 0.3 * random.vector(), trial % 2 == 0);
    const double t = 0.05, end = 0.2;
    const DistanceResult now = signed_distance(A.shape.shape, A.pose(t), B.shape.shape, B.pose(t));
    if (now.distance <= 0.01) continue;
    // As a face of A, as a face of B, or as it comes.
    const Vec3 turn = trial % 5 == 0   ? A.motion.sample(t).w
                      : trial % 5 == 1 ? B.motion.sample(t).w
                                       : Vec3(4 * random.vector());
    const PartingDirection along(now.n_W, turn);
    const MovingCore core_A = A.core(), core_B = B.core();
    const SeparationBound bound(core_A, core_B, along, now.distance, t, end);
    EXPECT_NEAR(bound.at(0), now.distance, 1e-15);
    for (int k = 1; k <= 30; ++k) {
      const double tau = (end - t) * k / 30;
      EXPECT_LE(bound.at(tau), gap_along(A, B, along, t, tau) + 1e-9) << trial;
    }
    // To first order it is the gap. Accelerations are below 1e4 m/s², and velocities along a step agree with
    // its momenta to the order of the method.
    constexpr double h = 1e-7;
    const double slope = (gap_along(A, B, along, t, h) - gap_along(A, B, along, t, 0)) / h;
    EXPECT_NEAR(bound.rate(), slope, 1e-3) << trial;
    useful += bound.safe_step(end - t, 0) > 0;
  }
  EXPECT_GT(useful, 200);
}

TEST(SeparationBound, KeepsTheRateOfACornerUnderAFaceThatTilts) {
  // A box tilts about y over a ball under its side: the end of its lower face sinks, but not the place over
  // the ball.
  Moving ball, plate;
  ball.shape.shape = Sphere{0.1};
  ball.shape.radius = 0.1;
  plate.shape.shape = Box{Vec3(1, 1, 0.05)};
  plate.shape.radius = radius_about(plate.shape.shape, Vec3::Zero());
  const BodyInertia inertia{1, Vec3::Ones()};
  const auto flight = [&](const Vec3& x, const Vec3& w) {
    return Motion::flight(FreeFlight(inertia, {x, Quat::Identity(), Vec3::Zero(), w}, 0, Vec3::Zero()),
                          inertia);
  };
  constexpr double place = 0.5, spin = 2;
  ball.motion = flight(Vec3(place, 0, 0), Vec3::Zero());
  plate.motion = flight(Vec3(0, 0, 0.16), Vec3(0, spin, 0));
  const MovingCore core_A = ball.core(), core_B = plate.core();
  const Vec3 up(0, 0, 1), w(0, spin, 0);
  const SeparationBound fixed(core_A, core_B, up, 0.01, 0, 1), turning(core_A, core_B, {up, w}, 0.01, 0, 1);
  // A point at x of the plate moves by -spin x along z.
  EXPECT_NEAR(fixed.rate(), -spin * 1, 1e-12);
  EXPECT_NEAR(turning.rate(), -spin * place, 1e-12);
}

TEST(SeparationBound, AFaceThatTurnsAlongWithABallNeedsNoTinySteps) {
  // A ball flies along the face of a spinning box, as fast as the face's points at its place: the face turns
  // away from it by ½ ω² d τ². In a fixed direction the corners of the face come nearer at ω times their
  // lever from the start, so that steps would be as short as slack / (ω lever), 2e-7 s.
  const double spin = 5, half = 0.2, radius = 0.1, start_gap = 1e-11;
  const auto body_of = [](const Shape& shape) {
    BodyShape part;
    part.shape = shape;
    part.radius = radius_about(shape, Vec3::Zero());
    Body body;
    body.shapes = {{part}};
    return body;
  };
  const Body box = body_of(Box{Vec3::Constant(half)}), ball = body_of(Sphere{radius});
  const double distance = half + radius + start_gap;
  const BodyInertia of_box{1, Vec3::Ones()}, of_ball{1, Vec3::Ones()};
  const BodyPhase box_phase{Vec3::Zero(), Quat::Identity(), Vec3::Zero(), Vec3(0, 0, spin)};
  const BodyPhase ball_phase{Vec3(distance, 0, 0), Quat::Identity(), Vec3(0, spin * distance, 0),
                             Vec3::Zero()};
  const Motion of_A = Motion::flight(FreeFlight(of_box, box_phase, 0, Vec3::Zero()), of_box);
  const Motion of_B = Motion::flight(FreeFlight(of_ball, ball_phase, 0, Vec3::Zero()), of_ball);
  const TimeOfImpact found = find_time_of_impact(box, of_A, ball, of_B, 0, 0.01, {});
  EXPECT_FALSE(found.is_contact);
  EXPECT_EQ(found.time, 0.01);
  EXPECT_LT(found.evaluations, 100);
}

TEST(SeparationBound, FindsStepsOfAnySize) {
  // Two balls that fall towards each other from a gap of g: the bound is exact, gap - v τ.
  for (const double gap : {1e-12, 1e-9, 1e-6, 1e-3, 1.0}) {
    Moving A, B;
    A.shape.shape = B.shape.shape = Sphere{0.5};
    A.shape.radius = B.shape.radius = 0.5;
    const BodyInertia inertia{1, Vec3(0.1, 0.1, 0.1)};
    const auto flight = [&](double x, double v) {
      return Motion::flight(
          FreeFlight(inertia, {Vec3(x, 0, 0), Quat::Identity(), Vec3(v, 0, 0), Vec3::Zero()}, 0,
                     Vec3::Zero()),
          inertia);
    };
    A.motion = flight(0, 1);
    B.motion = flight(1 + gap, -1);
    const MovingCore core_A = A.core(), core_B = B.core();
    const SeparationBound bound(core_A, core_B, Vec3(1, 0, 0), gap, 0, 1e9);
    EXPECT_NEAR(bound.safe_step(1e9, 0), gap / 2, 1e-6 * gap);
    EXPECT_EQ(bound.safe_step(1e9, 2 * gap), 0);
  }
}

TEST(TurningRadius, HoldsWhatTurningMoves) {
  BodyShape shape;
  shape.X_BS.p = Vec3(0.3, 0, 0.4);
  shape.shape = Sphere{2};
  shape.radius = 2;
  EXPECT_DOUBLE_EQ(turning_radius(shape.shape, shape.X_BS, shape.radius), 0.5);
  shape.shape = Capsule{1, 0.25};
  shape.radius = 1.25;
  EXPECT_DOUBLE_EQ(turning_radius(shape.shape, shape.X_BS, shape.radius), 0.75);
  shape.shape = Box{Vec3(1, 2, 2)};
  shape.radius = 3;
  EXPECT_DOUBLE_EQ(turning_radius(shape.shape, shape.X_BS, shape.radius), 3.5);
}

}  // namespace
}  // namespace rigor::separation_bound_test
