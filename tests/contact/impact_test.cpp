#include "rigor/contact/impact/impact.hpp"

#include "contact/impact_systems.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace rigor::test::impact_test {
namespace {

// A ball of radius 1 on the floor (body 0, prescribed); the contact is at the origin.
ContactSystem ball_on_floor(const Vec3& v, const Vec3& w, double mu, double e) {
  return make_contact_system({contact_at(0, 1, Vec3::Zero(), Vec3::UnitZ(), mu, e)}, {0, 1},
                             {BodyKinetics{}, ball(2, Vec3(0, 0, 1), v, w)});
}

TEST(Impact, BallSlidesWhereFrictionIsWeakAndSticksWhereItIsStrong) {
  // Newton with friction: v_z⁺ = -e v_z; the tangential impulse stops the slip or is μ times the normal one.
  // The slip of a solid ball of radius 1 with I = 0.4 m changes by 3.5 j/m.
  for (const double mu : {0.05, 0.9}) {
    const double e = 0.7, slip = 2.1 - 0.4;
    const ContactSystem after = after_impact(ball_on_floor(Vec3(2.1, 0, -3), Vec3(0, 0.4, 0), mu, e));
    const BodyKinetics& k = after.of(1);
    const double normal = 3 * (1 + e), tangential = std::min(mu * normal, slip / 3.5);
    EXPECT_NEAR(k.v.z(), 3 * e, 1e-14);
    EXPECT_NEAR(k.v.x(), 2.1 - tangential, 1e-14);
    EXPECT_NEAR(k.w.y(), 0.4 + tangential / 0.4, 1e-13);
    EXPECT_EQ(mu > 0.5, relative_velocities(after).head<2>().norm() < 1e-13);
  }
}

TEST(Impact, WithoutFrictionEnergyIsLostByOneMinusESquared) {
  Random random(22);
  for (const double e : {0.0, 0.4, 1.0}) {
    const Mat3 inertia = Vec3(1, 2, 2.5).asDiagonal();
    const ContactSystem before =
        make_contact_system({contact_at(0, 1, Vec3(1, 0.2, 0.1), Vec3::UnitX(), 0, e)}, {0, 1},
                            {body(1, Vec3::Zero(), Vec3(2, 0, 0.3), Vec3(0.1, 0.4, -0.2), inertia),
                             body(3, Vec3(2, 0, 0), Vec3(-1, 0, 0), Vec3::Zero(), inertia)});
    const double u = relative_velocities(before)[2];
    ASSERT_LT(u, 0);
    const double reduced_mass = 1 / delassus(before)(2, 2);
    EXPECT_NEAR(kinetic_energy(before) - kinetic_energy(after_impact(before)),
                0.5 * reduced_mass * u * u * (1 - e * e), 1e-13);
  }
}

TEST(Impact, ABallBetweenTwoWallsOfACornerLeavesTheWayItCame) {
  for (const Vec3& v : {Vec3(-1, 0, -1), Vec3(-1, 0, -0.3)}) {
    const ContactSystem before = make_contact_system({contact_at(0, 1, Vec3(0, 0, 1), Vec3::UnitX(), 0, 1),
                                                      contact_at(0, 1, Vec3(1, 0, 0), Vec3::UnitZ(), 0, 1)},
                                                     {0, 1}, {BodyKinetics{}, ball(1, Vec3(1, 0, 1), v)});
    EXPECT_LE((after_impact(before).of(1).v + v).norm(), 1e-13);
  }
}

// Only what approaches is pushed: a contact that parts gets no impulse and keeps its velocity.
TEST(Impact, LeavesPartingContactsAlone) {
  const ContactSystem before = ball_on_floor(Vec3(1, 0, 0.5), Vec3::Zero(), 0.5, 0.8);
  const ImpactSolution impact =
      solve_impact(before, {0.8}, RestitutionLaw::newton, SimultaneousLaw::reflections);
  EXPECT_TRUE(impact.lambda.isZero(0));
}

}  // namespace
}  // namespace rigor::test::impact_test
