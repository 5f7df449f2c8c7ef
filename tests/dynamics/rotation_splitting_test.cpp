#include "rigor/dynamics/rotation_splitting.hpp"

#include "rigor/dynamics/free_rotation.hpp"
#include "rigor/math/rotation.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace rigor::rotation_splitting_test {
namespace {

const Vec3 kMoments(1, 2, 3);
const Vec3 kL(0.01, 4, 0.03);  // ω = (0.01, 2, 0.01)

using Splitting = Quat (*)(const Vec3&, const Quat&, const Vec3&, double);

Quat rotate(Splitting step, double end, int steps) {
  Quat q = Quat::Identity();
  for (int i = 0; i < steps; ++i) q = step(kMoments, q, kL, end / steps);
  return q;
}

double observed_order(Splitting step, double end, int steps) {
  const Quat exact = FreeRotation(kMoments, Quat::Identity(), kL).orientation(end);
  return std::log2(rotation_angle_between(rotate(step, end, steps), exact) /
                   rotation_angle_between(rotate(step, end, 2 * steps), exact));
}

TEST(RotationSplitting, StrangIsOfOrderTwoAndItsCompositionOfOrderFour) {
  EXPECT_NEAR(observed_order(rotate_by_splitting, 8, 4000), 2, 0.02);
  EXPECT_NEAR(observed_order(rotate_by_splitting4, 8, 400), 4, 0.1);
}

TEST(RotationSplitting, PhaseErrorAtMillisecondStepsIsBelow1em5) {
  const Quat exact = FreeRotation(kMoments, Quat::Identity(), kL).orientation(20);
  EXPECT_LE(rotation_angle_between(rotate(rotate_by_splitting, 20, 20000), exact), 2e-5);
  EXPECT_LE(rotation_angle_between(rotate(rotate_by_splitting4, 20, 2000), exact), 1e-6);
}

TEST(RotationSplitting, EnergyErrorIsBoundedWithoutDrift) {
  const BodyInertia inertia{1, kMoments};
  const double energy = kinetic_energy(inertia, {.L = kL});
  Quat q = Quat::Identity();
  double early = 0, late = 0;
  for (int i = 0; i < 400000; ++i) {
    q = rotate_by_splitting(kMoments, q, kL, 0.01);
    const double error = std::abs(kinetic_energy(inertia, {.q = q, .L = kL}) / energy - 1);
    if (i < 40000) early = std::max(early, error);
    if (i >= 360000) late = std::max(late, error);
  }
  EXPECT_LE(early, 1e-4);
  EXPECT_NEAR(late, early, 1e-3 * early);
}

TEST(RotationSplitting, HundredThousandStepsThereAndBackReturn) {
  Quat q = Quat::Identity();
  for (int i = 0; i < 100000; ++i) q = rotate_by_splitting(kMoments, q, kL, 0.01);
  for (int i = 0; i < 100000; ++i) q = rotate_by_splitting(kMoments, q, -kL, 0.01);
  EXPECT_LE((q.coeffs() - Quat::Identity().coeffs()).norm(), 1e-10);
}

TEST(RotationSplitting, SpinAboutAPrincipalAxisIsExact) {
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 L = 1.7 * Vec3::Unit(axis);
    const Quat q = rotate_by_splitting(kMoments, Quat::Identity(), L, 0.5);
    EXPECT_LE(rotation_angle_between(q, rotation_exp(0.5 * L.cwiseQuotient(kMoments))), 1e-15);
  }
}

// A heavy top about its centre: torque and force from the potential energy of two springs to fixed points.
const std::vector<BodyInertia> kInertia = {{1.3, Vec3(1, 2, 2.5)}};

void two_springs(double, std::span<const BodyPhase> phases, std::span<Wrench> wrenches) {
  const Vec3 points[2] = {Vec3(0.5, 0.2, 0), Vec3(-0.3, 0, 0.6)},
             anchors[2] = {Vec3(1, 1, 0), Vec3(-1, 0, 1)};
  for (int i = 0; i < 2; ++i) {
    const Vec3 arm = rotation_matrix(phases[0].q) * points[i];
    const Vec3 pull = 3 * (anchors[i] - (phases[0].x + arm));
    wrenches[0].f_W += pull;
    wrenches[0].tau_W += arm.cross(pull);
  }
}

double spring_energy(const BodyPhase& phase) {
  const Vec3 points[2] = {Vec3(0.5, 0.2, 0), Vec3(-0.3, 0, 0.6)},
             anchors[2] = {Vec3(1, 1, 0), Vec3(-1, 0, 1)};
  double energy = kinetic_energy(kInertia[0], phase);
  for (int i = 0; i < 2; ++i) {
    energy += 1.5 * (anchors[i] - (phase.x + rotation_matrix(phase.q) * points[i])).squaredNorm();
  }
  return energy;
}

BodyPhase leapfrog(decltype(&leapfrog_step) step, BodyPhase phase, double end, int steps) {
  std::vector<BodyPhase> phases = {phase};
  for (int i = 0; i < steps; ++i) phases = step(kInertia, phases, i * end / steps, end / steps, two_springs);
  return phases[0];
}

const BodyPhase kStart{Vec3(0.1, 0, 0.2), rotation_exp(Vec3(0.3, 0.1, 0)), Vec3(0.5, 0, 0.1),
                       Vec3(0.2, 1, -0.5)};

TEST(Leapfrog, OrdersAreTwoAndFourUnderForces) {
  BodyPhase exact = kStart;
  for (int i = 0; i < 2000; ++i) {
    exact = integrate_step(IntegratorName::dopri5, OrientationForm::quaternion, kInertia,
                           std::span(&exact, 1), 0, 1e-3, two_springs, {})
                .end[0];
  }
  const auto error = [&](decltype(&leapfrog_step) step, int steps) {
    const BodyPhase end = leapfrog(step, kStart, 2, steps);
    return (end.x - exact.x).norm() + rotation_angle_between(end.q, exact.q) + (end.L - exact.L).norm();
  };
  EXPECT_NEAR(std::log2(error(leapfrog_step, 400) / error(leapfrog_step, 800)), 2, 0.02);
  EXPECT_NEAR(std::log2(error(leapfrog4_step, 80) / error(leapfrog4_step, 160)), 4, 0.1);
}

TEST(Leapfrog, EnergyHasNoDriftAndTimeCanBeReversed) {
  const double energy = spring_energy(kStart);
  EXPECT_NEAR(spring_energy(leapfrog(leapfrog_step, kStart, 100, 20000)), energy, 1e-3 * energy);
  BodyPhase there = leapfrog(leapfrog_step, kStart, 20, 4000);
  there.P = -there.P;
  there.L = -there.L;
  const BodyPhase back = leapfrog(leapfrog_step, there, 20, 4000);
  EXPECT_LE((back.x - kStart.x).norm() + rotation_angle_between(back.q, kStart.q), 1e-10);
  EXPECT_LE((back.L + kStart.L).norm(), 1e-10);
}

}  // namespace
}  // namespace rigor::rotation_splitting_test
