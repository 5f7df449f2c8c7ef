#include "rigor/solver/linear/lcp.hpp"

#include "solver/reference_data.hpp"

#include <gtest/gtest.h>

#include <random>

namespace rigor::lcp_test {
namespace {

using Solver = LcpSolution (*)(const MatX&, const VecX&);

class Lcp : public testing::TestWithParam<Solver> {};

INSTANTIATE_TEST_SUITE_P(Solvers, Lcp, testing::Values(&lcp_dantzig, &lcp_lemke),
                         [](const auto& test) { return test.index == 0 ? "Dantzig" : "Lemke"; });

MatX random_matrix(Eigen::Index rows, Eigen::Index cols, std::mt19937_64& generator) {
  std::normal_distribution<double> normal;
  MatX J(rows, cols);
  for (double& x : J.reshaped()) x = normal(generator);
  return J;
}

// Rational reference solutions: accelerations and w are unique, λ is where the matrix is regular.
TEST_P(Lcp, GivesTheReferenceAccelerations) {
  for (const nlohmann::json file = reference::read("lcp.json");
       const nlohmann::json& reference : file["cases"]) {
    SCOPED_TRACE(reference["name"]);
    const MatX J = reference::matrix(reference["J"]);
    const VecX inverse_mass = reference::vector(reference["M"]).cwiseInverse();
    const VecX a0 = reference::vector(reference["a0"]);
    const MatX A = J * inverse_mass.asDiagonal() * J.transpose();
    const LcpSolution solution = GetParam()(A, J * a0 - reference::vector(reference["c"]));
    ASSERT_TRUE(solution.converged);
    EXPECT_GE(solution.z.minCoeff(), 0.0);
    const VecX acceleration = a0 + inverse_mass.asDiagonal() * (J.transpose() * solution.z);
    const VecX expected = reference::vector(reference["acceleration"]);
    const double size = a0.cwiseAbs().maxCoeff() + expected.cwiseAbs().maxCoeff();
    EXPECT_LT((acceleration - expected).cwiseAbs().maxCoeff(), 1e-12 * size);
    EXPECT_LT((solution.w - reference::vector(reference["w"])).cwiseAbs().maxCoeff(),
              1e-12 * solution.w.cwiseAbs().maxCoeff() + 1e-12 * size);
    if (!reference["lambda_unique"].get<bool>()) continue;
    const VecX lambda = reference::vector(reference["lambda"]);
    EXPECT_LE((solution.z - lambda).cwiseAbs().maxCoeff(), 1e-12 * lambda.cwiseAbs().maxCoeff());
  }
}

// A tower of n unit masses: contact k carries all masses above it, (n - k) g.
TEST_P(Lcp, ATowerCarriesItsWeight) {
  const int n = 30;
  const double g = 9.81;
  MatX J = MatX::Zero(n, n);
  for (int k = 0; k < n; ++k) {
    J(k, k) = 1;
    if (k > 0) J(k, k - 1) = -1;
  }
  const LcpSolution solution = GetParam()(J * J.transpose(), J * VecX::Constant(n, -g));
  ASSERT_TRUE(solution.converged);
  for (int k = 0; k < n; ++k) EXPECT_NEAR(solution.z(k), (n - k) * g, 1e-11 * n * g);  // condition n²
}

TEST_P(Lcp, RedundantContactsGiveTheUniqueMotion) {
  std::mt19937_64 generator(11);
  for (int trial = 0; trial < 60; ++trial) {
    const MatX J = random_matrix(20, 6, generator).cwiseAbs();
    const VecX a0 = random_matrix(6, 1, generator) - VecX::Constant(6, 0.5);
    const LcpSolution solution = GetParam()(J * J.transpose(), J * a0);
    ASSERT_TRUE(solution.converged) << trial << " " << solution.residual;
    // KKT of the projection: a - a0 = Jᵀλ, and every other feasible a is farther: checked by complementarity.
    const VecX a = a0 + J.transpose() * solution.z;
    EXPECT_NEAR(solution.z.dot(J * a), 0.0, 1e-11 * (1 + solution.z.cwiseAbs().sum()));
  }
}

TEST_P(Lcp, ScalesExactlyByPowersOfTwo) {
  std::mt19937_64 generator(4);
  const MatX J = random_matrix(8, 12, generator);
  const MatX M = J * J.transpose();
  const VecX q = random_matrix(8, 1, generator);
  const LcpSolution one = GetParam()(M, q);
  const LcpSolution other = GetParam()(std::ldexp(1.0, 30) * M, std::ldexp(1.0, -21) * q);
  EXPECT_EQ(other.z, std::ldexp(1.0, -51) * one.z);
}

TEST_P(Lcp, AMotionlessContactThatMustPushHasNoSolution) {
  // Two opposite walls squeeze a body: w1 = z1 - z2 - 1, w2 = z2 - z1 - 1, w1 + w2 = -2.
  MatX M(2, 2);
  M << 1, -1, -1, 1;
  const LcpSolution solution = GetParam()(M, VecX::Constant(2, -1.0));
  EXPECT_FALSE(solution.converged);
  EXPECT_GT(solution.residual, 0.1);
}

TEST_P(Lcp, AnEmptyProblemIsSolved) {
  EXPECT_TRUE(GetParam()(MatX(0, 0), VecX(0)).converged);
}

TEST(LcpLemke, SolvesUnsymmetricProblemsWithPositiveDefinitePart) {
  std::mt19937_64 generator(8);
  for (int trial = 0; trial < 60; ++trial) {
    const MatX J = random_matrix(15, 20, generator);
    const MatX S = random_matrix(15, 15, generator);
    const LcpSolution solution =
        lcp_lemke(J * J.transpose() + 2 * (S - S.transpose()), random_matrix(15, 1, generator));
    EXPECT_TRUE(solution.converged) << trial << " " << solution.residual;
  }
}

TEST(LcpLemke, APainleveProblemWithoutSolutionIsReported) {
  // One slipping contact with A_nn - μ A_nt < 0 that sinks: no λ ≥ 0 can stop it.
  EXPECT_FALSE(lcp_lemke(MatX::Constant(1, 1, -0.5), VecX::Constant(1, -1.0)).converged);
  EXPECT_TRUE(lcp_lemke(MatX::Constant(1, 1, -0.5), VecX::Constant(1, 1.0)).converged);
}

}  // namespace
}  // namespace rigor::lcp_test
