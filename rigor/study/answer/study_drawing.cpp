#include "rigor/study/answer/study_drawing.hpp"

#include "rigor/view/plot/curve_plot.hpp"
#include "rigor/view/plot/plot_axes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigor {

namespace {

constexpr const char *dot_color = "#1b5fa8", *bar_color = "#8fb4d8", *line_color = "#5a6b7d";
constexpr double panel_width = 560, panel_height = 300, top_margin = 30;

/// Lowest and highest finite value.
struct DataRange {
  double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();
  void add(const std::vector<double>& values) {
    for (const double value : values) {
      if (std::isfinite(value)) low = std::min(low, value), high = std::max(high, value);
    }
  }
  bool is_empty() const { return !(low <= high); }
  /// With room beside the outermost points.
  DataRange with_margin() const {
    constexpr double share = 0.04;
    return {low - share * (high - low), high + share * (high - low)};
  }
};

void add_titles(const AnswerFigure& figure, const PlotAxes& axes, Drawing& drawing) {
  const double middle = 0.5 * (axes.left + axes.right);
  drawing.labels.push_back({figure.title, middle, axes.top - 10, plot_style::text_size + 1, Anchor::middle});
  drawing.labels.push_back({axis_title(figure.x_label, "", axes.x_ticks.exponent), middle, axes.bottom + 36,
                            plot_style::text_size, Anchor::middle});
  drawing.labels.push_back({axis_title(figure.y_label, "", axes.y_ticks.exponent), 16,
                            0.5 * (axes.top + axes.bottom), plot_style::text_size, Anchor::middle, true});
}

PlotAxes axes_for(const DataRange& x, const DataRange& y) {
  return {make_ticks(x.low, x.high, 6, false),
          make_ticks(y.low, y.high, 6, true),
          plot_style::left,
          plot_style::left + panel_width,
          top_margin,
          top_margin + panel_height};
}

Drawing empty_panel() {
  Drawing drawing;
  drawing.width = plot_style::left + panel_width + plot_style::right;
  drawing.height = top_margin + panel_height + plot_style::bottom;
  return drawing;
}

void add_dot(const Vec2& at, double width, Drawing& drawing) {
  drawing.strokes.push_back({{at, at}, width, dot_color});
}

Drawing points_drawing(const AnswerFigure& figure) {
  DataRange x, y;
  x.add(figure.x), y.add(figure.y), y.add(figure.low), y.add(figure.high);
  Drawing drawing = empty_panel();
  if (x.is_empty() || y.is_empty()) return drawing;
  const PlotAxes axes = axes_for(x.with_margin(), y);
  add_axes(axes, {}, drawing);
  add_titles(figure, axes, drawing);
  constexpr double cap = 3;
  for (std::size_t i = 0; i < figure.x.size(); ++i) {
    if (!std::isfinite(figure.x[i]) || !std::isfinite(figure.y[i])) continue;
    const Vec2 at = axes.place({figure.x[i], figure.y[i]});
    if (i < figure.low.size() && std::isfinite(figure.low[i]) && std::isfinite(figure.high[i])) {
      const double low = axes.y(figure.low[i]), high = axes.y(figure.high[i]);
      drawing.strokes.push_back({{{at.x(), low}, {at.x(), high}}, plot_style::axis_pen, line_color});
      for (const double end : {low, high})
        drawing.strokes.push_back(
            {{{at.x() - cap, end}, {at.x() + cap, end}}, plot_style::axis_pen, line_color});
    }
    add_dot(at, 5, drawing);
  }
  return drawing;
}

Drawing columns_drawing(const AnswerFigure& figure) {
  DataRange x, y;
  x.add(figure.x), x.add(figure.low), y.add(figure.y), y.add({0});
  Drawing drawing = empty_panel();
  if (x.is_empty()) return drawing;
  const PlotAxes axes = axes_for(x, y);
  for (std::size_t i = 0; i < figure.x.size(); ++i)
    drawing.boxes.push_back(
        {axes.x(figure.x[i]), axes.y(figure.y[i]), axes.x(figure.low[i]) - 0.5, axes.bottom, bar_color});
  add_axes(axes, {}, drawing);
  add_titles(figure, axes, drawing);
  return drawing;
}

/// The most important on top.
Drawing bars_drawing(const AnswerFigure& figure) {
  std::vector<std::size_t> order(figure.y.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return figure.y[a] > figure.y[b]; });
  std::vector<Bar> bars;
  for (const std::size_t i : order) {
    const std::string text = i < figure.low.size() ? fmt::format("{:.3g} ({:.3g} to {:.3g})", figure.y[i],
                                                                 figure.low[i], figure.high[i])
                                                   : fmt::format("{:.3g}", figure.y[i]);
    bars.push_back({figure.labels[i], std::max(0.0, figure.y[i]), text, bar_color});
  }
  return make_bar_plot(figure.title, bars, plot_style::left + panel_width + plot_style::right);
}

}  // namespace

Drawing figure_drawing(const AnswerFigure& figure) {
  if (figure.kind == AnswerFigure::Kind::points) return points_drawing(figure);
  return figure.kind == AnswerFigure::Kind::bars ? bars_drawing(figure) : columns_drawing(figure);
}

Drawing answer_drawing(const StudyAnswer& answer) {
  Drawing all;
  for (const AnswerFigure& figure : answer.figures) {
    const Drawing next = figure_drawing(figure);
    all = all.height > 0 ? stacked(all, next) : next;
  }
  return all;
}

Drawing scatter_matrix(const std::vector<std::string>& names,
                       const std::vector<std::vector<double>>& columns) {
  constexpr double cell = 118, gap = 6, margin = 12, dot = 2;
  constexpr std::size_t most_columns = 6, most_dots = 2000;
  const std::size_t n = std::min(most_columns, names.size());
  Drawing drawing;
  drawing.width = drawing.height = 2 * margin + static_cast<double>(n) * (cell + gap);
  for (std::size_t row = 0; row < n; ++row) {
    for (std::size_t column = 0; column < n; ++column) {
      const double left = margin + static_cast<double>(column) * (cell + gap),
                   top = margin + static_cast<double>(row) * (cell + gap);
      drawing.strokes.push_back(
          {{{left, top}, {left + cell, top}, {left + cell, top + cell}, {left, top + cell}, {left, top}},
           plot_style::grid_pen,
           line_color});
      if (row == column) {
        drawing.labels.push_back(
            {names[row], left + 0.5 * cell, top + 0.5 * cell, plot_style::tick_text, Anchor::middle});
        continue;
      }
      DataRange x, y;
      x.add(columns[column]), y.add(columns[row]);
      if (x.is_empty() || y.is_empty()) continue;
      const double x_span = x.high > x.low ? x.high - x.low : 1, y_span = y.high > y.low ? y.high - y.low : 1;
      const std::size_t step = columns[row].size() / most_dots + 1;
      for (std::size_t i = 0; i < columns[row].size(); i += step) {
        if (!std::isfinite(columns[column][i]) || !std::isfinite(columns[row][i])) continue;
        add_dot({left + 4 + (cell - 8) * (columns[column][i] - x.low) / x_span,
                 top + cell - 4 - (cell - 8) * (columns[row][i] - y.low) / y_span},
                dot, drawing);
      }
    }
  }
  return drawing;
}

}  // namespace rigor
