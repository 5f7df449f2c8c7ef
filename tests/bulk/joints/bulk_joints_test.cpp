#include "rigor/bulk/joints/bulk_joints.hpp"

#include "bulk/joint_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace rigor::bulk_joints_test {
namespace {

using tests::JointRun;

constexpr double kStep = 1.0 / 60;
const Vec3 kGravity(0, 0, -9.81);

struct ChainFigures {
  double joint_error = 0;   ///< Largest [m].
  double energy_error = 0;  ///< Largest, of the energy that its fall can release.
};

/// A chain of ten rods falls from level.
ChainFigures swing(int substeps) {
  JointRun chain(tests::rod_chain(10, kGravity));
  const double released = 10 * 9.81 * 2.5, before = chain.energy();
  ChainFigures figures;
  for (int i = 0; i < 180; ++i) {
    chain.step(kStep, substeps);
    figures.joint_error = std::max(figures.joint_error, chain.error());
    figures.energy_error = std::max(figures.energy_error, std::abs(chain.energy() - before) / released);
  }
  return figures;
}

TEST(BulkJoints, ASwingingChainKeepsItsJointsAndItsEnergy) {
  const ChainFigures figures = swing(4);
  EXPECT_LE(figures.joint_error, 1e-3);
  EXPECT_LE(figures.energy_error, 0.05);
}

TEST(BulkJoints, ErrorsOfASwingingChainFallWithItsSubsteps) {
  // The kick of the weight in front makes the energy of first order in h, turning makes the joints' errors of
  // at least second order.
  const ChainFigures coarse = swing(8), fine = swing(32);
  EXPECT_LE(fine.energy_error, 0.5 * coarse.energy_error);
  EXPECT_LE(fine.joint_error, 0.25 * coarse.joint_error + 2e-6);  // Rounding of lengths of 5 m: 32 bits.
}

TEST(BulkJoints, SubstepsOfAStepAreAsGoodAsStepsOfTheirLength) {
  // Bodies turn about changing axes: arms, inertia, gyroscopic torque and rotation vectors follow within a
  // step.
  for (const JointType type : {JointType::ball, JointType::universal}) {
    const auto places = [&](double step, int substeps) {
      ModelBuilder builder;
      builder.set_gravity(kGravity);
      for (int i = 0; i < 4; ++i) {
        const std::string name = "b" + std::to_string(i);
        builder.add_body(tests::bulk_body(name, Vec3(0.25 + 0.5 * i, 0, 0), 1, Vec3(0.02, 0.2, 0.21)));
        ModelBuilder::JointDescription joint;
        joint.name = "j" + name;
        joint.type = type;
        joint.bodies = {i == 0 ? "world" : "b" + std::to_string(i - 1), name};
        joint.anchors = {Vec3(0.5 * i, 0, 0)};
        if (type == JointType::universal) joint.second_axis = Vec3::UnitY();
        builder.add_joint(joint);
      }
      JointRun run(builder.build());
      for (int i = 0; i < 4; ++i) run.set(i, Vec3::Zero(), Vec3(6, 4 * i - 8, 8 - 5 * i));
      run.run(0.5, step, substeps);
      return run.bodies.x;
    };
    const std::vector<Vec3> many = places(kStep, 16), one = places(kStep / 16, 1);
    // 480 substeps of 32 bits. With the inertia of the begin of a step it is 2e-3.
    for (std::size_t i = 0; i < 4; ++i) EXPECT_LE((many[i] - one[i]).norm(), 2e-5) << i;
  }
}

/// How far the rods of a chain that carries a load have moved across it within a second of substeps of 1/60
/// s, after a push of 1 mm/s.
double sway_of_taut_chain(double h_omega) {
  // Joints of rods of length a that swing against each other are as fast as they can be: ω² = T a / I.
  const double a = 0.5, moment = 0.0208333, omega = h_omega / kStep;
  const double tension = omega * omega * moment / a, g = 100;
  ModelBuilder builder;
  builder.set_gravity(Vec3(g, 0, 0));
  for (int i = 0; i <= 8; ++i) {
    const std::string name = "b" + std::to_string(i);
    const bool is_load = i == 8;
    const Vec3 moments = is_load ? Vec3(10, 10, 10) : Vec3(0.001, moment, moment);
    builder.add_body(tests::bulk_body(name, Vec3(0.25 + a * i, 0, 0), is_load ? tension / g : 0.1, moments));
    ModelBuilder::JointDescription joint;
    joint.name = "j" + name;
    joint.type = JointType::ball;
    joint.bodies = {i == 0 ? "world" : "b" + std::to_string(i - 1), name};
    joint.anchors = {Vec3(a * i, 0, 0)};
    builder.add_joint(joint);
  }
  JointRun run(builder.build());
  for (int i = 0; i < 8; ++i) run.set(i, Vec3(0, i % 2 == 0 ? 1e-3 : -1e-3, 0), Vec3::Zero());
  run.run(1, kStep, 1);
  double sway = 0;
  for (const Vec3& x : run.bodies.x) sway = std::isfinite(x.y()) ? std::max(sway, std::abs(x.y())) : 1e9;
  return sway;
}

TEST(BulkJoints, StandTensionsHoweverFastTheirVibrations) {
  // Explicit steps of vibrations with h ω > 2 would gain energy without bound.
  for (const double rate : {0.5, 1.5, 3.0, 10.0, 100.0, 1000.0})
    EXPECT_LT(sway_of_taut_chain(rate), 1e-3) << rate;
}

TEST(BulkJoints, BothTargetsOfLanesGiveTheSameBits) {
  JointRun portable(tests::rod_chain(5, kGravity, 11), LaneTarget::portable);
  JointRun best(tests::rod_chain(5, kGravity, 11));
  portable.run(0.5, kStep, 4);
  best.run(0.5, kStep, 4);
  EXPECT_EQ(std::memcmp(portable.bodies.motion.data(), best.bodies.motion.data(),
                        portable.bodies.motion.size() * sizeof(portable.bodies.motion[0])),
            0);
}

TEST(BulkJoints, AChainMovesTheSameWhicheverLaneItIsIn) {
  JointRun one(tests::rod_chain(5, kGravity)), many(tests::rod_chain(5, kGravity, 11));
  one.run(0.5, kStep, 4);
  many.run(0.5, kStep, 4);
  for (int chain = 0; chain < 11; ++chain) {
    for (int i = 0; i < 5; ++i) EXPECT_EQ(one.velocity(i), many.velocity(5 * chain + i));
  }
}

}  // namespace
}  // namespace rigor::bulk_joints_test
