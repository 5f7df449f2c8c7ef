#include "rigor/view/plot/plot.hpp"

#include "rigor/core/index.hpp"
#include "rigor/view/plot/plot_axes.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

using plot_style::bottom, plot_style::left, plot_style::legend_row, plot_style::line_pen, plot_style::right,
    plot_style::text_size, plot_style::tick_text;

// Sizes in units of a drawing, which are points on paper; a plot is 640 wide.
constexpr double plot_width = 640, panel_height = 190;
constexpr double top = 14, between = 16;

struct Panel {
  std::vector<const PlotSeries*> series;
  std::vector<std::size_t> colors;  ///< Colours by their index in the palette.
};

std::vector<Panel> panels_by_quantity(std::span<const PlotSeries> series) {
  std::vector<Panel> panels;
  for (std::size_t i = 0; i < series.size(); ++i) {
    const auto same = std::find_if(panels.begin(), panels.end(), [&](const Panel& panel) {
      return panel.series[0]->quantity == series[i].quantity && panel.series[0]->unit == series[i].unit;
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

/// Draws the rows of the legend above a panel; returns the height that they take.
double add_legend(const Panel& panel, double y, Drawing& drawing) {
  constexpr double sample = 20, gap = 16;
  double x = left, row = y + legend_row - 5;
  for (std::size_t i = 0; i < panel.series.size(); ++i) {
    const double needed = sample + 5 + text_width(panel.series[i]->key, tick_text) + gap;
    if (x > left && x + needed > plot_width - right) x = left, row += legend_row;
    drawing.strokes.push_back({{{x, row - 4}, {x + sample, row - 4}}, line_pen, color_of(panel.colors[i])});
    drawing.labels.push_back({panel.series[i]->key, x + sample + 5, row, tick_text});
    x += needed;
  }
  return row - y + 8;
}

/// "angular velocity" of angular_velocity.
std::string spaced(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

/// Keeps the lowest and the highest point of each column, in order.
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

void add_lines(const Panel& panel, std::span<const double> time, const PlotAxes& axes, Drawing& drawing) {
  constexpr std::size_t columns = 2000;
  for (std::size_t i = 0; i < panel.series.size(); ++i) {
    const PlotSeries& series = *panel.series[i];
    const std::span<const double> own = series.times.empty() ? time : std::span<const double>(series.times);
    for (Polyline& piece : line_pieces(own, series.values, columns)) {
      for (Vec2& point : piece) point = axes.place(point);
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
  drawing.width = plot_width;
  const std::vector<Panel> panels = panels_by_quantity(series);
  const Extent times = time_extent(time, series);
  double y = top;
  for (const Panel& panel : panels) {
    const bool is_last = &panel == &panels.back();
    y += add_legend(panel, y, drawing);
    const PlotAxes axes{make_ticks(times.low, times.high, 8, false),
                        value_ticks(panel),
                        left,
                        plot_width - right,
                        y,
                        y + panel_height};
    add_axes(axes, {.x = is_last, .y = true}, drawing);
    drawing.labels.push_back(
        {axis_title(spaced(panel.series[0]->quantity), panel.series[0]->unit, axes.y_ticks.exponent), 16,
         0.5 * (axes.top + axes.bottom), text_size, Anchor::middle, true});
    add_lines(panel, time, axes, drawing);
    y = axes.bottom + between;
    if (is_last) {
      drawing.labels.push_back({axis_title("time", "s", axes.x_ticks.exponent),
                                0.5 * (left + plot_width - right), axes.bottom + 36, text_size,
                                Anchor::middle});
    }
  }
  drawing.height = y - between + bottom;
  return drawing;
}

}  // namespace rigor
