#include "rigor/solver/coulomb/static_friction.hpp"

#include <gtest/gtest.h>

namespace rigor::static_friction_test {
namespace {

/// Points of mass 1 on a floor, side by side; b_t of each as given, b_n = -1 (so λ_n = 1).
struct Points {
  std::vector<double> pulls;
  CoulombSolution operator()(const std::vector<double>& mu) const {
    const Eigen::Index n = static_cast<Eigen::Index>(pulls.size());
    CoulombProblem problem{MatX::Identity(3 * n, 3 * n), VecX::Zero(3 * n), mu,
                           std::vector<FrictionRow>(pulls.size(), FrictionRow::cone),
                           std::vector<Vec2>(pulls.size(), Vec2::UnitX())};
    for (Eigen::Index i = 0; i < n; ++i) {
      problem.b(3 * i) = pulls[static_cast<std::size_t>(i)];
      problem.b(3 * i + 2) = -1;
    }
    return solve_coulomb(problem);
  }
};

TEST(StaticFriction, WhatWasStillHoldsUpToTheStaticCoefficientAndWhatSlippedDoesNot) {
  // Pulled with 0.4 between μ = 0.3 and μ_s = 0.5.
  const StaticFriction friction{{0.3, 0.3}, {0.5, 0.5}, {true, false}};
  const StaticFrictionSolution s = solve_static_friction(friction, Points{{0.4, 0.4}});
  EXPECT_EQ(s.rounds, 1);
  EXPECT_EQ(s.solution.modes[0], ContactMode::stick);
  EXPECT_NEAR(s.solution.lambda(0), -0.4, 1e-15);
  EXPECT_EQ(s.solution.modes[1], ContactMode::slide);
  EXPECT_NEAR(s.solution.lambda(3), -0.3, 1e-15);
}

TEST(StaticFriction, WhatBreaksLooseIsBrakedWithTheCoefficientOfSliding) {
  const StaticFriction friction{{0.3}, {0.5}, {true}};
  const StaticFrictionSolution s = solve_static_friction(friction, Points{{0.6}});
  EXPECT_EQ(s.rounds, 2);
  EXPECT_EQ(s.mu, std::vector<double>({0.3}));
  EXPECT_NEAR(s.solution.lambda(0), -0.3, 1e-15);
  EXPECT_NEAR(s.solution.w(0), 0.3, 1e-15);
}

TEST(StaticFriction, WhatSlipsComesToRestWithTheCoefficientOfSliding) {
  const StaticFriction friction{{0.3}, {0.5}, {false}};
  const StaticFrictionSolution s = solve_static_friction(friction, Points{{0.25}});
  EXPECT_EQ(s.solution.modes[0], ContactMode::stick);
  EXPECT_EQ(s.mu, std::vector<double>({0.3}));
}

// Two points of one body, mass 1, pulled with 0.9: they share the load 1 each. Static friction holds 0.5 +
// 0.3 = 0.8; the one that breaks loose leaves the other alone, which breaks loose too.
TEST(StaticFriction, OneThatBreaksLooseTakesOthersWithIt) {
  const auto solve = [](const std::vector<double>& mu) {
    CoulombProblem problem;
    problem.A = MatX::Zero(6, 6);
    for (const Eigen::Index i : {0, 3})
      for (const Eigen::Index j : {0, 3}) problem.A(i, j) = 1;
    // The second tangent and the normals belong to each alone.
    for (const Eigen::Index i : {1, 2, 4, 5}) problem.A(i, i) = 1;
    problem.b = VecX::Zero(6);
    problem.b(0) = problem.b(3) = 0.9;
    problem.b(2) = problem.b(5) = -1;
    problem.mu = mu;
    problem.rows.assign(2, FrictionRow::cone);
    problem.slips.assign(2, Vec2::UnitX());
    return solve_coulomb(problem);
  };
  const StaticFrictionSolution loose = solve_static_friction({{0.2, 0.2}, {0.5, 0.3}, {true, true}}, solve);
  EXPECT_TRUE(loose.solution.converged);
  EXPECT_NEAR(loose.solution.w(0), 0.5, 1e-14);
  EXPECT_EQ(loose.mu, std::vector<double>({0.2, 0.2}));
  const StaticFrictionSolution held = solve_static_friction({{0.2, 0.2}, {0.6, 0.4}, {true, true}}, solve);
  EXPECT_NEAR(held.solution.w(0), 0, 1e-14);
  EXPECT_EQ(held.mu, std::vector<double>({0.6, 0.4}));
}

}  // namespace
}  // namespace rigor::static_friction_test
