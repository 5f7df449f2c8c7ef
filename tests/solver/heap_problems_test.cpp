#include "solver/heap_problems.hpp"

#include "rigor/solver/coulomb/proximal_points.hpp"
#include "rigor/solver/motion/motion_problem.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace rigor::heaps {
namespace {

constexpr double kSolved = 1e-12;

/// As steps of time stepping are solved: of many contacts from the interior of their cones, boldly.
CoulombSolution solve_as_steps_do(const MotionProblem& problem) {
  CoulombOptions options;
  options.least_norm = false;
  options.tolerance = options.enough = kSolved;
  options.resolution = 0;
  options.is_bold = true;
  const std::optional<CoulombSolution> solution = solve_in_motion_space(problem, {}, options);
  return solution ? *solution
                  : CoulombSolution{VecX::Zero(problem.laws.b.size()), {}, {}, 1, 0, false, "none"};
}

/// By proximal points with the motion alone as the unknown, from no forces.
CoulombSolution solve_by_motion(const MotionProblem& problem) {
  const SparseMotion motion(problem.rows);
  const auto largest = [&](const VecX& lambda) {
    return std::max(problem.laws.b.cwiseAbs().maxCoeff(), largest_term(problem.rows, lambda));
  };
  return solve_by_proximal_points(problem.laws, motion, largest, {.enough = kSolved, .gives_best = true})
      .value();
}

/// Which no method solves to 1e-12 yet.
bool is_open(const Heap& heap) {
  return (heap.kind == Kind::balls && heap.layers == 5 && heap.blow == 0) ||
         (heap.kind == Kind::pyramid && heap.layers == 5 && heap.blow == 0.1) ||
         (heap.kind == Kind::wall && heap.layers == 16 && heap.blow > 0);
}

void expect_solved(const Heap& heap) {
  const MotionProblem problem = problem_of(heap);
  for (const CoulombSolution& solution : {solve_as_steps_do(problem), solve_by_motion(problem)}) {
    // What a solution says of itself is what the rows say of it.
    const double residual = residual_of(problem, solution.lambda);
    EXPECT_NEAR(residual, solution.residual, 1e-14 + 1e-6 * residual);
    for (std::size_t k = 0; k < problem.laws.mu.size(); ++k) {
      const Vec3 force = solution.lambda.segment<3>(3 * static_cast<Eigen::Index>(k));
      EXPECT_LE(force.head<2>().norm(), problem.laws.mu[k] * force.z() * (1 + 1e-15));
    }
    if (is_open(heap)) {
      EXPECT_LE(residual, 1e-4);
    } else {
      EXPECT_LE(residual, kSolved) << solution.method;
    }
  }
}

class HeapProblems : public testing::TestWithParam<Heap> {};

TEST_P(HeapProblems, AreSolvedByTwoMethods) {
  expect_solved(GetParam());
}

INSTANTIATE_TEST_SUITE_P(All, HeapProblems, testing::ValuesIn(all_heaps()), [](const auto& tested) {
  std::string name = name_of(tested.param);
  std::erase_if(name, [](char c) { return c == ' ' || c == '.'; });
  return name;
});

TEST(HeapProblem, HasTheContactsThatItsRulesSay) {
  ASSERT_EQ(all_heaps().size(), 60);
  // Two bricks on the floor; one of the two above lies on both, the other on one.
  EXPECT_EQ(problem_of({Kind::wall, 2, 0, 1}).laws.mu.size(), 4 * (2 + 3));
  // Four bricks on the floor, one on all of them.
  EXPECT_EQ(problem_of({Kind::pyramid, 2, 0, 1}).laws.mu.size(), 4 * (4 + 4));
  // Four balls on the floor, one in their pocket.
  const MotionProblem balls = problem_of({Kind::balls, 2, 0, 1});
  EXPECT_EQ(balls.laws.mu.size(), 4 + 4);
  // Weight closes contacts with the floor, and none between bodies that fall alike.
  int closing = 0;
  for (Eigen::Index row = 2; row < balls.laws.b.size(); row += 3) {
    const bool closes = std::abs(balls.laws.b(row) + 0.0981) < 1e-14;
    closing += closes;
    EXPECT_TRUE(closes || std::abs(balls.laws.b(row)) < 1e-14);
  }
  EXPECT_EQ(closing, 4);
}

/// Without rows and without a resolution, by A alone; the chain of methods for few contacts is not for so
/// many.
TEST(HeapProblem, OfManyContactsIsSolvedInContactSpace) {
  const MotionProblem rows = problem_of({Kind::wall, 6, 0.1, 5});
  CoulombProblem problem = rows.laws;
  problem.A = contact_response(rows.rows);
  ASSERT_GE(problem.mu.size(), 200);
  const CoulombSolution solution = solve_coulomb(problem);
  EXPECT_TRUE(solution.converged);
  EXPECT_LE(residual_of(rows, solution.lambda), kSolved);
  EXPECT_EQ(solution.method, "proximal points");
}

}  // namespace
}  // namespace rigor::heaps
