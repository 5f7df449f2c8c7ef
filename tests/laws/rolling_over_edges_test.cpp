// Balls that roll and slide over the edges of boxes and cylinders in free space: contacts whose curvature
// jumps.

#include "rigor/math/rotation.hpp"
#include "rigor/model/model_builder.hpp"
#include "rigor/model/state.hpp"
#include "rigor/sim/audit/audit.hpp"
#include "rigor/sim/make_stepper.hpp"

#include "random_vectors.hpp"

#include <gtest/gtest.h>

#include <string>

namespace rigor::rolling_over_edges_test {
namespace {

/// Two bodies that meet without a bounce, both spinning, with so much friction that the ball rolls around the
/// other one, which turns away below it.
std::shared_ptr<const Model> meeting(test::Random& random, const Shape& shape) {
  ModelBuilder builder;
  builder.set_gravity(Vec3::Zero());
  builder.add_material({"m", 900, 0.9, 0});
  const auto add = [&](const std::string& name, const Shape& own, const Vec3& x, const Vec3& v) {
    BodyDescription body;
    body.name = name;
    body.p_WU = x;
    body.q_WU = rotation_exp(3 * random.vector());
    body.velocity = v;
    body.angular_velocity = 6 * random.vector();
    body.shapes.push_back({own, Vec3::Zero(), Quat::Identity(), "m", ""});
    builder.add_body(body);
  };
  add("turning", shape, Vec3::Zero(), Vec3(1 + 0.5 * random.number(), 0.3 * random.number(), 0));
  add("ball", Sphere{0.28}, Vec3(0.9, 0.2 * random.number(), 0.2 * random.number()), -Vec3::UnitX());
  return builder.build();
}

/// The embedded methods had agreed on steps across edges that gained up to 1e-5 of the energy.
TEST(RollingOverEdges, GivesNoEnergy) {
  test::Random random(3);
  int touching = 0;
  for (int k = 0; k < 30; ++k) {
    const Shape shape = k % 2 == 0 ? Shape(Box{Vec3(0.25, 0.345, 0.295)}) : Shape(Cylinder{0.29, 0.35});
    const std::shared_ptr<const Model> model = meeting(random, shape);
    Method method;
    method.scheme = Scheme::event_driven;
    State state = make_initial_state(*model);
    Auditor auditor(model, method, state);
    const std::unique_ptr<Stepper> stepper = make_stepper(model, method, 0.002);
    for (int step = 1; step <= 20; ++step) auditor.observe(state, stepper->advance(state, 0.05 * step));
    const Audit audit = auditor.audit(state);
    EXPECT_EQ(audit.violations, std::vector<std::string>{}) << k;
    if (audit.report.resting > 0) ++touching;
  }
  EXPECT_GE(touching, 20);
}

}  // namespace
}  // namespace rigor::rolling_over_edges_test
