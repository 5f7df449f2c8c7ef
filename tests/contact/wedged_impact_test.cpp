#include "rigor/contact/impact/collision.hpp"

#include <gtest/gtest.h>

#include <random>

namespace rigor::wedged_impact_test {
namespace {

// Joints can let no impulse along a direction d move a contact: K d = 0. If d lies inside the cone of
// friction and sliding stops, all has stopped, since u is in the range of K: u · d = 0.
TEST(WedgedImpact, EndsWithItsSlipWhateverTheLawAndTheRestitution) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  int wedged = 0;
  for (int k = 0; k < 400; ++k) {
    // A random response, made blind for d.
    Mat3 B;
    for (int i = 0; i < 9; ++i) B(i / 3, i % 3) = normal(random);
    const Mat3 A = B * B.transpose();
    const double mu = 0.7;
    Vec3 d(0.3 * normal(random), 0.3 * normal(random), 1);
    if (d.head<2>().norm() > 0.95 * mu) continue;
    const Vec3 Ad = A * d;
    const Mat3 K = A - Ad * Ad.transpose() / d.dot(Ad);
    Vec3 u = K * Vec3(normal(random), normal(random), normal(random));
    if (u.z() > 0) u = -u;
    ++wedged;
    for (const RestitutionLaw law :
         {RestitutionLaw::newton, RestitutionLaw::poisson, RestitutionLaw::stronge}) {
      for (const double e : {0.0, 0.3, 1.0}) {
        const CollisionOutcome outcome = resolve_collision({{0.5 * (K + K.transpose()), mu}, u, e}, law);
        ASSERT_TRUE(outcome.is_resolved) << k << " " << e;
        EXPECT_GE(outcome.end.u.z(), -1e-9 * u.norm()) << k;
        // Inside the cone, and no energy comes of it.
        EXPECT_LE(outcome.end.lambda.head<2>().norm(), mu * outcome.end.lambda.z() * (1 + 1e-9) + 1e-12);
        if (law == RestitutionLaw::stronge) {
          EXPECT_LE(outcome.energy_change, 1e-9 * u.squaredNorm());
        }
      }
    }
  }
  EXPECT_GT(wedged, 200);
}

}  // namespace
}  // namespace rigor::wedged_impact_test
