// Several impacts as a projection on velocities: over random systems it is what the complementarity problem
// says, the nearest of what the contacts allow, and gains what its formula says; after Moreau it gains
// nothing.

#include "rigor/contact/impact/velocity_projection.hpp"
#include "contact/impact_systems.hpp"
#include "rigor/contact/impact/newton_impacts.hpp"
#include "rigor/contact/impact/reflections.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace rigor::test::velocity_projection_test {
namespace {

constexpr int kSystems = 500;

/// A system with the problem of its contacts.
struct Instant {
  ContactSystem system;
  ImpactProblem problem;
};

Instant instant_of(const ContactSystem& system) {
  return {system, make_impact_problem(system, restitutions_of(system))};
}

/// The bound max(0, -e u_n⁻) of a contact.
double bound_of(const ImpactProblem& problem, std::size_t i) {
  return std::max(0.0, -problem.contacts[i].restitution * normal_velocity(problem.u, i));
}

double largest_speed(const VecX& u) {
  return u.cwiseAbs().maxCoeff();
}

/// A cube of 2 m that comes down on its four lower corners, moving and turning at random: three normal rows
/// of the four are independent.
ContactSystem cube_on_four_corners(Random& random, double e) {
  const Mat3 inertia = 2.0 / 3 * Mat3::Identity();
  std::vector<Contact> contacts;
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0})
      contacts.push_back(contact_at(0, 1, Vec3(x, y, 0), Vec3::UnitZ(), 0, e));
  return make_contact_system(contacts, {0, 1},
                             {BodyKinetics{}, body(1, Vec3::UnitZ(), random.vector() - 1.5 * Vec3::UnitZ(),
                                                   0.7 * random.vector(), inertia)});
}

void expect_kkt(const Instant& instant, const VecX& lambda) {
  const auto& [system, problem] = instant;
  const VecX u = problem.u + problem.A * lambda;
  const double speed = largest_speed(problem.u), size = lambda.cwiseAbs().maxCoeff();
  for (std::size_t i = 0; i < problem.count(); ++i) {
    const double pressure = lambda[row_of(i) + 2], slack = normal_velocity(u, i) - bound_of(problem, i);
    EXPECT_GE(slack, -1e-11 * speed);
    EXPECT_GE(pressure, 0);
    EXPECT_LE(std::min(pressure / std::max(size, 1e-300), slack / speed), 1e-11);
  }
}

TEST(VelocityProjection, WithoutFrictionItIsTheVelocityOfTheComplementarityProblem) {
  Random random(11);
  for (int k = 0; k < kSystems; ++k) {
    const Instant instant = instant_of(k % 3 ? random_system(random, 0)
                                             : cube_on_four_corners(random, 0.5 + 0.5 * random.number()));
    const ImpactSolution projection = solve_projection(instant.system, instant.problem);
    const ImpactSolution lcp = solve_newton_impacts(instant.problem);
    ASSERT_TRUE(projection.converged) << k;
    expect_kkt(instant, projection.lambda);
    const VecX difference = instant.problem.A * (projection.lambda - lcp.lambda);
    EXPECT_LE(largest_speed(difference), 1e-10 * largest_speed(instant.problem.u)) << k;
  }
}

TEST(VelocityProjection, RedundantContactsShareWithLeastNorm) {
  Random random(12);
  ContactSystem system = cube_on_four_corners(random, 0.25);
  system.of(1).v = Vec3(0.3, -0.1, -2);
  system.of(1).w = Vec3::Zero();
  const Instant instant = instant_of(system);
  const ImpactSolution projection = solve_projection(instant.system, instant.problem);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(projection.lambda[row_of(i) + 2], 1.25 * 2 / 4, 1e-14);
}

// (V⁺ - V⁻)ᵀ M (V - V⁺) ≥ 0 for every V that the contacts allow: here other projections, e = 0.
TEST(VelocityProjection, NothingThatTheContactsAllowIsNearer) {
  Random random(13);
  for (int k = 0; k < kSystems; ++k) {
    ContactSystem system = random_system(random, 0);
    const std::vector<double> plastic(system.contacts.size(), 0.0);
    const ImpactProblem problem = make_impact_problem(system, plastic);
    const VecX lambda = solve_projection(system, problem).lambda;
    ContactSystem nearest = system;
    apply_impulses(lambda, nearest);
    ContactSystem other = system;
    for (BodyKinetics& body : other.kinetics) {
      if (body.inverse_mass == 0) continue;
      body.v = random.vector();
      body.w = random.vector();
    }
    apply_impulses(solve_projection(other, make_impact_problem(other, plastic)).lambda, other);
    double product = 0;
    for (std::size_t i = 0; i < system.kinetics.size(); ++i) {
      const BodyKinetics &before = system.kinetics[i], &after = nearest.kinetics[i], &V = other.kinetics[i];
      if (before.inverse_mass == 0) continue;
      product += (after.v - before.v).dot(V.v - after.v) / before.inverse_mass;
      product += (after.w - before.w).dot(before.inertia * (V.w - after.w));
    }
    EXPECT_GE(product, -1e-11 * (kinetic_energy(system) + kinetic_energy(other))) << k;
  }
}

// ½ λ_n u_n⁻ of what was parting and is pressed, -½ (1 - e) λ_n |u_n⁻| of what approached.
TEST(VelocityProjection, GainsWhatPartingContactsThatArePressedAdd) {
  Random random(14);
  int gains = 0;
  for (int k = 0; k < kSystems; ++k) {
    const Instant instant = instant_of(random_system(random, 0));
    const ImpactProblem& problem = instant.problem;
    const VecX lambda = solve_projection(instant.system, problem).lambda;
    double expected = 0;
    for (std::size_t i = 0; i < problem.count(); ++i) {
      const double before = normal_velocity(problem.u, i), pressure = lambda[row_of(i) + 2];
      const double e = problem.contacts[i].restitution;
      expected += 0.5 * pressure * (before > 0 ? before : (1 - e) * before);
    }
    ContactSystem after = instant.system;
    apply_impulses(lambda, after);
    const double energy = kinetic_energy(instant.system), change = kinetic_energy(after) - energy;
    EXPECT_NEAR(change, expected, 1e-11 * energy) << k;
    if (change > 1e-6 * energy) ++gains;
  }
  // The laws' table: about one in fifty.
  EXPECT_GE(gains, 3);
}

TEST(VelocityProjection, WithFrictionItObeysCoulombsLaw) {
  Random random(15);
  int solved = 0;
  for (int k = 0; k < kSystems; ++k) {
    const Instant instant = instant_of(random_system(random, 1));
    const ImpactProblem& problem = instant.problem;
    const ImpactSolution projection = solve_projection(instant.system, problem);
    if (!projection.converged) continue;
    ++solved;
    VecX w = problem.u + problem.A * projection.lambda;
    for (std::size_t i = 0; i < problem.count(); ++i) {
      w[row_of(i) + 2] -= bound_of(problem, i);
      const Vec3 force = projection.lambda.segment<3>(row_of(i)), motion = w.segment<3>(row_of(i));
      const double mu = problem.contacts[i].mu, speed = largest_speed(problem.u);
      EXPECT_GE(motion.z(), -1e-9 * speed);
      EXPECT_LE(force.head<2>().norm(), mu * force.z() * (1 + 1e-12));
      // Against the slip, and as much as there can be where it slips.
      const double missing = force.head<2>().dot(motion.head<2>()) + mu * force.z() * motion.head<2>().norm();
      EXPECT_NEAR(missing, 0, 1e-9 * speed * projection.lambda.cwiseAbs().maxCoeff()) << k;
    }
  }
  EXPECT_GE(solved, kSystems * 99 / 100);
}

/// P V⁻: the plastic impact without friction.
VecX plastic_impulses(const Instant& instant) {
  ImpactProblem plastic = instant.problem;
  for (ImpactContact& contact : plastic.contacts) contact.restitution = 0;
  return solve_projection(instant.system, plastic).lambda;
}

// V⁺ = V⁻ + (1 + e) (P V⁻ - V⁻), with ΔT = -(1 - e²) D, wherever that makes no contact approach.
TEST(MoreauProjection, GoesBeyondTheProjectionByRestitution) {
  Random random(16);
  int compared = 0;
  for (int k = 0; k < kSystems; ++k) {
    ContactSystem system = k % 3 ? random_system(random, 0) : cube_on_four_corners(random, 0);
    const double e = 0.5 + 0.5 * random.number();
    for (Contact& contact : system.contacts) contact.restitution = e;
    const Instant instant = instant_of(system);
    const ImpactProblem& problem = instant.problem;
    const VecX plastic = plastic_impulses(instant);
    const VecX reflected = problem.u + 2 * (problem.A * plastic);
    if (fastest_approach(reflected) > 1e-13 * largest_speed(problem.u)) continue;
    ++compared;
    const ImpactSolution moreau = solve_moreau(system, problem);
    const VecX difference = problem.A * (moreau.lambda - (1 + e) * plastic);
    EXPECT_LE(largest_speed(difference), 1e-10 * largest_speed(problem.u)) << k;
    EXPECT_NEAR(energy_change(problem, moreau.lambda), (1 - e * e) * energy_change(problem, plastic),
                1e-11 * kinetic_energy(system))
        << k;
  }
  EXPECT_GE(compared, kSystems / 2);
}

TEST(MoreauProjection, NeverGainsEnergyAndLeavesNothingApproaching) {
  Random random(17);
  for (const double mu_max : {0.0, 0.5, 1.0, 2.0}) {
    for (int k = 0; k < kSystems; ++k) {
      const Instant instant = instant_of(random_system(random, mu_max));
      const ImpactProblem& problem = instant.problem;
      const ImpactSolution moreau = solve_moreau(instant.system, problem);
      EXPECT_LE(energy_change(problem, moreau.lambda), 1e-13 * kinetic_energy(instant.system)) << mu_max << k;
      const VecX u = problem.u + problem.A * moreau.lambda;
      EXPECT_LE(fastest_approach(u), 1e-9 * largest_speed(problem.u)) << mu_max << " " << k;
      for (std::size_t i = 0; i < problem.count(); ++i) {
        const Vec3 force = moreau.lambda.segment<3>(row_of(i));
        EXPECT_LE(force.head<2>().norm(),
                  problem.contacts[i].mu * force.z() + 1e-12 * moreau.lambda.cwiseAbs().maxCoeff());
      }
    }
  }
}

// The catalogue's light ball between heavy ones, of which the right one runs off.
TEST(MoreauProjection, KeepsTheEnergyWhereTheProjectionGains) {
  const ContactSystem before = chain({10, 10.0 / 9, 10}, {1, 0, 0.5}, 1);
  const double energy = kinetic_energy(before);
  EXPECT_NEAR(kinetic_energy(after_impact(before, SimultaneousLaw::projection)) / energy, 605.0 / 475, 1e-14);
  EXPECT_NEAR(kinetic_energy(after_impact(before, SimultaneousLaw::moreau)) / energy, 1, 1e-14);
}

TEST(MoreauProjection, IsThePlasticImpactWithoutRestitution) {
  const ContactSystem before = chain({1, 2, 3}, {1, 0, -1}, 0);
  const ContactSystem after = after_impact(before, SimultaneousLaw::moreau);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(after.of(i).v.x(), -2.0 / 6, 1e-15);
}

}  // namespace
}  // namespace rigor::test::velocity_projection_test
