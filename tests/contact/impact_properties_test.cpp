// What holds for any impact of any bodies, on random systems.

#include "contact/impact_systems.hpp"
#include "rigor/contact/impact/sequential_impacts.hpp"
#include "rigor/math/rotation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rigor::test::impact_properties_test {
namespace {

const SimultaneousLaw kAllLaws[] = {SimultaneousLaw::reflections, SimultaneousLaw::lcp,
                                    SimultaneousLaw::sequential};

/// |P|, |L| sums to compare rounding with.
double momentum_scale(const ContactSystem& system, const VecX& lambda) {
  double scale = lambda.cwiseAbs().sum();
  for (const BodyKinetics& k : system.kinetics) {
    if (k.inverse_mass > 0) scale += k.v.norm() / k.inverse_mass + (k.inertia * k.w).norm();
  }
  return scale;
}

bool has_fixed_body(const ContactSystem& system) {
  return std::any_of(system.kinetics.begin(), system.kinetics.end(),
                     [](const BodyKinetics& k) { return k.inverse_mass == 0; });
}

void expect_impulses_in_cones(const ContactSystem& system, const VecX& lambda) {
  const double rounding = 1e-14 * lambda.norm();
  for (std::size_t i = 0; i < system.contacts.size(); ++i) {
    const Vec3 impulse = lambda.segment<3>(row_of(i));
    EXPECT_GE(impulse.z(), -rounding);
    EXPECT_LE(impulse.head<2>().norm(), system.contacts[i].friction * impulse.z() + rounding);
  }
}

class RandomImpacts : public testing::TestWithParam<int> {};

// 10000 systems of 2 to 8 contacts.
TEST_P(RandomImpacts, AreAdmissible) {
  Random random(static_cast<unsigned>(GetParam()));
  int unsolved = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const ContactSystem before = random_system(random, trial % 4 == 0 ? 0.0 : 1.0);
    const VecX u = relative_velocities(before);
    for (const SimultaneousLaw law : kAllLaws) {
      const ImpactSolution impact =
          solve_impact(before, restitutions_of(before), RestitutionLaw::stronge, law);
      unsolved += impact.converged ? 0 : 1;
      ContactSystem after = before;
      apply_impulses(impact.lambda, after);

      const double scale = momentum_scale(before, impact.lambda);
      if (!has_fixed_body(before)) {
        // The arms of the momentum are up to ten times the unit of length.
        EXPECT_LE((totals(after).P - totals(before).P).norm(), 1e-14 * scale) << trial;
        EXPECT_LE((totals(after).L - totals(before).L).norm(), 1e-13 * scale) << trial;
      }
      EXPECT_LE(fastest_approach(relative_velocities(after)), 1e-10 * u.norm()) << trial;
      expect_impulses_in_cones(before, impact.lambda);
      if (law != SimultaneousLaw::lcp) {
        EXPECT_LE(kinetic_energy(after), kinetic_energy(before) * (1 + 1e-12)) << trial;
      }
    }
  }
  // About one in ten thousand meets a cone problem that is not solved; what is promised holds then, too.
  EXPECT_LE(unsolved, 1);
}

INSTANTIATE_TEST_SUITE_P(TenSeeds, RandomImpacts, testing::Range(1, 11));

/// The same system told differently: contacts in another order, every other one seen from its other body,
/// bodies under other numbers, and all of it turned or mirrored by Q (orthogonal).
ContactSystem retold(const ContactSystem& system, const std::vector<int>& names, const Mat3& Q) {
  const auto axial = [&Q](const Vec3& w) { return Vec3(Q.determinant() * (Q * w)); };
  std::vector<BodyKinetics> kinetics(system.bodies.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    BodyKinetics moved = system.kinetics[i];
    moved.x = Q * moved.x;
    moved.v = Q * moved.v;
    moved.w = axial(moved.w);
    moved.inertia = Q * moved.inertia * Q.transpose();
    moved.inverse_inertia = Q * moved.inverse_inertia * Q.transpose();
    kinetics[static_cast<std::size_t>(names[i])] = moved;
  }
  std::vector<Contact> contacts;
  for (const Contact& contact : system.contacts) {
    const int A = names[static_cast<std::size_t>(contact.body_A)],
              B = names[static_cast<std::size_t>(contact.body_B)];
    const Vec3 p = Q * contact.p_W(), n = Q * contact.point.n_W;
    contacts.insert(contacts.begin(), contacts.size() % 2 == 0
                                          ? contact_at(A, B, p, n, contact.friction, contact.restitution)
                                          : contact_at(B, A, p, -n, contact.friction, contact.restitution));
  }
  return make_contact_system(contacts, system.bodies, kinetics);
}

/// Largest difference of velocities between a system and the retold one.
double difference(const ContactSystem& system, const ContactSystem& other, const std::vector<int>& names,
                  const Mat3& Q) {
  double largest = 0;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const BodyKinetics& a = system.kinetics[i];
    const BodyKinetics& b = other.kinetics[static_cast<std::size_t>(names[i])];
    largest = std::max({largest, (Q * a.v - b.v).norm(), (Q.determinant() * (Q * a.w) - b.w).norm()});
  }
  return largest;
}

TEST(ImpactSymmetry, NeitherOrderNorNamesNorRotationNorMirrorsMatter) {
  Random random(31);
  for (int trial = 0; trial < 400; ++trial) {
    const ContactSystem before = random_system(random, trial % 2 == 0 ? 0.0 : 0.6);
    std::vector<int> names(before.bodies.size());
    std::iota(names.rbegin(), names.rend(), 0);
    std::swap(names.front(), names[names.size() / 2]);
    Mat3 Q = Mat3::Identity();
    if (trial % 3 == 1) Q = rotation_matrix(rotation_exp(3 * random.vector()));
    if (trial % 3 == 2) Q = Vec3(-1, 1, 1).asDiagonal();
    for (const SimultaneousLaw law : kAllLaws) {
      const ContactSystem after = after_impact(before, law, RestitutionLaw::stronge);
      const ContactSystem other = after_impact(retold(before, names, Q), law, RestitutionLaw::stronge);
      // Speeds are near 1, masses of 0.1 and lever arms make some of them 100: rounding times condition, in a
      // sequence once for each of its impacts, of which there can be hundreds.
      const int impacts = law == SimultaneousLaw::sequential
                              ? solve_sequential_impacts(make_impact_problem(before, restitutions_of(before)),
                                                         RestitutionLaw::stronge)
                                    .iterations
                              : 1;
      EXPECT_LE(difference(after, other, names, Q), 1e-12 * std::max(1, impacts))
          << trial << " " << static_cast<int>(law);
    }
  }
}

// A break of three against one, mirrored in the plane of symmetry: the same on both sides.
TEST(ImpactSymmetry, MirrorSymmetricBodiesStaySo) {
  const double s = std::sqrt(0.75);
  for (const double mu : {0.0, 0.3}) {
    std::vector<Contact> contacts;
    const Vec3 centres[] = {Vec3(0, 0, 0), Vec3(2 * s, 1, 0), Vec3(2 * s, -1, 0), Vec3(-2, 0, 0)};
    for (const auto& [a, b] : {std::pair{3, 0}, std::pair{0, 1}, std::pair{0, 2}, std::pair{1, 2}}) {
      contacts.push_back(
          contact_at(a, b, 0.5 * (centres[a] + centres[b]), 0.5 * (centres[b] - centres[a]), mu, 0.9));
    }
    std::vector<BodyKinetics> kinetics;
    for (const Vec3& x : centres) kinetics.push_back(ball(1, x, Vec3::Zero()));
    kinetics[3].v = Vec3(1, 0, 0);
    for (const SimultaneousLaw law : kAllLaws) {
      const ContactSystem after = after_impact(make_contact_system(contacts, {0, 1, 2, 3}, kinetics), law);
      const Mat3 mirror = Vec3(1, -1, 1).asDiagonal();
      EXPECT_LE((after.of(1).v - mirror * after.of(2).v).norm(), 1e-14);
      EXPECT_LE((after.of(1).w + mirror * after.of(2).w).norm(), 1e-14);
    }
  }
}

}  // namespace
}  // namespace rigor::test::impact_properties_test
