#include "rigor/contact/impact/slip_flow.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/math/polynomial.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace rigor {

namespace {

/// f_θ (1 + t²)² as a polynomial in t = tan((θ - θ₀)/2), for θ₀ = 0 or π (rotated by half a circle, where
/// b changes its sign).
Polynomial angular_rate_polynomial(const SlipFlow& flow, double sign) {
  const Polynomial c{1, 0, -1}, n{0, 2}, w{1, 0, 1};
  const Polynomial b1{sign * flow.drive * flow.b.x()}, b2{sign * flow.drive * flow.b.y()};
  const Polynomial a{flow.mu * (flow.M(0, 0) - flow.M(1, 1))}, k{flow.mu * flow.M(0, 1)};
  return (b2 * c - b1 * n) * w + a * n * c + k * (n * n - c * c);
}

/// Two steps of Newton's method on f_θ.
double polished(const SlipFlow& flow, double theta) {
  for (int step = 0; step < 2; ++step) {
    const Vec2 d{std::cos(theta), std::sin(theta)};
    const double slope = flow.angular_rate_slope(d);
    if (slope == 0) return theta;
    const double change = flow.angular_rate(d) / slope;
    if (!(std::abs(change) < 1e-6)) return theta;
    theta -= change;
  }
  return theta;
}

}  // namespace

SlipFlow::SlipFlow(const CollisionMatrix& collision)
    : M(collision.K.topLeftCorner<2, 2>()),
      b(collision.K.topRightCorner<2, 1>()),
      kappa(collision.K(2, 2)),
      mu(collision.mu) {}

double SlipFlow::angular_rate(const Vec2& direction) const {
  return perpendicular(direction).dot(slip_rate(direction));
}

double SlipFlow::angular_rate_slope(const Vec2& direction) const {
  const Vec2 across = perpendicular(direction);
  return -radial_rate(direction) - mu * across.dot(M * across);
}

double SlipFlow::rate_bound() const {
  return drive * b.norm() + mu * M.norm();
}

std::vector<InvariantDirection> find_invariant_directions(const SlipFlow& flow) {
  // The chart t in [-1, 1] is half of the circle; roots at its ends are found in both halves.
  constexpr double apart = 1e-9;

  // The roots of f_θ, as angles.
  std::vector<double> angles;
  for (const double sign : {1.0, -1.0}) {
    const Polynomial f = angular_rate_polynomial(flow, sign);
    if (std::all_of(f.c, f.c + f.degree + 1, [](double c) { return c == 0; })) return {};
    for (double from = -1; from <= 1;) {
      const std::optional<double> root = find_smallest_root(f, from, 1);
      if (!root) break;
      angles.push_back(polished(flow, 2 * std::atan(*root) + (sign > 0 ? 0 : std::numbers::pi)));
      from = *root + apart;
    }
  }

  // In ascending order, each once: a root on the border of the two halves was found twice.
  for (double& angle : angles) angle = std::remainder(angle, 2 * std::numbers::pi);
  std::sort(angles.begin(), angles.end());
  std::vector<InvariantDirection> result;
  for (const double theta : angles) {
    const bool is_same = !result.empty() && theta - result.back().theta < 2 * apart;
    const bool is_first_again =
        !result.empty() && theta - result.front().theta > 2 * std::numbers::pi - 2 * apart;
    if (is_same || is_first_again) continue;
    const Vec2 d{std::cos(theta), std::sin(theta)};
    result.push_back({theta, flow.radial_rate(d), flow.normal_rate(d)});
  }
  return result;
}

StickTest test_sticking(const CollisionMatrix& collision) {
  // Cholesky with the larger diagonal first: backward stable, so that K (f, 1) has no tangential part beyond
  // rounding, whatever the condition of M.
  constexpr double rank_tolerance = 1e-14;
  const Vec2 b = collision.K.topRightCorner<2, 1>();
  const int first = collision.K(0, 0) >= collision.K(1, 1) ? 0 : 1, second = 1 - first;
  const double m11 = collision.K(first, first), m12 = collision.K(0, 1), m22 = collision.K(second, second);
  Vec2 f = Vec2::Zero();
  bool holds = true;
  if (m11 <= 0) {
    holds = b.isZero(0);
  } else {
    const double l = m12 / m11, pivot = m22 - l * m12;
    if (pivot > rank_tolerance * m22) {
      f[second] = -(b[second] - l * b[first]) / pivot;
      f[first] = -b[first] / m11 - l * f[second];
    } else {
      // Rank one, M = m11 a aᵀ with a = (1, l): the least norm solution.
      const double a2 = 1 + l * l, along = -(b[first] + l * b[second]) / (m11 * a2 * a2);
      f[first] = along, f[second] = l * along;
      holds = std::abs(b[second] - l * b[first]) <= 1e-9 * b.norm();
    }
  }

  // It sticks if that friction lies in the cone.
  const double ratio = holds ? f.norm() : std::numeric_limits<double>::infinity();
  // At the limit both answers agree (slip starts with a rate that vanishes there).
  constexpr double at_limit = 1 + 1e-12;
  return {f, ratio, ratio <= at_limit * collision.mu, collision.K(2, 2) + b.dot(f)};
}

Vec2 diverging_direction(const SlipFlow& flow) {
  // In the principal axes of M: |(μ M + λ 1)⁻¹ b|² = Σ bᵢ² / (μ mᵢ + λ)².
  const double half_trace = 0.5 * (flow.M(0, 0) + flow.M(1, 1));
  const double half_difference = 0.5 * (flow.M(0, 0) - flow.M(1, 1)), off = flow.M(0, 1);
  const double angle = 0.5 * std::atan2(off, half_difference), radius = std::hypot(half_difference, off);
  const Vec2 axis{std::cos(angle), std::sin(angle)}, other = perpendicular(axis);
  const double m1 = flow.mu * (half_trace + radius);
  const double m2 =
      flow.mu * std::max(0.0, (flow.M(0, 0) * flow.M(1, 1) - off * off) / (half_trace + radius));
  const double b1 = axis.dot(flow.b), b2 = other.dot(flow.b);
  // Each term alone is a lower bound of the root; from below Newton's method on the concave 1/h is monotone.
  double lambda = std::max({0.0, std::abs(b1) - m1, std::abs(b2) - m2});
  constexpr int most_steps = 60;
  for (int step = 0; step < most_steps; ++step) {
    const double c1 = b1 / (m1 + lambda), c2 = b2 / (m2 + lambda);
    const double h2 = c1 * c1 + c2 * c2, h = std::sqrt(h2);
    const double slope = c1 * c1 / (m1 + lambda) + c2 * c2 / (m2 + lambda);
    const double next = lambda + (h - 1) * h2 / slope;
    if (!(next > lambda)) break;
    lambda = next;
  }
  const Vec2 d = b1 / (m1 + lambda) * axis + b2 / (m2 + lambda) * other;
  return d.normalized();
}

}  // namespace rigor
