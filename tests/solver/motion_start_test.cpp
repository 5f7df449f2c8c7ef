// Problems that begin with the forces of one like them.

#include "rigor/solver/motion/motion_start.hpp"

#include "random_vectors.hpp"
#include "rigor/solver/motion/motion_problem.hpp"
#include "solver/heap_problems.hpp"

#include <gtest/gtest.h>

namespace rigor::motion_start_test {
namespace {

CoulombOptions step_options() {
  CoulombOptions options;
  options.least_norm = false;
  options.enough = 1e-10;
  options.resolution = 0;
  options.is_bold = true;
  return options;
}

VecX forces_of(const MotionProblem& problem) {
  return solve_in_motion_space(problem, {}, step_options()).value().lambda;
}

class MotionStart : public testing::TestWithParam<heaps::Heap> {};

TEST_P(MotionStart, ForcesThatSolveTheProblemAreKept) {
  const MotionProblem problem = heaps::problem_of(GetParam());
  const VecX forces = forces_of(problem);
  ASSERT_LE(heaps::residual_of(problem, forces), 1e-12);
  const std::optional<CoulombSolution> kept = solve_from_forces(problem, forces, step_options());
  ASSERT_TRUE(kept.has_value());
  EXPECT_EQ(kept->iterations, 0);
  // But for the rounding of forces at the border of their cones.
  EXPECT_LE((kept->lambda - forces).norm(), 1e-15 * forces.norm());
  EXPECT_TRUE(kept->converged);
  // What it says of the contacts is what their forces and motions are.
  for (std::size_t k = 0; k < kept->modes.size(); ++k) {
    if (forces(3 * static_cast<Eigen::Index>(k) + 2) > 0) {
      EXPECT_NE(kept->modes[k], ContactMode::open);
    }
  }
}

TEST_P(MotionStart, NearbyForcesLeadToThoseOfTheProblem) {
  MotionProblem problem = heaps::problem_of(GetParam());
  const VecX forces = forces_of(problem);
  // Bodies move by a ten-thousandth of their speeds otherwise.
  test::Random random(7);
  VecX change(6 * static_cast<Eigen::Index>(problem.rows.node_count()));
  for (double& value : change) value = random.uniform(-1, 1);
  problem.laws.b += 1e-5 * problem.laws.b.cwiseAbs().maxCoeff() * contact_rates(problem.rows, change);
  ASSERT_GT(heaps::residual_of(problem, forces), 1e-9);
  const std::optional<CoulombSolution> found = solve_from_forces(problem, forces, step_options());
  ASSERT_TRUE(found.has_value());
  EXPECT_GT(found->iterations, 0);
  EXPECT_LE(found->residual, 1e-10);
  EXPECT_LE(heaps::residual_of(problem, found->lambda), 1e-10);
}

TEST_P(MotionStart, ForcesFarFromTheProblemAreLeft) {
  const MotionProblem problem = heaps::problem_of(GetParam());
  const VecX forces = forces_of(problem);
  EXPECT_FALSE(solve_from_forces(problem, 2 * forces, step_options()).has_value());
  EXPECT_FALSE(solve_from_forces(problem, 0 * forces, step_options()).has_value());
  // Those that are a rounding off hold, and are found anew.
  const double slope = heaps::residual_of(problem, (1 + 1e-6) * forces) / 1e-6;
  EXPECT_FALSE(solve_from_forces(problem, (1 + 1e-12 / slope) * forces, step_options()).has_value());
}

INSTANTIATE_TEST_SUITE_P(Heaps, MotionStart,
                         testing::Values(heaps::Heap{heaps::Kind::wall, 5, 0, 1},
                                         heaps::Heap{heaps::Kind::pyramid, 4, 0, 2},
                                         heaps::Heap{heaps::Kind::pyramid, 5, 0, 3},
                                         heaps::Heap{heaps::Kind::wall, 4, 0.3, 4}));

}  // namespace
}  // namespace rigor::motion_start_test
