#include "rigor/contact/impact/impact_problem.hpp"
#include "rigor/contact/impact/reflections.hpp"

#include "jointed_row.hpp"
#include "random_vectors.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace rigor::jointed_impact_test {
namespace {

/// The row with ball joints falls and spins at random.
ContactSystem falling_row(int boxes, test::Random& random) {
  ModelBuilder::JointDescription joint;
  joint.type = JointType::ball;
  return test::jointed_row(boxes, joint,
                           [&random] {
                             const Vec3 P = random.vector() - Vec3(0, 0, 1);
                             return std::pair<Vec3, Vec3>(P, 0.1 * random.vector());
                           })
      .system;
}

double residual_of(const ImpactProblem& problem, const CoulombSolution& solution) {
  const CoulombProblem law{problem.A.dense(), problem.u, frictions(problem),
                           std::vector<FrictionRow>(problem.count(), FrictionRow::cone),
                           std::vector<Vec2>(problem.count(), Vec2::Zero())};
  return coulomb_residual(law, solution.lambda, problem.u + law.A * solution.lambda);
}

/// Many contacts of jointed bodies are solved on rows, and solve the law of the dense matrix.
TEST(JointedImpact, SolvesTheLawOnRows) {
  test::Random random(33);
  for (const int boxes : {3, 5, 9}) {
    SCOPED_TRACE(boxes);
    const ContactSystem system = falling_row(boxes, random);
    const ImpactProblem problem =
        make_impact_problem(system, std::vector<double>(system.contacts.size(), 0.0));
    ASSERT_TRUE(problem.jointed_rows && !problem.rows);
    const CoulombSolution solution = solve_cones(problem, problem.u, frictions(problem));
    EXPECT_TRUE(solution.converged);
    EXPECT_EQ(solution.method, "proximal points");
    EXPECT_LE(residual_of(problem, solution), 1e-9);
    EXPECT_LE(energy_change(problem, solution.lambda), 0);
  }
}

/// With restitution no contact approaches afterwards, and no more energy comes back than the coefficient
/// allows.
TEST(JointedImpact, BouncesOffTheFloorTogether) {
  test::Random random(34);
  for (int example = 0; example < 6; ++example) {
    SCOPED_TRACE(example);
    const ContactSystem system = falling_row(3 + example, random);
    const double e = 0.3;
    const ImpactProblem problem = make_impact_problem(system, std::vector<double>(system.contacts.size(), e));
    const ImpactSolution solution = solve_reflections(problem);
    EXPECT_TRUE(solution.converged);
    EXPECT_LE(fastest_approach(problem.u + problem.A * solution.lambda),
              1e-6 * problem.u.cwiseAbs().maxCoeff());
    EXPECT_LE(energy_change(problem, solution.lambda), 0);
  }
}

}  // namespace
}  // namespace rigor::jointed_impact_test
