#pragma once

#include "rigor/core/index.hpp"
#include "rigor/math/compensated_sum.hpp"
#include "rigor/math/types.hpp"

#include <array>

namespace rigor {

/// A number of about 32 digits, high + low, where high is the sum rounded to double.
///
/// Source: Dekker, A Floating-Point Technique for Extending the Available Precision, Numer. Math. 18, 1971.
struct DoubleDouble {
  double high;
  double low;
};

/// The same value with `high` as the rounded sum.
inline DoubleDouble renormalized(double high, double low) {
  const Exact sum = two_sum(high, low);
  return {sum.value, sum.error};
}

inline DoubleDouble operator-(const DoubleDouble& a) {
  return {-a.high, -a.low};
}
inline DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
  const Exact high = two_sum(a.high, b.high);
  const Exact low = two_sum(a.low, b.low);
  const DoubleDouble sum = renormalized(high.value, high.error + low.value);
  return renormalized(sum.high, sum.low + low.error);
}
inline DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) {
  return a + -b;
}
inline DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
  const Exact product = two_product(a.high, b.high);
  return renormalized(product.value, product.error + (a.high * b.low + a.low * b.high));
}
/// Long division: two quotient digits, and the rounding of a third.
inline DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) {
  const double first = a.high / b.high;
  const DoubleDouble rest = a - b * DoubleDouble{first, 0};
  const double second = rest.high / b.high;
  const DoubleDouble last = rest - b * DoubleDouble{second, 0};
  return renormalized(first, second) + DoubleDouble{last.high / b.high, 0};
}

using DoubleDoubleVec3 = std::array<DoubleDouble, 3>;

inline DoubleDoubleVec3 exact_difference(const Vec3& a, const Vec3& b) {
  DoubleDoubleVec3 result;
  for (int i = 0; i < 3; ++i) {
    const Exact difference = two_sum(a[i], -b[i]);
    result[at(i)] = {difference.value, difference.error};
  }
  return result;
}
inline DoubleDouble dot(const DoubleDoubleVec3& a, const DoubleDoubleVec3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline DoubleDoubleVec3 cross(const DoubleDoubleVec3& a, const DoubleDoubleVec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Vec3 rounded(const DoubleDoubleVec3& a) {
  return {a[0].high, a[1].high, a[2].high};
}

}  // namespace rigor
