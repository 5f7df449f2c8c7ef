// Newton's matrices in contact space, block by block, against dense algebra; problems of which only the
// matrix is known.

#include "rigor/solver/linear/contact_space_motion.hpp"

#include "rigor/solver/coulomb/coulomb_problem.hpp"
#include "rigor/solver/linear/contact_motion.hpp"
#include "solver/heap_problems.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
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

/// Positive semidefinite, of rank 0 to 3.
Mat3 random_square(std::mt19937& generator) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  const Index rank = generator() % 4;
  const MatX half = MatX::NullaryExpr(3, rank, [&] { return uniform(generator); });
  return 100 * half * half.transpose();
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
      D[static_cast<std::size_t>(i)] = random_square(generator);
      whole.middleRows<3>(3 * i) += D[static_cast<std::size_t>(i)] * A.middleRows<3>(3 * i);
    }
    const VecX v = motion.newton_step(D, lambda, Symmetry::positive);
    const VecX momentum = motion.apply_mass(v);
    // Its condition is that of stiffness, at most 1e5 here.
    EXPECT_LT((momentum - whole.partialPivLu().solve(lambda)).norm(), 1e-10 * momentum.norm()) << draw;
  }
}

/// Heaps of which a solver sees the matrix alone.
TEST(CoulombOfAMatrix, IsSolvedForHeaps) {
  int problems = 0;
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
    }
    ++problems;
  }
  EXPECT_GE(problems, 20);
}

}  // namespace
}  // namespace rigor
