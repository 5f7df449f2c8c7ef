#include "rigor/math/principal_axes.hpp"

#include "rigor/core/rounding.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rigor {

namespace {

/// Largest number of sweeps. The convergence is quadratic and needs about five.
constexpr int kMaxSweeps = 30;

/// Zeroes A(p, q) by the smaller of the two rotations that do so, and accumulates it in R: A_before = R A Rᵀ
/// remains true.
void rotate(int p, int q, Mat3& A, Mat3& R) {
  // The tangent t of the angle solves t² + 2 θ t - 1 = 0; its smaller root is an angle of at most 45°.
  const double theta = (A(q, q) - A(p, p)) / (2 * A(p, q));
  const double t = (theta >= 0 ? 1.0 : -1.0) / (std::abs(theta) + std::hypot(theta, 1.0));
  const double c = 1 / std::sqrt(1 + t * t);
  const double s = t * c;

  // The rotated matrix: elements that are known exactly are not computed.
  A(p, p) -= t * A(p, q);
  A(q, q) += t * A(p, q);
  A(p, q) = A(q, p) = 0;
  const int r = 3 - p - q;
  const double a_rp = A(r, p), a_rq = A(r, q);
  A(r, p) = A(p, r) = c * a_rp - s * a_rq;
  A(r, q) = A(q, r) = s * a_rp + c * a_rq;

  const Vec3 column_p = R.col(p);
  R.col(p) = c * column_p - s * R.col(q);
  R.col(q) = s * column_p + c * R.col(q);
}

bool is_negligible(const Mat3& A, int p, int q) {
  return std::abs(A(p, q)) <= kUnitRoundoff * std::sqrt(std::abs(A(p, p))) * std::sqrt(std::abs(A(q, q)));
}

/// Exponent of a power of two near the largest element; scaling by it makes the result independent of the
/// units.
int exponent_of(const Mat3& A) {
  const double largest = A.cwiseAbs().maxCoeff();
  return largest > 0 && std::isfinite(largest) ? std::ilogb(largest) : 0;
}

}  // namespace

PrincipalAxes principal_axes(const Mat3& inertia) {
  const Mat3 symmetric = inertia.selfadjointView<Eigen::Upper>();
  // A matrix that is diagonal to rounding keeps its axes.
  const double off_diagonal =
      std::max({std::abs(symmetric(0, 1)), std::abs(symmetric(0, 2)), std::abs(symmetric(1, 2))});
  const int exponent = exponent_of(symmetric);
  Mat3 A = symmetric.unaryExpr([exponent](double x) { return std::scalbn(x, -exponent); });
  if (std::scalbn(off_diagonal, -exponent) <= 16 * kUnitRoundoff * A.norm()) {
    return {Mat3::Identity(), symmetric.diagonal()};
  }

  // Cyclic Jacobi method: sweeps over the three off-diagonal elements until all are negligible.
  Mat3 R = Mat3::Identity();
  for (int sweep = 0; sweep < kMaxSweeps; ++sweep) {
    bool is_diagonal = true;
    for (const auto& [p, q] : {std::pair{0, 1}, std::pair{0, 2}, std::pair{1, 2}}) {
      if (is_negligible(A, p, q)) continue;
      rotate(p, q, A, R);
      is_diagonal = false;
    }
    if (is_diagonal) break;
  }

  // One step of the Newton iteration for the orthogonal polar factor removes what the rounding of the
  // rotations accumulated.
  R = 1.5 * R - 0.5 * (R * (R.transpose() * R));
  const Vec3 moments = A.diagonal().unaryExpr([exponent](double x) { return std::scalbn(x, exponent); });
  return {R, moments};
}

}  // namespace rigor
