#include "rigor/math/elliptic.hpp"

#include "rigor/core/assert.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace rigor {
namespace {

/// Relative gap of the two means below which the next ones agree to rounding: it shrinks from g to g²/8.
constexpr double kLastGap = 1e-8;

/// Arguments below this have a square below rounding.
constexpr double kTinyArgument = 0x1p-27;

}  // namespace

double complete_elliptic_k(double complement) {
  RIGOR_ASSERT(complement >= 0 && complement <= 1);
  if (complement == 0) return std::numeric_limits<double>::infinity();
  // Arithmetic-geometric mean: the two means converge quadratically.
  double a = 1, b = std::sqrt(complement);
  while (a - b > kLastGap * a) {
    const double mean = 0.5 * (a + b);
    b = std::sqrt(a * b);
    a = mean;
  }
  return std::numbers::pi / (a + b);
}

JacobiFunctions::JacobiFunctions(double complement) : complement_(complement) {
  RIGOR_ASSERT(complement >= 0 && complement <= 1);
  a_[0] = 1;
  b_[0] = std::sqrt(complement);
  quarter_period_ = std::numeric_limits<double>::infinity();
  if (complement == 0) return;

  // All means are kept, for the Landen transformation climbs back through them.
  bool last = false;
  while (!last) {
    last = a_[levels_] - b_[levels_] <= kLastGap * a_[levels_];
    RIGOR_ASSERT(levels_ + 1 < max_levels);
    a_[levels_ + 1] = 0.5 * (a_[levels_] + b_[levels_]);
    b_[levels_ + 1] = std::sqrt(a_[levels_] * b_[levels_]);
    ++levels_;
  }
  quarter_period_ = std::numbers::pi / (2 * a_[levels_]);
}

JacobiValues JacobiFunctions::at(double u) const {
  // At m = 1 the functions are hyperbolic.
  if (complement_ == 0) {
    const double sech = 1 / std::cosh(u);
    return {std::tanh(u), sech, sech};
  }
  if (std::abs(u) <= quarter_period_) return at_reduced(u);
  // The argument is reduced by multiples of 2 K, of which each changes the signs of sn and cn.
  const double half_periods = std::nearbyint(u / (2 * quarter_period_));
  JacobiValues values = at_reduced(u - 2 * half_periods * quarter_period_);
  if (std::fmod(half_periods, 2) != 0) {
    values.sn = -values.sn;
    values.cn = -values.cn;
  }
  return values;
}

JacobiValues JacobiFunctions::at_reduced(double u) const {
  if (std::abs(u) < kTinyArgument) return {u, 1, 1};

  // Descending Landen transformation: let tₙ = aₙ cn/sn and dₙ = dn for the modulus of the n-th means at the
  // argument aₙ u. At the last means the functions are circular, and from there up to the first
  //   w = tₙ₊₁²/aₙ₊₁,   tₙ = tₙ₊₁ dₙ₊₁,   dₙ = (bₙ + w)/(aₙ + w).
  const double phase = a_[levels_] * u;
  double t = a_[levels_] * std::cos(phase) / std::sin(phase);
  double d = 1;
  for (int n = levels_ - 1; n >= 0; --n) {
    const double w = t * t / a_[n + 1];
    t *= d;
    d = (b_[n] + w) / (a_[n] + w);
  }
  const double sn = std::copysign(1 / std::sqrt(1 + t * t), u);
  return {sn, t * sn, d};
}

double JacobiFunctions::amplitude(double u) const {
  const double half_periods = complement_ == 0 ? 0 : std::nearbyint(u / (2 * quarter_period_));
  const JacobiValues values = complement_ == 0 ? at(u) : at_reduced(u - 2 * half_periods * quarter_period_);
  return std::atan2(values.sn, values.cn) + half_periods * std::numbers::pi;
}

}  // namespace rigor
