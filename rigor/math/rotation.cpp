#include "rigor/math/rotation.hpp"

#include <cmath>

namespace rigor {

Mat3 rotation_matrix(const Quat& q) {
  const double w = q.w(), x = q.x(), y = q.y(), z = q.z();
  const double s = 2 / (w * w + x * x + y * y + z * z);
  Mat3 R;
  R << 1 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y),  //
      s * (x * y + w * z), 1 - s * (x * x + z * z), s * (y * z - w * x),   //
      s * (x * z - w * y), s * (y * z + w * x), 1 - s * (x * x + y * y);
  return R;
}

Quat rotation_exp(const Vec3& phi) {
  const double angle = phi.norm();
  const double half = 0.5 * angle;
  // sin(a/2)/a = ½ sinc(a/2); below 1e-4 two Taylor terms are exact to rounding.
  const double factor = angle < 1e-4 ? 0.5 * (1 - half * half / 6) : std::sin(half) / angle;
  return Quat(std::cos(half), factor * phi.x(), factor * phi.y(), factor * phi.z());
}

Vec3 rotation_log(const Quat& q) {
  const Vec3 v = q.vec();
  const double sine = v.norm();
  if (sine == 0) return Vec3::Zero();
  // q and -q are the same rotation; the sign with w ≥ 0 gives the shorter one. atan2 is accurate at all
  // angles.
  const double sign = q.w() < 0 ? -1 : 1;
  return sign * 2 * std::atan2(sine, sign * q.w()) / sine * v;
}

double rotation_angle_between(const Quat& a, const Quat& b) {
  const Quat d = a.conjugate() * b;
  return 2 * std::atan2(d.vec().norm(), std::abs(d.w()));
}

Quat quaternion_of(const Mat3& R) {
  Quat q(R);
  q.normalize();
  if (q.w() < 0) q.coeffs() = -q.coeffs();
  return q;
}

Mat3 gram_schmidt(const Mat3& R) {
  const Vec3 a = R.col(0).normalized();
  const Vec3 b = (R.col(1) - a.dot(R.col(1)) * a).normalized();
  Mat3 result;
  result << a, b, a.cross(b);
  return result;
}

Mat3 skew(const Vec3& a) {
  Mat3 S;
  S << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
  return S;
}

Mat3 frame_with_z(const Vec3& n) {
  // The axis least aligned with n gives the best-conditioned cross product.
  int axis = 0;
  n.cwiseAbs().minCoeff(&axis);
  const Vec3 t1 = Vec3::Unit(axis).cross(n).normalized();
  Mat3 frame;
  frame << t1, n.cross(t1), n;
  return frame;
}

}  // namespace rigor
