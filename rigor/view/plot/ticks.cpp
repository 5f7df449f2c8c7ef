#include "rigor/view/plot/ticks.hpp"

#include "rigor/core/index.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace rigor {

namespace {

/// The step, 1, 2 or 5 times a power of ten, whose number of marks is nearest to the requested one.
double round_step(double span, int count) {
  const double ideal = span / count, power = std::pow(10, std::floor(std::log10(ideal)));
  const double lead = ideal / power;
  return power * (lead < 1.4 ? 1 : lead < 3.2 ? 2 : lead < 7.1 ? 5 : 10);
}

int exponent_of(double largest) {
  const int exponent = static_cast<int>(std::floor(std::log10(largest)));
  if (exponent > -3 && exponent < 5) return 0;
  return 3 * static_cast<int>(std::floor(exponent / 3.0));
}

}  // namespace

Ticks make_ticks(double low, double high, int count, bool fits_marks) {
  constexpr double least_change = 1e-6;
  const double size = std::max(std::abs(low), std::abs(high));
  if (size == 0) high = 1;
  if (high - low < least_change * size) {
    const double middle = 0.5 * (low + high);
    low = middle - 0.5 * least_change * size, high = middle + 0.5 * least_change * size;
  }
  const double step = round_step(high - low, count);
  // A mark that rounding puts just outside still belongs to the range.
  constexpr double slack = 1e-9;
  long first = std::lround(std::ceil(low / step - slack)),
       last = std::lround(std::floor(high / step + slack));
  if (fits_marks) {
    first = std::lround(std::floor(low / step + slack)), last = std::lround(std::ceil(high / step - slack));
    low = static_cast<double>(first) * step, high = static_cast<double>(last) * step;
  }
  Ticks ticks{low, high, {}, {}, exponent_of(std::max(std::abs(low), std::abs(high)))};
  const double unit = std::pow(10, ticks.exponent);
  const int decimals = std::max(0, static_cast<int>(std::ceil(-std::log10(step / unit) - slack)));
  for (long k = first; k <= last; ++k) {
    ticks.values.push_back(static_cast<double>(k) * step);
    std::string label = fmt::format("{:.{}f}", static_cast<double>(k) * step / unit, decimals);
    if (label.starts_with('-')) label.replace(0, 1, "−");
    ticks.labels.push_back(label);
  }
  return ticks;
}

std::string unit_text(const std::string& unit, int exponent) {
  constexpr std::array<std::string_view, 10> raised = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string name = unit == "1" ? "" : unit;
  if (exponent == 0) return name;
  std::string power = "10";
  if (exponent < 0) power += "⁻";
  for (const char digit : std::to_string(std::abs(exponent))) power += raised[at(digit - '0')];
  return name.empty() ? power : power + " " + name;
}

}  // namespace rigor
