#include "rigor/solver/motion/projected_gauss_seidel.hpp"

#include "rigor/solver/coulomb/coulomb_guess.hpp"

#include "random_vectors.hpp"
#include "solver/jointed_scenes.hpp"

#include <gtest/gtest.h>

namespace rigor::projected_gauss_seidel_test {
namespace {

using scenes::JointedScene;

constexpr double kGravity = 9.81;

JointedScene without_joints(const scenes::Scene& scene) {
  JointedScene result;
  static_cast<scenes::Scene&>(result) = scene;
  return result;
}

/// b and c of the bodies' free motion.
VelocityProblem velocity_problem_of(const JointedScene& scene) {
  VelocityProblem problem{scenes::motion_problem_of(scene), {}};
  const VecX V = scenes::free_motion(scene);
  problem.contacts.laws.b = contact_rates(problem.contacts.rows, V);
  problem.c = scenes::joint_matrix(scene) * V;
  return problem;
}

TEST(ProjectedGaussSeidel, OneSweepSolvesAMassOnThePlane) {
  // A point mass m: A = 1/m. It slides at v - μ h g, and sticks where that is below zero.
  JointedScene scene;
  scene.bodies.push_back({2.0, Mat3::Identity(), Vec3::Zero(), Vec3(0.3, -0.4, -kGravity)});
  scene.contacts.push_back({-1, 0, Vec3::Zero(), scenes::axes_of(Vec3::UnitZ()), 0.02});
  const VelocityProblem problem = velocity_problem_of(scene);
  const VelocitySolution slides = solve_projected_gauss_seidel(problem, 1);
  EXPECT_LE(slides.residual, 1e-15);
  EXPECT_NEAR(slides.lambda(2), 2 * kGravity, 1e-14);
  EXPECT_NEAR(slides.w.head<2>().norm(), 0.5 - 0.02 * kGravity, 1e-15);
  scene.contacts[0].mu = 0.06;
  const VelocitySolution sticks = solve_projected_gauss_seidel(velocity_problem_of(scene), 1);
  EXPECT_LE(sticks.w.norm(), 1e-15);
  EXPECT_LE((sticks.lambda - Vec3(-0.6, 0.8, 2 * kGravity)).norm(), 1e-14);
}

TEST(ProjectedGaussSeidel, SweepsConvergeToTheExactCone) {
  test::Random random(5);
  for (int trial = 0; trial < 10; ++trial) {
    scenes::Scene scene = scenes::stack({1, 2, 1}, 0.3);
    for (scenes::Body& body : scene.bodies) {
      body.v += random.vector();
      body.omega = 0.3 * random.vector();
    }
    const VelocityProblem problem = velocity_problem_of(without_joints(scene));
    const VelocitySolution rough = solve_projected_gauss_seidel(problem, 10);
    const VelocitySolution fine = solve_projected_gauss_seidel(problem, 20000);
    EXPECT_LE(fine.residual, 1e-12) << trial;
    EXPECT_LT(fine.residual, 1e-6 * rough.residual) << trial;
    // The residual is that of the dense problem: the law holds with the disc, not with a box.
    const CoulombProblem dense = scenes::problem_of(scene);
    EXPECT_LE(coulomb_residual(dense, fine.lambda, dense.A * fine.lambda + dense.b), 1e-12) << trial;
  }
}

TEST(ProjectedGaussSeidel, ItBeginsWithTheForcesItIsGiven) {
  const VelocityProblem problem =
      velocity_problem_of(without_joints(scenes::stack(std::vector<double>(10, 1.0), 0.5)));
  const VelocitySolution cold = solve_projected_gauss_seidel(problem, 50);
  const VelocitySolution warm = solve_projected_gauss_seidel(problem, 50, {cold.lambda, cold.nu});
  const VelocitySolution all = solve_projected_gauss_seidel(problem, 100);
  EXPECT_EQ(warm.lambda, clamp_to_cones(problem.contacts.laws, warm.lambda));
  EXPECT_LE((warm.lambda - all.lambda).norm(), 1e-12 * all.lambda.norm());
  // The bottom of a stack learns of its load slowly: what a fixed number of sweeps leaves is told.
  EXPECT_GT(cold.residual, 1e-4);
  EXPECT_LT(warm.residual, cold.residual);
  EXPECT_DOUBLE_EQ(warm.residual, solve_projected_gauss_seidel(problem, 0, {warm.lambda, warm.nu}).residual);
}

TEST(ProjectedGaussSeidel, JointsAndContactsTogetherConvergeToTheHeldMotion) {
  // A box on nine points, held by a hinge that stands over its middle; the joint is listed twice.
  JointedScene scene = without_joints(scenes::box_on_plane(3, 0.4, kGravity * Vec3(0.1, 0.2, -1)));
  scene.bodies[0].omega = Vec3(0.4, 3, 0.7);
  scene.joints.push_back({-1, 0, Vec3(0.1, 0, 0.6), Vec3::UnitY()});
  scene.joints.push_back(scene.joints.front());
  const VelocityProblem problem = velocity_problem_of(scene);
  const VelocitySolution solution = solve_projected_gauss_seidel(problem, 3000);
  EXPECT_LE(solution.residual, 1e-12);
  EXPECT_LE(solution.r.cwiseAbs().maxCoeff(), 1e-10);
  const CoulombSolution exact = solve_coulomb(scenes::contact_problem_of(scene));
  ASSERT_TRUE(exact.converged);
  EXPECT_LE((scenes::held_motion_with(scene, exact.lambda) - scenes::held_motion_with(scene, solution.lambda))
                .cwiseAbs()
                .maxCoeff(),
            1e-9);
}

TEST(ProjectedGaussSeidel, SlideRowsKeepTheirDirection) {
  JointedScene scene = without_joints(scenes::box_on_plane(2, 0.3, Vec3(0, 0, -kGravity)));
  VelocityProblem problem = velocity_problem_of(scene);
  problem.contacts.laws.rows.assign(4, FrictionRow::slide);
  problem.contacts.laws.slips.assign(4, Vec2(0.6, 0.8));
  const VelocitySolution solution = solve_projected_gauss_seidel(problem, 2000);
  EXPECT_LE(solution.residual, 1e-12);
  for (Eigen::Index i = 0; i < 4; ++i)
    EXPECT_LE((solution.lambda.segment<2>(3 * i) + 0.3 * solution.lambda(3 * i + 2) * Vec2(0.6, 0.8)).norm(),
              1e-15);
}

}  // namespace
}  // namespace rigor::projected_gauss_seidel_test
