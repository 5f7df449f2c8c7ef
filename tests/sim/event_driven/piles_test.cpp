// Random piles that only lose energy.

#include "random_vectors.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/model/model_builder.hpp"
#include "rigor/sim/audit/audit.hpp"
#include "rigor/sim/event_driven/event_driven_stepper.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace rigor::piles_test {
namespace {

/// Boxes, balls and capsules of many masses that are thrown onto a floor, with friction and without
/// restitution.
std::shared_ptr<const Model> small_pile(unsigned seed) {
  test::Random random(seed);
  ModelBuilder builder;
  builder.set_gravity(Vec3(0, 0, -9.81));
  builder.add_material({"rough", 1000, 0.5, 0});
  BodyDescription floor;
  floor.name = "floor";
  floor.motion = MotionType::fixed;
  floor.shapes.push_back({HalfSpace{Vec3::UnitZ(), 0}, Vec3::Zero(), Quat::Identity(), "rough", ""});
  builder.add_body(floor);
  for (int k = 0; k < 5; ++k) {
    const double size = 0.12 + 0.05 * random.number();
    const Shape shape = k % 3 == 0   ? Shape(Box{Vec3(size, 0.6 * size, 0.8 * size)})
                        : k % 3 == 1 ? Shape(Sphere{size})
                                     : Shape(Capsule{0.5 * size, size});
    BodyDescription body;
    body.name = "b" + std::to_string(k);
    body.p_WU = Vec3(0.1 * random.number(), 0.1 * random.number(), 0.4 + 0.45 * k);
    body.q_WU = rotation_exp(3 * random.vector()).normalized();
    body.mass = std::pow(10.0, 1 + random.number());
    body.velocity = 0.5 * random.vector();
    body.angular_velocity = 4 * random.vector();
    body.shapes.push_back({shape, Vec3::Zero(), Quat::Identity(), "rough", ""});
    builder.add_body(body);
  }
  return builder.build();
}

TEST(Piles, EnergyNeverRisesAndNothingSinks) {
  for (const unsigned seed : {1u, 2u, 3u}) {
    const std::shared_ptr<const Model> model = small_pile(seed);
    State state = make_initial_state(*model);
    EventDrivenStepper stepper(model, Method{}, 0.002);
    Auditor auditor(model, Method{}, state);
    const double initial = auditor.energy().total();
    for (int k = 1; k <= 100; ++k) auditor.observe(state, stepper.advance(state, 0.01 * k));
    const Audit audit = auditor.audit(state);
    EXPECT_EQ(audit.report.reason, StopReason::reached_end) << audit.report.detail;
    // What the integrator's tolerance, 1e-10 of the momenta, leaves.
    EXPECT_LE(audit.max_increase, 1e-9 * initial) << seed;
    EXPECT_LE(audit.report.max_penetration, 1e-6) << seed;
    EXPECT_GT(audit.dissipated, 0.1 * initial) << seed;
  }
}

}  // namespace
}  // namespace rigor::piles_test
