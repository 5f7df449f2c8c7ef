#include "rigor/bulk/gyration.hpp"

#include "rigor/math/rotation.hpp"

#include <cmath>

namespace rigor {

BodyGyration gyration_of(const Body& body, const Quat& q_WB) {
  const Mat3 R_WB = rotation_matrix(q_WB);
  BodyGyration gyration;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) gyration.R_WB[3 * i + j] = static_cast<float>(R_WB(i, j));
    gyration.moments[i] = static_cast<float>(body.moments[i]);
  }
  return gyration;
}

bool is_round(const Body& body) {
  return body.moments[0] == body.moments[1] && body.moments[1] == body.moments[2];
}

void gyroscopic_change(const BodyGyration& body, const float* w, float h, float* change) {
  const float* R = body.R_WB;
  const float* I = body.moments;
  float b[3];  // ω along the principal axes.
  for (int j = 0; j < 3; ++j) b[j] = R[j] * w[0] + R[3 + j] * w[1] + R[6 + j] * w[2];

  // J x = h ω × I ω,  J = I + h (ω~ I - (I ω)~): row i has I_i on the diagonal and h (I_k - I_j) of the other
  // components.
  const float g0 = h * (I[2] - I[1]), g1 = h * (I[0] - I[2]), g2 = h * (I[1] - I[0]);
  const float f[3] = {g0 * b[1] * b[2], g1 * b[2] * b[0], g2 * b[0] * b[1]};
  const float m01 = g0 * b[2], m02 = g0 * b[1];
  const float m10 = g1 * b[2], m12 = g1 * b[0];
  const float m20 = g2 * b[1], m21 = g2 * b[0];
  // Cramer's rule.
  const float c00 = I[1] * I[2] - m12 * m21, c01 = m12 * m20 - m10 * I[2], c02 = m10 * m21 - I[1] * m20;
  const float determinant = I[0] * c00 + m01 * c01 + m02 * c02;
  const float x[3] = {
      (f[0] * c00 + f[1] * (m02 * m21 - m01 * I[2]) + f[2] * (m01 * m12 - m02 * I[1])) / determinant,
      (f[0] * c01 + f[1] * (I[0] * I[2] - m02 * m20) + f[2] * (m02 * m10 - I[0] * m12)) / determinant,
      (f[0] * c02 + f[1] * (m01 * m20 - I[0] * m21) + f[2] * (I[0] * I[1] - m01 * m10)) / determinant};
  // One Newton step is not the solution: at several radians a step its energy may be more.
  float before = 0, after = 0, y[3];
  for (int j = 0; j < 3; ++j) {
    y[j] = b[j] - x[j];
    before += I[j] * b[j] * b[j];
    after += I[j] * y[j] * y[j];
  }
  const float scale = after > before ? std::sqrt(before / after) : 1;
  for (int j = 0; j < 3; ++j) y[j] = scale * y[j] - b[j];
  for (int i = 0; i < 3; ++i) change[i] = R[3 * i] * y[0] + R[3 * i + 1] * y[1] + R[3 * i + 2] * y[2];
}

}  // namespace rigor
