#include "rigor/solver/cones/convex_cone.hpp"
#include "rigor/solver/cones/pyramid_cone.hpp"
#include "rigor/solver/motion/motion_problem.hpp"

#include "random_vectors.hpp"
#include "solver/jointed_scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace rigor::cone_model_test {
namespace {

constexpr double kGravity = 9.81;

/// A point of mass m on a plane: w = λ / m + b.
CoulombProblem point_mass(double mass, const Vec3& b, double mu) {
  return {Mat3::Identity() / mass, b, {mu}, {FrictionRow::cone}, {Vec2::UnitX()}};
}

/// The scene's contacts as sparse rows.
MotionProblem rows_of(const scenes::Scene& scene) {
  scenes::JointedScene jointed;
  static_cast<scenes::Scene&>(jointed) = scene;
  MotionProblem problem = scenes::motion_problem_of(jointed);
  constrain_nodes(nullptr, {}, problem.rows);
  return problem;
}

// With p = m g h: K ∋ λ ⊥ w ∈ K* on the sides of both cones gives λ_n = (p + μ m v) / (1 + μ²), w_n = μ
// |w_t|.
TEST(ConvexCone, ASlidingBlockLiftsOffWithMuTimesItsSpeed) {
  const double m = 2, mu = 0.5, v = 3, fall = 0.0981;
  const CoulombProblem problem = point_mass(m, Vec3(0.6 * v, 0.8 * v, -fall), mu);
  const CoulombSolution convex = solve_convex_cones(problem);
  ASSERT_TRUE(convex.converged);
  EXPECT_EQ(convex.modes[0], ContactMode::slide);
  const double normal = m * (fall + mu * v) / (1 + mu * mu);
  EXPECT_NEAR(convex.lambda(2), normal, 1e-11 * normal);
  const double speed = v - mu * normal / m;
  EXPECT_NEAR(convex.w(2), mu * speed, 1e-10);
  EXPECT_LE((convex.w.head<2>() - speed * Vec2(0.6, 0.8)).norm(), 1e-10);
  // It flies up at more than a metre a second; Coulomb's law leaves it on the floor.
  EXPECT_GT(convex.w(2), 1.0);
  const CoulombSolution exact = solve_coulomb(problem);
  EXPECT_NEAR(exact.w(2), 0, 1e-15);
  EXPECT_NEAR(exact.lambda(2), m * fall, 1e-14);
  EXPECT_GT(coulomb_residual(problem, convex.lambda, convex.w), 0.1);
}

TEST(ConvexCone, WhatSticksIsAsCoulombsLawHasIt) {
  const CoulombProblem problem = scenes::problem_of(scenes::stack({1, 2, 1, 5}, 0.5));
  const CoulombSolution convex = solve_convex_cones(problem), exact = solve_coulomb(problem);
  ASSERT_TRUE(convex.converged);
  EXPECT_LE((convex.w - exact.w).cwiseAbs().maxCoeff(), 1e-8);
}

TEST(ConvexCone, ItsForcesAreOfLeastEnergyAmongAllOfTheCones) {
  test::Random random(2);
  for (int trial = 0; trial < 20; ++trial) {
    scenes::Scene scene = scenes::box_on_plane(2, 0.4, Vec3(0, 0, -1));
    scene.bodies[0].v += random.vector();
    scene.bodies[0].omega = random.vector();
    const CoulombProblem problem = scenes::problem_of(scene);
    const CoulombSolution convex = solve_convex_cones(problem);
    EXPECT_TRUE(convex.converged) << convex.residual;
    // The conditions of the minimum over the cones: λ·w = 0, and w in the dual cones.
    EXPECT_NEAR(convex.lambda.dot(convex.w), 0, 1e-9);
    for (Eigen::Index i = 0; i < 4; ++i)
      EXPECT_GE(convex.w(3 * i + 2), 0.4 * convex.w.segment<2>(3 * i).norm() - 1e-9);
    // Exact forces obey the cones too: their energy is no smaller.
    const CoulombSolution exact = solve_coulomb(problem);
    const auto energy = [&](const VecX& x) { return 0.5 * x.dot(problem.A * x) + problem.b.dot(x); };
    EXPECT_LE(energy(convex.lambda), energy(exact.lambda) + 1e-12);
    const CoulombSolution sparse = solve_convex_cones(rows_of(scene));
    EXPECT_LE((sparse.w - convex.w).norm(), 1e-9);
  }
}

// With four directions all of the friction is along t1 while |w_1| > |w_2|.
TEST(PyramidCone, FrictionTakesTheNearestDirection) {
  const double m = 2, mu = 0.1, v = 3, fall = 0.0981;
  for (const double angle : {0.1, 0.35, 0.7}) {
    const CoulombProblem problem = point_mass(m, Vec3(v * std::cos(angle), v * std::sin(angle), -fall), mu);
    const CoulombSolution four = solve_pyramids(problem);
    ASSERT_TRUE(four.converged);
    EXPECT_NEAR(four.lambda(2), m * fall, 1e-13);
    EXPECT_LE((four.lambda.head<2>() + mu * m * fall * Vec2::UnitX()).norm(), 1e-13);
    EXPECT_NEAR(four.w(2), 0, 1e-14);
    // 2k directions: the error is at most π / 2k, and half of it in the mean.
    const CoulombSolution many = solve_pyramids(problem, {64, 0});
    const double error = std::acos(-many.lambda.head<2>().normalized().dot(many.w.head<2>().normalized()));
    EXPECT_LE(error, std::numbers::pi / 64 + 1e-9);
    const CoulombSolution exact = solve_coulomb(problem);
    EXPECT_NEAR(exact.lambda.head<2>().normalized().dot(exact.w.head<2>().normalized()), -1, 1e-14);
  }
}

enum class ConeModel { exact, convex, pyramid };

/// The problem with this cone, each by the solver that time stepping uses for it.
CoulombSolution solve_with_cone(const MotionProblem& problem, ConeModel cone) {
  if (cone == ConeModel::convex) return solve_convex_cones(problem);
  if (cone == ConeModel::exact) {
    if (std::optional<CoulombSolution> solution = solve_in_motion_space(problem)) return *solution;
  }
  CoulombProblem dense = problem.laws;
  dense.A = contact_response(problem.rows);
  return cone == ConeModel::pyramid ? solve_pyramids(dense) : solve_coulomb(dense);
}

/// Velocity (across, down) after the time `end` of a block on a ramp of angle α that is thrown across with
/// v0, μ = tan α: steps of h with a cone model.
Vec2 thrown_across(ConeModel cone, double end, double h) {
  const double alpha = 20 * std::numbers::pi / 180, v0 = 2;
  MotionProblem problem;
  problem.rows.masses.push_back(Mat6::Identity());
  problem.rows.inverse_masses.push_back(Mat6::Identity());
  ContactRows::Sides sides;
  sides[0].node = 0;
  sides[0].J.leftCols<3>().setIdentity();
  problem.rows.contacts.push_back(sides);
  problem.laws = point_mass(1, Vec3::Zero(), std::tan(alpha));
  problem.laws.A.resize(0, 0);
  Vec3 v(v0, 0, 0);
  for (int step = 0; step < std::lround(end / h); ++step) {
    problem.laws.b = v + h * kGravity * Vec3(0, std::sin(alpha), -std::cos(alpha));
    v = solve_with_cone(problem, cone).w;
  }
  return v.head<2>();
}

// T47: |v| (1 + cos ψ) = v0 with the angle ψ to the fall line; at 0.5 s the reference has (0.589814734844041,
// 0.913029644640213).
TEST(ConeModels, OnlyTheExactConeLetsABlockTurnDownTheRamp) {
  const Vec2 reference(0.589814734844041, 0.913029644640213);
  const Vec2 exact = thrown_across(ConeModel::exact, 0.5, 1e-3);
  EXPECT_LE((exact - reference).norm(), 2e-3);  // A step of first order.
  EXPECT_NEAR(exact.norm() + exact(1), 2.0, 4e-3);
  // The pyramid brakes along t1 alone until both components are v0 / 2; then friction is what gravity needs
  // along t2, and the block goes on at 45 degrees for ever.
  const Vec2 pyramid = thrown_across(ConeModel::pyramid, 0.5, 1e-3);
  EXPECT_LE((pyramid - Vec2(1, 1)).norm(), 4e-3);
  EXPECT_LE((thrown_across(ConeModel::pyramid, 2, 1e-3) - Vec2(1, 1)).norm(), 4e-3);
  EXPECT_LE((thrown_across(ConeModel::exact, 2, 1e-3) - Vec2(0, 1)).norm(), 0.05);
}

TEST(ConeModels, EachIsReachedByItsName) {
  scenes::Scene scene = scenes::box_on_plane(2, 0.3, Vec3(0.2, 0.1, -1));
  scene.bodies[0].v += Vec3(1, 0.5, 0);
  const MotionProblem problem = rows_of(scene);
  const CoulombProblem dense = scenes::problem_of(scene);
  const CoulombSolution exact = solve_with_cone(problem, ConeModel::exact),
                        convex = solve_with_cone(problem, ConeModel::convex),
                        pyramid = solve_with_cone(problem, ConeModel::pyramid);
  EXPECT_TRUE(exact.converged && convex.converged && pyramid.converged);
  EXPECT_LE(coulomb_residual(dense, exact.lambda, exact.w), 1e-12);
  EXPECT_GT(coulomb_residual(dense, convex.lambda, convex.w), 1e-3);
  EXPECT_GT(coulomb_residual(dense, pyramid.lambda, pyramid.w), 1e-3);
  EXPECT_EQ(pyramid.method, "pyramid");
  EXPECT_EQ(convex.method, "convex");
}

TEST(ConeModels, TheFormedMatrixIsThatOfTheRows) {
  const scenes::Scene scene = scenes::stack({1, 3}, 0.4);
  EXPECT_LE((contact_response(rows_of(scene).rows) - scenes::problem_of(scene).A).norm(), 1e-13);
}

}  // namespace
}  // namespace rigor::cone_model_test
