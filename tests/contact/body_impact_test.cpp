// Impacts of whole bodies: from poses and velocities to velocities, through the contact system.

#include "contact/impact_systems.hpp"
#include "rigor/math/rotation.hpp"
#include "solver/reference_data.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>

namespace rigor::body_impact_test {
namespace {

BodyKinetics kinetics_of(const nlohmann::json& json) {
  BodyKinetics body;
  if (json.is_null()) return body;
  const double mass = json["mass"].get<double>();
  const Vec3 moments = reference::vector(json["moments"]);
  const VecX q = reference::vector(json["q"]);
  body.x = reference::vector(json["x"]);
  body.R = rotation_matrix(Quat(q[0], q[1], q[2], q[3]));
  body.v = reference::vector(json["v"]);
  body.w = reference::vector(json["w"]);
  body.inverse_mass = 1 / mass;
  body.inertia = body.R * moments.asDiagonal() * body.R.transpose();
  body.inverse_inertia = body.R * moments.cwiseInverse().asDiagonal() * body.R.transpose();
  return body;
}

void expect_near(const Vec3& found, const nlohmann::json& expected) {
  const Vec3 reference = reference::vector(expected);
  EXPECT_LT((found - reference).norm(), 1e-13 * (1 + reference.norm()));
}

TEST(BodyImpact, GivesTheVelocitiesOfTheReference) {
  constexpr std::array laws = {RestitutionLaw::newton, RestitutionLaw::poisson, RestitutionLaw::stronge};
  constexpr std::array names = {"newton", "poisson", "stronge"};
  for (const nlohmann::json& json : reference::read("body_impact.json")["cases"]) {
    const Contact contact = test::contact_at(0, 1, reference::vector(json["point"]),
                                             Vec3(reference::vector(json["normal"])).normalized(),
                                             json["mu"].get<double>(), json["e"].get<double>());
    const ContactSystem before =
        make_contact_system({contact}, {0, 1}, {kinetics_of(json["body_A"]), kinetics_of(json["body_B"])});
    for (std::size_t law = 0; law < laws.size(); ++law) {
      SCOPED_TRACE(json["id"].get<std::string>() + " " + names[law]);
      const nlohmann::json& expected = json[names[law]];
      const ImpactSolution impact =
          solve_impact(before, {contact.restitution}, laws[law], SimultaneousLaw::reflections);
      EXPECT_EQ(impact.phases, expected["phases"].get<std::string>());
      expect_near(world_impulse(before, impact.lambda, 0), expected["impulse"]);
      ContactSystem after = before;
      apply_impulses(impact.lambda, after);
      expect_near(after.of(1).v, expected["v_B"]);
      expect_near(after.of(1).w, expected["w_B"]);
      EXPECT_NEAR(kinetic_energy(after) - kinetic_energy(before), expected["energy_change"].get<double>(),
                  1e-12);
      if (json["body_A"].is_null()) continue;
      expect_near(after.of(0).v, expected["v_A"]);
      expect_near(after.of(0).w, expected["w_A"]);
      const test::Totals old_sum = test::totals(before), new_sum = test::totals(after);
      EXPECT_LT((new_sum.P - old_sum.P).norm(), 1e-15 * (1 + old_sum.P.norm()) * 4);
      EXPECT_LT((new_sum.L - old_sum.L).norm(), 1e-15 * (1 + old_sum.L.norm()) * 4);
    }
  }
}

}  // namespace
}  // namespace rigor::body_impact_test
