#include "rigor/view/plot.hpp"

#include "rigor/view/ticks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

// In units of a drawing: as points on paper, 640 wide.
constexpr double width = 640, panel_height = 190;
constexpr double left = 74, right = 22, top = 14, bottom = 46, between = 16;
constexpr double text = 12, tick_text = 11, legend_row = 17, tick_length = 4;
constexpr double axis_pen = 0.9, grid_pen = 0.5, line_pen = 1.4;
constexpr const char *axis_color = "#1d2733", *grid_color = "#dfe3e8";

struct Panel {
  std::vector<const PlotSeries*> series;
  std::vector<std::size_t> colors;  ///< Of the palette.
};

std::vector<Panel> panels_by_quantity(std::span<const PlotSeries> series) {
  std::vector<Panel> panels;
  for (std::size_t i = 0; i < series.size(); ++i) {
    const auto same = std::find_if(panels.begin(), panels.end(), [&](const Panel& panel) {
      return panel.series[0]->quantity == series[i].quantity;
    });
    Panel& panel = same == panels.end() ? panels.emplace_back() : *same;
    panel.series.push_back(&series[i]);
    panel.colors.push_back(i);
  }
  return panels;
}

struct Extent {
  double low = HUGE_VAL, high = -HUGE_VAL;
};
Extent extent_of(std::span<const double> values) {
  Extent extent;
  for (const double value : values) {
    if (std::isfinite(value)) extent = {std::min(extent.low, value), std::max(extent.high, value)};
  }
  return extent;
}

Ticks value_ticks(const Panel& panel) {
  Extent all;
  for (const PlotSeries* const series : panel.series) {
    const Extent extent = extent_of(series->values);
    all = {std::min(all.low, extent.low), std::max(all.high, extent.high)};
  }
  if (all.low > all.high) all = {0, 1};
  return make_ticks(all.low, all.high, 5, true);
}

std::string color_of(std::size_t index) {
  return hex_text(palette_color(static_cast<int>(index)));
}

/// Legend rows above a panel; returns the height they take.
double add_legend(const Panel& panel, double y, Drawing& drawing) {
  constexpr double sample = 20, gap = 16;
  double x = left, row = y + legend_row - 5;
  for (std::size_t i = 0; i < panel.series.size(); ++i) {
    const double needed = sample + 5 + text_width(panel.series[i]->key, tick_text) + gap;
    if (x > left && x + needed > width - right) x = left, row += legend_row;
    drawing.strokes.push_back({{{x, row - 4}, {x + sample, row - 4}}, line_pen, color_of(panel.colors[i])});
    drawing.labels.push_back({panel.series[i]->key, x + sample + 5, row, tick_text});
    x += needed;
  }
  return row - y + 8;
}

/// From data to places in the drawing.
struct Axes {
  Ticks time, value;
  double y_top, y_bottom;

  double x(double t) const { return left + (width - left - right) * (t - time.low) / (time.high - time.low); }
  double y(double v) const {
    return y_bottom - (y_bottom - y_top) * (v - value.low) / (value.high - value.low);
  }
};

void add_frame(const Axes& axes, const std::string& title, bool is_last, Drawing& drawing) {
  for (std::size_t i = 0; i < axes.value.values.size(); ++i) {
    const double y = axes.y(axes.value.values[i]);
    drawing.strokes.push_back({{{left, y}, {width - right, y}}, grid_pen, grid_color});
    drawing.strokes.push_back({{{left - tick_length, y}, {left, y}}, axis_pen, axis_color});
    drawing.labels.push_back({axes.value.labels[i], left - tick_length - 4, y + 4, tick_text, Anchor::end});
  }
  for (std::size_t i = 0; i < axes.time.values.size(); ++i) {
    const double x = axes.x(axes.time.values[i]), y = axes.y_bottom;
    drawing.strokes.push_back({{{x, axes.y_top}, {x, y}}, grid_pen, grid_color});
    drawing.strokes.push_back({{{x, y}, {x, y + tick_length}}, axis_pen, axis_color});
    if (is_last) drawing.labels.push_back({axes.time.labels[i], x, y + 17, tick_text, Anchor::middle});
  }
  drawing.strokes.push_back(
      {{{left, axes.y_top}, {left, axes.y_bottom}, {width - right, axes.y_bottom}}, axis_pen, axis_color});
  drawing.labels.push_back({title, 16, 0.5 * (axes.y_top + axes.y_bottom), text, Anchor::middle, true});
}

/// "angular velocity [rad/s]".
std::string axis_title(std::string quantity, const std::string& unit, int exponent) {
  std::replace(quantity.begin(), quantity.end(), '_', ' ');
  const std::string with_power = unit_text(unit, exponent);
  return with_power.empty() ? quantity : fmt::format("{} [{}]", quantity, with_power);
}

/// Keeps the lowest and the highest point of each column, in their order.
Polyline thinned(const Polyline& line, std::size_t columns) {
  const double begin = line.front().x(), span = line.back().x() - begin;
  Polyline kept = {line.front()};
  for (std::size_t i = 0; i < line.size();) {
    const auto column = [&](std::size_t k) {
      return static_cast<std::size_t>((line[k].x() - begin) / span * static_cast<double>(columns));
    };
    std::size_t lowest = i, highest = i;
    const std::size_t here = column(i);
    for (; i < line.size() && column(i) == here; ++i) {
      if (line[i].y() < line[lowest].y()) lowest = i;
      if (line[i].y() > line[highest].y()) highest = i;
    }
    kept.push_back(line[std::min(lowest, highest)]);
    if (lowest != highest) kept.push_back(line[std::max(lowest, highest)]);
  }
  kept.push_back(line.back());
  return kept;
}

/// Width of the i-th line of a panel.
double pen_of(const Panel& panel, std::size_t i) {
  constexpr double rim = 1.2, widest = 4.2;
  const double later = static_cast<double>(panel.series.size() - 1 - i);
  if (panel.series[i]->times.empty() || later == 0) return line_pen;
  return line_pen + later * std::min(rim, widest / static_cast<double>(panel.series.size() - 1));
}

/// First and last output time of all lines.
Extent time_extent(std::span<const double> time, std::span<const PlotSeries> series) {
  Extent all = extent_of(time);
  for (const PlotSeries& own : series) {
    const Extent extent = extent_of(own.times);
    all = {std::min(all.low, extent.low), std::max(all.high, extent.high)};
  }
  return all;
}

void add_lines(const Panel& panel, std::span<const double> time, const Axes& axes, Drawing& drawing) {
  constexpr std::size_t columns = 2000;
  for (std::size_t i = 0; i < panel.series.size(); ++i) {
    const PlotSeries& series = *panel.series[i];
    const std::span<const double> own = series.times.empty() ? time : std::span<const double>(series.times);
    for (Polyline& piece : line_pieces(own, series.values, columns)) {
      for (Vec2& point : piece) point = {axes.x(point.x()), axes.y(point.y())};
      drawing.strokes.push_back({std::move(piece), pen_of(panel, i), color_of(panel.colors[i])});
    }
  }
}
}  // namespace

std::vector<Polyline> line_pieces(std::span<const double> time, std::span<const double> values,
                                  std::size_t columns) {
  std::vector<Polyline> pieces;
  Polyline piece;
  const auto finish = [&] {
    if (piece.empty()) return;
    if (piece.size() == 1) piece.push_back(piece[0]);
    pieces.push_back(piece.size() > 2 * columns ? thinned(piece, columns) : piece);
    piece.clear();
  };
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::isfinite(values[i])) {
      piece.push_back({time[i], values[i]});
    } else {
      finish();
    }
  }
  finish();
  return pieces;
}

Drawing make_plot(std::span<const double> time, std::span<const PlotSeries> series) {
  Drawing drawing;
  drawing.width = width;
  const std::vector<Panel> panels = panels_by_quantity(series);
  const Extent times = time_extent(time, series);
  double y = top;
  for (const Panel& panel : panels) {
    const bool is_last = &panel == &panels.back();
    y += add_legend(panel, y, drawing);
    const Axes axes{make_ticks(times.low, times.high, 8, false), value_ticks(panel), y, y + panel_height};
    add_frame(axes, axis_title(panel.series[0]->quantity, panel.series[0]->unit, axes.value.exponent),
              is_last, drawing);
    add_lines(panel, time, axes, drawing);
    y = axes.y_bottom + between;
    if (is_last) {
      drawing.labels.push_back({axis_title("time", "s", axes.time.exponent), 0.5 * (left + width - right),
                                axes.y_bottom + 36, text, Anchor::middle});
    }
  }
  drawing.height = y - between + bottom;
  return drawing;
}

}  // namespace rigor
