#include "rigor/math/carlson.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {
namespace {

/// R_C(1, q) with q = 1 + e > 0: atan(√e)/√e, its continuation to e < 0, or its series. Both e and q are
/// arguments because neither follows from the other without loss: either may be tiny.
double carlson_rc1(double e, double q) {
  if (std::abs(e) < 0.02) {
    // Σ (-e)ᵏ/(2k + 1); the first term omitted is below 0.02⁹/19 = 3e-17.
    double sum = 1.0 / 17;
    for (int k = 7; k >= 0; --k) sum = 1.0 / (2 * k + 1) - e * sum;
    return sum;
  }
  const double root = std::sqrt(std::abs(e));
  return e > 0 ? std::atan(root) / root : std::asinh(root / std::sqrt(q)) / root;
}

}  // namespace

double carlson_rf(double x, double y, double z) {
  double mean = (x + y + z) / 3;
  // The remainder of the Taylor series of degree five is below rounding once the spread of the arguments is
  // below 1/430 of their mean.
  double spread = 430 * std::max({std::abs(mean - x), std::abs(mean - y), std::abs(mean - z)});
  // Duplication theorem: R_F does not change when λ is added to all arguments and the sums are divided by
  // four; this quarters their spread.
  while (spread > mean) {
    const double sx = std::sqrt(x), sy = std::sqrt(y), sz = std::sqrt(z);
    const double lambda = sx * sy + sy * sz + sz * sx;
    x = 0.25 * (x + lambda);
    y = 0.25 * (y + lambda);
    z = 0.25 * (z + lambda);
    mean = 0.25 * (mean + lambda);
    spread *= 0.25;
  }
  // The Taylor series in the elementary symmetric functions of the relative deviations, whose sum is zero.
  const double X = (mean - x) / mean, Y = (mean - y) / mean, Z = -(X + Y);
  const double E2 = X * Y - Z * Z, E3 = X * Y * Z;
  return (1 - E2 / 10 + E3 / 14 + E2 * E2 / 24 - 3 * E2 * E3 / 44) / std::sqrt(mean);
}

double carlson_rj(double x, double y, double z, double p) {
  double mean = (x + y + z + 2 * p) / 5;
  // The remainder of the Taylor series of degree five is below rounding once the spread of the arguments is
  // below 1/600 of their mean.
  double spread =
      600 * std::max({std::abs(mean - x), std::abs(mean - y), std::abs(mean - z), std::abs(mean - p)});
  // Duplication as for R_F; each step splits off a term with R_C, and what is left is divided by four.
  double power = 1;  // 4⁻ⁿ
  double sum = 0;
  while (spread > mean) {
    const double sx = std::sqrt(x), sy = std::sqrt(y), sz = std::sqrt(z), sp = std::sqrt(p);
    const double lambda = sx * sy + sy * sz + sz * sx;
    const double d = (sp + sx) * (sp + sy) * (sp + sz);
    // (p - x)(p - y)(p - z)/d², a product of three numbers between -1 and 1.
    const double e = (p - x) * (p - y) * (p - z) / (d * d);
    // 1 + e, expanded: a sum of positive terms.
    const double q = 2 * sp * (p + lambda) / d;
    sum += power / d * carlson_rc1(e, q);
    x = 0.25 * (x + lambda);
    y = 0.25 * (y + lambda);
    z = 0.25 * (z + lambda);
    p = 0.25 * (p + lambda);
    mean = 0.25 * (mean + lambda);
    spread *= 0.25;
    power *= 0.25;
  }
  // The Taylor series in the elementary symmetric functions of the deviations, in which p counts twice.
  const double X = (mean - x) / mean, Y = (mean - y) / mean, Z = (mean - z) / mean;
  const double P = -(X + Y + Z) / 2;
  const double XYZ = X * Y * Z;
  const double E2 = X * Y + Y * Z + Z * X - 3 * P * P;
  const double E3 = XYZ + 2 * E2 * P + 4 * P * P * P;
  const double E4 = (2 * XYZ + E2 * P + 3 * P * P * P) * P;
  const double E5 = XYZ * P * P;
  const double series =
      1 - 3 * E2 / 14 + E3 / 6 + 9 * E2 * E2 / 88 - 3 * E4 / 22 - 9 * E2 * E3 / 52 + 3 * E5 / 26;
  return power * series / (mean * std::sqrt(mean)) + 6 * sum;
}

}  // namespace rigor
