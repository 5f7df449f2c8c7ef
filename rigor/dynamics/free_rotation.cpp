#include "rigor/dynamics/free_rotation.hpp"

#include "rigor/core/rounding.hpp"
#include "rigor/math/carlson.hpp"
#include "rigor/math/rotation.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace rigor {
namespace {

/// Covers the rounding errors of |ω|, so that the bound holds for the motion as it is evaluated.
constexpr double kSpeedMargin = 1 + 16 * kEpsilon;

/// For a smaller 1 - m the passage of the intermediate axis takes longer than 340/λ, and squares underflow:
/// the motion is then that on the separatrix.
constexpr double kSmallestComplement = 0x1p-1000;

/// Axes in the order of growing moments; ties keep their order.
std::array<int, 3> sorted_axes(const Vec3& moments) {
  std::array<int, 3> axes = {0, 1, 2};
  std::stable_sort(axes.begin(), axes.end(), [&](int i, int k) { return moments[i] < moments[k]; });
  return axes;
}

/// Whether two moments agree to four units in the last place.
bool are_equal(double I, double J) {
  return std::abs(I - J) <= 4 * kEpsilon * std::max(I, J);
}

/// Sums of the absolute values of the terms in each entry of the rotation matrix: its rounding errors are
/// relative to them, and exactly zero where no term is left.
Mat3 rotation_matrix_terms(const Quat& q) {
  const double w = std::abs(q.w()), x = std::abs(q.x()), y = std::abs(q.y()), z = std::abs(q.z());
  const double s = 2 / q.squaredNorm();
  Mat3 terms;
  terms << 1 + s * (y * y + z * z), s * (x * y + w * z), s * (x * z + w * y),  //
      s * (x * y + w * z), 1 + s * (x * x + z * z), s * (y * z + w * x),       //
      s * (x * z + w * y), s * (y * z + w * x), 1 + s * (x * x + y * y);
  return terms;
}

/// Angular momenta [kg m²/s] and shares of them whose squares underflow. What is so slow turns no body by a
/// bit of its orientation, nor do such shares change how it rotates.
constexpr double kSmallestMomentum = 0x1p-400, kSmallestShare = 0x1p-200;

/// M = Rᵀ L with the components that are below their own rounding error set to zero.
Vec3 body_angular_momentum(const Quat& q_WB, const Vec3& L_W) {
  const Vec3 L_B = rotation_matrix(q_WB).transpose() * L_W;
  const double smallest = kSmallestShare * L_B.cwiseAbs().maxCoeff();
  const Vec3 error =
      (4 * kEpsilon * (rotation_matrix_terms(q_WB).transpose() * L_W.cwiseAbs())).cwiseMax(smallest);
  return (L_B.cwiseAbs().array() <= error.array()).select(Vec3::Zero(), L_B);
}

/// The rotation b with b ẑ = m/|m|: first about y (by β, sin β = m_x/|m|) and then about x (by α, tan
/// α = -m_y/m_z). m_z ≥ 0, so both angles stay in [-π/2, π/2] and b is continuous; half angles by square
/// roots.
Quat orbit_frame(const Vec3& m) {
  const double rho = std::hypot(m.y(), m.z());
  const double length = std::hypot(m.x(), rho);
  const double cos_b = std::sqrt(0.5 * (1 + rho / length));
  const double sin_b = m.x() / (2 * length * cos_b);
  const double cos_a = std::sqrt(0.5 * (1 + m.z() / rho));
  const double sin_a = -m.y() / (2 * rho * cos_a);
  return Quat(cos_a * cos_b, sin_a * cos_b, cos_a * sin_b, sin_a * sin_b);
}

/// R_BO with x and z along the given axes of B, signed so that m_z ≥ 0 and the component `positive` (x or y)
/// of m is ≥ 0.
Mat3 orbit_axes(int axis_x, int axis_z, int positive, const Vec3& m_B) {
  Mat3 R_BO;
  R_BO.col(2) = Vec3::Unit(axis_z) * (m_B[axis_z] < 0 ? -1 : 1);
  R_BO.col(0) = Vec3::Unit(axis_x);
  R_BO.col(1) = R_BO.col(2).cross(R_BO.col(0));
  if (R_BO.col(positive).dot(m_B) < 0) R_BO.leftCols<2>() *= -1;
  return R_BO;
}

}  // namespace

FreeRotation::FreeRotation(const Vec3& moments, const Quat& q_WB, const Vec3& L_W) : q_WB_(q_WB) {
  if (L_W.cwiseAbs().maxCoeff() < kSmallestMomentum) {
    max_angular_speed_ = 2 * L_W.cwiseAbs().maxCoeff() / moments.minCoeff();
    return;
  }
  const std::array<int, 3> axes = sorted_axes(moments);
  const bool low_pair = are_equal(moments[axes[0]], moments[axes[1]]);
  const bool high_pair = are_equal(moments[axes[1]], moments[axes[2]]);

  // Three equal moments: ω = L/I is constant.
  if (low_pair && high_pair) {
    spin_W_ = L_W / moments[axes[1]];
    max_angular_speed_ = spin_W_.norm() * kSpeedMargin;
    return;
  }
  // Two equal moments, rotation about one principal axis, or the general motion.
  const Vec3 L_B = body_angular_momentum(q_WB, L_W);
  if (low_pair || high_pair) {
    set_symmetric(moments, low_pair ? axes[2] : axes[0], L_B, L_W);
  } else if ((L_B.array() != 0).count() <= 1) {
    // Steady rotation about a principal axis: ω is parallel to L.
    int axis = 0;
    L_B.cwiseAbs().maxCoeff(&axis);
    spin_W_ = L_W / moments[axis];
    max_angular_speed_ = spin_W_.norm() * kSpeedMargin;
  } else {
    set_asymmetric(moments, L_B, L_W);
  }
}

// R(t) = exp(t L/I_t) R(0) exp(t (1/I_s - 1/I_t) M_s e_s): precession about L, spin about the axis of
// symmetry.
void FreeRotation::set_symmetric(const Vec3& moments, int axis, const Vec3& L_B, const Vec3& L_W) {
  kind_ = Kind::symmetric;
  const double along = moments[axis], across = moments[(axis + 1) % 3];
  spin_W_ = L_W / across;
  spin_B_[axis] = L_B[axis] * ((across - along) / along) / across;
  // |ω| is constant.
  Vec3 w_B = L_B / across;
  w_B[axis] = L_B[axis] / along;
  max_angular_speed_ = w_B.norm() * kSpeedMargin;
}

// The axes of the orbit frame O are axes of B: z the one that M = Rᵀ L circulates around (largest moment if 2
// T I2 < |L|², else smallest; M_z > 0), x the other extreme one, y the intermediate one. With m = M/|L|, r =
// 1/I and ε = ±1,
//
//   ẋ = -ε |L| |r_y - r_z| y z,   ẏ = ε |L| |r_x - r_z| z x,   ż = -ε |L| |r_x - r_y| x y,
//
// so x² + δ_d y² = a² and z² + δ_p y² = c² are constant, with δ_d = |r_y - r_z|/|r_x - r_z|, δ_p = 1 - δ_d,
// a² + c² = 1.
void FreeRotation::set_asymmetric(const Vec3& moments, const Vec3& L_B, const Vec3& L_W) {
  // δ between the reciprocal moments, from differences of the moments themselves.
  const std::array<int, 3> axes = sorted_axes(moments);
  const double I1 = moments[axes[0]], I2 = moments[axes[1]], I3 = moments[axes[2]];
  const double delta_12 = (I2 - I1) / (I3 - I1) * (I3 / I2);
  const double delta_23 = (I3 - I2) / (I3 - I1) * (I1 / I2);
  const double length = L_W.norm();
  const Vec3 m_B = L_B / L_B.norm();

  // The side of the separatrix on which the orbit lies: the sign of 2 T I2 - |L|², without large terms.
  const double m1 = m_B[axes[0]], m2 = m_B[axes[1]], m3 = m_B[axes[2]];
  const double side = delta_12 * m1 * m1 - delta_23 * m3 * m3;
  const bool around_largest = side <= 0;
  epsilon_ = around_largest ? 1 : -1;
  const double delta_d = around_largest ? delta_23 : delta_12;
  const double delta_p = around_largest ? delta_12 : delta_23;
  const double m_z = around_largest ? m3 : m1;
  const double complement = std::abs(side) / (delta_d * (m_z * m_z + delta_p * m2 * m2));
  kind_ = complement < kSmallestComplement ? Kind::separatrix : Kind::circulating;

  // The orbit frame, and the constants of the motion in it.
  const int axis_x = around_largest ? axes[0] : axes[2], axis_z = around_largest ? axes[2] : axes[0];
  const Mat3 R_BO = orbit_axes(axis_x, axis_z, kind_ == Kind::separatrix ? 0 : 1, m_B);
  const Vec3 m_O = R_BO.transpose() * m_B;
  phi_rate_ = length / I2;
  const double rate = length / I1 * ((I3 - I1) / I3);
  if (kind_ == Kind::separatrix) {
    set_separatrix(m_O, delta_d, delta_p, rate);
  } else {
    set_circulating(m_O, delta_d, delta_p, rate);
  }
  set_frames(quaternion_of(R_BO));

  // |ω|² is linear in y² along the orbit, with the slope r_y² - δ_d r_x² - δ_p r_z². That is not positive,
  // because r_y = δ_d r_x + δ_p r_z and squares are convex: the largest |ω| is at y = 0.
  max_angular_speed_ = length * std::hypot(a_ / moments[axis_x], c_ / moments[axis_z]) * kSpeedMargin;
}

void FreeRotation::set_frames(const Quat& q_BO) {
  const OrbitPoint start = orbit_point(0);
  phi0_ = start.phi;
  q_WN_ = q_WB_ * q_BO * orbit_frame(start.m_O);
  q_OB_ = q_BO.conjugate();
}

// With 1 - m = k'² = (δ_d z² - δ_p x²)/(δ_d c²), v = λ t + v0, λ = |L| |r_x - r_z| √δ_d c:
//
//   x = -ε a k' sn/dn,   y = b cn/dn,   z = c k'/dn,   b² = a²/δ_d = 1 - k'² c².
//
// v is counted from the passage nearest to the intermediate axis: then the integrand of φ (circulating_point)
// has one sign and its pole form 1 - b² sn² is a sum of positive terms.
void FreeRotation::set_circulating(const Vec3& m_O, double delta_d, double delta_p, double rate) {
  // Amplitudes and modulus of the elliptic functions, from the constants of the motion.
  const Vec3 squares = m_O.cwiseAbs2();
  const double c2 = squares.z() + delta_p * squares.y();
  const double complement = std::min(1.0, (delta_d * squares.z() - delta_p * squares.x()) / (delta_d * c2));
  const double root_delta = std::sqrt(delta_d);
  a_ = std::sqrt(squares.x() + delta_d * squares.y());
  b_ = a_ / root_delta;
  c_ = std::sqrt(c2);
  jacobi_ = JacobiFunctions(complement);
  // The rates of v and φ.
  lambda_ = rate * root_delta * c_;
  kappa_ = epsilon_ * root_delta * complement * c_;
  half_period_integral_ = 2 * third_kind_integral(jacobi_.quarter_period(), {1, 0, std::sqrt(complement)});

  // tan am(v0) = sn/cn = -ε x/(√δ_d k' y), and v0 = F(am) by R_F; F = tan where its square is below rounding.
  const double tangent = -epsilon_ * m_O.x() / (root_delta * std::sqrt(complement) * m_O.y());
  const double cotangent2 = 1 / (tangent * tangent);
  v0_ = std::abs(tangent) < 0x1p-27
            ? tangent
            : std::copysign(carlson_rf(cotangent2, cotangent2 + complement, cotangent2 + 1), tangent);
}

// a² = δ_d, c² = δ_p, and with u = λ t + u0:  x = a sech u,  y = tanh u,  z = c sech u.
void FreeRotation::set_separatrix(const Vec3& m_O, double delta_d, double delta_p, double rate) {
  a_ = std::sqrt(delta_d);
  b_ = 1;
  c_ = std::sqrt(delta_p);
  lambda_ = rate * a_ * c_;
  jacobi_ = JacobiFunctions(0);
  v0_ = std::asinh(m_O.y() / std::hypot(m_O.x(), m_O.z()));
}

Quat FreeRotation::orientation(double dt) const {
  if (dt == 0) return q_WB_;
  if (kind_ == Kind::uniform) return (rotation_exp(dt * spin_W_) * q_WB_).normalized();
  if (kind_ == Kind::symmetric) {
    return (rotation_exp(dt * spin_W_) * q_WB_ * rotation_exp(dt * spin_B_)).normalized();
  }
  // R(t) = R(0) B(0) Rz(φ) B(t)ᵀ: the frame built on M and the axis x rotates about L by φ.
  const OrbitPoint point = orbit_point(dt);
  const double half = 0.5 * (point.phi - phi0_);
  const Quat about_L(std::cos(half), 0, 0, std::sin(half));
  return (q_WN_ * about_L * orbit_frame(point.m_O).conjugate() * q_OB_).normalized();
}

FreeRotation::OrbitPoint FreeRotation::orbit_point(double dt) const {
  return kind_ == Kind::separatrix ? separatrix_point(dt) : circulating_point(dt);
}

// φ̇ = |L| (r_y y² + r_z z²)/(y² + z²) = |L| r_y - ε |L| |r_y - r_z| z²/(y² + z²), and z²/(y² + z²) = k'²
// c²/(1 - b² sn²):
//
//   φ = |L| r_y t - κ Π(b²; v),   κ = ε √δ_d k'² c.
FreeRotation::OrbitPoint FreeRotation::circulating_point(double dt) const {
  // v reduced by whole half periods to w in [-K, K].
  const double K = jacobi_.quarter_period();
  const double v = lambda_ * dt + v0_;
  const double half_periods = std::nearbyint(v / (2 * K));
  const double w = std::clamp(v - 2 * half_periods * K, -K, K);
  const double sign = std::fmod(half_periods, 2) == 0 ? 1 : -1;

  // M/|L| by the elliptic functions, and φ by the integral of the third kind.
  const JacobiValues f = jacobi_.at(w);
  const double root = std::sqrt(jacobi_.complement());
  const Vec3 m_O(-epsilon_ * sign * a_ * root * f.sn / f.dn, sign * b_ * f.cn / f.dn, c_ * root / f.dn);
  const double integral = half_periods * half_period_integral_ + third_kind_integral(w, f);
  return {m_O, phi_rate_ * dt - kappa_ * integral};
}

// ∫ sech²/(c² sech² + tanh²) du is elementary, and the factors before it cancel.
FreeRotation::OrbitPoint FreeRotation::separatrix_point(double dt) const {
  const double u = lambda_ * dt + v0_;
  const JacobiValues f = jacobi_.at(u);
  return {Vec3(a_ * f.cn, f.sn, c_ * f.cn), phi_rate_ * dt - std::atan2(a_ * f.sn, c_)};
}

double FreeRotation::third_kind_integral(double w, const JacobiValues& f) const {
  const double cn2 = f.cn * f.cn, dn2 = f.dn * f.dn;
  // Carlson's form: w + b² sn³ R_J(cn², dn², 1, 1 - b² sn²)/3, with 1 - b² sn² = c² dn² + a² cn².
  const double pole = c_ * c_ * dn2 + a_ * a_ * cn2;
  return w + b_ * b_ * f.sn * f.sn * f.sn * carlson_rj(cn2, dn2, 1, pole) / 3;
}

}  // namespace rigor
