#include "rigor/solver/coulomb/proximal_points.hpp"
#include "rigor/solver/coulomb/coulomb_problem.hpp"
#include "rigor/solver/coulomb/smooth_modes.hpp"

#include "random_vectors.hpp"
#include "solver/reference_data.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace rigor::proximal_points_test {
namespace {

using Eigen::Index;

constexpr double kSolved = 1e-10;

CoulombProblem problem_of(const MatX& A, const VecX& b, const std::vector<double>& mu) {
  return {A, b, mu, std::vector<FrictionRow>(mu.size(), FrictionRow::cone),
          std::vector<Vec2>(mu.size(), Vec2::Zero())};
}

std::optional<CoulombSolution> solve(const CoulombProblem& problem, double resolution,
                                     const VecX& start = VecX()) {
  return solve_by_proximal_points(problem, FactoredMotion(problem.A),
                                  [&](const VecX& lambda) { return largest_term(problem, lambda); },
                                  {.resolution = resolution, .start = start});
}

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
  CoulombProblem problem = problem_of(J * inverse_mass * J.transpose(), J * V, std::vector<double>(4, 0.5));
  problem.b[3] += error;
  return problem;
}

/// Hard contact problems of steps of random piles (tests/data).
struct HardProblem {
  std::string name;
  CoulombProblem problem;
  double resolution;
};

std::vector<HardProblem> hard_problems() {
  std::vector<HardProblem> problems;
  for (const auto& record : reference::read("hard_contacts.json")["problems"]) {
    const VecX b = reference::vector(record["b"]), lower = reference::vector(record["A"]);
    MatX A(b.size(), b.size());
    for (Index row = 0, entry = 0; row < b.size(); ++row)
      for (Index column = 0; column <= row; ++column) A(row, column) = A(column, row) = lower[entry++];
    problems.push_back(
        {record["name"], problem_of(A, b, record["mu"].get<std::vector<double>>()), record["resolution"]});
  }
  return problems;
}

/// How far forces are from the law of the problem with the b nearest to its own, within the resolution, for
/// which its sticking contacts stand still: what contradictions leave is in the range that A cannot reach.
double largest_miss(const HardProblem& hard, const CoulombSolution& solution) {
  const VecX w = hard.problem.A * solution.lambda + hard.problem.b;
  double worst = 0;
  for (std::size_t k = 0; k < hard.problem.mu.size(); ++k) {
    const Index row = 3 * static_cast<Index>(k);
    const Vec3 force = solution.lambda.segment<3>(row), motion = w.segment<3>(row);
    const double mu = hard.problem.mu[k], friction = force.head<2>().norm();
    EXPECT_GE(force.z(), 0);
    EXPECT_LE(friction, mu * force.z() * (1 + 1e-12));
    worst = std::max(worst, -motion.z());
    if (force.z() == 0) continue;
    worst = std::max(worst, motion.z());
    // Friction below its bound: no slip. At its bound: none across it, none along with it.
    const Vec2 along = friction > 0 ? Vec2(force.head<2>() / friction) : Vec2::Zero();
    const Vec2 across(-along.y(), along.x());
    const bool slides = friction > (1 - 1e-9) * mu * force.z();
    worst =
        std::max(worst, slides ? std::max(std::abs(across.dot(motion.head<2>())), along.dot(motion.head<2>()))
                               : motion.head<2>().norm());
  }
  return worst;
}

TEST(ProximalPoints, SolveHardContacts) {
  for (const HardProblem& hard : hard_problems()) {
    const std::optional<CoulombSolution> solution = solve(hard.problem, hard.resolution);
    ASSERT_TRUE(solution) << hard.name;
    EXPECT_LE(solution->residual, kSolved) << hard.name;
    EXPECT_LE(largest_miss(hard, *solution), hard.resolution) << hard.name;
    EXPECT_LT(solution->iterations, 30) << hard.name;
  }
}

/// A random tower of blocks, each on the four corners of the next, thrown over a step: corners stick, slide
/// and open, and blocks rest on more points than they need.
CoulombProblem random_tower(test::Random& random) {
  const int count = 1 + static_cast<int>(random.uniform(0, 5.99));
  MatX J = MatX::Zero(12 * count, 6 * count), inverse_mass = MatX::Zero(6 * count, 6 * count);
  VecX V(6 * count);
  std::vector<double> mu;
  for (int body = 0; body < count; ++body) {
    const double mass = std::pow(10, random.uniform(-1, 1));
    const Vec3 half(random.uniform(0.2, 1), random.uniform(0.2, 1), random.uniform(0.1, 0.5));
    const Vec3 squares = half.cwiseProduct(half);
    inverse_mass.diagonal().segment<3>(6 * body).setConstant(1 / mass);
    inverse_mass.diagonal().segment<3>(6 * body + 3) =
        (mass / 3 * (Vec3::Constant(squares.sum()) - squares)).cwiseInverse();
    V.segment<3>(6 * body) = 0.05 * random.vector() - Vec3(0, 0, 0.05);
    V.segment<3>(6 * body + 3) = 0.05 * random.vector();
    for (int i = 0; i < 4; ++i) {
      const int row = 12 * body + 3 * i;
      const auto moved_by = [&](const Vec3& p) {
        Eigen::Matrix<double, 3, 6> rates;
        rates << Mat3::Identity(), Mat3{{0, p.z(), -p.y()}, {-p.z(), 0, p.x()}, {p.y(), -p.x(), 0}};
        return rates;
      };
      const Vec3 p(i & 1 ? half.x() : -half.x(), i & 2 ? half.y() : -half.y(), -half.z());
      J.block<3, 6>(row, 6 * body) = moved_by(p);
      if (body > 0) J.block<3, 6>(row, 6 * (body - 1)) = -moved_by({p.x(), p.y(), random.uniform(0.1, 0.5)});
      mu.push_back(random.uniform(0, 1));
    }
  }
  return problem_of(J * inverse_mass * J.transpose(), J * V, mu);
}

TEST(ProximalPoints, BoldlyReachTheLawToo) {
  // Steps of a scheme search boldly: full Newton steps, over kinks, with the matrix of the step before.
  test::Random random(20261126);
  int solved = 0;
  for (int k = 0; k < 80; ++k) {
    const HardProblem tower{"tower " + std::to_string(k), random_tower(random), 1e-9};
    const std::optional<CoulombSolution> solution =
        solve_by_proximal_points(tower.problem, FactoredMotion(tower.problem.A),
                                 [&](const VecX& lambda) { return largest_term(tower.problem, lambda); },
                                 {.resolution = tower.resolution, .is_bold = true});
    if (!solution) continue;
    ++solved;
    EXPECT_LE(solution->residual, kSolved) << tower.name;
    EXPECT_LE(largest_miss(tower, *solution), tower.resolution) << tower.name;
  }
  EXPECT_EQ(solved, 80);
}

TEST(ProximalPoints, AreTriedByTheChainWhereAResolutionIsGiven) {
  for (const HardProblem& hard : hard_problems()) {
    CoulombOptions options;
    options.enough = kSolved;
    options.least_norm = false;
    options.resolution = hard.resolution;
    const CoulombSolution solution = solve_coulomb(hard.problem, options);
    EXPECT_EQ(solution.method, "proximal points") << hard.name;
    // In other units: multiplied by powers of two the digits stay.
    HardProblem scaled = hard;
    scaled.problem.A *= 8;
    scaled.problem.b *= 0.25;
    options.resolution = 0.25 * hard.resolution;
    const CoulombSolution same = solve_coulomb(scaled.problem, options);
    EXPECT_EQ(same.lambda, solution.lambda / 32) << hard.name;
  }
}

TEST(ProximalPoints, ContactsThatContradictEachOtherByLessThanTheResolutionHoldTogether) {
  const double error = 1e-9;
  const CoulombProblem problem = block_on_its_corners(error);
  const std::optional<CoulombSolution> solution = solve(problem, 1e-6);
  ASSERT_TRUE(solution);
  EXPECT_LE(solution->residual, kSolved);
  // What is left of the rates is no more than the error that was put in, and the forces carry the weight.
  EXPECT_LE(solution->w.cwiseAbs().maxCoeff(), error);
  double weight = 0;
  for (Index row = 2; row < 12; row += 3) weight += solution->lambda[row];
  EXPECT_NEAR(weight, 0.02, 2 * error);
}

TEST(ProximalPoints, WithoutAResolutionTheLawItselfHoldsOrNothingComesBack) {
  const CoulombProblem problem = block_on_its_corners(1e-6);
  const std::optional<CoulombSolution> solution = solve(problem, 0);
  if (solution) {
    EXPECT_LE(coulomb_residual(problem, solution->lambda, solution->w), kSolved);
  }
  // With one that is finer than the contradiction contacts must slip: the law is missed by no more than it.
  const double fine = 1e-9;
  const std::optional<CoulombSolution> slipping = solve(problem, fine);
  if (slipping) {
    const double miss = coulomb_residual(problem, slipping->lambda, slipping->w);
    EXPECT_LE(miss * largest_term(problem, slipping->lambda), 2 * fine);
  }
}

TEST(ProximalPoints, FromItsOwnForcesThereIsLittleToDo) {
  const CoulombProblem problem = block_on_its_corners(0);
  const std::optional<CoulombSolution> cold = solve(problem, 0);
  ASSERT_TRUE(cold);
  const std::optional<CoulombSolution> warm = solve(problem, 0, cold->lambda);
  ASSERT_TRUE(warm);
  EXPECT_EQ(warm->iterations, 1);
}

}  // namespace
}  // namespace rigor::proximal_points_test
