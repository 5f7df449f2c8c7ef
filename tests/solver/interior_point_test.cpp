#include "rigor/solver/coulomb/interior_point.hpp"
#include "rigor/solver/coulomb/coulomb_problem.hpp"
#include "rigor/solver/coulomb/second_order_cone.hpp"

#include "random_vectors.hpp"
#include "solver/contact_scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace rigor::interior_point_test {
namespace {

/// Inside the cone x₀ ≥ |x_t|, some of them near its border.
Vec3 inside_cone(std::mt19937& generator) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  const Vec2 side(uniform(generator), uniform(generator));
  const double above = std::pow(10.0, 3 * uniform(generator) - 3);
  return {side.norm() + above, side.x(), side.y()};
}

TEST(SecondOrderCone, QuotientsUndoProducts) {
  std::mt19937 generator(1);
  for (int k = 0; k < 100; ++k) {
    const Vec3 x = inside_cone(generator), z = inside_cone(generator) - inside_cone(generator);
    // Near the border the quotient multiplies rounding by one over the determinant.
    const double det = x(0) * x(0) - x.tail<2>().squaredNorm();
    EXPECT_LE((jordan_quotient(jordan_product(x, z), x) - z).norm(),
              1e-14 * z.norm() * x.squaredNorm() / det);
  }
}

TEST(SecondOrderCone, ScalingMakesForcesAndRatesTheSame) {
  std::mt19937 generator(2);
  for (int k = 0; k < 100; ++k) {
    const Vec3 x = inside_cone(generator), y = inside_cone(generator);
    const NesterovToddScaling scaling(x, jordan_square(x), y, jordan_square(y));
    const double size = (scaling.W * x).norm();
    EXPECT_LE((scaling.W * x - scaling.inverse * y).norm(), 1e-9 * size);
    EXPECT_LE((scaling.W * scaling.inverse - Mat3::Identity()).norm(), 1e-9);
    EXPECT_NEAR((scaling.W * x).squaredNorm(), (scaling.inverse * y).squaredNorm(), 1e-9 * size * size);
  }
}

TEST(SecondOrderCone, StepsEndWhereTheBorderIs) {
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto depth = [](const Vec3& x) { return x(0) - x.tail<2>().norm(); };
  int ending = 0;
  for (int k = 0; k < 200; ++k) {
    const Vec3 x = inside_cone(generator), d(uniform(generator), uniform(generator), uniform(generator));
    const double t = step_to_border(x, jordan_square(x), d);
    if (!std::isfinite(t)) {
      EXPECT_GE(depth(d), 0);
      continue;
    }
    ++ending;
    EXPECT_NEAR(depth(x + t * d), 0, 1e-9 * (1 + t));
    for (const double share : {0.25, 0.5, 0.75, 0.99}) EXPECT_GT(depth(x + share * t * d), 0);
  }
  EXPECT_GT(ending, 100);
  // Without friction the cone is a ray, and only its end is met.
  EXPECT_DOUBLE_EQ(step_to_border({2, 0, 0}, 4, {-4, 0, 0}), 0.5);
}

/// Largest |λ - P(λ - c w)| / c as a share of the largest term.
double miss(const CoulombProblem& problem) {
  const std::optional<VecX> forces = interior_forces(problem, FactoredMotion(problem.A));
  if (!forces) return 1;
  return coulomb_residual(problem, *forces, problem.A * *forces + problem.b);
}

TEST(InteriorPoint, IsNearTheSolutionHoweverRedundantTheContacts) {
  for (const int count : {2, 4, 7}) {
    for (const double along : {0.0, 2.0, 4.8, 5.0, 9.0}) {
      const Vec3 gravity(along, 0.3 * along, -9.81);
      EXPECT_LE(miss(problem_of(scenes::box_on_plane(count, 0.5, gravity))), 1e-4) << count << ' ' << along;
    }
  }
  scenes::Scene stack = scenes::stack(std::vector<double>(15, 1.0), 0.4);
  EXPECT_LE(miss(problem_of(stack)), 1e-4);
  for (scenes::Body& body : stack.bodies) body.v.x() = 3 + body.center.z();
  EXPECT_LE(miss(problem_of(stack)), 1e-4);
}

/// The convex relaxation has w_n = μ |w_t| where a contact slides, Coulomb's law w_n = 0.
TEST(InteriorPoint, SlidingContactsDoNotLift) {
  const CoulombProblem problem = problem_of(scenes::box_on_plane(3, 0.5, {9, 0, -9.81}));
  const std::optional<VecX> forces = interior_forces(problem, FactoredMotion(problem.A));
  ASSERT_TRUE(forces);
  const VecX w = problem.A * *forces + problem.b;
  for (Eigen::Index row = 0; row < w.size(); row += 3) {
    EXPECT_NEAR(w(row), 9 - 0.5 * 9.81, 1e-3);
    EXPECT_NEAR(w(row + 2), 0, 1e-3);
  }
}

TEST(InteriorPoint, ContactsWithoutFrictionHaveNone) {
  CoulombProblem problem = problem_of(scenes::stack({1, 2, 1}, 0));
  EXPECT_LE(miss(problem), 1e-4);
  const VecX forces = interior_forces(problem, FactoredMotion(problem.A)).value();
  for (Eigen::Index row = 0; row < forces.size(); row += 3) EXPECT_EQ(forces.segment<2>(row).norm(), 0);
}

TEST(InteriorPoint, SlipsThatAreHeldAreNotForIt) {
  CoulombProblem problem = problem_of(scenes::stack({1, 1}, 0.5));
  problem.rows[0] = FrictionRow::slide;
  problem.slips[0] = Vec2::UnitX();
  EXPECT_FALSE(interior_forces(problem, FactoredMotion(problem.A)));
}

}  // namespace
}  // namespace rigor::interior_point_test
