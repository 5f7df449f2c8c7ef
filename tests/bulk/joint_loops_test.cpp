#include "bulk/joint_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigor {
namespace {

using tests::JointRun;

constexpr double kStep = 1.0 / 60;

void add_wheel(const std::string& name, const Vec3& center, double moment, ModelBuilder& builder) {
  builder.add_body(tests::bulk_body(name, center, 1, Vec3(moment, moment, moment)));
  builder.add_joint(
      {.name = "hinge of " + name, .type = JointType::hinge, .bodies = {"world", name}, .anchors = {center}});
}

TEST(BulkGears, WheelsTurnInProportionAndShareTheirMomenta) {
  ModelBuilder builder;
  add_wheel("a", Vec3(0, 0, 0), 2, builder);
  add_wheel("b", Vec3(1, 0, 0), 3, builder);
  builder.add_joint(
      {.name = "gear", .type = JointType::gear, .joints = {"hinge of a", "hinge of b"}, .ratio = -0.5});
  JointRun run(builder.build());
  run.set(0, Vec3::Zero(), Vec3(0, 0, 4));
  run.run(10, kStep, 4);
  // 2 (ω_a - 4) = 0.5 λ, 3 ω_b = λ, ω_b = -ω_a / 2 with the impulse of the gear λ on b: 2.75 ω_a = 8.
  EXPECT_NEAR(run.spin(0).z(), 8 / 2.75, 1e-4);  // 32 bits over 2,400 substeps.
  EXPECT_NEAR(run.spin(1).z(), -4 / 2.75, 1e-4);
  // Angles too, whole turns apart: half of those of a.
  const auto angle = [&](int i) {
    const Quat& q = run.bodies.q[static_cast<std::size_t>(i)];
    return 2 * std::atan2(q.z(), q.w());
  };
  EXPECT_NEAR(std::remainder(angle(1) + 0.5 * angle(0), std::numbers::pi), 0, 1e-4);
}

TEST(BulkLoops, AFourBarLinkageSwingsClosed) {
  // Two rods hang from the world, the third joins their ends: hinges about y.
  ModelBuilder builder;
  builder.set_gravity(Vec3(0, 0, -9.81));
  const Vec3 moments(0.08, 0.08, 0.001);
  builder.add_body(tests::bulk_body("left", Vec3(0, 0, -0.5), 1, moments));
  builder.add_body(tests::bulk_body("right", Vec3(1, 0, -0.5), 1, moments));
  builder.add_body(tests::bulk_body("coupler", Vec3(0.5, 0, -1), 1, Vec3(0.001, 0.08, 0.08)));
  const auto hinge = [&](const std::string& a, const std::string& b, const Vec3& p) {
    builder.add_joint(
        {.name = a + b, .type = JointType::hinge, .bodies = {a, b}, .anchors = {p}, .axis = Vec3::UnitY()});
  };
  hinge("world", "left", Vec3(0, 0, 0));
  hinge("world", "right", Vec3(1, 0, 0));
  hinge("left", "coupler", Vec3(0, 0, -1));
  hinge("right", "coupler", Vec3(1, 0, -1));
  JointRun run(builder.build());
  run.set(0, Vec3(-0.5, 0, 0), Vec3(0, 1, 0));
  run.set(1, Vec3(-0.5, 0, 0), Vec3(0, 1, 0));
  run.set(2, Vec3(-1, 0, 0), Vec3::Zero());
  const double before = run.energy();
  double worst = 0, energy_error = 0;
  for (int i = 0; i < 120; ++i) {
    run.step(kStep, 4);
    worst = std::max(worst, run.error());
    energy_error = std::max(energy_error, std::abs(run.energy() - before));
  }
  // Turns of trees and loops end before they converge: what is left is put back in the next substeps.
  EXPECT_LE(worst, 1e-3);
  EXPECT_LE(energy_error, 0.05 * 0.83);  // Of its kinetic energy of 0.83 J.
}

TEST(BulkJoints, TakeBackWhatTheyHaveChanged) {
  JointRun run(tests::rod_chain(3, Vec3(0, 0, -9.81)));
  run.run(0.2, kStep, 4);
  const Executor executor(1);
  begin_bulk_step(*run.model, run.bodies);
  run.joints.prepare(run.bodies, kStep, executor);
  run.set(1, Vec3(1, 2, 3), Vec3(0, 1, 0));
  const Vec3 v = run.velocity(1), w = run.spin(1);
  run.joints.solve(true, run.bodies, executor);
  run.joints.solve(false, run.bodies, executor);
  EXPECT_GE((run.velocity(1) - v).norm(), 0.1);
  run.joints.take_back_change(run.bodies);
  EXPECT_LE((run.velocity(1) - v).norm() + (run.spin(1) - w).norm(), 2e-5);  // 32 bits.
}

}  // namespace
}  // namespace rigor
