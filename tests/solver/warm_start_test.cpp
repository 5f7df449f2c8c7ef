#include "solver/jointed_scenes.hpp"

#include <gtest/gtest.h>

namespace rigor::warm_start_test {
namespace {

constexpr double kGravity = 9.81;

MotionProblem rows_of(const scenes::Scene& scene) {
  scenes::JointedScene jointed;
  static_cast<scenes::Scene&>(jointed) = scene;
  MotionProblem problem = scenes::motion_problem_of(jointed);
  constrain_nodes(nullptr, {}, problem.rows);
  return problem;
}

CoulombOptions any_share() {
  CoulombOptions options;
  options.least_norm = false;
  options.tolerance = 1e-10;
  return options;
}

TEST(WarmStart, AStackOfFiftyUnderAMillionTimesTheMassIsSolved) {
  std::vector<double> masses(50, 1.0);
  masses.back() = 1e6;
  const MotionProblem problem = rows_of(scenes::stack(masses, 0.5));
  const std::optional<CoulombSolution> cold = solve_in_motion_space(problem);
  ASSERT_TRUE(cold.has_value());
  EXPECT_LE(cold->residual, 1e-12);
  const double load = (49 + 1e6) * kGravity / 4;
  // The residual is relative to what the load alone would do to a cube of mass 1, 1e7 m/s²: 1e-12 of that is
  // 1e-6 of the acceleration of the top.
  for (Eigen::Index i = 0; i < 4; ++i) EXPECT_NEAR(cold->lambda(3 * i + 2), load, 1e-6 * load);
  // From forces of before a single step is enough.
  const std::optional<CoulombSolution> warm = solve_in_motion_space(problem, {}, any_share(), cold->lambda);
  ASSERT_TRUE(warm.has_value());
  EXPECT_EQ(warm->iterations, 1);
  EXPECT_LE(warm->residual, 1e-10);
}

TEST(WarmStart, AnyShareMovesTheBodiesAsTheLeastOneDoes) {
  // A box that tips over the edge of its hundred points.
  const scenes::Scene scene = scenes::box_on_plane(10, 2.0, kGravity * Vec3(0.9, 0.1, -0.4));
  const MotionProblem problem = rows_of(scene);
  const std::optional<CoulombSolution> least = solve_in_motion_space(problem);
  const std::optional<CoulombSolution> some = solve_in_motion_space(problem, {}, any_share());
  ASSERT_TRUE(least && some);
  EXPECT_LE(some->residual, 1e-10);
  EXPECT_LE((some->w - least->w).cwiseAbs().maxCoeff(), 1e-7);
  EXPECT_GE(some->lambda.norm(), (1 - 1e-9) * least->lambda.norm());
  const std::optional<CoulombSolution> again = solve_in_motion_space(problem, {}, any_share(), some->lambda);
  ASSERT_TRUE(again.has_value());
  EXPECT_LT(again->iterations, some->iterations);
}

}  // namespace
}  // namespace rigor::warm_start_test
