#pragma once

#include <string>
#include <vector>

namespace rigor {

/// Marks of an axis.
struct Ticks {
  double low, high;                 ///< Range of the axis; holds all data.
  std::vector<double> values;       ///< Multiples of 1, 2 or 5 times a power of ten, inside the range.
  std::vector<std::string> labels;  ///< Of the values divided by 10^exponent, with equal decimals.
  int exponent;  ///< A multiple of 3, 0 for numbers of usual size; shown in the title of the axis.
};

/// Marks for data between low and high (both finite, low ≤ high), about `count` of them. The range is widened
/// to whole marks if fits_marks. It is also widened where the data change by no more than a millionth of
/// their size, because a smaller range would show rounding as motion.
Ticks make_ticks(double low, double high, int count, bool fits_marks);

/// "m" for exponent 0, "10⁻⁶ m" for -6; "" and "10⁻⁶" for the unit "1".
std::string unit_text(const std::string& unit, int exponent);

}  // namespace rigor
