// Several impacts at one instant: known answers of the three laws.

#include "contact/impact_systems.hpp"
#include "rigor/contact/impact/newton_impacts.hpp"
#include "rigor/contact/impact/reflections.hpp"
#include "rigor/contact/impact/sequential_impacts.hpp"
#include "rigor/math/rotation.hpp"
#include "solver/reference_data.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

namespace rigor::test::simultaneous_impacts_test {
namespace {

const std::map<std::string, SimultaneousLaw> kLaws = {{"reflections", SimultaneousLaw::reflections},
                                                      {"lcp", SimultaneousLaw::lcp},
                                                      {"sequential", SimultaneousLaw::sequential}};

TEST(SimultaneousImpacts, TouchingChainsGoAsRationalArithmeticSays) {
  for (const nlohmann::json file = reference::read("multi_impact.json");
       const nlohmann::json& c : file["cases"]) {
    const ContactSystem before = chain(c["masses"], c["v"], c["e"]);
    for (const auto& [name, law] : kLaws) {
      const ContactSystem after = after_impact(before, law);
      for (int i = 0; i < static_cast<int>(before.bodies.size()); ++i) {
        // A few roundings of numbers near 1; a sequence ends where the approach is a 1e-13 of the speeds.
        EXPECT_NEAR(after.of(i).v.x(), c[name][static_cast<std::size_t>(i)].get<double>(), 2e-13)
            << c["name"] << " " << name << " " << i;
      }
    }
    const ContactSystem projected = after_impact(before, SimultaneousLaw::projection);
    for (int i = 0; i < static_cast<int>(before.bodies.size()); ++i)
      EXPECT_NEAR(projected.of(i).v.x(), c["lcp"][static_cast<std::size_t>(i)].get<double>(), 2e-13)
          << c["name"] << " projection " << i;
    const double ratio = kinetic_energy(after_impact(before, SimultaneousLaw::lcp)) / kinetic_energy(before);
    EXPECT_NEAR(ratio, c["lcp_energy_ratio"].get<double>(), 1e-14) << c["name"];
  }
}

// A light ball between two heavy ones of which the right one already runs off: Newton's law on both contacts
// at once holds it to u_n⁺ ≥ 0 there and so gains 27 %.
TEST(SimultaneousImpacts, NewtonsLawOnAllContactsGainsEnergyWhereAPartingContactIsPressed) {
  const ContactSystem before = chain({10, 10.0 / 9, 10}, {1, 0, 0.5}, 1);
  const ContactSystem after = after_impact(before, SimultaneousLaw::lcp);
  EXPECT_NEAR(kinetic_energy(after) / kinetic_energy(before), 1.273684210526, 1e-12);
  EXPECT_NEAR(kinetic_energy(after_impact(before)) / kinetic_energy(before), 1, 1e-14);
}

// Huygens: unlike masses and speeds, e = 1, off centre. Without friction the velocities change along the
// normal only, by the 1-D law.
TEST(SimultaneousImpacts, TwoBallsThatMeetObliquelyKeepMomentumAndEnergy) {
  const Vec3 n = Vec3(1, 2, -1).normalized();
  for (const double mass : {1.0, 3.0}) {
    const ContactSystem before =
        make_contact_system({contact_at(0, 1, n, n, 0, 1)}, {0, 1},
                            {ball(1, Vec3::Zero(), Vec3(0.7, 0.4, 0.2)), ball(mass, 2 * n, Vec3::Zero())});
    const ContactSystem after = after_impact(before);
    const Vec3 struck = 2 / (1 + mass) * n.dot(Vec3(0.7, 0.4, 0.2)) * n;
    EXPECT_LE((after.of(1).v - struck).norm(), 1e-15);
    EXPECT_LE((totals(after).P - totals(before).P).norm(), 1e-15);
    EXPECT_NEAR(kinetic_energy(after), kinetic_energy(before), 1e-15);
    // Equal masses part at a right angle.
    if (mass == 1) {
      EXPECT_NEAR(after.of(0).v.dot(after.of(1).v), 0, 1e-15);
    }
  }
}

/// A ball that comes down at 1 m/s between two touching balls, seen from which it stands at ±30 degrees.
ContactSystem ball_on_two(bool has_floor) {
  const double height = std::sqrt(3.0);
  const Vec3 left(-1, 0, 0), right(1, 0, 0), top(0, 0, height);
  std::vector<Contact> contacts = {contact_at(1, 3, 0.5 * (left + top), (top - left) / 2, 0, 1),
                                   contact_at(2, 3, 0.5 * (right + top), (top - right) / 2, 0, 1),
                                   contact_at(1, 2, Vec3::Zero(), Vec3::UnitX(), 0, 1)};
  if (has_floor) {
    contacts.push_back(contact_at(0, 1, left - Vec3::UnitZ(), Vec3::UnitZ(), 0, 1));
    contacts.push_back(contact_at(0, 2, right - Vec3::UnitZ(), Vec3::UnitZ(), 0, 1));
  }
  return make_contact_system(contacts, {0, 1, 2, 3},
                             {BodyKinetics{}, ball(1, left, Vec3::Zero()), ball(1, right, Vec3::Zero()),
                              ball(1, top, Vec3(0, 0, -1))});
}

// Bernoulli: j = 1/(3/2 + ...) by symmetry; the striker goes back at 1/5, the others leave at 2√3/5.
TEST(SimultaneousImpacts, BallThatMeetsTwoAtOnceGoesBackAtAFifth) {
  const ContactSystem after = after_impact(ball_on_two(false));
  EXPECT_LE((after.of(3).v - Vec3(0, 0, 0.2)).norm(), 1e-15);
  EXPECT_NEAR(after.of(1).v.norm(), 2 * std::sqrt(3.0) / 5, 1e-15);
  EXPECT_LE((after.of(2).v - 2 * std::sqrt(3.0) / 5 * Vec3(0.5, 0, -std::sqrt(0.75))).norm(), 1e-15);
}

/// The system turned by R.
ContactSystem turned(const ContactSystem& system, const Mat3& R) {
  ContactSystem result = system;
  for (BodyKinetics& k : result.kinetics) {
    k.x = R * k.x;
    k.v = R * k.v;
    k.w = R * k.w;
  }
  for (Contact& contact : result.contacts) {
    contact = contact_at(contact.body_A, contact.body_B, R * contact.p_W(), R * contact.point.n_W,
                         contact.friction, contact.restitution);
  }
  return make_contact_system(result.contacts, result.bodies, result.kinetics);
}

// Contacts that close equally fast but for rounding are one impact for the sequence, too.
TEST(SimultaneousImpacts, SequenceTakesTiesTogetherHoweverTheyAreRounded) {
  Random random(8);
  for (int trial = 0; trial < 50; ++trial) {
    const Mat3 R = rotation_matrix(rotation_exp(3 * random.vector()));
    const ContactSystem after = after_impact(turned(ball_on_two(false), R), SimultaneousLaw::sequential);
    EXPECT_LE((after.of(3).v - R * Vec3(0, 0, 0.2)).norm(), 1e-14) << trial;
  }
}

// On a floor three reflections follow one another: at the striker (1/5, down at 3/5), at the floor (up at
// 3/5), at the striker again, which takes √3/10 more in u_n.
TEST(SimultaneousImpacts, BallThatFallsOnTwoRestingBallsGoesUpAtElevenTwentyFifths) {
  const ContactSystem after = after_impact(ball_on_two(true));
  EXPECT_LE((after.of(3).v - Vec3(0, 0, 11.0 / 25)).norm(), 2e-15);
  EXPECT_LE((after.of(2).v - Vec3(6 * std::sqrt(3.0) / 25, 0, 12.0 / 25)).norm(), 2e-15);
  EXPECT_LE((after.of(1).v - Vec3(-6 * std::sqrt(3.0) / 25, 0, 12.0 / 25)).norm(), 2e-15);
}

/// A cue ball that meets 15 touching balls in a triangle at 1 m/s: bodies 1, then 2 and 3, ... 11 to 15.
ContactSystem break_of_fifteen() {
  std::vector<BodyKinetics> kinetics{ball(1, Vec3(-2, 0, 0), Vec3(1, 0, 0))};
  for (int row = 0; row < 5; ++row) {
    for (int k = 0; k <= row; ++k)
      kinetics.push_back(ball(1, Vec3(row * std::sqrt(3.0), 2 * k - row, 0), Vec3::Zero()));
  }
  std::vector<Contact> contacts;
  std::vector<int> indices;
  for (int i = 0; i < 16; ++i) {
    indices.push_back(i);
    for (int k = 0; k < i; ++k) {
      const Vec3 &a = kinetics[static_cast<std::size_t>(k)].x, &b = kinetics[static_cast<std::size_t>(i)].x;
      if ((b - a).norm() < 2.001) contacts.push_back(contact_at(k, i, 0.5 * (a + b), 0.5 * (b - a), 0, 1));
    }
  }
  return make_contact_system(contacts, indices, kinetics);
}

// The numbers of docs/theory/simultaneous_impacts.md. All laws keep energy and momentum and the symmetry of
// the break; what the balls do differs.
TEST(SimultaneousImpacts, BreakOfFifteenBallsKeepsEnergyMomentumAndSymmetry) {
  const ContactSystem before = break_of_fifteen();
  const double cue[] = {-1.0 / 5, -27.0 / 35, -1.0 / 5}, corner[] = {0.590947, 0.197949, 0.692820};
  for (const auto& [name, law] : kLaws) {
    const ContactSystem after = after_impact(before, law);
    EXPECT_NEAR(kinetic_energy(after), 0.5, 1e-14) << name;
    EXPECT_LE((totals(after).P - Vec3(1, 0, 0)).norm(), 1e-14) << name;
    EXPECT_NEAR(after.of(0).v.x(), cue[static_cast<int>(law)], 1e-14) << name;
    for (const int side : {11, 15}) EXPECT_NEAR(after.of(side).v.norm(), corner[static_cast<int>(law)], 1e-6);
    EXPECT_LE((after.of(11).v - Vec3(1, -1, 1).cwiseProduct(after.of(15).v)).norm(), 1e-13) << name;
  }
}

// Two touching balls at rest, struck by a third: elastic between the first two and plastic between the last
// two gives (0, ½, ½). The other way round the only contact that closes is plastic: no energy may come back.
TEST(SimultaneousImpacts, OnlyWhatAContactTookInCompressionCanComeBackThere) {
  ContactSystem chain_of_three = chain({1, 1, 1}, {1, 0, 0}, 1);
  chain_of_three.contacts[1].restitution = 0;
  const ContactSystem elastic_first = after_impact(chain_of_three);
  EXPECT_LE(Vec3(elastic_first.of(0).v.x(), elastic_first.of(1).v.x() - 0.5, elastic_first.of(2).v.x() - 0.5)
                .norm(),
            1e-15);
  std::swap(chain_of_three.contacts[0].restitution, chain_of_three.contacts[1].restitution);
  const ContactSystem plastic_first = after_impact(chain_of_three);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(plastic_first.of(i).v.x(), 1.0 / 3, 1e-14);
}

// Where e goes to zero the reflections go over into the plastic impact with Coulomb's friction, without a
// jump.
TEST(SimultaneousImpacts, ReflectionsAreContinuousInTheRestitution) {
  Random random(4);
  for (int trial = 0; trial < 100; ++trial) {
    const ContactSystem system = random_system(random, 0.8);
    const std::vector<double> none(system.contacts.size(), 0.0), little(system.contacts.size(), 1e-9);
    const VecX plastic = solve_reflections(make_impact_problem(system, none)).lambda;
    const VecX nearly = solve_reflections(make_impact_problem(system, little)).lambda;
    EXPECT_LE((nearly - plastic).norm(), 1e-6 * (1 + plastic.norm())) << trial;
  }
}

// Galperin, Playing Pool with π: a ball between a wall and one 100ᵏ times as heavy makes 3, 31, 314, ...
// impacts.
TEST(SimultaneousImpacts, SequenceOfABallBetweenAWallAndAHeavyOneCountsTheDigitsOfPi) {
  for (const auto& [heavy, count] : {std::pair{1.0, 3}, std::pair{100.0, 31}, std::pair{10000.0, 314}}) {
    ContactSystem system = chain({1, 1, heavy}, {0, 0, -1}, 1);
    system.kinetics[0] = BodyKinetics{};
    const ImpactProblem problem = make_impact_problem(system, {1, 1});
    EXPECT_EQ(solve_sequential_impacts(problem, RestitutionLaw::newton).iterations, count);
    // Hundreds of reflections, each with the rounding of the heavy one's energy.
    EXPECT_LE(std::abs(energy_change(problem, generalised_reflections(problem))), 1e-11 * heavy);
  }
}

// A mass ratio of 1e10 would need 157080 impacts: both laws stop long before, and what still approaches ends
// there.
TEST(SimultaneousImpacts, EndlessSequencesEndInAPlasticImpact) {
  ContactSystem before = chain({1, 1, 1e10}, {0, 0, -1}, 1);
  before.kinetics[0] = BodyKinetics{};
  for (const SimultaneousLaw law : {SimultaneousLaw::reflections, SimultaneousLaw::sequential}) {
    const ContactSystem after = after_impact(before, law);
    // Impulses of 1e10 N s act on the ball of 1 kg from both sides: what is left of their rounding.
    EXPECT_LE(fastest_approach(relative_velocities(after)), 1e10 * 1e-15);
    EXPECT_LE(kinetic_energy(after), kinetic_energy(before) * (1 + 1e-12));
  }
}

// Bodies squeezed by others that do not give way: no impulses can help, and none are made up.
TEST(SimultaneousImpacts, SqueezedBallIsReportedAsUnsolvedAndGainsNoEnergy) {
  for (const double mu : {0.0, 0.4}) {
    ContactSystem system = chain({1, 1, 1}, {1, 0.3, -1}, 0.5);
    for (Contact& contact : system.contacts) contact.friction = mu;
    for (const std::size_t wall : {0u, 2u}) {
      system.kinetics[wall].inverse_mass = 0;
      system.kinetics[wall].inverse_inertia.setZero();
    }
    const ImpactProblem problem = make_impact_problem(system, {0.5, 0.5});
    const ImpactSolution impact = solve_reflections(problem);
    EXPECT_FALSE(impact.converged);
    EXPECT_TRUE(impact.lambda.allFinite());
    EXPECT_LE(energy_change(problem, impact.lambda), 1e-12);
  }
}

}  // namespace
}  // namespace rigor::test::simultaneous_impacts_test
