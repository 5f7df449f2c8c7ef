#pragma once

#include <cmath>

namespace rigor {

/// A rounded result and the exact remainder that rounding dropped: value + error is exact.
struct Exact {
  double value;
  double error;
};

/// a + b without loss (barring overflow), whatever the magnitudes.
///
/// Source: Knuth, The Art of Computer Programming, vol. 2, section 4.2.2.
inline Exact two_sum(double a, double b) {
  const double sum = a + b;
  const double b_part = sum - a;
  return {sum, (a - (sum - b_part)) + (b - b_part)};
}

/// a b without loss (barring overflow and underflow).
inline Exact two_product(double a, double b) {
  const double product = a * b;
  return {product, std::fma(a, b, -product)};
}

/// A sum that keeps the rounding errors of its additions. The result is as good as if it had been rounded
/// once, unless the terms cancel by more than the square of the machine precision.
///
/// Source: Neumaier, Rundungsfehleranalyse einiger Verfahren zur Summation endlicher Summen, ZAMM 54, 1974.
/// There the error of each addition is found by a comparison of magnitudes, here by two_sum, which gives the
/// same number.
class CompensatedSum {
 public:
  void add(double term) {
    const Exact sum = two_sum(sum_, term);
    sum_ = sum.value;
    error_ += sum.error;
  }
  double value() const { return sum_ + error_; }

 private:
  double sum_ = 0;
  double error_ = 0;
};

}  // namespace rigor
