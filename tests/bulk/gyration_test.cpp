#include "rigor/bulk/gyration.hpp"

#include "rigor/math/rotation.hpp"

#include "random_vectors.hpp"

#include <gtest/gtest.h>

namespace rigor {
namespace {

using test::Random;

Body body_of(const Vec3& moments) {
  Body body;
  body.moments = moments;
  return body;
}

/// ω after h by the step under test.
Vec3 turned(const Body& body, const Quat& q_WB, const Vec3& w_W, float h) {
  const float w[3] = {static_cast<float>(w_W.x()), static_cast<float>(w_W.y()), static_cast<float>(w_W.z())};
  float change[3];
  gyroscopic_change(gyration_of(body, q_WB), w, h, change);
  return w_W + Vec3(change[0], change[1], change[2]);
}

Vec3 angular_acceleration(const Body& body, const Quat& q_WB, const Vec3& w_W) {
  const Vec3 w_B = q_WB.conjugate() * w_W;
  const Vec3 torque_B = -w_B.cross(body.moments.cwiseProduct(w_B));
  return q_WB * Vec3(torque_B.cwiseQuotient(body.moments));
}

double energy(const Body& body, const Quat& q_WB, const Vec3& w_W) {
  const Vec3 w_B = q_WB.conjugate() * w_W;
  return 0.5 * w_B.dot(body.moments.cwiseProduct(w_B));
}

TEST(Gyration, IsEulersEquationToFirstOrder) {
  Random random(1);
  for (int trial = 0; trial < 50; ++trial) {
    const Body body = body_of(Vec3(1, 2, 2.5));
    const Quat q_WB = rotation_exp(3 * random.vector());
    const Vec3 w = 2 * random.vector();
    const float h = 1e-3f;
    const Vec3 expected = w + h * angular_acceleration(body, q_WB, w);
    // Second order in h ω = 3e-3, and 32 bits.
    EXPECT_LT((turned(body, q_WB, w, h) - expected).norm(), 20 * h * h * w.squaredNorm() + 1e-6);
  }
}

TEST(Gyration, GainsNoEnergyAtAnySpeed) {
  Random random(2);
  for (int trial = 0; trial < 200; ++trial) {
    const Body body = body_of(Vec3(0.1, 1, 1.05));
    const Quat q_WB = rotation_exp(3 * random.vector());
    Vec3 w = 300 * random.vector();
    const double before = energy(body, q_WB, w);
    for (int k = 0; k < 20; ++k) w = turned(body, q_WB, w, 1.0f / 60);
    EXPECT_LE(energy(body, q_WB, w), before * (1 + 1e-5));
  }
}

TEST(Gyration, OfSpinAboutAPrincipalAxisIsNone) {
  const Body body = body_of(Vec3(1, 2, 2.5));
  const Quat q_WB = rotation_exp(Vec3(0.3, -0.4, 1));
  for (int k = 0; k < 3; ++k) {
    const Vec3 w = q_WB * Vec3(50 * Vec3::Unit(k));
    EXPECT_LT((turned(body, q_WB, w, 1.0f / 60) - w).norm(), 1e-4);  // 32 bits of 50 rad/s.
  }
}

}  // namespace
}  // namespace rigor
