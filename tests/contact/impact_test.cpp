#include "rigor/contact/impact.hpp"

#include "random_vectors.hpp"
#include "rigor/contact/contact_system.hpp"
#include "rigor/math/rotation.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace rigor {
namespace {

using test::Random;

BodyKinetics body(double mass, const Vec3& x, const Vec3& v, const Vec3& w, const Mat3& inertia) {
  BodyKinetics result;
  result.x = x;
  result.v = v;
  result.w = w;
  result.inverse_mass = 1 / mass;
  result.inertia = inertia;
  result.inverse_inertia = inertia.inverse();
  return result;
}

BodyKinetics ball(double mass, const Vec3& x, const Vec3& v, const Vec3& w = Vec3::Zero()) {
  return body(mass, x, v, w, 0.4 * mass * Mat3::Identity());
}

Contact contact_at(int A, int B, const Vec3& p_W, const Vec3& n_W, double mu, double e) {
  Contact contact{};
  contact.body_A = A;
  contact.body_B = B;
  contact.point.p_WA = contact.point.p_WB = p_W;
  contact.point.n_W = n_W;
  contact.friction = mu;
  contact.restitution = e;
  return contact;
}

std::vector<double> restitutions_of(const ContactSystem& system) {
  std::vector<double> e;
  for (const Contact& contact : system.contacts) e.push_back(contact.restitution);
  return e;
}

struct Totals {
  Vec3 P = Vec3::Zero(), L = Vec3::Zero();
};
Totals totals(const ContactSystem& system) {
  Totals sum;
  for (const BodyKinetics& k : system.kinetics) {
    if (k.inverse_mass == 0) continue;
    const Vec3 P = k.v / k.inverse_mass;
    sum.P += P;
    sum.L += k.inertia * k.w + k.x.cross(P);
  }
  return sum;
}

ContactSystem after_impact(const ContactSystem& before, SimultaneousLaw law = SimultaneousLaw::reflections) {
  ContactSystem after = before;
  const ImpactSolution impact = solve_impact(before, restitutions_of(before), law);
  EXPECT_TRUE(impact.converged);
  apply_impulses(impact.lambda, after);
  return after;
}

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

TEST(Impact, ConservesMomentumAndNeverGainsEnergyByReflections) {
  Random random(21);
  for (int trial = 0; trial < 200; ++trial) {
    const int bodies = 2 + trial % 3;
    std::vector<BodyKinetics> kinetics;
    std::vector<int> indices;
    for (int i = 0; i < bodies; ++i) {
      const Mat3 R = rotation_matrix(rotation_exp(3 * random.vector()));
      const Vec3 moments = Vec3(1, 1.2, 0.9) + 0.3 * random.vector();
      kinetics.push_back(body(1 + 0.9 * random.number(), 2.0 * i * Vec3::UnitX() + 0.2 * random.vector(),
                              random.vector(), random.vector(), R * moments.asDiagonal() * R.transpose()));
      indices.push_back(i);
    }
    std::vector<Contact> contacts;
    for (int i = 0; i + 1 < bodies; ++i) {
      for (int k = 0; k <= trial % 2; ++k) {
        const Vec3 p = (2.0 * i + 1) * Vec3::UnitX() + 0.3 * random.vector();
        const Vec3 n = (Vec3::UnitX() + 0.3 * random.vector()).normalized();
        contacts.push_back(
            contact_at(i, i + 1, p, n, 0.5 * (1 + random.number()), 0.5 * (1 + random.number())));
      }
    }
    const ContactSystem before = make_contact_system(contacts, indices, kinetics);
    const bool is_one_pair = bodies == 2;
    const ContactSystem after = after_impact(before);
    EXPECT_LE((totals(after).P - totals(before).P).norm(), 1e-12);
    EXPECT_LE((totals(after).L - totals(before).L).norm(), 1e-12);
    const VecX u = relative_velocities(after);
    for (Eigen::Index row = 2; row < u.size(); row += 3) EXPECT_GE(u[row], -1e-10);
    // Newton's law with friction on one pair may gain; that it is told is the audit's matter.
    if (!is_one_pair) {
      EXPECT_LE(kinetic_energy(after), kinetic_energy(before) * (1 + 1e-12));
    }
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

// A chain of n equal touching balls, the first one moving: reflections pass the motion to the last (as gaps
// would), Newton's law on all contacts at once does not.
TEST(Impact, ACradleHitByOneBallSendsOneBallOff) {
  const int n = 5;
  std::vector<BodyKinetics> kinetics;
  std::vector<Contact> contacts;
  std::vector<int> indices;
  for (int i = 0; i < n; ++i) {
    kinetics.push_back(ball(1, 2.0 * i * Vec3::UnitX(), i == 0 ? Vec3(1, 0, 0) : Vec3(0, 0, 0)));
    indices.push_back(i);
    if (i > 0) contacts.push_back(contact_at(i - 1, i, (2.0 * i - 1) * Vec3::UnitX(), Vec3::UnitX(), 0, 1));
  }
  const ContactSystem system = make_contact_system(contacts, indices, kinetics);
  const ContactSystem after = after_impact(system);
  for (int i = 0; i < n; ++i) EXPECT_NEAR(after.of(i).v.x(), i == n - 1 ? 1.0 : 0.0, 1e-12) << i;
  const ContactSystem at_once = after_impact(system, SimultaneousLaw::lcp);
  EXPECT_GT(std::abs(at_once.of(n - 1).v.x() - 1), 0.1);
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
  const ImpactSolution impact = solve_impact(before, {0.8}, SimultaneousLaw::reflections);
  EXPECT_TRUE(impact.lambda.isZero(0));
}

}  // namespace
}  // namespace rigor
