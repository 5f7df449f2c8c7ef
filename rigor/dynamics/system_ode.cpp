#include "rigor/dynamics/system_ode.hpp"

#include "rigor/math/rotation.hpp"

#include <cmath>

namespace rigor {
namespace {

template <class Vector>
Quat quaternion_at(const Vector& y, int offset) {
  return Quat(y[offset], y[offset + 1], y[offset + 2], y[offset + 3]);
}

Mat3 matrix_at(const VecX& y, int offset) {
  return Eigen::Map<const Mat3>(y.data() + offset);
}

}  // namespace

SystemOde::SystemOde(AttitudeChart chart, std::span<const BodyInertia> inertias,
                     std::span<const BodyPhase> start, const WrenchField& wrenches)
    : chart_(chart),
      inertias_(inertias),
      start_(start),
      wrench_field_(wrenches),
      phases_(start.size()),
      wrenches_(start.size()) {}

int SystemOde::attitude_size() const {
  return chart_ == AttitudeChart::quaternion ? 4 : chart_ == AttitudeChart::matrix ? 9 : 3;
}

VecX SystemOde::start_vector() const {
  VecX y = VecX::Zero(body_count() * body_size());
  for (int i = 0; i < body_count(); ++i) {
    const BodyPhase& phase = start(i);
    y.segment<3>(offset(i)) = phase.x;
    y.segment<3>(offset(i) + 3) = phase.P;
    y.segment<3>(offset(i) + 6) = phase.L;
    if (chart_ == AttitudeChart::quaternion) {
      y.segment<4>(offset(i) + 9) << phase.q.w(), phase.q.x(), phase.q.y(), phase.q.z();
    } else if (chart_ == AttitudeChart::matrix) {
      Eigen::Map<Mat3>(y.data() + offset(i) + 9) = rotation_matrix(phase.q);
    }
  }
  return y;
}

Quat SystemOde::orientation(const VecX& y, int body) const {
  const int first = offset(body) + 9;
  switch (chart_) {
    case AttitudeChart::quaternion:
      return quaternion_at(y, first).normalized();
    case AttitudeChart::matrix:
      return quaternion_of(gram_schmidt(matrix_at(y, first)));
    case AttitudeChart::rotation_vector:
      return (rotation_exp(y.segment<3>(first)) * start(body).q).normalized();
  }
  return start(body).q;
}

double SystemOde::attitude_drift(const VecX& y, int body) const {
  const int first = offset(body) + 9;
  switch (chart_) {
    case AttitudeChart::quaternion:
      return std::abs(y.segment<4>(first).norm() - 1);
    case AttitudeChart::matrix:
      return (matrix_at(y, first).transpose() * matrix_at(y, first) - Mat3::Identity()).norm();
    case AttitudeChart::rotation_vector:
      return std::abs((rotation_exp(y.segment<3>(first)) * start(body).q).norm() - 1);
  }
  return 0;
}

SystemOde::Attitude SystemOde::attitude_rate(const Attitude& attitude, const Mat3& R_WB,
                                             const Vec3& w_WB) const {
  // q̇ = ½ (0, ω) q.
  if (chart_ == AttitudeChart::quaternion) {
    const Quat rate = Quat(0, w_WB.x(), w_WB.y(), w_WB.z()) * quaternion_at(attitude, 0);
    return 0.5 * Vec4(rate.w(), rate.x(), rate.y(), rate.z());
  }
  // Ṙ = ω × R.
  if (chart_ == AttitudeChart::matrix) {
    const Mat3 rate = skew(w_WB) * R_WB;
    return Eigen::Map<const Attitude>(rate.data(), 9);
  }
  // Φ̇ by the inverse of the differential of exp, truncated as a method of order four allows.
  const Vec3 phi = attitude;
  const Vec3 bracket = phi.cross(w_WB);
  return w_WB - 0.5 * bracket + phi.cross(bracket) / 12;
}

VecX SystemOde::derivative(double t, const VecX& y) {
  // The phases of all bodies, and the forces on them.
  for (int i = 0; i < body_count(); ++i) {
    const int first = offset(i);
    wrenches_[at(i)] = {};
    if (is_ledger(i)) continue;
    phases_[at(i)] = {y.segment<3>(first), orientation(y, i), y.segment<3>(first + 3),
                      y.segment<3>(first + 6)};
  }
  wrench_field_(t, phases_, wrenches_);

  // Newton and Euler: ẋ = P/m, Ṗ = F, L̇ = τ, and the attitude with ω = R I_B⁻¹ Rᵀ L.
  VecX rate(y.size());
  for (int i = 0; i < body_count(); ++i) {
    const BodyPhase& phase = phases_[at(i)];
    const Wrench& wrench = wrenches_[at(i)];
    const BodyInertia& inertia = inertias_[at(i)];
    const int first = offset(i);
    if (is_ledger(i)) {
      // It has no place: its attitude stays.
      rate.segment(first, body_size()).setZero();
      rate.segment<3>(first + 3) = wrench.f_W;
      rate.segment<3>(first + 6) = wrench.tau_W;
      continue;
    }
    // The matrix chart uses R as it stands, so that the right-hand side is smooth in y.
    const Mat3 R_WB = chart_ == AttitudeChart::matrix ? matrix_at(y, first + 9) : rotation_matrix(phase.q);
    const Vec3 w_B = (R_WB.transpose() * phase.L).cwiseQuotient(inertia.moments);
    rate.segment<3>(first) = phase.P / inertia.mass;
    rate.segment<3>(first + 3) = wrench.f_W;
    rate.segment<3>(first + 6) = wrench.tau_W;
    rate.segment(first + 9, attitude_size()) =
        attitude_rate(y.segment(first + 9, attitude_size()), R_WB, R_WB * w_B);
  }
  return rate;
}

}  // namespace rigor
