// First forces of few contacts.

#include "rigor/solver/motion/swept_forces.hpp"

#include "solver/heap_problems.hpp"

#include <gtest/gtest.h>

namespace rigor::swept_forces_test {
namespace {

TEST(SweptForces, AreInTheirConesAndComeNearer) {
  for (const heaps::Heap& heap :
       {heaps::Heap{heaps::Kind::wall, 3, 0.3, 1}, heaps::Heap{heaps::Kind::pyramid, 3, 0.3, 2},
        heaps::Heap{heaps::Kind::balls, 3, 0.3, 3}}) {
    const MotionProblem problem = heaps::problem_of(heap);
    const VecX lambda = swept_forces(problem, 20);
    for (std::size_t k = 0; k < problem.laws.mu.size(); ++k) {
      const Vec3 force = lambda.segment<3>(3 * static_cast<Eigen::Index>(k));
      EXPECT_GE(force.z(), 0);
      EXPECT_LE(force.head<2>().norm(), (1 + 1e-15) * problem.laws.mu[k] * force.z());
    }
    EXPECT_LT(heaps::residual_of(problem, lambda), 0.3 * heaps::residual_of(problem, 0 * lambda))
        << heaps::name_of(heap);
  }
}

TEST(SweptForces, ConvergeToTheLaw) {
  const MotionProblem problem = heaps::problem_of({heaps::Kind::pyramid, 2, 0, 4});
  EXPECT_LE(heaps::residual_of(problem, swept_forces(problem, 3000)), 1e-10);
}

}  // namespace
}  // namespace rigor::swept_forces_test
