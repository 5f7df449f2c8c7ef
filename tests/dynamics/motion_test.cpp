#include "rigor/dynamics/motion.hpp"

#include "random_vectors.hpp"
#include "rigor/math/rotation.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rigor::motion_test {
namespace {

constexpr IntegratorName all_integrators[] = {IntegratorName::euler,    IntegratorName::semi_implicit_euler,
                                              IntegratorName::midpoint, IntegratorName::rk4,
                                              IntegratorName::dopri5,   IntegratorName::dop853,
                                              IntegratorName::lie_rk4};

using test::Random;

const BodyInertia inertia{2, Vec3(0.5, 0.8, 1.1)};

BodyPhase random_phase(Random& random) {
  const Vec3 axis = random.vector();
  return {random.vector(), rotation_exp(3 * axis), 2 * random.vector(), random.vector()};
}

/// A step under a force and a torque that change with time and place.
Motion random_step(IntegratorName name, OrientationForm form, Random& random, double h, BodyPhase& start) {
  start = random_phase(random);
  const WrenchField field = [](double t, std::span<const BodyPhase> phases, std::span<Wrench> wrenches) {
    wrenches[0] = {Vec3(0, 3 * t, -9.81) - 4 * phases[0].x, Vec3(1, 0, t) - phases[0].L};
  };
  const SystemStep step =
      integrate_step(name, form, std::span(&inertia, 1), std::span(&start, 1), 0.3, h, field, {});
  return Motion::step(step.dense.front(), 0.3, h);
}

TEST(Motion, VelocitiesOfAStepAreTheDerivativesOfItsPath) {
  Random random(1);
  constexpr double d = 1e-5;
  for (const IntegratorName name : all_integrators) {
    for (const OrientationForm form : {OrientationForm::quaternion, OrientationForm::matrix}) {
      BodyPhase start;
      const Motion motion = random_step(name, form, random, 0.1, start);
      for (const double t : {0.3 + d, 0.33, 0.37, 0.4 - d}) {
        const Motion::Sample now = motion.sample(t), before = motion.sample(t - d),
                             after = motion.sample(t + d);
        EXPECT_LE((now.v - (after.X_WB.p - before.X_WB.p) / (2 * d)).norm(), 1e-8);
        EXPECT_EQ(now.v, motion.velocity(t));
        const Vec3 turned = rotation_log(quaternion_of(after.X_WB.R * before.X_WB.R.transpose()));
        EXPECT_LE((now.w - turned / (2 * d)).norm(), 1e-8);
      }
    }
  }
}

// Whether two bodies approach when a step begins must not depend on who is asked, the path or the momenta.
TEST(Motion, AStepLeavesWithTheVelocitiesOfItsStart) {
  Random random(2);
  for (const IntegratorName name : all_integrators) {
    BodyPhase start;
    const Motion motion = random_step(name, OrientationForm::quaternion, random, 0.05, start);
    const Motion::Sample first = motion.sample(0.3);
    EXPECT_LE((first.v - start.P / inertia.mass).norm(), 1e-14);
    // lie_rk4's quaternion polynomial is a fit: exact to the order of the fit only.
    const double tolerance = name == IntegratorName::lie_rk4 ? 1e-8 : 1e-13;
    EXPECT_LE((first.w - angular_velocity(inertia, start.q, start.L)).norm(), tolerance);
  }
}

void expect_bounds_hold(const Motion& motion, double ta, double tb, Random& random) {
  constexpr int samples = 50;
  constexpr double d = 1e-4;
  const Vec3 n = random.vector().normalized();
  const double least = motion.min_acceleration_along(n, ta, tb);
  const Aabb box = motion.path_box(ta, tb).grown(1e-14);
  for (int k = 0; k <= samples; ++k) {
    const double t = ta + (tb - ta) * k / samples;
    const Motion::Sample now = motion.sample(t);
    EXPECT_TRUE((now.X_WB.p.array() >= box.lower.array()).all() &&
                (now.X_WB.p.array() <= box.upper.array()).all());
    EXPECT_LE(now.w.norm(), motion.max_angular_speed() * (1 + 1e-12));
    if (t - d < ta || t + d > tb) continue;
    // Central differences of a path with derivatives of some hundreds: good to 1e-5.
    const Motion::Sample before = motion.sample(t - d), after = motion.sample(t + d);
    EXPECT_GE(n.dot(after.v - before.v) / (2 * d), least - 1e-5);
    const double alpha = (after.w - before.w).norm() / (2 * d);
    EXPECT_LE(alpha + now.w.squaredNorm(), motion.max_turn_acceleration() * (1 + 1e-9) + 1e-5);
  }
}

TEST(Motion, BoundsOfStepsHoldAllAlong) {
  Random random(3);
  for (int trial = 0; trial < 20; ++trial) {
    for (const IntegratorName name : all_integrators) {
      BodyPhase start;
      expect_bounds_hold(random_step(name, OrientationForm::quaternion, random, 0.1, start), 0.32, 0.39,
                         random);
    }
  }
}

TEST(Motion, BoundsOfFlightsHoldAllAlong) {
  Random random(4);
  for (int trial = 0; trial < 40; ++trial) {
    const BodyPhase start = random_phase(random);
    const FreeFlight flight(inertia, start, 0.5, Vec3(0, 0, -9.81));
    const Motion motion = Motion::flight(flight, inertia);
    expect_bounds_hold(motion, 0.5, 1.5, random);
    EXPECT_TRUE(motion.is_ballistic());
    EXPECT_EQ(motion.acceleration(), Vec3(0, 0, -9.81));
  }
}

TEST(Motion, OfABodyAtRestIsNone) {
  Random random(5);
  const BodyPhase phase{random.vector(), rotation_exp(random.vector()), Vec3::Zero(), Vec3::Zero()};
  const Motion motion = Motion::at_rest(phase, 2);
  EXPECT_EQ(motion.position(7), phase.x);
  EXPECT_TRUE(motion.velocity(7).isZero(0));
  EXPECT_EQ(motion.max_angular_speed(), 0);
  EXPECT_TRUE(std::isinf(motion.end()));
  const Aabb box = motion.path_box(2, 9);
  EXPECT_EQ(box.lower, phase.x);
  EXPECT_EQ(box.upper, phase.x);
}

}  // namespace
}  // namespace rigor::motion_test
