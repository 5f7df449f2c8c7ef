#include "rigor/solver/coulomb/alart_curnier.hpp"

#include <gtest/gtest.h>

#include <random>

namespace rigor {
namespace {

/// At random x, away from where they bend: the force lies in the cone, is the nearest of its disk, and the
/// slope is that of finite differences.
TEST(AlartCurnier, ProjectsOnTheDiskWithTheSlopeOfDifferences) {
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  CoulombProblem laws;
  laws.mu = {0.0, 0.3, 0.9, 0.4};
  laws.rows = {FrictionRow::cone, FrictionRow::cone, FrictionRow::cone, FrictionRow::slide};
  laws.slips.assign(4, Vec2(0.6, -0.8));
  constexpr double step = 1e-6, bend = 1e-3;
  for (int example = 0; example < 4000; ++example) {
    const std::size_t k = static_cast<std::size_t>(example) % 4;
    const Vec3 x(uniform(generator), uniform(generator), uniform(generator));
    if (std::abs(x.z()) < bend || std::abs(x.head<2>().norm() - laws.mu[k] * x.z()) < bend) continue;
    const ProjectedForce projection = alart_curnier(laws, k, x);

    // What it is.
    EXPECT_EQ(projection.force.z(), std::max(0.0, x.z()));
    const double radius = laws.mu[k] * projection.force.z(), share = projection.force.head<2>().norm();
    EXPECT_LE(share, radius * (1 + 1e-15));
    if (laws.rows[k] == FrictionRow::cone && radius > 0) {
      // Of the disk's points none is nearer: the miss is along the force, or zero inside.
      const Vec2 miss = x.head<2>() - projection.force.head<2>();
      EXPECT_NEAR(miss.dot(projection.force.head<2>()), miss.norm() * share, 1e-14);
      EXPECT_LE(miss.norm() * (radius - share), 1e-15);
      EXPECT_EQ(projection.mode, miss.norm() > 0 ? ContactMode::slide : ContactMode::stick);
    }

    // Its slope.
    for (int i = 0; i < 3; ++i) {
      const Vec3 d = step * Vec3::Unit(i);
      const Vec3 difference =
          (alart_curnier(laws, k, x + d).force - alart_curnier(laws, k, x - d).force) / (2 * step);
      // Second differences of P grow like 1 / |x_t|³, of which the disk leaves radius / |x_t|³.
      const double curvature = 1 + radius / std::pow(std::max(bend, x.head<2>().norm()), 3);
      EXPECT_LE((projection.slope.col(i) - difference).norm(), 4 * step * step * curvature + 1e-9)
          << x.transpose();
    }
  }
}

}  // namespace
}  // namespace rigor
