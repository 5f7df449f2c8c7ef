// A chain between two points that is nearly straight closes by a motion across itself that grows with one
// over its sag: the whole of Newton's step goes far beyond where the joints hold.

#include "rigor/sim/islands/joint_projection.hpp"
#include "random_vectors.hpp"
#include "rigor/sim/method/tolerances.hpp"
#include "sim/time_stepping_scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rigor::joint_projection_test {
namespace {

/// A chain of balls of 1 kg on distance joints or of rods on ball joints, in 3 to 12 equal links between two
/// points 1 m apart; it is longer than that by `slack`.
std::shared_ptr<const Model> chain(test::Random& random, double slack) {
  ModelBuilder builder = test::stepping_builder(0.5, 0, Vec3(0, 0, -9.81));
  const int count = static_cast<int>(random.uniform(2, 11.999));
  const bool has_rods = random.uniform(0, 1) < 0.5;

  // The knots lie on an arc of an angle 2 a with a / sin a = 1 + slack.
  const double a = std::sqrt(6 * slack);
  const auto knot = [&](double i) {
    const double angle = a * (2 * i / (count + 1) - 1);
    return Vec3(0.5 + 0.5 * std::sin(angle) / std::sin(a), 0,
                0.5 * (std::cos(a) - std::cos(angle)) / std::sin(a));
  };
  const int bodies = has_rods ? count + 1 : count;
  const auto name = [&](int i) { return i < 0 || i >= bodies ? "world" : "body" + std::to_string(i); };
  for (int i = 0; i < bodies; ++i) {
    const Vec3 place = has_rods ? Vec3(0.5 * (knot(i) + knot(i + 1))) : knot(i + 1);
    builder.add_body(test::stepping_body(name(i), Sphere{0.02}, place));
  }
  for (int i = 0; i <= count + (has_rods ? 1 : 0); ++i) {
    ModelBuilder::JointDescription joint;
    joint.name = "joint" + std::to_string(i);
    joint.type = has_rods ? JointType::ball : JointType::distance;
    joint.bodies = {name(i - 1), name(i)};
    joint.anchors = has_rods ? std::vector<Vec3>{knot(i)} : std::vector<Vec3>{knot(i), knot(i + 1)};
    builder.add_joint(joint);
  }
  return builder.build();
}

TEST(JointProjection, ClosesChainsThatAreNearlyStraight) {
  test::Random random(1804);
  for (int k = 0; k < 200; ++k) {
    SCOPED_TRACE(k);
    const double slack = std::pow(10, random.uniform(-6, -1));
    const std::shared_ptr<const Model> model = chain(random, slack);
    const State state = make_initial_state(*model);
    std::vector<int> bodies;
    std::vector<BodyPhase> phases;
    for (int i = 0; i < model->body_count(); ++i) {
      if (model->body(i).motion != MotionType::dynamic) continue;
      bodies.push_back(i);
      // The bodies have been moved as by a step: mostly across, by more than the chain sags.
      const double off = std::sqrt(slack) * random.uniform(0, 0.1);
      phases.push_back(
          {state.position(i) + off * random.vector(), state.orientation(i), Vec3::Zero(), Vec3::Zero()});
    }

    const Environment environment(*model);
    const ContactSystemAssembler assembler(*model, environment);
    AdvanceReport report;
    JointProjection(*model, assembler).project_positions(0, bodies, phases, report);
    EXPECT_LE(report.max_joint_drift, projected_joint_drift(model->length_scale()));
    EXPECT_LE(assembler.assemble_joints(0, bodies, phases, true).joints->largest_residual().first,
              projected_joint_drift(model->length_scale()));
  }
}

}  // namespace
}  // namespace rigor::joint_projection_test
