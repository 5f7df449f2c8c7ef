#include "rigor/solver/coulomb/coulomb_local.hpp"

#include "rigor/solver/coulomb/cone.hpp"
#include "solver/reference_data.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace rigor::coulomb_local_test {
namespace {

ContactMode mode_named(const std::string& name) {
  return name == "open" ? ContactMode::open : name == "stick" ? ContactMode::stick : ContactMode::slide;
}

// Coulomb's law, written out by mode, relative to the largest term.
double broken_law(const Mat3& K, const Vec3& b, double mu, const LocalCoulombSolution& s) {
  const Vec3 w = K * s.lambda + b;
  const double size = std::max(b.cwiseAbs().maxCoeff(), (K.cwiseAbs() * s.lambda.cwiseAbs()).maxCoeff());
  const double force = s.lambda.norm();
  const double friction = s.lambda.head<2>().norm();
  double error = (w - s.w).norm() / size;
  if (s.mode == ContactMode::open) return std::max({error, force, -w(2)});
  if (s.mode == ContactMode::stick)
    return std::max({error, w.norm() / size, (friction - mu * s.lambda(2)) / force});
  const Vec2 slip = w.head<2>() / w.head<2>().norm();
  const double opposes = (s.lambda.head<2>() + mu * s.lambda(2) * slip).norm() / force;
  // The direction of a slow slip is known to the round-off of w over the speed.
  return std::max({error, std::abs(w(2)) / size, opposes * std::min(1.0, w.head<2>().norm() / size)});
}

struct RandomContact {
  Mat3 K;
  Vec3 b;
  double mu;
};

RandomContact random_contact(std::mt19937_64& generator) {
  std::normal_distribution<double> normal;
  Eigen::Matrix<double, 3, 6> J;
  for (double& x : J.reshaped()) x = normal(generator);
  const Vec3 b(normal(generator), normal(generator), normal(generator));
  return {J * J.transpose(), b, std::exp(1.5 * normal(generator))};
}

// Reference problems with all their solutions to 20 digits.
TEST(CoulombLocal, FindsAllSolutionsOfTheReferenceProblems) {
  for (const nlohmann::json file = reference::read("ncp.json");
       const nlohmann::json& reference : file["cases"]) {
    SCOPED_TRACE(reference["name"]);
    const Mat3 K = reference::matrix(reference["K"]);
    const Vec3 b = reference::vector(reference["b"]);
    const std::vector<LocalCoulombSolution> found = solve_coulomb_local_all(K, b, reference["mu"]);
    ASSERT_EQ(found.size(), reference["solutions"].size());
    for (const nlohmann::json& expected : reference["solutions"]) {
      const Vec3 lambda = reference::vector(expected["lambda"]);
      double nearest = std::numeric_limits<double>::infinity();
      for (const LocalCoulombSolution& solution : found) {
        if (solution.mode != mode_named(expected["mode"])) continue;
        nearest = std::min(nearest, (solution.lambda - lambda).norm());
      }
      EXPECT_LE(nearest, 1e-13 * lambda.norm());
    }
  }
}

TEST(CoulombLocal, EverySolutionObeysCoulombsLaw) {
  std::mt19937_64 generator(1);
  for (int i = 0; i < 20000; ++i) {
    const RandomContact c = random_contact(generator);
    const std::vector<LocalCoulombSolution> found = solve_coulomb_local_all(c.K, c.b, c.mu);
    ASSERT_FALSE(found.empty()) << i;
    for (const LocalCoulombSolution& solution : found)
      EXPECT_LT(broken_law(c.K, c.b, c.mu, solution), 1e-13) << i;
    // Solutions are born and die in pairs (folds), except when b_n ≥ 0 where the open one stands alone as
    // well.
    EXPECT_EQ(found.size() % 2, 1u) << i;
  }
}

TEST(CoulombLocal, TheQuickSolverReturnsTheFirstSolution) {
  std::mt19937_64 generator(2);
  for (int i = 0; i < 5000; ++i) {
    const RandomContact c = random_contact(generator);
    const LocalCoulombSolution first = solve_coulomb_local_all(c.K, c.b, c.mu).front();
    const LocalCoulombSolution quick = solve_coulomb_local(c.K, c.b, c.mu);
    EXPECT_EQ(quick.lambda, first.lambda);
    EXPECT_EQ(quick.mode, first.mode);
  }
}

TEST(CoulombLocal, AHintOnlySavesTime) {
  std::mt19937_64 generator(5);
  for (int i = 0; i < 5000; ++i) {
    const RandomContact c = random_contact(generator);
    if (c.b(2) >= 0 || solve_coulomb_local_all(c.K, c.b, c.mu).size() > 1) continue;
    const LocalCoulombSolution plain = solve_coulomb_local(c.K, c.b, c.mu);
    const LocalCoulombSolution hinted = solve_coulomb_local(c.K, c.b, c.mu, Vec2(std::cos(i), std::sin(i)));
    // Two Newton iterations to one root of the angle: round-off times the condition of the root.
    EXPECT_LT((hinted.lambda - plain.lambda).norm(), 1e-9 * plain.lambda.norm());
    EXPECT_LT(broken_law(c.K, c.b, c.mu, hinted), 1e-13);
  }
}

TEST(CoulombLocal, AFrictionlessContactStopsTheNormalMotionOnly) {
  Mat3 K;
  K << 2, 0.3, 0.4, 0.3, 3, -0.2, 0.4, -0.2, 1.5;
  const LocalCoulombSolution s = solve_coulomb_local(K, {0.5, -0.7, -1.2}, 0.0);
  EXPECT_EQ(s.lambda.head<2>().norm(), 0.0);
  EXPECT_NEAR(s.lambda(2), 1.2 / 1.5, 1e-15);
  EXPECT_EQ(s.mode, ContactMode::slide);
}

TEST(CoulombLocal, ASeparatingContactStaysOpenEvenWhereSlidingIsPossibleToo) {
  // The rod at 45 degrees of the reference problems: three solutions, of which λ = 0 continues from μ = 0.
  for (const nlohmann::json file = reference::read("ncp.json");
       const nlohmann::json& reference : file["cases"]) {
    if (reference["name"] != "NCP_rod45_mu2_multi") continue;
    const LocalCoulombSolution s = solve_coulomb_local(reference::matrix(reference["K"]),
                                                       reference::vector(reference["b"]), reference["mu"]);
    EXPECT_EQ(s.mode, ContactMode::open);
  }
}

// 0 ≤ λ ⊥ r λ + b ≥ 0 by the signs of r and b.
TEST(CoulombLocal, ASlidingContactHasNoneOneOrTwoForces) {
  EXPECT_EQ(count_sliding_solutions(0.5, -1), 1);
  EXPECT_EQ(count_sliding_solutions(0.5, 1), 1);
  EXPECT_EQ(count_sliding_solutions(-0.5, -1), 0);
  EXPECT_EQ(count_sliding_solutions(-0.5, 1), 2);
  EXPECT_EQ(count_sliding_solutions(0, -1), 0);
  EXPECT_EQ(count_sliding_solutions(0, 1), 1);
  EXPECT_EQ(count_sliding_solutions(-0.5, 0), 1);
}

// The rod of NCP_rod45_mu2_jam: κ - μ k·û = 5/2 - 2 · 3/2 one way, 5/2 + 2 · 3/2 the other.
TEST(CoulombLocal, FrictionChangesTheResponseByTheSlipsDirection) {
  Mat3 K;
  K << 2.5, 0, -1.5, 0, 1, 0, -1.5, 0, 2.5;
  EXPECT_EQ(sliding_response(K, 2, -Vec2::UnitX()), -0.5);
  EXPECT_EQ(sliding_response(K, 2, Vec2::UnitX()), 5.5);
  EXPECT_EQ(sliding_response(K, 2, Vec2::UnitY()), 2.5);
}

}  // namespace
}  // namespace rigor::coulomb_local_test
