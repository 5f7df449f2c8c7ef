#pragma once

#include <initializer_list>
#include <optional>

namespace rigor {

/// A polynomial Σ cₖ xᵏ of small degree, without heap allocation.
struct Polynomial {
  static constexpr int max_degree = 12;
  double c[max_degree + 1] = {};  ///< Ascending; zero above the degree.
  int degree = 0;

  Polynomial() = default;
  /// The polynomial with the coefficients c₀, c₁, ...; its degree is their number less one, whatever their
  /// values.
  Polynomial(std::initializer_list<double> coefficients);

  /// Value at x, by Horner's rule.
  double operator()(double x) const;
  Polynomial derivative() const;
};

Polynomial operator+(const Polynomial& p, const Polynomial& q);
Polynomial operator-(const Polynomial& p, const Polynomial& q);
/// Product; the sum of the degrees must not exceed max_degree.
Polynomial operator*(const Polynomial& p, const Polynomial& q);

/// Coefficients b of p on [a, b] in the Bernstein basis: p(a + s (b - a)) = Σ bₖ C(n, k) sᵏ (1 - s)ⁿ⁻ᵏ. The
/// first and the last are the values at the ends; on [a, b], p lies between the smallest and the largest.
struct BernsteinForm {
  double b[Polynomial::max_degree + 1] = {};
  int degree = 0;
  double rounding = 0;  ///< Bound of the error of each coefficient.
};
BernsteinForm bernstein_form(const Polynomial& p, double a, double b);

/// Bounds of p on [a, b] that hold for exact values of p: the Bernstein coefficients, widened by their
/// rounding errors. Sharp to second order in b - a.
struct Bounds {
  double min, max;
};
Bounds polynomial_bounds(const Polynomial& p, double a, double b);

/// Real roots of a x² + b x + c in ascending order; count is 0, 1 (double root, or a = 0) or 2. Nothing
/// cancels: the discriminant is computed with one rounding, and the root of smaller magnitude from the
/// product of the roots. There are no roots if a = b = 0.
struct QuadraticRoots {
  int count = 0;
  double x[2] = {0, 0};
};
QuadraticRoots find_quadratic_roots(double a, double b, double c);

/// Smallest root of p in [a, b], correct to rounding, or nothing. A point at which |p| is below its own
/// rounding error counts as a root; so a double root (p touches zero) is found, up to the square root of
/// rounding. The zero polynomial has the root a. The interval is subdivided in the Bernstein basis: no sign
/// change among the coefficients excludes a root, and one proves one.
std::optional<double> find_smallest_root(const Polynomial& p, double a, double b);

}  // namespace rigor
