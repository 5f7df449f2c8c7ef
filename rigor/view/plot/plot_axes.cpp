#include "rigor/view/plot/plot_axes.hpp"

#include <fmt/format.h>

namespace rigor {

namespace style = plot_style;

void add_axes(const PlotAxes& axes, AxisNumbers numbers, Drawing& drawing) {
  for (std::size_t i = 0; i < axes.y_ticks.values.size(); ++i) {
    const double y = axes.y(axes.y_ticks.values[i]);
    drawing.strokes.push_back({{{axes.left, y}, {axes.right, y}}, style::grid_pen, style::grid_color});
    drawing.strokes.push_back(
        {{{axes.left - style::tick_length, y}, {axes.left, y}}, style::axis_pen, style::axis_color});
    if (!numbers.y) continue;
    drawing.labels.push_back(
        {axes.y_ticks.labels[i], axes.left - style::tick_length - 4, y + 4, style::tick_text, Anchor::end});
  }
  for (std::size_t i = 0; i < axes.x_ticks.values.size(); ++i) {
    const double x = axes.x(axes.x_ticks.values[i]), y = axes.bottom;
    drawing.strokes.push_back({{{x, axes.top}, {x, y}}, style::grid_pen, style::grid_color});
    drawing.strokes.push_back({{{x, y}, {x, y + style::tick_length}}, style::axis_pen, style::axis_color});
    if (numbers.x)
      drawing.labels.push_back({axes.x_ticks.labels[i], x, y + 17, style::tick_text, Anchor::middle});
  }
  drawing.strokes.push_back({{{axes.left, axes.top}, {axes.left, axes.bottom}, {axes.right, axes.bottom}},
                             style::axis_pen,
                             style::axis_color});
}

std::string axis_title(const std::string& quantity, const std::string& unit, int exponent) {
  const std::string with_power = unit_text(unit, exponent);
  return with_power.empty() ? quantity : fmt::format("{} [{}]", quantity, with_power);
}

}  // namespace rigor
