// Newton's matrices in contact space, block by block, against dense algebra; problems of which only the
// matrix is known.

#include "rigor/solver/linear/contact_space_motion.hpp"

#include "rigor/solver/coulomb/coulomb_problem.hpp"
#include "rigor/solver/linear/contact_motion.hpp"
#include "solver/heap_problems.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <random>
#include <vector>

namespace rigor {
namespace {

using Eigen::Index;

/// A = J M⁻¹ Jᵀ of random contacts between bodies in a row and the ground: singular, and with few blocks.
MatX random_matrix(int bodies, int contacts, std::mt19937& generator) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  MatX J = MatX::Zero(3 * contacts, 6 * bodies);
  for (int i = 0; i < contacts; ++i) {
    const int body = static_cast<int>(generator() % static_cast<unsigned>(bodies));
    for (const int side : {body, body + 1})
      if (side < bodies)
        J.block<3, 6>(3 * i, 6 * side) =
            Eigen::Matrix<double, 3, 6>::NullaryExpr([&] { return uniform(generator); });
  }
  return J * J.transpose();
}

/// As Newton's method has them: zero where a contact is open, definite where it sticks, and not symmetric
/// where it slides, with friction along a direction in the place of a spring.
Mat3 random_slope(std::mt19937& generator) {
  std::uniform_real_distribution<double> uniform(0, 1);
  const double stiffness = std::pow(10, 5 * uniform(generator));
  const auto mode = generator() % 3;
  if (mode == 0) return Mat3::Zero();
  if (mode == 1) return stiffness * Mat3::Identity();
  const double angle = 6.3 * uniform(generator), mu = 2 * uniform(generator);
  const Vec2 along(std::cos(angle), std::sin(angle)), across(-along.y(), along.x());
  Mat3 slope = Mat3::Zero();
  slope(2, 2) = 1;
  slope.topRightCorner<2, 1>() = mu * along;
  slope.topLeftCorner<2, 2>() = uniform(generator) * across * across.transpose();
  return stiffness * slope;
}

TEST(ContactSpaceMotion, SolvesWhatDenseAlgebraSolves) {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int draw = 0; draw < 200; ++draw) {
    const int contacts = 1 + static_cast<int>(generator() % 30);
    const MatX A = random_matrix(1 + static_cast<int>(generator() % 10), contacts, generator);
    const ContactSpaceMotion motion(A);
    const VecX lambda = VecX::NullaryExpr(3 * contacts, [&] { return uniform(generator); });

    // A is L M⁻¹ of the forces.
    const VecX w = motion.rates(motion.apply_inverse_mass(motion.apply_transpose(lambda)));
    EXPECT_LT((w - A * lambda).norm(), 1e-14 * A.norm() * lambda.norm());

    // (1 + D A) m v = g.
    std::vector<Mat3> D(static_cast<std::size_t>(contacts));
    MatX whole = MatX::Identity(3 * contacts, 3 * contacts);
    for (int i = 0; i < contacts; ++i) {
      D[static_cast<std::size_t>(i)] = random_slope(generator);
      whole.middleRows<3>(3 * i) += D[static_cast<std::size_t>(i)] * A.middleRows<3>(3 * i);
    }
    const VecX v = motion.newton_step(D, lambda, Symmetry::none);
    const VecX momentum = motion.apply_mass(v);
    // How far the equations are missed, of their terms: rounding, and what pivots within blocks add.
    const double terms = whole.cwiseAbs().rowwise().sum().maxCoeff() * momentum.cwiseAbs().maxCoeff() +
                         lambda.cwiseAbs().maxCoeff();
    EXPECT_LT((whole * momentum - lambda).cwiseAbs().maxCoeff(), 1e-13 * terms) << draw;
  }
}

/// Heaps of which a solver sees the matrix alone.
TEST(CoulombOfAMatrix, IsSolvedForHeaps) {
  int problems = 0, compared = 0;
  for (const heaps::Heap& heap : heaps::all_heaps()) {
    const MotionProblem problem = heaps::problem_of(heap);
    const Index size = problem.laws.b.size();
    if (problem.laws.mu.size() > 80) continue;
    const SparseMotion motion(problem.rows);
    CoulombProblem laws = problem.laws;
    laws.A.resize(size, size);
    for (Index k = 0; k < size; ++k)
      laws.A.col(k) = motion.rates(motion.apply_inverse_mass(motion.apply_transpose(VecX::Unit(size, k))));
    // Any share of the load, and the one of least norm, which is no larger.
    const CoulombSolution any = solve_coulomb(laws, {.least_norm = false}), least = solve_coulomb(laws);
    for (const CoulombSolution* solution : {&any, &least}) {
      EXPECT_LE(heaps::residual_of(problem, solution->lambda), 1e-10) << heaps::name_of(heap);
      EXPECT_TRUE(solution->converged) << heaps::name_of(heap);
    }
    if ((any.w - least.w).norm() <= 1e-9 * laws.b.norm()) {
      EXPECT_LE(least.lambda.norm(), any.lambda.norm() * (1 + 1e-9)) << heaps::name_of(heap);
      ++compared;
    }
    ++problems;
  }
  EXPECT_GE(problems, 20);
  EXPECT_GE(compared, 5);
}

TEST(CoulombOfAMatrix, HasNoAnswerAndEndsWhereNothingMoves) {
  for (const int contacts : {1, 8, 20}) {
    for (const bool least_norm : {true, false}) {
      for (const std::optional<double> resolution : {std::optional<double>(), std::optional<double>(1e-9)}) {
        CoulombProblem problem;
        problem.A = MatX::Zero(3 * contacts, 3 * contacts);
        problem.b = -VecX::Ones(3 * contacts);
        problem.mu.assign(static_cast<std::size_t>(contacts), 0.5);
        problem.rows.assign(problem.mu.size(), FrictionRow::cone);
        problem.slips.assign(problem.mu.size(), Vec2::UnitX());
        const CoulombSolution solution =
            solve_coulomb(problem, {.least_norm = least_norm, .resolution = resolution});
        EXPECT_FALSE(solution.converged);
        EXPECT_TRUE(solution.lambda.allFinite());
        EXPECT_EQ(solution.w, problem.b);
      }
    }
  }
}

}  // namespace
}  // namespace rigor
