// Friction with known bounds: the law, its energy against a brute force, rows against the matrix.

#include "rigor/solver/coulomb/bounded_friction.hpp"

#include "solver/heap_problems.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace rigor::bounded_friction_test {
namespace {

using Eigen::Index;

double draw(std::mt19937& generator) {
  return static_cast<double>(generator()) / 4294967296.0;
}

/// Bounds over six decades, every fifth contact without load.
std::vector<double> bounds_of(std::size_t count, std::mt19937& generator) {
  std::vector<double> bounds;
  for (std::size_t k = 0; k < count; ++k)
    bounds.push_back(k % 5 == 4 ? 0.0 : std::pow(10.0, 6 * draw(generator) - 5));
  return bounds;
}

double energy_of(const MatX& A, const VecX& u, const VecX& lambda) {
  return lambda.dot(u + 0.5 * A * lambda);
}

/// Sweeps over the contacts, each with the least energy along its own gradient within its disk.
VecX swept(const MatX& A, const VecX& u, const std::vector<double>& bounds, int sweeps) {
  VecX lambda = VecX::Zero(u.size());
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (std::size_t k = 0; k < bounds.size(); ++k) {
      const Index row = 3 * static_cast<Index>(k);
      if (bounds[k] == 0) continue;
      const Vec2 w = (A.middleRows<2>(row) * lambda) + u.segment<2>(row);
      const double step = 1 / A.block<2, 2>(row, row).trace();
      Vec2 own = lambda.segment<2>(row) - step * w;
      if (own.norm() > bounds[k]) own *= bounds[k] / own.norm();
      lambda.segment<2>(row) = own;
    }
  }
  return lambda;
}

TEST(BoundedFriction, IsTheLawOnHeaps) {
  std::mt19937 generator(20261128);
  for (const heaps::Heap& heap : heaps::all_heaps()) {
    if (heap.layers > 6) continue;
    const MotionProblem problem = heaps::problem_of(heap);
    const std::vector<double> bounds = bounds_of(problem.laws.mu.size(), generator);
    const BoundedFriction found = solve_bounded_friction(SparseMotion(problem.rows), problem.laws.b, bounds);
    EXPECT_LE(found.residual, 1e-11) << heaps::name_of(heap) << " " << bounds.size() << " contacts, "
                                     << found.iterations << " points";
    // The law, worked out here: inside its disk nothing slips, on its edge friction opposes slip.
    const VecX w =
        contact_rates(problem.rows,
                      node_accelerations(problem.rows, contact_wrenches(problem.rows, found.lambda))) +
        problem.laws.b;
    const double fastest = problem.laws.b.cwiseAbs().maxCoeff();
    for (std::size_t k = 0; k < bounds.size(); ++k) {
      const Vec3 own = found.lambda.segment<3>(3 * static_cast<Index>(k));
      const Vec2 slip = w.segment<2>(3 * static_cast<Index>(k));
      EXPECT_EQ(own.z(), 0);
      EXPECT_LE(own.norm(), (1 + 1e-15) * bounds[k]);
      if (bounds[k] == 0) continue;
      if (own.norm() < (1 - 1e-6) * bounds[k]) {
        EXPECT_LE(slip.norm(), 1e-8 * fastest) << heaps::name_of(heap);
      }
      if (slip.norm() > 1e-6 * fastest) {
        EXPECT_LE(own.head<2>().dot(slip), -(1 - 1e-8) * own.norm() * slip.norm()) << heaps::name_of(heap);
      }
    }
  }
}

TEST(BoundedFriction, LeavesTheLeastEnergy) {
  std::mt19937 generator(7);
  for (const heaps::Heap& heap :
       {heaps::Heap{heaps::Kind::wall, 2, 0.3, 11}, heaps::Heap{heaps::Kind::pyramid, 2, 0.3, 12},
        heaps::Heap{heaps::Kind::balls, 3, 0.3, 13}}) {
    const MotionProblem problem = heaps::problem_of(heap);
    const MatX A = contact_response(problem.rows);
    const std::vector<double> bounds = bounds_of(problem.laws.mu.size(), generator);
    const VecX on_rows = solve_bounded_friction(SparseMotion(problem.rows), problem.laws.b, bounds).lambda;
    const VecX on_matrix = solve_bounded_friction(FactoredMotion(A), problem.laws.b, bounds).lambda;
    const VecX brute = swept(A, problem.laws.b, bounds, 20000);
    const double least = energy_of(A, problem.laws.b, brute);
    EXPECT_LT(least, 0);
    EXPECT_LE(energy_of(A, problem.laws.b, on_rows), least * (1 - 1e-9)) << heaps::name_of(heap);
    EXPECT_LE((A * (on_rows - on_matrix)).cwiseAbs().maxCoeff(), 1e-9 * problem.laws.b.cwiseAbs().maxCoeff());
  }
}

TEST(BoundedFriction, WithoutLoadIsNothing) {
  const MotionProblem problem = heaps::problem_of({heaps::Kind::wall, 2, 0.3, 3});
  const std::vector<double> none(problem.laws.mu.size(), 0.0);
  const BoundedFriction found = solve_bounded_friction(SparseMotion(problem.rows), problem.laws.b, none);
  EXPECT_TRUE(found.lambda.isZero(0));
  EXPECT_EQ(found.residual, 0);
}

}  // namespace
}  // namespace rigor::bounded_friction_test
