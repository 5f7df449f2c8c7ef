#include "rigor/bulk/gyroscopic/gyroscopic_terms.hpp"

#include "rigor/math/rotation.hpp"

#include "bulk/joint_scenes.hpp"

#include <gtest/gtest.h>

namespace rigor::gyroscopic_terms_test {
namespace {

using test::Random;

/// A body that turns freely.
struct Turner {
  explicit Turner(const Vec3& moments) {
    ModelBuilder builder;
    builder.add_body(tests::bulk_body("b", Vec3::Zero(), 1, moments));
    model = builder.build();
    bodies = read_bulk_bodies(*model, make_initial_state(*model));
  }

  /// ω after h by the change under test.
  Vec3 turned(const Quat& q_WB, const Vec3& w_W, float h) {
    bodies.q[0] = q_WB;
    for (int k = 0; k < 3; ++k) bodies.motion[0].w[k] = static_cast<float>(w_W[k]);
    GyroscopicTerms gyroscopic_terms(*model);
    const Executor executor(1);
    gyroscopic_terms.prepare(bodies, {0}, executor);
    std::vector<std::array<float, kLaneCount>> turns;
    gyroscopic_terms.find_changes(h, bodies, executor, turns);
    return w_W + Vec3(turns[0][4], turns[0][5], turns[0][6]);
  }

  const Body& body() const { return model->body(0); }
  std::shared_ptr<const Model> model;
  BulkBodies bodies;
};

Vec3 angular_acceleration(const Body& body, const Quat& q_WB, const Vec3& w_W) {
  const Vec3 w_B = q_WB.conjugate() * w_W;
  const Vec3 torque_B = -w_B.cross(body.moments.cwiseProduct(w_B));
  return q_WB * Vec3(torque_B.cwiseQuotient(body.moments));
}

double energy(const Body& body, const Quat& q_WB, const Vec3& w_W) {
  const Vec3 w_B = q_WB.conjugate() * w_W;
  return 0.5 * w_B.dot(body.moments.cwiseProduct(w_B));
}

TEST(GyroscopicTorque, IsEulersEquationToFirstOrder) {
  Random random(1);
  for (int trial = 0; trial < 50; ++trial) {
    Turner turner(Vec3(1, 2, 2.5));
    const Quat q_WB = rotation_exp(3 * random.vector());
    const Vec3 w = 2 * random.vector();
    const float h = 1e-3f;
    const Vec3 expected = w + h * angular_acceleration(turner.body(), q_WB, w);
    // Second order in h ω = 3e-3, and 32 bits.
    EXPECT_LT((turner.turned(q_WB, w, h) - expected).norm(), 20 * h * h * w.squaredNorm() + 1e-6);
  }
}

TEST(GyroscopicTorque, GainsNoEnergyAtAnySpeed) {
  Random random(2);
  for (int trial = 0; trial < 200; ++trial) {
    Turner turner(Vec3(0.1, 1, 1.05));
    const Quat q_WB = rotation_exp(3 * random.vector());
    Vec3 w = 300 * random.vector();
    const double before = energy(turner.body(), q_WB, w);
    for (int k = 0; k < 20; ++k) w = turner.turned(q_WB, w, 1.0f / 60);
    EXPECT_LE(energy(turner.body(), q_WB, w), before * (1 + 1e-5));
  }
}

TEST(GyroscopicTorque, OfSpinAboutAPrincipalAxisIsNone) {
  Turner turner(Vec3(1, 2, 2.5));
  const Quat q_WB = rotation_exp(Vec3(0.3, -0.4, 1));
  for (int k = 0; k < 3; ++k) {
    const Vec3 w = q_WB * Vec3(50 * Vec3::Unit(k));
    EXPECT_LT((turner.turned(q_WB, w, 1.0f / 60) - w).norm(), 1e-4);  // 32 bits of 50 rad/s.
  }
}

TEST(GyroscopicTorque, TurnsWithTheBodyWithinAStep) {
  // A body that has turned by 0.8 rad since the begin of the step changes like one that stands so.
  Turner start(Vec3(1, 2, 2.5)), turned(Vec3(1, 2, 2.5));
  const Quat q_WB = rotation_exp(Vec3(0.3, -0.4, 1));
  const Vec3 turn(0.5, -0.6, 0.2), w(3, 5, -4);
  for (int k = 0; k < 3; ++k) start.bodies.motion[0].dr[k] = static_cast<float>(turn[k]);
  const Vec3 expected = turned.turned(rotation_exp(turn) * q_WB, w, 1e-2F);
  EXPECT_LT((start.turned(q_WB, w, 1e-2F) - expected).norm(), 2e-6);  // 32 bits of 7 rad/s.
  EXPECT_GT((expected - w).norm(), 0.01);
}

TEST(GyroscopicTorque, OfBodiesOfRevolutionIsEulersSolution) {
  // As seen from the body the part of ω across its axis turns about it at the rate (I_along/I_across - 1)
  // ω_along.
  Random random(3);
  for (int trial = 0; trial < 50; ++trial) {
    const int axis = trial % 3;
    Vec3 moments = Vec3::Constant(2);
    moments[axis] = trial % 2 == 0 ? 0.3 : 3.5;
    Turner turner(moments);
    const Quat q_WB = rotation_exp(3 * random.vector());
    const Vec3 w = 20 * random.vector(), e = q_WB * Vec3(Vec3::Unit(axis));
    const float h = 0.01F;
    const double angle = h * (moments[axis] / 2 - 1) * w.dot(e);
    const Vec3 expected = rotation_exp(angle * e) * w;
    const Vec3 now = turner.turned(q_WB, w, h);
    // The tangent of half the angle is taken for it; 32 bits.
    EXPECT_LT((now - expected).norm(), (std::abs(angle * angle * angle) / 12 + 1e-6) * w.norm() + 1e-6);
    EXPECT_NEAR(energy(turner.body(), q_WB, now) / energy(turner.body(), q_WB, w), 1, 2e-6);
  }
}

/// The rotation after turns by h ω, one after the other.
Quat composed(const std::vector<Vec3>& turns) {
  Quat q = Quat::Identity();
  for (const Vec3& turn : turns) q = rotation_exp(turn) * q;
  return q;
}

TEST(TurnFurther, IsExactAndBoundedForTurnsOfAnySize) {
  for (const double size : {0.001, 0.1, 0.6, 2.0, 5.0, 40.0}) {
    Random random(4);
    std::vector<Vec3> turns;
    MotionRecord motion;
    double sum = 0, third = 0;
    for (int k = 0; k < 8; ++k) {
      const float h = 0.25F;
      const Vec3 w = size / h * random.vector();
      for (int j = 0; j < 3; ++j) motion.w[j] = static_cast<float>(w[j]);
      const Vec3 before(motion.dr[0], motion.dr[1], motion.dr[2]);
      turn_further(h, motion);
      turns.push_back(h * w);
      sum += h * w.norm();
      // What is left out where the series is used: second order in the turn, fourth in what has been.
      const double r = std::min(before.norm(), 1.0), s = std::min(h * w.norm(), 1.0);
      third += s * s * r / 12 + s * r * r * r * r / 720;
    }
    const Vec3 dr(motion.dr[0], motion.dr[1], motion.dr[2]);
    EXPECT_LE(dr.norm(), sum + M_PI) << size;
    EXPECT_LT(rotation_angle_between(rotation_exp(dr), composed(turns)), third + 1e-6 * (1 + sum)) << size;
  }
}

TEST(TurnFurther, CountsWholeTurnsAboutAnAxisThatStays) {
  MotionRecord motion;
  motion.w[2] = 100;
  for (int k = 0; k < 10; ++k) turn_further(0.1F, motion);
  EXPECT_NEAR(motion.dr[2], 100, 1e-4);  // 32 bits.
}

TEST(GyroscopicTerms, PreparedBeforeForOthersAreAsNew) {
  ModelBuilder builder;
  for (int i = 0; i < 40; ++i) {
    const Vec3 moments = i % 3 == 0 ? Vec3(1, 1, 1) : (i % 3 == 1 ? Vec3(1, 1, 0.5) : Vec3(1, 1.2, 1.5));
    builder.add_body(tests::bulk_body("b" + std::to_string(i), Vec3(i, 0, 0), 1, moments));
  }
  const std::shared_ptr<const Model> model = builder.build();
  BulkBodies bodies = read_bulk_bodies(*model, make_initial_state(*model));
  test::Random random(11);
  const Executor executor(2);
  GyroscopicTerms kept(*model);
  for (int step = 0; step < 12; ++step) {
    std::vector<int> who;
    for (int i = 0; i < 40; ++i) {
      bodies.q[static_cast<std::size_t>(i)] = rotation_exp(3 * random.vector());
      const Vec3 w = 5 * random.vector();
      for (int k = 0; k < 3; ++k) bodies.motion[static_cast<std::size_t>(i)].w[k] = static_cast<float>(w[k]);
      if (i % (1 + step / 2 % 4) == 0) who.push_back(i);  // Others in every second step.
    }
    std::vector<std::array<float, kLaneCount>> turns, fresh_turns;
    kept.prepare(bodies, who, executor);
    kept.find_changes(0.003F, bodies, executor, turns);
    GyroscopicTerms fresh(*model);
    fresh.prepare(bodies, who, executor);
    fresh.find_changes(0.003F, bodies, executor, fresh_turns);
    for (const int i : who)
      EXPECT_EQ(turns[static_cast<std::size_t>(i)], fresh_turns[static_cast<std::size_t>(i)]);
  }
}

}  // namespace
}  // namespace rigor::gyroscopic_terms_test
