#include "rigor/dynamics/joint_measures.hpp"

#include "rigor/math/rotation.hpp"

#include <array>
#include <cmath>

namespace rigor {

namespace {

/// F(a, b) with its derivatives; `curvature` is F_aa ȧ² + 2 F_ab ȧ ḃ + F_bb ḃ².
struct Slopes {
  double value, F_a, F_b, curvature;
};

JointCoordinate chain(const JointCoordinate& a, const JointCoordinate& b, const Slopes& F) {
  return {F.value, F.F_a * a.rate + F.F_b * b.rate, F.F_a * a.J_A + F.F_b * b.J_A,
          F.F_a * a.J_B + F.F_b * b.J_B, F.F_a * a.bias + F.F_b * b.bias + F.curvature};
}

RotationMeasure chain(const RotationMeasure& a, const RotationMeasure& b, const Slopes& F) {
  return {F.value, F.F_a * a.rate + F.F_b * b.rate, F.F_a * a.gradient_W + F.F_b * b.gradient_W,
          F.F_a * a.bias + F.F_b * b.bias + F.curvature};
}

template <class Measure>
Slopes slopes_of_product(const Measure& a, const Measure& b) {
  return {a.value * b.value, b.value, a.value, 2 * a.rate * b.rate};
}

template <class Measure>
Slopes slopes_of_quotient(const Measure& a, const Measure& b) {
  const double value = a.value / b.value;
  // F = a/b: F_ab = -1/b², F_bb = 2 a/b³.
  const double curvature = 2 * b.rate * (value * b.rate - a.rate) / (b.value * b.value);
  return {value, 1 / b.value, -value / b.value, curvature};
}

RotationMeasure operator+(const RotationMeasure& a, const RotationMeasure& b) {
  return chain(a, b, {a.value + b.value, 1, 1, 0});
}
RotationMeasure operator-(const RotationMeasure& a, const RotationMeasure& b) {
  return chain(a, b, {a.value - b.value, 1, -1, 0});
}
RotationMeasure operator*(const RotationMeasure& a, const RotationMeasure& b) {
  return chain(a, b, slopes_of_product(a, b));
}
RotationMeasure operator/(const RotationMeasure& a, const RotationMeasure& b) {
  return chain(a, b, slopes_of_quotient(a, b));
}
RotationMeasure operator+(const RotationMeasure& a, double c) {
  return {a.value + c, a.rate, a.gradient_W, a.bias};
}
RotationMeasure operator*(double c, const RotationMeasure& a) {
  return {c * a.value, c * a.rate, c * a.gradient_W, c * a.bias};
}

Vec6 stacked(const Vec3& linear, const Vec3& angular) {
  Vec6 row;
  row << linear, angular;
  return row;
}

JointCoordinate on_both(const RotationMeasure& a) {
  return {a.value, a.rate, stacked(Vec3::Zero(), -a.gradient_W), stacked(Vec3::Zero(), a.gradient_W), a.bias};
}

double power(const Vec6& row, const BodyMotion& body) {
  return row.head<3>().dot(body.v) + row.tail<3>().dot(body.w);
}

}  // namespace

JointCoordinate operator+(const JointCoordinate& a, const JointCoordinate& b) {
  return chain(a, b, {a.value + b.value, 1, 1, 0});
}

JointCoordinate operator-(const JointCoordinate& a, const JointCoordinate& b) {
  return chain(a, b, {a.value - b.value, 1, -1, 0});
}

JointCoordinate operator*(const JointCoordinate& a, const JointCoordinate& b) {
  return chain(a, b, slopes_of_product(a, b));
}

JointCoordinate operator/(const JointCoordinate& a, const JointCoordinate& b) {
  return chain(a, b, slopes_of_quotient(a, b));
}

JointCoordinate operator+(const JointCoordinate& a, double c) {
  JointCoordinate sum = a;
  sum.value += c;
  return sum;
}

JointCoordinate operator*(double c, const JointCoordinate& a) {
  return {c * a.value, c * a.rate, c * a.J_A, c * a.J_B, c * a.bias};
}

namespace {

template <class Measure>
Measure angle_of_point(const Measure& y, const Measure& x) {
  const double square = x.value * x.value + y.value * y.value;
  if (square == 0) return {};
  // F = atan2(y, x): F_y = x/r², F_x = -y/r², and with the rates along and across the radius
  // d²F = -2 (radial rate)(angular rate)/r.
  const double F_y = x.value / square, F_x = -y.value / square;
  const double radial = (x.value * x.rate + y.value * y.rate) / square;
  const double angular = F_y * y.rate + F_x * x.rate;
  return chain(y, x, {std::atan2(y.value, x.value), F_y, F_x, -2 * radial * angular});
}

template <class Measure>
Measure length_of_vector(std::span<const Measure> components) {
  Vec3 value = Vec3::Zero(), rate = Vec3::Zero();
  for (std::size_t i = 0; i < components.size(); ++i) {
    value[static_cast<Eigen::Index>(i)] = components[i].value;
    rate[static_cast<Eigen::Index>(i)] = components[i].rate;
  }
  const double length = value.norm(), speed = rate.norm();
  // Its direction; that of the rate, or of the last component, where the vector is zero.
  Vec3 direction = Vec3::Unit(static_cast<Eigen::Index>(components.size()) - 1);
  if (length > 0) {
    direction = value / length;
  } else if (speed > 0) {
    direction = rate / speed;
  }
  // ṙ = direction · rate.
  Measure result;
  for (std::size_t i = 0; i < components.size(); ++i) {
    result = result + direction[static_cast<Eigen::Index>(i)] * components[i];
  }
  result.value = length;
  // Motion across the direction makes the vector longer: r̈ gets (|rate|² - ṙ²)/r.
  if (length > 0) result.bias += (rate - result.rate * direction).squaredNorm() / length;
  return result;
}

}  // namespace

JointCoordinate angle_of(const JointCoordinate& y, const JointCoordinate& x) {
  return angle_of_point(y, x);
}

JointCoordinate length_of(std::span<const JointCoordinate> components) {
  return length_of_vector(components);
}

JointMeasures::JointMeasures(const Joint& joint, const BodyMotion& A, const BodyMotion& B)
    : joint_(joint), A_(A), B_(B) {
  // The arms of the frames' origins about the centres of mass, and the displacement d between them.
  R_WF_ = A.R * joint.X_AF.R;
  p_AJ_W_ = A.R * joint.X_AF.p;
  p_BK_W_ = B.R * joint.X_BK.p;
  p_AK_W_ = (B.x - A.x) + p_BK_W_;
  p_JK_W_ = p_AK_W_ - p_AJ_W_;
  d_rate_ = (B.v - A.v) + B.w.cross(p_BK_W_) - A.w.cross(p_AJ_W_);
  centripetal_ = B.w.cross(B.w.cross(p_BK_W_)) - A.w.cross(A.w.cross(p_AJ_W_));
}

const JointMeasures::Rotation& JointMeasures::rotation() const {
  if (rotation_) return *rotation_;
  // Equal frames give a symmetric product, so q = 1 without rounding.
  const Mat3 R_WK = B_.R * joint_.X_BK.R;
  // d/dt R_WJᵀ (ω_B - ω_A) = R_WJᵀ (ω̇_B - ω̇_A - ω_A × (ω_B - ω_A)).
  return rotation_.emplace(Rotation{quaternion_of(R_WF_.transpose() * R_WK),
                                    R_WF_.transpose() * (B_.w - A_.w),
                                    -(R_WF_.transpose() * A_.w.cross(B_.w))});
}

JointCoordinate JointMeasures::displacement(int k) const {
  // g = n·d along an axis n that rotates with A: ġ = n·(v_K - v_F) + (ω_A × n)·d.
  const Vec3 n = R_WF_.col(k);
  JointCoordinate measure;
  measure.value = n.dot(p_JK_W_);
  measure.J_A = stacked(-n, -p_AK_W_.cross(n));
  measure.J_B = stacked(n, p_BK_W_.cross(n));
  measure.rate = power(measure.J_A, A_) + power(measure.J_B, B_);
  // d = p_K - p_F. g̈ = n·d̈ + 2 ṅ·ḋ + n̈·d, with ṅ = ω_A × n.
  const Vec3 n_rate = A_.w.cross(n);
  measure.bias = n.dot(centripetal_) + 2 * n_rate.dot(d_rate_) + A_.w.cross(n_rate).dot(p_JK_W_);
  return measure;
}

RotationMeasure JointMeasures::quaternion(int i) const {
  // q̇ = ½ Ω q with Ω = w_FK_F, so that q̈ = ½ Ω̇ q - ¼ |Ω|² q.
  const auto& [q_FK, w_FK_F, alpha_JK_J] = rotation();
  Vec3 gradient = -0.5 * q_FK.vec();
  double value = q_FK.w();
  if (i > 0) {
    const Vec3 axis = Vec3::Unit(i - 1);
    gradient = 0.5 * (q_FK.w() * axis + q_FK.vec().cross(axis));
    value = q_FK.vec()[i - 1];
  }
  return {value, gradient.dot(w_FK_F), R_WF_ * gradient,
          gradient.dot(alpha_JK_J) - 0.25 * w_FK_F.squaredNorm() * value};
}

JointCoordinate twist_angle(const JointMeasures& measures) {
  return on_both(2 * angle_of_point(measures.quaternion(3), measures.quaternion(0)));
}

std::pair<JointCoordinate, JointCoordinate> swing(const JointMeasures& measures) {
  const RotationMeasure w = measures.quaternion(0), x = measures.quaternion(1), y = measures.quaternion(2),
                        z = measures.quaternion(3);
  // q = s t with the twist t = (w, 0, 0, z)/c gives the swing s = (c, (w x - y z)/c, (w y + x z)/c, 0),
  // c = cos θ/2. Where c = 0 the twist is undetermined: t = 1.
  const RotationMeasure c = length_of_vector(std::span<const RotationMeasure>(std::array{w, z}));
  constexpr double smallest_cosine = 1e-9;
  if (c.value < smallest_cosine) return {on_both(4 * (x / (w + 1))), on_both(4 * (y / (w + 1)))};
  const RotationMeasure divisor = c * (c + 1);
  return {on_both(4 * ((w * x - y * z) / divisor)), on_both(4 * ((w * y + x * z) / divisor))};
}

JointCoordinate whole_rotation(const JointMeasures& measures, int k) {
  return on_both(4 * (measures.quaternion(k + 1) / (measures.quaternion(0) + 1)));
}

JointCoordinate whole_angle(const JointMeasures& measures) {
  std::array sines{measures.quaternion(1), measures.quaternion(2), measures.quaternion(3)};
  // A vector of the size of rounding errors has no direction and counts as zero.
  constexpr double smallest_sine = 1e-13;
  if (Vec3(sines[0].value, sines[1].value, sines[2].value).norm() < smallest_sine) {
    for (RotationMeasure& sine : sines) sine.value = 0;
  }
  return on_both(
      2 * angle_of_point(length_of_vector(std::span<const RotationMeasure>(sines)), measures.quaternion(0)));
}

JointCoordinate direction_cosine(const JointMeasures& measures, int i, int j) {
  if (i == j) {
    // 1 - 2 (the squares of the other two components of the vector).
    const RotationMeasure a = measures.quaternion((i + 1) % 3 + 1), b = measures.quaternion((i + 2) % 3 + 1);
    return on_both(-2 * (a * a + b * b) + 1);
  }
  const int k = 3 - i - j;
  const double sign = (i + 1) % 3 == j ? -1 : 1;
  return on_both(2 * (measures.quaternion(i + 1) * measures.quaternion(j + 1) +
                      sign * (measures.quaternion(0) * measures.quaternion(k + 1))));
}

}  // namespace rigor
