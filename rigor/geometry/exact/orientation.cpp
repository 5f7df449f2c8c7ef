#include "rigor/geometry/exact/orientation.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/rounding.hpp"
#include "rigor/math/compensated_sum.hpp"

#include <array>
#include <cmath>

namespace rigor {

namespace {

/// A sum held exactly as non-overlapping parts of increasing magnitude, none of them zero: an expansion in
/// the sense of Shewchuk.
class ExactSum {
 public:
  /// Grow-expansion: the sum passes through all parts by two_sum, whose errors become the new parts.
  void add(double term) {
    int kept = 0;
    for (int i = 0; i < size_; ++i) {
      const Exact sum = two_sum(term, parts_[at(i)]);
      if (sum.error != 0) parts_[at(kept++)] = sum.error;
      term = sum.value;
    }
    if (term != 0) parts_[at(kept++)] = term;
    size_ = kept;
  }
  void add_product(double a, double b) {
    const Exact product = two_product(a, b);
    add(product.error);
    add(product.value);
  }
  void add_product(double a, double b, double c) {
    const Exact product = two_product(a, b);
    add_product(product.error, c);
    add_product(product.value, c);
  }
  /// The last part is larger than the sum of all others, so its sign is that of the sum.
  int sign() const {
    if (size_ == 0) return 0;
    return parts_[at(size_ - 1)] > 0 ? 1 : -1;
  }

 private:
  std::array<double, 128> parts_;  // the largest sum here has 96 terms
  int size_ = 0;
};

int sign_of(double x) {
  return x > 0 ? 1 : (x < 0 ? -1 : 0);
}

/// a × b + b × c + c × a, with all six products held exactly.
int exact_orientation(const Vec2& a, const Vec2& b, const Vec2& c) {
  ExactSum sum;
  sum.add_product(a.x(), b.y());
  sum.add_product(-a.y(), b.x());
  sum.add_product(b.x(), c.y());
  sum.add_product(-b.y(), c.x());
  sum.add_product(c.x(), a.y());
  sum.add_product(-c.y(), a.x());
  return sum.sign();
}

/// Adds sign a · (b × c).
void add_triple_product(double sign, const Vec3& a, const Vec3& b, const Vec3& c, ExactSum& sum) {
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    sum.add_product(sign * a[i], b[j], c[k]);
    sum.add_product(-sign * a[i], b[k], c[j]);
  }
}

/// Whether a - b = difference holds without rounding.
bool is_exact(const Vec3& a, const Vec3& b, const Vec3& difference) {
  for (int i = 0; i < 3; ++i) {
    if (two_sum(a[i], -b[i]).error != 0) return false;
  }
  return difference.allFinite();
}

}  // namespace

int orientation(const Vec2& a, const Vec2& b, const Vec2& c) {
  // First try in double: its sign is right if the magnitude exceeds the error bound of the computation.
  const double left = (b.x() - a.x()) * (c.y() - a.y());
  const double right = (b.y() - a.y()) * (c.x() - a.x());
  const double area = left - right;
  if (std::abs(area) > (3 + 16 * kUnitRoundoff) * kUnitRoundoff * (std::abs(left) + std::abs(right)))
    return sign_of(area);
  return exact_orientation(a, b, c);
}

int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  // First try in double, as above.
  const Vec3 u = b - a, v = c - a, w = d - a;
  const Vec3 left(u.y() * v.z(), u.z() * v.x(), u.x() * v.y());
  const Vec3 right(u.z() * v.y(), u.x() * v.z(), u.y() * v.x());
  const double volume = (left - right).dot(w);
  const double magnitude = (left.cwiseAbs() + right.cwiseAbs()).dot(w.cwiseAbs());
  if (std::abs(volume) > (7 + 56 * kUnitRoundoff) * kUnitRoundoff * magnitude) return sign_of(volume);

  // The exact determinant. Where the differences are exact, as between nearby points, it takes fewer terms.
  ExactSum sum;
  if (is_exact(b, a, u) && is_exact(c, a, v) && is_exact(d, a, w)) {
    if (magnitude == 0) return 0;  // a zero in each product
    add_triple_product(1, w, u, v, sum);
  } else {
    // Otherwise the determinant of the rows (p, 1) is expanded along the column of ones.
    add_triple_product(1, b, c, d, sum);
    add_triple_product(-1, a, c, d, sum);
    add_triple_product(1, a, b, d, sum);
    add_triple_product(-1, a, b, c, sum);
  }
  return sum.sign();
}

}  // namespace rigor
