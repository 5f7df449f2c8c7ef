#pragma once

#include "rigor/math/types.hpp"

#include <algorithm>
#include <cmath>

namespace rigor::tests {

/// Attitude and body angular momentum M = Rᵀ L in extended precision.
struct ExtendedRotation {
  long double q[4];  // w x y z
  long double M[3];

  Quat quaternion() const {
    return Quat(static_cast<double>(q[0]), static_cast<double>(q[1]), static_cast<double>(q[2]),
                static_cast<double>(q[3]));
  }
};

inline ExtendedRotation start_rotation(const Quat& q_WB, const Vec3& L_W) {
  ExtendedRotation y{{q_WB.w(), q_WB.x(), q_WB.y(), q_WB.z()}, {}};
  const long double norm = std::sqrt(y.q[0] * y.q[0] + y.q[1] * y.q[1] + y.q[2] * y.q[2] + y.q[3] * y.q[3]);
  for (long double& value : y.q) value /= norm;
  const long double w = y.q[0], a = y.q[1], b = y.q[2], c = y.q[3];
  const long double R[3][3] = {{1 - 2 * (b * b + c * c), 2 * (a * b - w * c), 2 * (a * c + w * b)},
                               {2 * (a * b + w * c), 1 - 2 * (a * a + c * c), 2 * (b * c - w * a)},
                               {2 * (a * c - w * b), 2 * (b * c + w * a), 1 - 2 * (a * a + b * b)}};
  for (int i = 0; i < 3; ++i) y.M[i] = R[0][i] * L_W[0] + R[1][i] * L_W[1] + R[2][i] * L_W[2];
  return y;
}

/// One step of Ṁ = M × I⁻¹ M, q̇ = ½ q (0, I⁻¹ M) by the Taylor series of degree 24: the products are Cauchy
/// products.
inline void taylor_step(const long double (&r)[3], long double h, ExtendedRotation& y) {
  constexpr int degree = 24;
  long double M[3][degree + 1], q[4][degree + 1];
  for (int i = 0; i < 3; ++i) M[i][0] = y.M[i];
  for (int i = 0; i < 4; ++i) q[i][0] = y.q[i];
  for (int n = 0; n < degree; ++n) {
    long double dM[3] = {}, dq[4] = {};
    for (int k = 0; k <= n; ++k) {
      const int l = n - k;
      dM[0] += (r[2] - r[1]) * M[1][k] * M[2][l];
      dM[1] += (r[0] - r[2]) * M[2][k] * M[0][l];
      dM[2] += (r[1] - r[0]) * M[0][k] * M[1][l];
      const long double wx = r[0] * M[0][l], wy = r[1] * M[1][l], wz = r[2] * M[2][l];
      dq[0] -= q[1][k] * wx + q[2][k] * wy + q[3][k] * wz;
      dq[1] += q[0][k] * wx + q[2][k] * wz - q[3][k] * wy;
      dq[2] += q[0][k] * wy + q[3][k] * wx - q[1][k] * wz;
      dq[3] += q[0][k] * wz + q[1][k] * wy - q[2][k] * wx;
    }
    for (int i = 0; i < 3; ++i) M[i][n + 1] = dM[i] / (n + 1);
    for (int i = 0; i < 4; ++i) q[i][n + 1] = dq[i] / (2 * (n + 1));
  }
  const auto sum = [h](const long double(&c)[degree + 1]) {
    long double value = c[degree];
    for (int k = degree - 1; k >= 0; --k) value = value * h + c[k];
    return value;
  };
  for (int i = 0; i < 3; ++i) y.M[i] = sum(M[i]);
  for (int i = 0; i < 4; ++i) y.q[i] = sum(q[i]);
}

/// The torque-free rotation after t, by steps in which the body turns less than a quarter radian: truncation
/// is far below rounding, so the error is a few units of 1e-19 a step.
inline ExtendedRotation rotate_extended(const Vec3& moments, const Quat& q_WB, const Vec3& L_W, double t) {
  ExtendedRotation y = start_rotation(q_WB, L_W);
  long double r[3];
  long double speed = 0;
  for (int i = 0; i < 3; ++i) {
    r[i] = 1 / static_cast<long double>(moments[i]);
    speed = std::max(speed, std::abs(y.M[i]) * r[i]);
  }
  speed =
      std::max(speed, static_cast<long double>(L_W.norm()) / static_cast<long double>(moments.maxCoeff()));
  const int steps = 1 + static_cast<int>(4 * speed * std::abs(static_cast<long double>(t)));
  const long double h = static_cast<long double>(t) / steps;
  for (int i = 0; i < steps; ++i) taylor_step(r, h, y);
  return y;
}

}  // namespace rigor::tests
