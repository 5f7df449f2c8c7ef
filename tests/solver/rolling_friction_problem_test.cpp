#include "rigor/solver/coulomb/rolling_friction_problem.hpp"

#include "random_vectors.hpp"
#include "solver/contact_scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace rigor::rolling_friction_problem_test {
namespace {

constexpr double kGravity = 9.81;

/// Contacts of the scene with six rows each: forces, then moments of B against A.
RollingFrictionProblem rolling_friction_problem_of(const scenes::Scene& scene, double rolling,
                                                   double torsional) {
  const Eigen::Index n = static_cast<Eigen::Index>(scene.contacts.size());
  const MatX forces = scenes::contact_jacobian(scene);
  MatX J = MatX::Zero(6 * n, forces.cols());
  RollingFrictionProblem problem;
  for (Eigen::Index i = 0; i < n; ++i) {
    const scenes::Contact& contact = scene.contacts[static_cast<std::size_t>(i)];
    J.middleRows<3>(6 * i) = forces.middleRows<3>(3 * i);
    if (contact.body_A >= 0) J.block<3, 3>(6 * i + 3, 6 * contact.body_A + 3) = -contact.axes.transpose();
    if (contact.body_B >= 0) J.block<3, 3>(6 * i + 3, 6 * contact.body_B + 3) = contact.axes.transpose();
    problem.mu.push_back(contact.mu);
    problem.rolling.push_back(rolling);
    problem.torsional.push_back(torsional);
  }
  const MatX A = J * scenes::inverse_mass(scene) * J.transpose();
  problem.A = 0.5 * (A + A.transpose());
  problem.b = J * scenes::free_motion(scene);
  return problem;
}

/// A ball of mass 2, radius 0.1 m on the floor, its velocities after a step of gravity.
scenes::Scene ball(double mu, const Vec3& v, const Vec3& omega, double h) {
  const double m = 2, R = 0.1;
  scenes::Scene scene;
  scene.bodies.push_back(
      {m, 0.4 * m * R * R * Mat3::Identity(), Vec3(0, 0, R), v - Vec3(0, 0, h * kGravity), omega});
  Mat3 axes = Mat3::Identity();
  scene.contacts.push_back({-1, 0, Vec3::Zero(), axes, mu});
  return scene;
}

// Rolling friction ρ: about the point of contact 7/5 m R² α = -ρ m g, so v falls by 5/7 ρ g h / R each step.
TEST(RollingFriction, ARollingBallIsBrakedByRollingFriction) {
  const double R = 0.1, rho = 1e-3, h = 1e-2, v = 0.5;
  const RollingFrictionProblem problem =
      rolling_friction_problem_of(ball(0.3, Vec3(v, 0, 0), Vec3(0, v / R, 0), h), rho, 0);
  const RollingFrictionSolution s = solve_rolling_friction(problem);
  ASSERT_TRUE(s.converged) << s.residual;
  const double slower = 5.0 / 7 * rho * kGravity * h / R;
  // It rolls on: the contact point rests, the ball turns with (v - slower) / R about y.
  EXPECT_LE(s.w.head<3>().norm(), 1e-15);
  EXPECT_NEAR(s.w(4), (v - slower) / R, 1e-13);
  EXPECT_NEAR(s.lambda(2), 2 * kGravity * h, 1e-15);
  EXPECT_NEAR(s.lambda(0), -2 * slower, 1e-14);
  EXPECT_NEAR(s.lambda(4), -rho * s.lambda(2), 1e-16);
}

TEST(RollingFriction, ASlowBallStopsWithLessThanTheGreatestMoment) {
  const double R = 0.1, rho = 1e-3, h = 1e-2, v = 3e-4;
  const RollingFrictionSolution s = solve_rolling_friction(
      rolling_friction_problem_of(ball(0.3, Vec3(v, 0, 0), Vec3(0, v / R, 0), h), rho, 0));
  ASSERT_TRUE(s.converged) << s.residual;
  EXPECT_LE(s.w.norm(), 1e-15);
  // 7/5 m R² v / R comes to rest about the point of contact.
  EXPECT_NEAR(s.lambda(4), -1.4 * 2 * R * v, 1e-16);
  EXPECT_LT(std::abs(s.lambda(4)), rho * s.lambda(2));
}

// Torsional friction σ: 2/5 m R² α = -σ m g.
TEST(RollingFriction, SpinDecaysAndEnds) {
  const double R = 0.1, sigma = 2e-4, h = 1e-2;
  const double slower = sigma * kGravity * h / (0.4 * R * R);
  const RollingFrictionSolution spins = solve_rolling_friction(
      rolling_friction_problem_of(ball(0.3, Vec3::Zero(), Vec3(0, 0, 3), h), 0, sigma));
  ASSERT_TRUE(spins.converged);
  EXPECT_NEAR(spins.w(5), 3 - slower, 1e-14);
  const RollingFrictionSolution stops = solve_rolling_friction(
      rolling_friction_problem_of(ball(0.3, Vec3::Zero(), Vec3(0, 0, -0.9 * slower), h), 0, sigma));
  EXPECT_NEAR(stops.w(5), 0, 1e-16);
  EXPECT_NEAR(stops.lambda(5), 0.9 * sigma * stops.lambda(2), 1e-18);
}

// All three at once: sliding along (3, 4) / 5, rolling about another axis, spinning.
TEST(RollingFriction, TheThreeFrictionsOpposeEachItsOwnMotion) {
  const double mu = 0.2, rho = 1e-3, sigma = 2e-4, h = 1e-3;
  const RollingFrictionProblem problem =
      rolling_friction_problem_of(ball(mu, Vec3(0.3, 0.4, 0), Vec3(1, -2, 3), h), rho, sigma);
  const RollingFrictionSolution s = solve_rolling_friction(problem);
  ASSERT_TRUE(s.converged) << s.residual;
  const double normal = 2 * kGravity * h;
  EXPECT_NEAR(s.lambda(2), normal, 1e-15);
  EXPECT_LE((s.lambda.head<2>() + mu * normal * s.w.head<2>().normalized()).norm(), 1e-14);
  EXPECT_LE((s.lambda.segment<2>(3) + rho * normal * s.w.segment<2>(3).normalized()).norm(), 1e-16);
  EXPECT_NEAR(s.lambda(5), -sigma * normal, 1e-17);
}

TEST(RollingFriction, WithoutMomentsItIsCoulombsProblem) {
  test::Random random(7);
  for (int trial = 0; trial < 20; ++trial) {
    scenes::Scene scene = scenes::box_on_plane(2, 0.3, Vec3(0, 0, -1));
    // Three points: forces are unique.
    scene.contacts.pop_back();
    scene.bodies[0].v += 0.5 * random.vector();
    scene.bodies[0].omega = random.vector();
    const RollingFrictionSolution s = solve_rolling_friction(rolling_friction_problem_of(scene, 0, 0));
    const CoulombProblem problem = scenes::problem_of(scene);
    VecX lambda(9), w(9);
    for (Eigen::Index i = 0; i < 3; ++i) {
      lambda.segment<3>(3 * i) = s.lambda.segment<3>(6 * i);
      w.segment<3>(3 * i) = s.w.segment<3>(6 * i);
    }
    EXPECT_TRUE(s.converged) << trial << ": " << s.residual;
    EXPECT_LE(coulomb_residual(problem, lambda, w), 2e-12) << trial;
  }
}

TEST(RollingFriction, HeapsOfBallsAndBoxesAreSolvedToRoundOff) {
  test::Random random(9);
  int solved = 0;
  for (int trial = 0; trial < 30; ++trial) {
    scenes::Scene scene = scenes::stack({1, 2, 1}, 0.3);
    for (scenes::Body& body : scene.bodies) {
      body.v += random.vector();
      body.omega = random.vector();
    }
    const RollingFrictionProblem problem = rolling_friction_problem_of(scene, 0.02, 0.01);
    const RollingFrictionSolution s = solve_rolling_friction(problem);
    solved += s.converged ? 1 : 0;
    EXPECT_LE(s.residual, 1e-9) << trial;
    EXPECT_EQ(s.residual, rolling_friction_residual(problem, s.lambda, s.w));
    // Started from its own forces it is there at once.
    EXPECT_LE(solve_rolling_friction(problem, s.lambda).residual, std::max(1e-12, s.residual)) << trial;
  }
  EXPECT_GE(solved, 28);
}

TEST(RollingFriction, UnitsOfLengthAndMassDoNotMatter) {
  scenes::Scene scene = ball(0.2, Vec3(0.3, 0.4, 0), Vec3(1, -2, 3), 1e-3);
  const RollingFrictionSolution metres =
      solve_rolling_friction(rolling_friction_problem_of(scene, 1e-3, 2e-4));
  RollingFrictionProblem problem = rolling_friction_problem_of(scene, 1e-3 * 1000, 2e-4 * 1000);
  // Millimetres: velocities and ρ times 1000, A of forces and moments accordingly.
  for (Eigen::Index i = 0; i < 6; ++i) {
    if (i < 3) problem.b(i) *= 1000;
    for (Eigen::Index j = 0; j < 6; ++j) problem.A(i, j) *= (i < 3 ? 1000 : 1) * (j < 3 ? 1 : 1e-3);
  }
  const RollingFrictionSolution millimetres = solve_rolling_friction(problem);
  for (Eigen::Index i = 0; i < 6; ++i)
    EXPECT_NEAR(millimetres.w(i), (i < 3 ? 1000 : 1) * metres.w(i), 1e-12 * (i < 3 ? 1000 : 1));
}

TEST(RollingFriction, NumbersThatAreNoneAreNotSolved) {
  RollingFrictionProblem problem =
      rolling_friction_problem_of(ball(0.2, Vec3(0.3, 0.4, 0), Vec3::Zero(), 1e-3), 1e-3, 0);
  problem.b(0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(solve_rolling_friction(problem).converged);
}

}  // namespace
}  // namespace rigor::rolling_friction_problem_test
