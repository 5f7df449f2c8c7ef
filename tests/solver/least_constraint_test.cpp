#include "rigor/solver/motion/least_constraint.hpp"

#include "rigor/solver/linear/lcp.hpp"
#include "solver/reference_data.hpp"

#include <gtest/gtest.h>

#include <random>

namespace rigor::least_constraint_test {
namespace {

MatX random_matrix(Eigen::Index rows, Eigen::Index cols, std::mt19937_64& generator) {
  std::normal_distribution<double> normal;
  MatX J(rows, cols);
  for (double& x : J.reshaped()) x = normal(generator);
  return J;
}

void expect_solved(const LeastConstraintProblem& problem, const LeastConstraintSolution& solution) {
  EXPECT_TRUE(solution.converged) << solution.residual;
  const VecX slack = problem.G * solution.y - problem.d;
  const double size = problem.d.cwiseAbs().maxCoeff() + solution.y.norm() * problem.G.norm();
  EXPECT_LT((solution.y - problem.G.transpose() * solution.lambda).norm(), 1e-12 * size * problem.G.norm());
  for (Eigen::Index i = 0; i < slack.size(); ++i) {
    if (i < problem.equalities) {
      EXPECT_NEAR(slack[i], 0, 1e-12 * size);
      continue;
    }
    EXPECT_GE(slack[i], -1e-12 * size);
    EXPECT_GE(solution.lambda[i], -1e-12 * solution.lambda.cwiseAbs().maxCoeff());
    if (solution.lambda[i] > 0) {
      EXPECT_NEAR(slack[i], 0, 1e-11 * size) << i;
    }
  }
}

TEST(LeastConstraint, GivesTheReferenceAccelerationsWithoutTheContactMatrix) {
  const nlohmann::json file = reference::read("lcp.json");
  for (const nlohmann::json& json : file["cases"]) {
    SCOPED_TRACE(json["name"].get<std::string>());
    const VecX root = reference::vector(json["M"]).cwiseSqrt(), a0 = reference::vector(json["a0"]);
    const MatX J = reference::matrix(json["J"]);
    const LeastConstraintProblem problem{J * root.cwiseInverse().asDiagonal(),
                                         reference::vector(json["c"]) - J * a0, 0};
    const LeastConstraintSolution solution = solve_least_constraint(problem);
    expect_solved(problem, solution);
    const VecX a = a0 + solution.y.cwiseQuotient(root), expected = reference::vector(json["acceleration"]);
    const double size = a0.cwiseAbs().maxCoeff() + expected.cwiseAbs().maxCoeff();
    EXPECT_LT((a - expected).cwiseAbs().maxCoeff(), 1e-12 * size);
    if (!json["lambda_unique"].get<bool>()) continue;
    const VecX lambda = reference::vector(json["lambda"]);
    EXPECT_LT((solution.lambda - lambda).cwiseAbs().maxCoeff(), 1e-12 * (1 + lambda.cwiseAbs().maxCoeff()));
  }
}

TEST(LeastConstraint, AgreesWithContactSpaceOnRandomAndRedundantRows) {
  std::mt19937_64 generator(7);
  for (int trial = 0; trial < 200; ++trial) {
    const Eigen::Index n = 2 + trial % 12, m = 1 + trial % 25;
    MatX G = random_matrix(m, n, generator);
    if (trial % 3 == 0)
      G.bottomRows(m / 2) = random_matrix(m / 2, m - m / 2, generator) * G.topRows(m - m / 2);
    // Something satisfies all rows: d = G x - slack.
    const VecX d = G * random_matrix(n, 1, generator) - random_matrix(m, 1, generator).cwiseAbs();
    const LeastConstraintProblem problem{G, d, 0};
    const LeastConstraintSolution solution = solve_least_constraint(problem);
    expect_solved(problem, solution);
    const LcpSolution contact_space = lcp_dantzig(G * G.transpose(), -d);
    if (!contact_space.converged) continue;
    EXPECT_LT((G.transpose() * contact_space.z - solution.y).norm(), 1e-10 * (1 + solution.y.norm()))
        << trial;
    // Started from its own rows: the same, in as many steps as there are rows.
    const LeastConstraintSolution again = solve_least_constraint(problem, solution.active);
    EXPECT_LT((again.y - solution.y).norm(), 1e-11 * (1 + solution.y.norm()));
    EXPECT_LE(again.iterations, solution.iterations);
  }
}

TEST(LeastConstraint, HoldsEquationsWhateverTheSignOfTheirForces) {
  std::mt19937_64 generator(11);
  for (int trial = 0; trial < 100; ++trial) {
    const Eigen::Index n = 8, m = 6;
    const MatX G = random_matrix(m, n, generator);
    const VecX d = random_matrix(m, 1, generator);
    const LeastConstraintProblem problem{G, d, 3};
    expect_solved(problem, solve_least_constraint(problem));
    // All rows as equations: the least norm solution.
    const LeastConstraintSolution all = solve_least_constraint({G, d, m});
    const VecX expected = G.completeOrthogonalDecomposition().solve(d);
    EXPECT_LT((all.y - expected).norm(), 1e-12 * (1 + expected.norm()));
  }
}

TEST(LeastConstraint, LeavesOutRedundantEquationsAndTellsContradictions) {
  MatX G(3, 2);
  G << 1, 0, 0, 1, 1, 1;
  const LeastConstraintSolution redundant = solve_least_constraint({G, Vec3(1, 2, 3), 3});
  EXPECT_TRUE(redundant.converged);
  EXPECT_LT((redundant.y - Vec2(1, 2)).norm(), 1e-15);
  EXPECT_EQ(redundant.active.size(), 2u);
  const LeastConstraintSolution contradiction = solve_least_constraint({G, Vec3(1, 2, 4), 3});
  EXPECT_FALSE(contradiction.converged);
  EXPECT_GT(contradiction.residual, 0.1);
  // x ≥ 1 and -x ≥ 1.
  MatX H(2, 1);
  H << 1, -1;
  EXPECT_FALSE(solve_least_constraint({H, Vec2(1, 1), 0}).converged);
}

TEST(LeastConstraint, WithoutViolationDoesNothing) {
  const LeastConstraintSolution solution = solve_least_constraint({MatX::Identity(3, 3), -Vec3::Ones(), 0});
  EXPECT_TRUE(solution.converged);
  EXPECT_TRUE(solution.y.isZero(0));
  EXPECT_TRUE(solution.active.empty());
}

// The condition of the two formulations, as the course has it: rows that nearly coincide cost contact space
// twice the digits.
TEST(LeastConstraint, KeepsDigitsThatContactSpaceLoses) {
  const double close = 1e-7;
  MatX G(2, 2);
  G << 1, 0, 1, close;
  // y = (1, 1) holds both rows with equality; both forces are positive.
  const VecX y = Vec2(1, 1e-9), d = G * y;
  const LeastConstraintSolution solution = solve_least_constraint({G, d, 2});
  EXPECT_LT((solution.y - y).norm(), 1e-15 / close);
}

}  // namespace
}  // namespace rigor::least_constraint_test
