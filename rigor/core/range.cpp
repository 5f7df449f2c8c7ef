#include "rigor/core/range.hpp"

#include <fmt/format.h>
#include <charconv>
#include <cmath>

namespace rigor {

namespace {

std::string with_space(std::string_view unit) {
  return unit.empty() ? "" : fmt::format(" {}", unit);
}

/// A limit with few digits, but never rounded to another number.
std::string limit_text(double limit) {
  const std::string text = fmt::format("{:g}", limit);
  double read_back = 0;
  std::from_chars(text.data(), text.data() + text.size(), read_back);
  return read_back == limit ? text : number_text(limit);
}

}  // namespace

bool Range::contains(double value) const {
  if (!std::isfinite(value)) return false;
  return (lowest_is_excluded ? value > lowest : value >= lowest) && value <= highest;
}

std::string number_text(double value) {
  return fmt::format("{}", value);
}

std::string range_text(const Range& range, std::string_view unit) {
  const std::string suffix = with_space(unit);
  const bool is_bounded_below = std::isfinite(range.lowest), is_bounded_above = std::isfinite(range.highest);
  if (!is_bounded_below && !is_bounded_above) return "finite";
  const std::string lowest = limit_text(range.lowest), highest = limit_text(range.highest);
  if (range.lowest == range.highest) return lowest + suffix;
  if (!is_bounded_below) return fmt::format("at most {}{}", highest, suffix);
  if (range.lowest_is_excluded && !is_bounded_above) return fmt::format("> {}{}", lowest, suffix);
  if (range.lowest_is_excluded) return fmt::format("> {} and at most {}{}", lowest, highest, suffix);
  if (!is_bounded_above) return fmt::format("at least {}{}", lowest, suffix);
  return fmt::format("from {} to {}{}", lowest, highest, suffix);
}

std::string range_error(std::string_view quantity, double value, const Range& range, std::string_view unit) {
  if (range.contains(value)) return {};
  return fmt::format("{} is {}{}, must be {}", quantity, value, with_space(unit), range_text(range, unit));
}

}  // namespace rigor
