#include "bulk/joint_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace rigor::joint_types_test {
namespace {

using tests::JointRun;

constexpr double kStep = 1.0 / 60;

std::string text_of(JointType type) {
  return joint_type_name(type);
}

/// Two free bodies of any orientation with a joint anywhere between them, or a chain of such.
std::shared_ptr<const Model> random_chain(JointType type, int count, unsigned seed) {
  test::Random random(seed);
  ModelBuilder builder;
  Vec3 anchor = Vec3::Zero();
  for (int i = 0; i < count; ++i) {
    const double mass = random.uniform(0.5, 2);
    BodyDescription body =
        tests::bulk_body("b" + std::to_string(i), anchor + Vec3(0.3, 0.1 * random.number(), 0), mass,
                         Vec3(0.02, 0.03, 0.04) * mass);
    body.q_WU = rotation_exp(3 * random.vector());
    builder.add_body(body);
    anchor = body.p_WU + Vec3(0.3, 0.1 * random.number(), 0);
    if (i == 0) continue;
    ModelBuilder::JointDescription joint;
    joint.name = "j" + std::to_string(i);
    joint.type = type;
    joint.bodies = {"b" + std::to_string(i - 1), "b" + std::to_string(i)};
    joint.axis = random.vector();
    joint.anchors = {body.p_WU - Vec3(0.3, 0, 0)};
    if (type == JointType::distance) joint.anchors.push_back(body.p_WU + 0.1 * random.vector());
    if (type == JointType::universal) joint.second_axis = joint.axis.cross(random.vector());
    if (type == JointType::screw) joint.parameter = 0.4;
    builder.add_joint(joint);
  }
  return builder.build();
}

struct Momenta {
  Vec3 P = Vec3::Zero(), L = Vec3::Zero();  ///< L about the origin of W.
};
/// With the inertia of the begin of a step, which is that of the step.
Momenta momenta_of(const JointRun& run) {
  Momenta momenta;
  for (int i = 0; i < run.bodies.count(); ++i) {
    const Body& body = run.model->body(i);
    const Quat& q = run.bodies.q[static_cast<std::size_t>(i)];
    const Vec3 P = body.mass * run.velocity(i);
    const Vec3 w_B = q.conjugate() * run.spin(i);
    momenta.P += P;
    momenta.L +=
        run.bodies.x[static_cast<std::size_t>(i)].cross(P) + q * Vec3(body.moments.cwiseProduct(w_B));
  }
  return momenta;
}

class EachJointType : public testing::TestWithParam<JointType> {};

TEST_P(EachJointType, KeepsWhatItHolds) {
  for (const int count : {2, 5}) {
    JointRun run(random_chain(GetParam(), count, 7));
    test::Random random(8);
    for (int i = 0; i < count; ++i) {
      const Vec3 v = random.vector(), w = 2 * random.vector();
      run.set(i, v, w);
    }
    double worst = 0;
    for (int i = 0; i < 120; ++i) {
      run.step(kStep, 4);
      worst = std::max(worst, run.error());
    }
    // Two corrections leave a part (ω h)² of what turning by ω h moves an arm of a metre off in a substep,
    // with ω about 5 rad/s; and what else turning of axes does within a step, (ω H)³.
    EXPECT_LE(worst, 1e-3) << text_of(GetParam()) << " " << count;
  }
}

TEST_P(EachJointType, ChangesNoMomentum) {
  JointRun run(random_chain(GetParam(), 4, 17));
  test::Random random(18);
  for (int i = 0; i < 4; ++i) {
    const Vec3 v = random.vector(), w = 2 * random.vector();
    run.set(i, v, w);
  }
  const Executor executor(1);
  begin_bulk_step(*run.model, Executor(1), run.bodies);
  run.joints.prepare(run.bodies, kStep, executor);
  const Momenta before = momenta_of(run);
  run.joints.solve(JointPass::places, executor);
  const Momenta after = momenta_of(run);
  // 32 bits of velocities of some metres a second, of bodies of 2 kg at 2 m.
  EXPECT_LE((after.P - before.P).norm(), 3e-5) << text_of(GetParam());
  EXPECT_LE((after.L - before.L).norm(), 3e-5) << text_of(GetParam());
}

// In one substep metres were hundreds of m/s, and what spun like that broke.
TEST_P(EachJointType, BringsTogetherWhatWasSetApartAtThreeMetresPerSecond) {
  test::Random random(9);
  for (int k = 0; k < 10; ++k) {
    JointRun run(random_chain(GetParam(), 2, 7));
    run.bodies.x[1] += 2 * random.vector();
    run.bodies.q[1] = rotation_exp(random.vector()) * run.bodies.q[1];
    // 3.5 m at 3 m/s and 1.8 rad at 3 rad/s take less than 1.5 s. The arms of both bodies turn meanwhile, by
    // which their centres may move at 3 m/s more each.
    for (int i = 0; i < 90; ++i) {
      const Vec3 before = run.bodies.x[1] - run.bodies.x[0];
      run.step(kStep, 4);
      EXPECT_LT((run.bodies.x[1] - run.bodies.x[0] - before).norm(), 9 * kStep) << k << ", step " << i;
    }
    EXPECT_LT(run.error(), 1e-4) << k;
  }
}

INSTANTIATE_TEST_SUITE_P(BulkJoints, EachJointType,
                         testing::Values(JointType::fixed, JointType::ball, JointType::hinge,
                                         JointType::slider, JointType::universal, JointType::cylindrical,
                                         JointType::planar, JointType::distance, JointType::screw,
                                         JointType::point_on_line),
                         [](const testing::TestParamInfo<JointType>& type) { return text_of(type.param); });

/// A body that turns about z of the world, whose moment about the axis is 2 kg m²; or one of 2 kg that slides
/// along z.
std::shared_ptr<const Model> one_axis(JointType type, const JointAxis& axis) {
  ModelBuilder builder;
  builder.add_body(tests::bulk_body("b", Vec3::Zero(), 2, Vec3(2, 2, 2)));
  ModelBuilder::JointDescription joint;
  joint.name = "j";
  joint.type = type;
  joint.bodies = {"world", "b"};
  joint.anchors = {Vec3::Zero()};
  joint.axes = {axis};
  builder.add_joint(joint);
  return builder.build();
}

TEST(BulkJointLaws, AMotorOfLimitedForceSpeedsUpEvenlyAndThenHoldsItsRate) {
  for (const JointType type : {JointType::hinge, JointType::slider}) {
    JointAxis axis;
    axis.motor = JointMotor{3, 4};
    JointRun run(one_axis(type, axis));
    const auto rate = [&] { return type == JointType::hinge ? run.spin(0).z() : run.velocity(0).z(); };
    run.run(1, kStep, 4);
    EXPECT_NEAR(rate(), 2, 1e-5);  // 4 N m on 2 kg m², 1 s; 32 bits over 240 substeps.
    run.run(1, kStep, 4);
    EXPECT_NEAR(rate(), 3, 1e-6);
  }
}

TEST(BulkJointLaws, AnUnlimitedMotorHoldsItsRateFromTheFirstStep) {
  JointAxis axis;
  axis.motor = JointMotor{.velocity = 3};
  JointRun run(one_axis(JointType::hinge, axis));
  run.step(kStep, 4);
  EXPECT_NEAR(run.spin(0).z(), 3, 1e-6);
}

TEST(BulkJointLaws, DryFrictionSlowsEvenlyAndThenHolds) {
  JointAxis axis;
  axis.friction = 4;
  JointRun run(one_axis(JointType::hinge, axis));
  run.set(0, Vec3::Zero(), Vec3(0, 0, 3));
  run.run(1, kStep, 4);
  EXPECT_NEAR(run.spin(0).z(), 1, 6e-5);  // Half a last place of 3 rad/s, 240 times.
  run.run(1, kStep, 4);
  EXPECT_EQ(run.spin(0).z(), 0);
}

TEST(BulkJointLaws, ASoftSpringSwingsAtItsFrequencyAndKeepsItsEnergy) {
  JointAxis axis;
  axis.stiffness = 8;  // On 2 kg: ω = 2 rad/s.
  JointRun run(one_axis(JointType::slider, axis));
  run.set(0, Vec3(0, 0, 1), Vec3::Zero());
  run.run(3, kStep, 4);
  // Of first order in h (the spring's kick comes in front): x = sin(2 t)/2, off by at most h v / 2 = 1/480 m
  // each way.
  EXPECT_NEAR(run.bodies.x[0].z(), 0.5 * std::sin(6.0), 1.0 / 240);
  EXPECT_NEAR(run.velocity(0).z(), std::cos(6.0), 4.0 / 240);
}

TEST(BulkJointLaws, ADamperSlowsExponentially) {
  JointAxis axis;
  axis.damping = 2;  // On 2 kg: rate 1/s.
  JointRun run(one_axis(JointType::slider, axis));
  run.set(0, Vec3(0, 0, 1), Vec3::Zero());
  run.run(1, kStep, 4);
  EXPECT_NEAR(run.velocity(0).z(), std::exp(-1), std::exp(-1) / 480 * 1.1);  // First order: h/2 relative.
}

TEST(BulkJointLaws, SpringsOfAnyStiffnessAreStable) {
  for (double stiffness = 1; stiffness <= 1e12; stiffness *= 100) {
    JointAxis axis;
    axis.stiffness = stiffness;
    axis.rest = 0.1;
    JointRun run(one_axis(JointType::slider, axis));
    for (int i = 0; i < 200; ++i) {
      run.step(kStep, 4);
      EXPECT_LE(std::abs(run.bodies.x[0].z()), 0.21) << stiffness;
    }
    if (stiffness >= 1e6) {
      EXPECT_NEAR(run.bodies.x[0].z(), 0.1, 1e-3) << stiffness;
    }
  }
}

TEST(BulkJointLaws, AnImpactAtALimitKeepsThePartOfTheSpeedThatItsRestitutionSays) {
  for (const double e : {0.0, 0.5, 1.0}) {
    JointAxis axis;
    axis.lower = -0.5;
    axis.upper = 0.5;
    axis.restitution = e;
    JointRun run(one_axis(JointType::slider, axis));
    run.set(0, Vec3(0, 0, 2), Vec3::Zero());
    double highest = 0;
    for (int i = 0; i < 24; ++i) {
      run.step(kStep, 4);
      highest = std::max(highest, run.bodies.x[0].z());
    }
    EXPECT_LE(highest, 0.5 + 1e-5) << e;
    EXPECT_NEAR(run.velocity(0).z(), -2 * e, 1e-5) << e;
  }
}

TEST(BulkJointLaws, AWeightRestsAtALimit) {
  JointAxis axis;
  axis.lower = -0.25;
  ModelBuilder builder;
  builder.set_gravity(Vec3(0, 0, -9.81));
  builder.add_body(tests::bulk_body("b", Vec3::Zero(), 2, Vec3(2, 2, 2)));
  builder.add_joint({.name = "j", .type = JointType::slider, .bodies = {"world", "b"}, .axes = {axis}});
  JointRun run(builder.build());
  run.run(2, kStep, 4);
  EXPECT_NEAR(run.bodies.x[0].z(), -0.25, 1e-6);
  EXPECT_LE(run.velocity(0).norm(), 1e-6);
}

TEST(BulkJointLaws, ADistanceWithLimitsIsARope) {
  JointAxis axis;
  axis.upper = 1.5;
  ModelBuilder builder;
  builder.set_gravity(Vec3(0, 0, -9.81));
  builder.add_body(tests::bulk_body("b", Vec3(0, 0, -1), 2, Vec3(2, 2, 2)));
  builder.add_joint({.name = "j",
                     .type = JointType::distance,
                     .bodies = {"world", "b"},
                     .anchors = {Vec3::Zero(), Vec3(0, 0, -1)},
                     .axes = {axis}});
  JointRun run(builder.build());
  run.run(0.2, kStep, 4);
  // Free fall; the kick in front makes it longer by g t h / 2.
  EXPECT_NEAR(run.bodies.x[0].z(), -1 - 0.5 * 9.81 * 0.2 * (0.2 + kStep / 4), 1e-5);
  run.run(2, kStep, 4);
  EXPECT_NEAR(run.bodies.x[0].z(), -1.5, 1e-5);
}

}  // namespace
}  // namespace rigor::joint_types_test
