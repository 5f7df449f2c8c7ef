#include "rigor/math/polynomial.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/rounding.hpp"
#include "rigor/math/roots.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace rigor {
namespace {

/// Σ |cₖ| xᵏ: the magnitude to which the rounding errors of p near |x| are relative.
double absolute_value(const Polynomial& p, double x) {
  double sum = 0;
  for (int k = p.degree; k >= 0; --k) sum = sum * x + std::abs(p.c[k]);
  return sum;
}

/// Bound of the error of p(x) by Horner's rule: 2n + 1 roundings of half an epsilon each.
double evaluation_error(const Polynomial& p, double x) {
  return (p.degree + 1) * kEpsilon * absolute_value(p, std::abs(x));
}

/// The number of roots in an interval; flat: p cannot be told from zero anywhere in it.
enum class RootsInside { none, one, flat, unknown };

/// Descartes' rule of signs in the Bernstein basis: the number of roots in (a, b), where it is certain.
RootsInside count_roots(const BernsteinForm& form) {
  int changes = 0;
  int sign = 0;
  bool is_certain = true;
  bool is_flat = true;
  // Sign changes are counted. A coefficient below its rounding error has no certain sign.
  for (int k = 0; k <= form.degree; ++k) {
    is_flat = is_flat && std::abs(form.b[k]) <= 2 * form.rounding;
    if (std::abs(form.b[k]) <= form.rounding) {
      is_certain = false;
      continue;
    }
    const int next = form.b[k] > 0 ? 1 : -1;
    if (sign != 0 && next != sign) ++changes;
    sign = next;
  }
  if (is_flat) return RootsInside::flat;
  if (!is_certain) return RootsInside::unknown;
  return changes == 0 ? RootsInside::none : changes == 1 ? RootsInside::one : RootsInside::unknown;
}

double end_nearer_to_zero(const Polynomial& p, double a, double b) {
  return std::abs(p(a)) <= std::abs(p(b)) ? a : b;
}

/// A root in an interval that cannot be divided further: there is one if the sign of p changes, or if p is
/// within its rounding error of zero at an end.
std::optional<double> find_root_in_grain(const Polynomial& p, double a, double b) {
  const double at_a = p(a), at_b = p(b);
  const bool is_near_a = std::abs(at_a) <= evaluation_error(p, a);
  const bool is_near_b = std::abs(at_b) <= evaluation_error(p, b);
  if (!is_near_a && !is_near_b && (at_a < 0) == (at_b < 0)) return std::nullopt;
  return end_nearer_to_zero(p, a, b);
}

}  // namespace

Polynomial::Polynomial(std::initializer_list<double> coefficients) {
  RIGOR_ASSERT(coefficients.size() >= 1 && coefficients.size() <= max_degree + 1);
  std::copy(coefficients.begin(), coefficients.end(), c);
  degree = static_cast<int>(coefficients.size()) - 1;
}

double Polynomial::operator()(double x) const {
  double sum = c[degree];
  for (int k = degree - 1; k >= 0; --k) sum = sum * x + c[k];
  return sum;
}

Polynomial Polynomial::derivative() const {
  Polynomial result;
  result.degree = std::max(0, degree - 1);
  for (int k = 1; k <= degree; ++k) result.c[k - 1] = k * c[k];
  return result;
}

Polynomial operator+(const Polynomial& p, const Polynomial& q) {
  Polynomial sum;
  sum.degree = std::max(p.degree, q.degree);
  for (int k = 0; k <= sum.degree; ++k) sum.c[k] = p.c[k] + q.c[k];
  return sum;
}

Polynomial operator-(const Polynomial& p, const Polynomial& q) {
  Polynomial difference;
  difference.degree = std::max(p.degree, q.degree);
  for (int k = 0; k <= difference.degree; ++k) difference.c[k] = p.c[k] - q.c[k];
  return difference;
}

Polynomial operator*(const Polynomial& p, const Polynomial& q) {
  Polynomial product;
  product.degree = p.degree + q.degree;
  RIGOR_ASSERT(product.degree <= Polynomial::max_degree);
  for (int i = 0; i <= p.degree; ++i) {
    for (int k = 0; k <= q.degree; ++k) product.c[i + k] += p.c[i] * q.c[k];
  }
  return product;
}

BernsteinForm bernstein_form(const Polynomial& p, double a, double b) {
  const int n = p.degree;
  const double width = b - a;

  // Taylor shift to a by repeated synthetic division, then the substitution x = a + s width.
  double c[Polynomial::max_degree + 1];
  std::copy(std::begin(p.c), std::end(p.c), c);
  for (int i = 0; i < n; ++i) {
    for (int k = n - 1; k >= i; --k) c[k] += a * c[k + 1];
  }
  double power = 1;
  for (int k = 0; k <= n; ++k, power *= width) c[k] *= power;

  // Change of basis: bₖ = Σ_{i ≤ k} C(k, i)/C(n, i) cᵢ.
  BernsteinForm form;
  form.degree = n;
  for (int k = 0; k <= n; ++k) {
    double weight = 1;
    for (int i = 0; i <= k; ++i) {
      form.b[k] += weight * c[i];
      weight *= static_cast<double>(k - i) / (n - i > 0 ? n - i : 1);
    }
  }
  // Each term undergoes at most 6n + 4 roundings, of half an epsilon each.
  form.rounding = (3 * n + 2) * kEpsilon * absolute_value(p, std::abs(a) + std::abs(width));
  return form;
}

Bounds polynomial_bounds(const Polynomial& p, double a, double b) {
  const BernsteinForm form = bernstein_form(p, a, b);
  const auto [low, high] = std::minmax_element(form.b, form.b + form.degree + 1);
  return {*low - form.rounding, *high + form.rounding};
}

QuadraticRoots find_quadratic_roots(double a, double b, double c) {
  const double largest = std::max({std::abs(a), std::abs(b), std::abs(c)});
  if (!(largest > 0) || (a == 0 && b == 0)) return {};
  // Scaling by a common power of two keeps the products in range and changes no digit.
  int exponent = 0;
  std::frexp(largest, &exponent);
  a = std::ldexp(a, -exponent);
  b = std::ldexp(b, -exponent);
  c = std::ldexp(c, -exponent);
  if (a == 0) return {1, {-c / b, 0}};

  // Discriminant b² - 4ac: fma recovers the rounding errors of both products.
  const double square = b * b, product = 4 * a * c;
  const double discriminant = (square - product) + (std::fma(b, b, -square) - std::fma(4 * a, c, -product));
  if (discriminant < 0) return {};
  if (discriminant == 0) return {1, {-b / (2 * a), 0}};
  // The root of larger magnitude is a sum without cancellation; the other one follows from the product c/a of
  // the roots.
  const double t = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
  const double first = t / a, second = c / t;
  return {2, {std::min(first, second), std::max(first, second)}};
}

std::optional<double> find_smallest_root(const Polynomial& p, double a, double b) {
  RIGOR_ASSERT(a <= b);
  // Stack of the intervals that are still to be searched, the leftmost on top; each bisection leaves one for
  // later.
  struct Interval {
    double a, b;
  };
  constexpr int kMaxHalvings = 128;
  Interval waiting[kMaxHalvings];
  int count = 0;
  waiting[count++] = {a, b};

  while (count > 0) {
    const Interval interval = waiting[--count];
    if (std::abs(p(interval.a)) <= evaluation_error(p, interval.a)) return interval.a;

    // No sign change excludes a root. One sign change proves exactly one, which ITP then finds in its
    // bracket.
    const RootsInside roots = count_roots(bernstein_form(p, interval.a, interval.b));
    if (roots == RootsInside::none) continue;
    if (roots == RootsInside::flat) return end_nearer_to_zero(p, interval.a, interval.b);
    if (roots == RootsInside::one && (p(interval.a) < 0) != (p(interval.b) < 0)) {
      return find_root_itp([&p](double x) { return p(x); }, interval.a, interval.b, 0).best();
    }
    // Otherwise the interval is bisected, down to the resolution of doubles.
    const double middle = interval.a + 0.5 * (interval.b - interval.a);
    const double grain = 2 * kEpsilon * std::max(std::abs(interval.a), std::abs(interval.b));
    if (interval.b - interval.a <= grain || middle == interval.a || count + 2 > kMaxHalvings) {
      const std::optional<double> root = find_root_in_grain(p, interval.a, interval.b);
      if (root) return root;
      continue;
    }
    waiting[count++] = {middle, interval.b};
    waiting[count++] = {interval.a, middle};
  }
  return std::nullopt;
}

}  // namespace rigor
