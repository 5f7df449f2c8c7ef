// Under penalty contacts may come to other features from step to step, and a step may go past one that no
// other had shown. Neither gives energy or lets bodies overlap.

#include "geometry/solid_shapes.hpp"
#include "random_vectors.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/model/model_builder.hpp"
#include "rigor/sim/simulation.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace rigor::penalty_meshes_test {
namespace {

using test::Random;

/// Two bodies of one shape each that fall and meet in free space, turned at random.
std::shared_ptr<const Model> impact(const Shape& a, const Shape& b, Random& random) {
  ModelBuilder builder;
  // Both fall: a step that is taken back must not keep what gravity gave in it.
  builder.set_gravity(Vec3(0, 0, -9.81));
  builder.add_material(
      {"m", 1000, random.uniform(0, 1) < 0.5 ? 0.5 : 0, random.uniform(0, 1) < 0.5 ? 0.5 : 0});
  for (const char* name : {"a", "b"}) {
    const bool is_b = name[0] == 'b';
    BodyDescription body;
    body.name = name;
    body.q_WU = rotation_exp(3 * random.vector()).normalized();
    if (is_b) {
      body.p_WU = Vec3(0.1 * random.number(), 0.1 * random.number(), 1.25);
      body.velocity = Vec3(random.uniform(-0.3, 0.3), 0, -random.uniform(2, 5));
    }
    body.shapes.push_back({is_b ? b : a, Vec3::Zero(), Quat::Identity(), "m", ""});
    builder.add_body(body);
  }
  return builder.build();
}

/// Runs random impacts of the two shapes; each has to end, and none may gain energy. Where a contact's normal
/// turns fast, as that of nearly parallel edges, an overlap may be deeper than the springs are made for: of
/// 480 impacts 12 were, and the audit says so.
void expect_sound_impacts(const Shape& a, const Shape& b, int count, unsigned seed) {
  Method method;
  method.scheme = Scheme::penalty;
  const Observer watch = [](const State&, const AdvanceReport&, const Auditor&) { return true; };
  Random random(seed);
  int overlaps = 0;
  for (int i = 0; i < count; ++i) {
    SCOPED_TRACE(std::to_string(seed) + ", impact " + std::to_string(i));
    const RunSettings settings{.duration = 0.5, .step = 0.005, .output_interval = 0.005};
    const RunResult end = run_simulation(impact(a, b, random), method, settings, std::nullopt, watch);
    EXPECT_EQ(end.audit.report.reason, StopReason::reached_end) << end.audit.report.detail;
    for (const std::string& violation : end.audit.violations) {
      const bool is_overlap = violation.starts_with("penetration");
      EXPECT_TRUE(is_overlap) << violation;
      overlaps += is_overlap;
    }
  }
  EXPECT_LE(overlaps, 1);
}

TEST(PenaltyMeshes, ImpactsOfSolidsWithHollowsGiveNoEnergy) {
  const Shape angle = test::as_scaled_mesh(test::l_solid(), 0.2),
              ring = test::as_scaled_mesh(test::torus_solid(0.35, 16, 10), 0.25);
  expect_sound_impacts(angle, angle, 6, 1831);
  expect_sound_impacts(ring, ring, 3, 1832);
  expect_sound_impacts(angle, Box{Vec3(0.2, 0.2, 0.2)}, 6, 1833);
}

TEST(PenaltyMeshes, ImpactsOfConesAndCylindersGiveNoEnergy) {
  const Shape box = Box{Vec3(0.25, 0.15, 0.1)};
  expect_sound_impacts(Cone{0.2, 0.2}, box, 12, 1834);
  expect_sound_impacts(Cylinder{0.2, 0.15}, Cylinder{0.1, 0.25}, 12, 1835);
}

}  // namespace
}  // namespace rigor::penalty_meshes_test
