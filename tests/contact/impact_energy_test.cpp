// Restitution with an energy certificate: over random systems of several contacts the laws that promise it
// give back no energy, and Newton's law on all contacts at once does.

#include "contact/impact_systems.hpp"
#include "rigor/contact/impact/newton_impacts.hpp"
#include "rigor/contact/impact/reflections.hpp"
#include "rigor/contact/impact/sequential_impacts.hpp"
#include "rigor/contact/impact/velocity_projection.hpp"
#include "rigor/solver/coulomb/static_friction.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>

namespace rigor::test {
namespace {

constexpr int kSystems = 2000;

/// Of the random systems: how many gained energy, and the largest gain as a part of their kinetic energy.
struct Gains {
  int count = 0;
  double largest = 0;
};

using Impulses = std::function<VecX(const ContactSystem&, const ImpactProblem&)>;

/// `impulses`: of a system and its problem. A gain counts from a thousand roundings of the kinetic energy on.
Gains gains_of(double mu_max, const Impulses& impulses) {
  Gains gains;
  Random random(7);
  for (int k = 0; k < kSystems; ++k) {
    const ContactSystem system = random_system(random, mu_max);
    const ImpactProblem problem = make_impact_problem(system, restitutions_of(system));
    const double gain = energy_change(problem, impulses(system, problem)) / kinetic_energy(system);
    if (gain > 1e-13) ++gains.count;
    gains.largest = std::max(gains.largest, gain);
  }
  return gains;
}

/// The same of a law that needs the problem alone.
Gains gains_of(double mu_max, const std::function<VecX(const ImpactProblem&)>& impulses) {
  return gains_of(mu_max,
                  [&](const ContactSystem&, const ImpactProblem& problem) { return impulses(problem); });
}

/// Plastic impact where every contact that stands still sticks with twice its kinetic friction.
VecX plastic_with_static_friction(const ImpactProblem& problem) {
  StaticFriction friction{frictions(problem), frictions(problem), std::vector<bool>(problem.count(), true)};
  for (double& mu : friction.mu_static) mu *= 2;
  return solve_static_friction(
             friction,
             [&](const std::vector<double>& mu) { return solve_cones(problem.A.dense(), problem.u, mu); })
      .solution.lambda;
}

void record(const std::string& name, const Gains& gains) {
  testing::Test::RecordProperty(name + "_count", gains.count);
  testing::Test::RecordProperty(name + "_largest", std::to_string(gains.largest));
}

TEST(ImpactEnergy, NewtonsLawOnAllContactsAtOnceGains) {
  const auto newton = [](const ImpactProblem& problem) { return solve_newton_impacts(problem).lambda; };
  const Gains smooth = gains_of(0, newton), rough = gains_of(1, newton);
  record("smooth", smooth);
  record("rough", rough);
  // Not in every system, but in many, and by much.
  EXPECT_GT(smooth.count, kSystems / 100);
  EXPECT_GT(rough.count, kSystems / 100);
  EXPECT_GT(smooth.largest, 0.01);
  EXPECT_GT(rough.largest, 0.01);
}

TEST(ImpactEnergy, TheProjectionOnVelocitiesGainsAsMuchAsTheComplementarityProblem) {
  const Gains lcp =
      gains_of(0, [](const ImpactProblem& problem) { return solve_newton_impacts(problem).lambda; });
  const Gains projection = gains_of(0, [](const ContactSystem& system, const ImpactProblem& problem) {
    return solve_projection(system, problem).lambda;
  });
  EXPECT_EQ(projection.count, lcp.count);
  EXPECT_NEAR(projection.largest, lcp.largest, 1e-11);
}

TEST(ImpactEnergy, MoreausProjectionGainsNone) {
  for (const double mu_max : {0.0, 0.5, 1.0, 2.0}) {
    const Gains gains = gains_of(mu_max, [](const ContactSystem& system, const ImpactProblem& problem) {
      return solve_moreau(system, problem).lambda;
    });
    EXPECT_EQ(gains.count, 0) << mu_max << " " << gains.largest;
  }
}

TEST(ImpactEnergy, NewtonsLawOfOneContactAfterTheOtherGainsByFrictionAlone) {
  const auto newton = [](const ImpactProblem& problem) {
    return solve_sequential_impacts(problem, RestitutionLaw::newton).lambda;
  };
  EXPECT_EQ(gains_of(0, newton).count, 0);
  const Gains rough = gains_of(2, newton);
  record("rough", rough);
  EXPECT_GT(rough.count, 0);
}

TEST(ImpactEnergy, ReflectionsGainNone) {
  for (const double mu_max : {0.0, 0.5, 1.0, 2.0}) {
    const Gains gains =
        gains_of(mu_max, [](const ImpactProblem& problem) { return solve_reflections(problem).lambda; });
    EXPECT_EQ(gains.count, 0) << mu_max << " " << gains.largest;
  }
}

TEST(ImpactEnergy, TheSequenceOfStrongesCollisionsGainsNone) {
  for (const double mu_max : {0.0, 1.0, 2.0}) {
    const Gains gains = gains_of(mu_max, [](const ImpactProblem& problem) {
      return solve_sequential_impacts(problem, RestitutionLaw::stronge).lambda;
    });
    EXPECT_EQ(gains.count, 0) << mu_max << " " << gains.largest;
  }
}

TEST(ImpactEnergy, PlasticImpactsGainNoneWithMoreStaticThanKineticFriction) {
  for (const double mu_max : {0.5, 1.0}) {
    const Gains gains = gains_of(mu_max, plastic_with_static_friction);
    EXPECT_EQ(gains.count, 0) << mu_max << " " << gains.largest;
  }
}

}  // namespace
}  // namespace rigor::test
