#include "rigor/view/plot/sparkline.hpp"

#include "rigor/core/index.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

namespace rigor {

namespace {

constexpr std::array<std::string_view, 8> blocks = {"▁", "▂", "▃", "▄", "▅", "▆", "▇", "█"};
constexpr std::array<std::string_view, 8> ascii = {"_", ".", ",", "-", "~", "=", "*", "#"};

/// Mean of the finite values, NaN if there is none.
double finite_mean(std::span<const double> values) {
  double sum = 0;
  int count = 0;
  for (const double value : values) {
    if (std::isfinite(value)) sum += value, ++count;
  }
  return sum / count;
}

}  // namespace

std::string sparkline(std::span<const double> values, int width, bool is_ascii) {
  const std::size_t columns = std::min(values.size(), at(std::max(0, width)));
  std::vector<double> means;
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (std::size_t i = 0; i < columns; ++i) {
    const std::size_t begin = i * values.size() / columns, end = (i + 1) * values.size() / columns;
    means.push_back(finite_mean(values.subspan(begin, end - begin)));
    if (std::isfinite(means.back())) low = std::min(low, means.back()), high = std::max(high, means.back());
  }
  const auto& levels = is_ascii ? ascii : blocks;
  std::string line;
  for (const double mean : means) {
    if (!std::isfinite(mean)) {
      line += ' ';
      continue;
    }
    const double share = high > low ? (mean - low) / (high - low) : 0.5;
    line += levels[static_cast<std::size_t>(std::min(7.0, std::floor(share * 8)))];
  }
  return line;
}

}  // namespace rigor
