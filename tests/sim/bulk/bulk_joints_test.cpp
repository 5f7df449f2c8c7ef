// Joints of the many-body path against the event-driven scheme, whose motion between events is exact to its
// tolerance.

#include "rigor/math/rotation.hpp"
#include "rigor/model/model_builder.hpp"
#include "rigor/sim/make_stepper.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace rigor::bulk_joints_test {
namespace {

/// Planks of 0.5 m and 15 kg between two banks, hinged to each other; they sag, the deepest hinge left of the
/// middle, and none carries anything.
std::shared_ptr<const Model> hinged_bridge(int planks) {
  ModelBuilder builder;
  builder.set_gravity(Vec3(0, 0, -9.81));
  Vec3 p = Vec3::Zero();
  const auto name = [](int i) { return "plank" + std::to_string(i); };
  const auto hinge = [&](const std::string& a, const std::string& b) {
    builder.add_joint(
        {.name = a + b, .type = JointType::hinge, .bodies = {a, b}, .anchors = {p}, .axis = Vec3::UnitY()});
  };
  for (int i = 0; i < planks; ++i) {
    const double slope = 3 * i < planks ? 0.5 : -0.2;
    const Vec3 along(0.5 * std::cos(slope), 0, -0.5 * std::sin(slope));
    BodyDescription plank;
    plank.name = name(i);
    plank.p_WU = p + 0.5 * along;
    plank.q_WU = rotation_exp(Vec3(0, slope, 0));
    plank.inertia = GivenInertia{.mass = 15, .moments = Vec3(5, 0.3125, 5.3)};
    builder.add_body(plank);
    hinge(i == 0 ? "world" : name(i - 1), name(i));
    p += along;
  }
  hinge(name(planks - 1), "world");
  return builder.build();
}

State motion_of(const std::shared_ptr<const Model>& model, const Method& method, double step, double t) {
  State state = make_initial_state(*model);
  const AdvanceReport report = make_stepper(model, method, step, 1)->advance(state, t);
  EXPECT_EQ(report.reason, StopReason::reached_end);
  return state;
}

double largest_distance(const State& a, const State& b) {
  double largest = 0;
  for (int i = 0; i < a.body_count(); ++i) {
    largest = std::max(largest, (a.position(i) - b.position(i)).norm());
  }
  return largest;
}

TEST(BulkJointsAndExact, ABridgeMovesAlikeAndTheDifferenceFallsWithTheSubsteps) {
  const std::shared_ptr<const Model> model = hinged_bridge(9);
  const double t = 0.5;
  const State exact = motion_of(model, Method{}, 1.0 / 60, t);
  const auto error = [&](double substeps) {
    Method method;
    method.scheme = Scheme::time_stepping;
    method.solver = SolverMethod::substep;
    method.substeps = substeps;
    return largest_distance(motion_of(model, method, 1.0 / 60, t), exact);
  };
  const double coarse = error(8), fine = error(32);
  EXPECT_LE(coarse, 0.002);
  // At least of first order in h; 32 bits of displacements, 32 times.
  EXPECT_LE(fine, 0.25 * 1.1 * coarse + 1e-5);
}

}  // namespace
}  // namespace rigor::bulk_joints_test
