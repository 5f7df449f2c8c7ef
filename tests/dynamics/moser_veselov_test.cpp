#include "rigor/dynamics/moser_veselov.hpp"

#include "rigor/dynamics/free_rotation.hpp"
#include "rigor/math/rotation.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace rigor::moser_veselov_test {
namespace {

const Vec3 kMoments(1, 2, 3);
const Vec3 kL(0.01, 4, 0.03);

Quat rotate(double end, int steps) {
  Quat q = Quat::Identity();
  for (int i = 0; i < steps; ++i) {
    const MoserVeselovStep step = moser_veselov_step(kMoments, q, kL, end / steps);
    EXPECT_TRUE(step.converged);
    q = step.q_WB;
  }
  return q;
}

TEST(MoserVeselov, StepSolvesTheMatrixEquation) {
  // h M~ = F J - J Fᵀ with J = ½ tr(I) 1 - I.
  const Vec3 L(0.7, -1.1, 0.4);
  const Quat q = rotation_exp(Vec3(0.5, -0.2, 0.9));
  const double h = 0.3;
  const MoserVeselovStep step = moser_veselov_step(kMoments, q, L, h);
  ASSERT_TRUE(step.converged);
  const Mat3 F = rotation_matrix(q.conjugate() * step.q_WB);
  const Mat3 J = (Vec3::Constant(0.5 * kMoments.sum()) - kMoments).asDiagonal();
  const Vec3 M = rotation_matrix(q).transpose() * L;
  EXPECT_LE((h * skew(M) - (F * J - J * F.transpose())).norm(), 2e-15);
  EXPECT_LE(step.residual, 1e-15);
  EXPECT_LE(step.iterations, 7);
}

TEST(MoserVeselov, ObservedOrderIsTwo) {
  const Quat exact = FreeRotation(kMoments, Quat::Identity(), kL).orientation(8);
  const double coarse = rotation_angle_between(rotate(8, 4000), exact);
  const double fine = rotation_angle_between(rotate(8, 8000), exact);
  EXPECT_NEAR(std::log2(coarse / fine), 2, 0.02);
}

TEST(MoserVeselov, EnergyIsKeptExactly) {
  // The discrete equations keep the energy as well as L; only the speed along the orbit is in error.
  const BodyInertia inertia{1, kMoments};
  const double energy = kinetic_energy(inertia, {.L = kL});
  Quat q = Quat::Identity();
  double worst = 0;
  for (int i = 0; i < 30000; ++i) {
    q = moser_veselov_step(kMoments, q, kL, 0.05).q_WB;
    worst = std::max(worst, std::abs(kinetic_energy(inertia, {.q = q, .L = kL}) / energy - 1));
  }
  EXPECT_LE(worst, 3e-14);  // a random walk of 30 000 roundings
}

TEST(MoserVeselov, StepBackUndoesTheStep) {
  const Quat q = rotation_exp(Vec3(0.1, 0.7, 0.2));
  const Vec3 L(0.3, 1.2, -0.8);
  const MoserVeselovStep there = moser_veselov_step(kMoments, q, L, 0.2);
  const MoserVeselovStep back = moser_veselov_step(kMoments, there.q_WB, L, -0.2);
  EXPECT_LE(rotation_angle_between(back.q_WB, q), 1e-15);
}

TEST(MoserVeselov, TooLargeAStepIsSaidAndChangesNothing) {
  const Quat q = rotation_exp(Vec3(0.1, 0.7, 0.2));
  const MoserVeselovStep step = moser_veselov_step(kMoments, q, kL, 100);
  EXPECT_FALSE(step.converged);
  EXPECT_EQ(step.q_WB.coeffs(), q.coeffs());
  EXPECT_TRUE(moser_veselov_step(kMoments, q, Vec3::Zero(), 100).converged);
}

}  // namespace
}  // namespace rigor::moser_veselov_test
