#pragma once

#include <limits>
#include <string>
#include <string_view>

namespace rigor {

/// The values that a quantity may take: from lowest to highest, both included unless lowest_is_excluded.
struct Range {
  double lowest = -std::numeric_limits<double>::infinity();
  double highest = std::numeric_limits<double>::infinity();
  bool lowest_is_excluded = false;

  /// Infinite and NaN values are never inside.
  bool contains(double value) const;
};

/// Shortest decimal form that reads back as the same double ("0.1", "1e+30", "nan").
std::string number_text(double value);

/// "> 0 and at most 1e9 kg", "from 0 to 1", "at least 0", "finite".
std::string range_text(const Range& range, std::string_view unit);

/// Empty if the value is inside, otherwise the end of a message: "mass is -1 kg, must be > 0 kg".
std::string range_error(std::string_view quantity, double value, const Range& range, std::string_view unit);

}  // namespace rigor
