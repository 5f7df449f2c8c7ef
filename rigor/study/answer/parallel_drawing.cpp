#include "rigor/study/answer/study_drawing.hpp"
#include "rigor/view/plot/plot_axes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace rigor {

namespace {

/// Lowest and highest finite value of a column.
struct AxisRange {
  double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();

  explicit AxisRange(const std::vector<double>& values) {
    for (const double value : values) {
      if (std::isfinite(value)) low = std::min(low, value), high = std::max(high, value);
    }
  }
  /// Where a value lies between them; the middle if all are equal.
  double share(double value) const { return high > low ? (value - low) / (high - low) : 0.5; }
};

/// From blue over grey to orange, which the colour-blind tell apart.
std::string ramp_color(double share) {
  constexpr std::array<std::array<double, 3>, 3> ends = {{{0, 114, 178}, {150, 150, 150}, {213, 94, 0}}};
  if (!std::isfinite(share)) return "#8c8c8c";
  const double at = 2 * std::clamp(share, 0.0, 1.0);
  const std::size_t i = at < 1 ? 0 : 1;
  std::array<int, 3> mixed{};
  for (std::size_t k = 0; k < 3; ++k)
    mixed[k] = static_cast<int>(
        std::lround(ends[i][k] + (at - static_cast<double>(i)) * (ends[i + 1][k] - ends[i][k])));
  return fmt::format("#{:02x}{:02x}{:02x}", mixed[0], mixed[1], mixed[2]);
}

}  // namespace

Drawing parallel_drawing(const std::vector<std::string>& names,
                         const std::vector<std::vector<double>>& columns, std::size_t main) {
  constexpr double width = 656, top = 44, height = 250, bottom = 30, side = 60;
  Drawing drawing;
  if (names.size() < 2) return drawing;
  drawing.width = width;
  drawing.height = top + height + bottom;
  const double gap = (width - 2 * side) / static_cast<double>(names.size() - 1);
  const auto x = [&](std::size_t axis) { return side + gap * static_cast<double>(axis); };
  std::vector<AxisRange> ranges;
  ranges.reserve(columns.size());
  for (const std::vector<double>& column : columns) ranges.emplace_back(column);

  for (std::size_t run = 0; run < columns[0].size(); ++run) {
    const double share = main < columns.size() ? ranges[main].share(columns[main][run]) : std::nan("");
    Polyline piece;
    const auto end_piece = [&] {
      if (piece.size() > 1) drawing.strokes.push_back({piece, 0.5, ramp_color(share)});
      piece.clear();
    };
    for (std::size_t axis = 0; axis < columns.size(); ++axis) {
      const double value = columns[axis][run];
      if (!std::isfinite(value)) {
        end_piece();
        continue;
      }
      piece.push_back({x(axis), top + height * (1 - ranges[axis].share(value))});
    }
    end_piece();
  }

  for (std::size_t axis = 0; axis < names.size(); ++axis) {
    drawing.strokes.push_back(
        {{{x(axis), top}, {x(axis), top + height}}, plot_style::axis_pen, plot_style::axis_color});
    drawing.labels.push_back({names[axis], x(axis), 16, plot_style::text_size, Anchor::middle});
    if (!(ranges[axis].low <= ranges[axis].high)) continue;
    drawing.labels.push_back(
        {fmt::format("{:.4g}", ranges[axis].high), x(axis), top - 8, plot_style::tick_text, Anchor::middle});
    drawing.labels.push_back({fmt::format("{:.4g}", ranges[axis].low), x(axis), top + height + 16,
                              plot_style::tick_text, Anchor::middle});
  }
  return drawing;
}

}  // namespace rigor
