#include "rigor/dynamics/dense_phase.hpp"

namespace rigor {

BodyPhase DensePhase::at(double theta) const {
  // Horner's scheme, then the quaternion back on the unit sphere.
  Eigen::Matrix<double, 13, 1> y = coefficients.col(degree);
  for (int k = degree - 1; k >= 0; --k) y = y * theta + coefficients.col(k);
  const Vec4 q = y.segment<4>(dense_q_row).normalized();
  return {y.segment<3>(dense_x_row), Quat(q[0], q[1], q[2], q[3]), y.segment<3>(dense_P_row),
          y.segment<3>(dense_L_row)};
}

DensePhase quadratic_dense_phase(const BodyPhase& start, const BodyPhase& end, const Vec3& v, const Vec3& w,
                                 double h) {
  const auto stacked = [](const BodyPhase& phase) {
    Eigen::Matrix<double, 13, 1> y;
    y << phase.x, phase.q.w(), phase.q.vec(), phase.P, phase.L;
    return y;
  };

  // Rates at θ = 0: h v and h q̇ with q̇ = ½ (0, ω) q; P and L are linear, so their rate is their change.
  const Quat w_q = Quat(0, w.x(), w.y(), w.z()) * start.q;
  Eigen::Matrix<double, 13, 1> rate = stacked(end) - stacked(start);
  const Eigen::Matrix<double, 13, 1> change = rate;
  rate.segment<3>(dense_x_row) = h * v;
  rate.segment<4>(dense_q_row) = 0.5 * h * Vec4(w_q.w(), w_q.x(), w_q.y(), w_q.z());

  // The parabola with this start, this rate and this change: y₀ + rate θ + (change - rate) θ².
  DensePhase dense;
  dense.degree = 2;
  dense.coefficients.col(0) = stacked(start);
  dense.coefficients.col(1) = rate;
  dense.coefficients.col(2) = change - rate;
  return dense;
}

QuaternionFit fit_quaternions(const std::function<Quat(double theta)>& q, const Quat& start, int n) {
  const Vec4 first(start.w(), start.x(), start.y(), start.z());

  // Differences from the start at θ = k/n. They are small, so the condition number of the system does no
  // harm.
  constexpr int most = DensePhase::max_degree;
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, most, most> powers(n, n);
  Eigen::Matrix<double, Eigen::Dynamic, 4, Eigen::ColMajor, most, 4> differences(n, 4);
  Vec4 previous = first;
  for (int k = 1; k <= n; ++k) {
    const double theta = k / static_cast<double>(n);
    const Quat sample = q(theta);
    Vec4 value(sample.w(), sample.x(), sample.y(), sample.z());
    if (value.dot(previous) < 0) value = -value;
    previous = value;
    differences.row(k - 1) = (value - first).transpose();
    double power = theta;
    for (int m = 0; m < n; ++m, power *= theta) powers(k - 1, m) = power;
  }

  // The polynomial through them has the coefficients V⁻¹ (differences), V the Vandermonde matrix.
  QuaternionFit coefficients(4, n + 1);
  coefficients.col(0) = first;
  coefficients.rightCols(n) = powers.partialPivLu().solve(differences).transpose();
  return coefficients;
}

}  // namespace rigor
