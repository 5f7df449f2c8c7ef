#pragma once

#include "rigor/math/types.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigor {

// The cone x₀ ≥ |x_t| of vectors x = (x₀, x_t) of three numbers and its Jordan algebra, as interior point
// methods use them (Alizadeh and Goldfarb, Second-order cone programming, 2003).

/// x ∘ y.
inline Vec3 jordan_product(const Vec3& x, const Vec3& y) {
  Vec3 z;
  z << x.dot(y), x(0) * y.tail<2>() + y(0) * x.tail<2>();
  return z;
}

/// z with x ∘ z = u.
inline Vec3 jordan_quotient(const Vec3& u, const Vec3& x) {
  Vec3 z;
  z(0) = (x(0) * u(0) - x.tail<2>().dot(u.tail<2>())) / (x(0) * x(0) - x.tail<2>().squaredNorm());
  z.tail<2>() = (u.tail<2>() - z(0) * x.tail<2>()) / x(0);
  return z;
}

/// x₀² - |x_t|², of x inside.
inline double jordan_square(const Vec3& x) {
  const double length = x.tail<2>().norm();
  return std::max((x(0) - length) * (x(0) + length), std::numeric_limits<double>::min());
}

/// The largest t up to which x + t d stays in the cone, of x inside with its jordan_square.
inline double step_to_border(const Vec3& x, double square, const Vec3& d) {
  // The first positive root of (x₀ + t d₀)² = |x_t + t d_t|², and where x₀ ends.
  double first = d(0) < 0 ? -x(0) / d(0) : std::numeric_limits<double>::infinity();
  const double a = d(0) * d(0) - d.tail<2>().squaredNorm(), b = x(0) * d(0) - x.tail<2>().dot(d.tail<2>());
  const double discriminant = b * b - a * square;
  if (discriminant < 0) return first;
  const double q = -(b + std::copysign(std::sqrt(discriminant), b));
  for (const double root : {q / a, square / q})
    if (root > 0) first = std::min(first, root);
  return first;
}

/// Scaling of Nesterov and Todd: the symmetric W with W x = W⁻¹ y, of x and y inside with their
/// jordan_squares.
struct NesterovToddScaling {
  Mat3 W, inverse, inverse_square;

  NesterovToddScaling(const Vec3& x, double square_x, const Vec3& y, double square_y) {
    // Of x and y on the unit hyperboloid, the point w half way between y and the mirrored x.
    const double size_x = std::sqrt(square_x), size_y = std::sqrt(square_y);
    const Vec3 unit_x = (1 / size_x) * x, unit_y = (1 / size_y) * y,
               mirrored(unit_x(0), -unit_x(1), -unit_x(2));
    const Vec3 w = (1 / std::sqrt(2 * (1 + unit_x.dot(unit_y)))) * (unit_y + mirrored);
    // W is the hyperbolic rotation that takes e₀ to w, times the ratio of the sizes.
    const double scale = std::sqrt(size_y / size_x), inverse_scale = 1 / scale;
    W(0, 0) = w(0);
    W.row(0).tail<2>() = w.tail<2>();
    W.col(0).tail<2>() = w.tail<2>();
    W.bottomRightCorner<2, 2>() =
        Mat2::Identity() + ((1 / (1 + w(0))) * w.tail<2>()) * w.tail<2>().transpose();
    inverse = inverse_scale * W;
    inverse.row(0).tail<2>() *= -1;
    inverse.col(0).tail<2>() *= -1;
    W *= scale;
    // With the mirror image of w the square of the inverse is 2 w wᵀ - diag(1, -1, -1), over that of the
    // scale.
    const Vec3 image(w(0), -w(1), -w(2));
    inverse_square = (2 * image) * image.transpose();
    inverse_square.diagonal() += Vec3(-1, 1, 1);
    inverse_square *= inverse_scale * inverse_scale;
  }
};

}  // namespace rigor
