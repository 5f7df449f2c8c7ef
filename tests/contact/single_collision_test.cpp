#include "rigor/contact/impact/single_collision.hpp"

#include "contact/impact_systems.hpp"
#include "rigor/math/rotation.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace rigor::test::single_collision_test {
namespace {

/// A box of 1 kg on the floor z = 0 (body 0): its lowest corners touch.
ContactSystem box_on_floor(const Vec3& half, const Mat3& R, const Vec3& v, const Vec3& w, double mu,
                           double e) {
  const Vec3 squares = half.cwiseProduct(half);
  const Mat3 I_B = ((squares.sum() - squares.array()) / 3).matrix().asDiagonal();
  std::vector<Vec3> corners;
  double lowest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 8; ++i) {
    const Vec3 signs((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1);
    corners.push_back(R * half.cwiseProduct(signs));
    lowest = std::min(lowest, corners.back().z());
  }
  const Vec3 x(0, 0, -lowest);
  std::vector<Contact> contacts;
  for (const Vec3& corner : corners) {
    if (corner.z() < lowest + 1e-9) contacts.push_back(contact_at(0, 1, x + corner, Vec3::UnitZ(), mu, e));
  }
  return make_contact_system(contacts, {0, 1}, {BodyKinetics{}, body(1, x, v, w, R * I_B * R.transpose())});
}

struct EdgeImpact {
  double angle, vx, vz, mu, e;
  RestitutionLaw law;
  Vec3 after;  ///< v_x, v_z, ω_y.
};

// Routh's construction for a box that lands on an edge along y: the tangential velocity reverses in the
// second case (so that no law of total impulses finds it) and stops in the third.
TEST(SingleCollision, BoxThatLandsOnAnEdgeCollidesOnceAsRouthHasIt) {
  const double degree = M_PI / 180;
  const EdgeImpact impacts[] = {
      {30, 1, -2, 0.1, 0.5, RestitutionLaw::newton, {0.900278, -1.002781, -4.734566}},
      {30, 1, -2, 0.1, 0.5, RestitutionLaw::poisson, {0.900278, -1.002781, -4.734566}},
      {30, 1, -2, 0.1, 0.5, RestitutionLaw::stronge, {0.900278, -1.002781, -4.734566}},
      {30, -1, -2, 0.3, 0.5, RestitutionLaw::newton, {-0.968310, -1.059412, -4.868439}},
      {30, -1, -2, 0.3, 0.5, RestitutionLaw::poisson, {-0.945009, -1.137081, -4.549434}},
      {30, -1, -2, 0.3, 0.5, RestitutionLaw::stronge, {-0.955022, -1.103704, -4.686519}},
      {45, -2, -2, 0.6, 0.5, RestitutionLaw::newton, {-1.931310, -0.782748, -5.252470}},
      {45, -2, -2, 0.6, 0.5, RestitutionLaw::poisson, {-1.759024, -1.084617, -4.783913}},
      {45, -2, -2, 0.6, 0.5, RestitutionLaw::stronge, {-1.815381, -0.985871, -4.937186}}};
  for (const EdgeImpact& c : impacts) {
    const Mat3 R = rotation_matrix(rotation_exp(c.angle * degree * Vec3::UnitY()));
    const ContactSystem before =
        box_on_floor(Vec3(0.5, 0.1, 0.02), R, Vec3(c.vx, 0, c.vz), Vec3::Zero(), c.mu, c.e);
    ASSERT_EQ(before.contacts.size(), 2u);
    for (const SimultaneousLaw law : {SimultaneousLaw::reflections, SimultaneousLaw::sequential}) {
      const BodyKinetics box = after_impact(before, law, c.law).of(1);
      // The references have six decimals.
      EXPECT_NEAR(box.v.x(), c.after.x(), 1e-6) << c.angle << " " << static_cast<int>(c.law);
      EXPECT_NEAR(box.v.z(), c.after.y(), 1e-6) << c.angle << " " << static_cast<int>(c.law);
      EXPECT_NEAR(box.w.y(), c.after.z(), 1e-6) << c.angle << " " << static_cast<int>(c.law);
      EXPECT_LE(Vec3(box.v.y(), box.w.x(), box.w.z()).norm(), 1e-13);
    }
  }
}

// The same box under `lcp`: Newton's restitution with one Coulomb check on the total impulse.
TEST(SingleCollision, LawOfAllContactsAtOnceTakesAPatchPointByPoint) {
  const Mat3 R = rotation_matrix(rotation_exp(M_PI / 6 * Vec3::UnitY()));
  const ContactSystem before = box_on_floor(Vec3(0.5, 0.1, 0.02), R, Vec3(-1, 0, -2), Vec3::Zero(), 0.3, 0.5);
  const BodyKinetics box = after_impact(before, SimultaneousLaw::lcp).of(1);
  EXPECT_NEAR(box.v.x(), -1.230132, 1e-6);
  EXPECT_NEAR(box.v.z(), -0.946583, 1e-6);
  EXPECT_NEAR(box.w.y(), -4.601713, 1e-6);
}

// A box slides as it lands flat: friction μ (1 + e) |v_z| at the floor. The load moves to the front by μ
// times the height of the centre, so that the box does not turn.
TEST(SingleCollision, BoxThatLandsFlatAndSlidesDoesNotTurn) {
  const double mu = 0.3, e = 0.6;
  const ContactSystem before =
      box_on_floor(Vec3(0.2, 0.3, 0.1), Mat3::Identity(), Vec3(3, 2, -1), Vec3::Zero(), mu, e);
  ASSERT_EQ(before.contacts.size(), 4u);
  for (const RestitutionLaw law :
       {RestitutionLaw::newton, RestitutionLaw::poisson, RestitutionLaw::stronge}) {
    const BodyKinetics box = after_impact(before, SimultaneousLaw::reflections, law).of(1);
    const Vec3 expected = Vec3(3, 2, 0) - mu * (1 + e) * Vec3(3, 2, 0).normalized() + e * Vec3::UnitZ();
    EXPECT_LE((box.v - expected).norm(), 1e-13);
    EXPECT_LE(box.w.norm(), 1e-12);
  }
}

// The impulses of a patch are those of one contact at its centre of pressure, whatever the number of points.
TEST(SingleCollision, PatchActsLikeOneContactAtItsCentreOfPressure) {
  const Mat3 R = rotation_matrix(rotation_exp(0.5 * Vec3::UnitY()));
  const ContactSystem edge =
      box_on_floor(Vec3(0.4, 0.2, 0.1), R, Vec3(0.4, 0, -1), Vec3(0, 0.5, 0), 0.4, 0.7);
  ASSERT_EQ(edge.contacts.size(), 2u);
  const Vec3 middle = 0.5 * (edge.contacts[0].p_W() + edge.contacts[1].p_W());
  const ContactSystem point =
      make_contact_system({contact_at(0, 1, middle, Vec3::UnitZ(), 0.4, 0.7)}, {0, 1}, edge.kinetics);
  const BodyKinetics a = after_impact(edge, SimultaneousLaw::reflections, RestitutionLaw::stronge).of(1);
  const BodyKinetics b = after_impact(point, SimultaneousLaw::reflections, RestitutionLaw::stronge).of(1);
  EXPECT_LE((a.v - b.v).norm() + (a.w - b.w).norm(), 1e-13);
}

/// A box on its way to an edge, with both points in contact.
ContactSystem box_on_edge() {
  const Mat3 R = rotation_matrix(rotation_exp(0.5 * Vec3::UnitY()));
  return box_on_floor(Vec3(0.4, 0.2, 0.1), R, Vec3(0.4, 0.2, -1), Vec3(0, 0.5, 0), 0.4, 0.7);
}

TEST(SingleCollision, PatchMayBeToldFromEitherBody) {
  const ContactSystem told = box_on_edge();
  std::vector<Contact> contacts = told.contacts;
  contacts[1] = contact_at(1, 0, contacts[1].p_W(), -contacts[1].point.n_W, 0.4, 0.7);
  const ContactSystem retold = make_contact_system(contacts, {0, 1}, told.kinetics);
  const auto box_after = [](const ContactSystem& system) {
    return after_impact(system, SimultaneousLaw::reflections, RestitutionLaw::stronge).of(1);
  };
  EXPECT_TRUE(find_single_collision(make_impact_problem(retold, {0.7, 0.7}), RestitutionLaw::stronge));
  EXPECT_LE((box_after(told).v - box_after(retold).v).norm(), 1e-13);
  EXPECT_LE((box_after(told).w - box_after(retold).w).norm(), 1e-13);
}

TEST(SingleCollision, PointsOfDifferentMaterialsAreSeveralImpacts) {
  for (const bool changes_friction : {true, false}) {
    ContactSystem system = box_on_edge();
    (changes_friction ? system.contacts[1].friction : system.contacts[1].restitution) += 0.1;
    EXPECT_FALSE(
        find_single_collision(make_impact_problem(system, restitutions_of(system)), RestitutionLaw::stronge));
  }
}

TEST(SingleCollision, LoneContactCollidesByItsOwnLawUnderEveryLawForSeveral) {
  const ContactSystem edge = box_on_edge();
  const ContactSystem corner = make_contact_system({edge.contacts[0]}, {0, 1}, edge.kinetics);
  for (const RestitutionLaw law : {RestitutionLaw::newton, RestitutionLaw::stronge}) {
    const CollisionOutcome expected =
        resolve_collision({{delassus(corner), 0.4}, relative_velocities(corner), 0.7}, law);
    for (const SimultaneousLaw several :
         {SimultaneousLaw::reflections, SimultaneousLaw::lcp, SimultaneousLaw::sequential}) {
      const ImpactSolution found = solve_impact(corner, {0.7}, law, several);
      EXPECT_EQ(found.lambda, VecX(expected.end.lambda));
      EXPECT_EQ(found.phases, expected.phases);
    }
  }
}

// An edge that lands in a sequence of impacts is still one collision: beside it a ball meets the floor
// faster.
TEST(SingleCollision, EdgeWithinASequenceCollidesOnce) {
  const ContactSystem alone = box_on_edge();
  std::vector<Contact> contacts = alone.contacts;
  contacts.push_back(contact_at(0, 2, Vec3(9, 0, 0), Vec3::UnitZ(), 0.4, 0.7));
  std::vector<BodyKinetics> kinetics = alone.kinetics;
  kinetics.push_back(ball(1, Vec3(9, 0, 1), Vec3(0, 0, -5)));
  const ContactSystem both = make_contact_system(contacts, {0, 1, 2}, kinetics);
  const BodyKinetics a = after_impact(alone, SimultaneousLaw::sequential, RestitutionLaw::stronge).of(1);
  const BodyKinetics b = after_impact(both, SimultaneousLaw::sequential, RestitutionLaw::stronge).of(1);
  EXPECT_LE((a.v - b.v).norm() + (a.w - b.w).norm(), 1e-14);
}

// One collision knows no friction against spin; the points of a flat face do: they are several impacts.
TEST(SingleCollision, SpinningBoxThatLandsFlatLosesSpinToFriction) {
  const ContactSystem before =
      box_on_floor(Vec3(0.3, 0.2, 0.1), Mat3::Identity(), Vec3(0, 0, -1), Vec3(0, 0, 4), 0.2, 0.5);
  EXPECT_FALSE(
      find_single_collision(make_impact_problem(before, restitutions_of(before)), RestitutionLaw::stronge));
  const BodyKinetics box = after_impact(before).of(1);
  // Four corners at distance r with λ_n = (1 + e) m |v_z| / 4 each, friction across r: Δω = -μ (1 + e) r /
  // I_z.
  const double r = std::hypot(0.3, 0.2), I_z = (0.09 + 0.04) / 3;
  EXPECT_NEAR(box.w.z(), 4 - 0.2 * 1.5 * r / I_z, 1e-12);
  EXPECT_NEAR(box.v.z(), 0.5, 1e-13);
}

// Of several touching contacts only one is loaded, and its collision makes no other approach: that is all.
TEST(SingleCollision, LoadedContactAmongIdleOnesCollidesAlone) {
  const Mat3 I = Vec3(1, 2, 2.5).asDiagonal();
  const BodyKinetics rod = body(1, Vec3(0, 0, 1), Vec3(-1, 0.3, -2), Vec3(0.2, 0.1, 0), I);
  const Contact loaded = contact_at(0, 1, Vec3(0.4, 0, 0), Vec3::UnitZ(), 0.3, 0.6);
  const Contact idle = contact_at(1, 2, Vec3(0, 0, 2), Vec3::UnitZ(), 0.3, 0.6);
  const ContactSystem alone = make_contact_system({loaded}, {0, 1}, {BodyKinetics{}, rod});
  const ContactSystem both = make_contact_system(
      {idle, loaded}, {0, 1, 2}, {BodyKinetics{}, rod, ball(1, Vec3(0, 0, 3), Vec3(0, 0, 5))});
  for (const SimultaneousLaw law : {SimultaneousLaw::reflections, SimultaneousLaw::sequential}) {
    const BodyKinetics a = after_impact(alone, law, RestitutionLaw::stronge).of(1);
    const ContactSystem after = after_impact(both, law, RestitutionLaw::stronge);
    EXPECT_EQ(after.of(1).v, a.v);
    EXPECT_EQ(after.of(1).w, a.w);
    EXPECT_EQ(after.of(2).v, both.of(2).v);
  }
}

}  // namespace
}  // namespace rigor::test::single_collision_test
