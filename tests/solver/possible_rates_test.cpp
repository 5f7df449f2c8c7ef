#include "rigor/solver/possible_rates.hpp"

#include <gtest/gtest.h>

namespace rigor::possible_rates_test {
namespace {

/// A block of mass 1 that lies on its four lower corners (half sides 1, 0.5, 0.2), pressed by its weight over
/// a step; the corners' rates are those of a rigid motion but for `error` at one of them.
CoulombProblem block_on_its_corners(double error) {
  const Vec3 half(1, 0.5, 0.2);
  Mat6 inverse_mass = Mat6::Identity();
  inverse_mass.bottomRightCorner<3, 3>() = Vec3(3, 2, 1).asDiagonal();
  MatX J(12, 6);
  for (int i = 0; i < 4; ++i) {
    const Vec3 p(i & 1 ? half.x() : -half.x(), i & 2 ? half.y() : -half.y(), -half.z());
    Mat3 cross;
    cross << 0, -p.z(), p.y(), p.z(), 0, -p.x(), -p.y(), p.x(), 0;
    J.middleRows<3>(3 * i) << Mat3::Identity(), -cross;
  }
  Vec6 V;
  V << 0.001, 0, -0.02, 0.001, 0, 0;
  CoulombProblem problem{J * inverse_mass * J.transpose(), J * V, std::vector<double>(4, 0.5),
                         std::vector<FrictionRow>(4, FrictionRow::cone), std::vector<Vec2>(4, Vec2::Zero())};
  problem.b[3] += error;
  return problem;
}

TEST(PossibleRates, ContactsThatContradictEachOtherByLessThanTheLimitHoldTogether) {
  const double error = 1e-9, limit = 1e-6;
  const CoulombProblem problem = block_on_its_corners(error);
  const CoulombSolution solution = solve_coulomb(problem);
  const std::optional<CoulombProblem> possible = with_possible_rates(problem, solution, limit);
  ASSERT_TRUE(possible);
  EXPECT_LE((possible->b - problem.b).cwiseAbs().maxCoeff(), error);
  // A motion that the block can have: b is in the range of A.
  const CoulombSolution held = solve_coulomb(*possible);
  EXPECT_LE(held.residual, 1e-12);
  EXPECT_LE(held.w.cwiseAbs().maxCoeff(), 1e-12);
  // Once they agree there is nothing to change.
  const std::optional<CoulombProblem> again = with_possible_rates(*possible, held, limit);
  if (again) {
    EXPECT_LE((again->b - possible->b).cwiseAbs().maxCoeff(), 1e-16);
  }
}

TEST(PossibleRates, NoRateChangesByMoreThanTheLimit) {
  const double error = 1e-9, limit = 1e-11;
  const CoulombProblem problem = block_on_its_corners(error);
  const std::optional<CoulombProblem> possible = with_possible_rates(problem, solve_coulomb(problem), limit);
  if (possible) {
    EXPECT_LE((possible->b - problem.b).cwiseAbs().maxCoeff(), limit);
  }
  EXPECT_FALSE(with_possible_rates(problem, solve_coulomb(problem), 0));
}

TEST(PossibleRates, ContactsThatOpenAreLeftAsTheyAre) {
  CoulombProblem problem = block_on_its_corners(0);
  for (Eigen::Index row = 2; row < 12; row += 3) problem.b[row] = 0.02;
  problem.b[0] += 1e-9;
  EXPECT_FALSE(with_possible_rates(problem, solve_coulomb(problem), 1e-6));
}

}  // namespace
}  // namespace rigor::possible_rates_test
