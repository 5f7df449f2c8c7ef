#include "rigor/solver/coulomb/cone.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace rigor::cone_test {
namespace {

std::vector<Vec3> random_points(int count) {
  std::mt19937_64 generator(3);
  std::normal_distribution<double> normal;
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i)
    points.emplace_back(normal(generator), normal(generator), normal(generator));
  return points;
}

const std::vector<double> kFrictions = {0.0, 0.1, 0.5, 1.0, 3.0, 1e6};

// Moreau: p = proj(x) onto a cone K iff p is in K, x - p is in the polar cone and p ⟂ x - p.
TEST(Cone, ProjectionSplitsAPointIntoConeAndPolarParts) {
  for (const double mu : kFrictions)
    for (const Vec3& x : random_points(500)) {
      const Vec3 p = project_on_cone(x, mu);
      const Vec3 rest = x - p;
      const double size = 1e-15 * x.norm() * (1 + mu);
      EXPECT_LE(p.head<2>().norm(), mu * p(2) + 4 * size);
      EXPECT_LE(mu * rest.head<2>().norm() + rest(2), 4 * size);
      EXPECT_NEAR(p.dot(rest), 0.0, 8e-15 * x.squaredNorm());
    }
}

TEST(Cone, DerivativeAgreesWithDifferences) {
  const double h = 1e-6;
  for (const double mu : {0.1, 0.5, 1.0, 3.0})
    for (const Vec3& x : random_points(200)) {
      const Mat3 derivative = cone_projection_derivative(x, mu);
      for (int axis = 0; axis < 3; ++axis) {
        const Vec3 step = h * Vec3::Unit(axis);
        if (cone_region(x + step, mu) != cone_region(x - step, mu)) continue;
        const Vec3 difference = (project_on_cone(x + step, mu) - project_on_cone(x - step, mu)) / (2 * h);
        // Central differences: h² times third derivatives, plus round-off / h.
        EXPECT_LT((difference - derivative.col(axis)).norm(), 1e-8);
      }
    }
}

TEST(Cone, FrictionlessConeIsTheNormalRay) {
  EXPECT_EQ(project_on_cone({1, 2, 3}, 0.0), Vec3(0, 0, 3));
  EXPECT_EQ(project_on_cone({1, 2, -3}, 0.0), Vec3(0, 0, 0));
  EXPECT_EQ(project_on_cone({0, 0, 3}, 0.0), Vec3(0, 0, 3));
}

TEST(Cone, ClampKeepsTheNormalPart) {
  EXPECT_LT((clamp_to_cone({3, 4, 2}, 0.5) - Vec3(0.6, 0.8, 2)).norm(), 1e-15);
  EXPECT_EQ(clamp_to_cone({0.3, 0.4, 2}, 0.5), Vec3(0.3, 0.4, 2));
  EXPECT_EQ(clamp_to_cone({3, 4, -2}, 0.5), Vec3(0, 0, 0));
}

}  // namespace
}  // namespace rigor::cone_test
