#pragma once

#include "rigor/view/plot/drawing.hpp"
#include "rigor/view/plot/ticks.hpp"

namespace rigor {

/// A panel of a plot: it maps data to positions in the drawing, x right and y up.
struct PlotAxes {
  Ticks x_ticks, y_ticks;
  double left, right, top, bottom;  ///< Edges of the panel in the drawing.

  double x(double value) const {
    return left + (right - left) * (value - x_ticks.low) / (x_ticks.high - x_ticks.low);
  }
  double y(double value) const {
    return bottom - (bottom - top) * (value - y_ticks.low) / (y_ticks.high - y_ticks.low);
  }
  Vec2 place(const Vec2& point) const { return {x(point.x()), y(point.y())}; }
};

/// Sizes that plots have in common, in units of a drawing, which are points on paper.
namespace plot_style {
/// Margins of a plot, and the height of a row of its legend.
inline constexpr double left = 74, right = 22, bottom = 46, legend_row = 17;
inline constexpr double text_size = 12, tick_text = 11, tick_length = 4;
inline constexpr double axis_pen = 0.9, grid_pen = 0.5, line_pen = 1.4;
inline constexpr const char *axis_color = "#1d2733", *grid_color = "#dfe3e8";
}  // namespace plot_style

/// The axes of a panel that have numbers at their marks.
struct AxisNumbers {
  bool x = true, y = true;
};
/// Draws the grid, the marks and the two axes of the panel.
void add_axes(const PlotAxes& axes, AxisNumbers numbers, Drawing& drawing);

/// "angular velocity [rad/s]", with the power of ten of the marks.
std::string axis_title(const std::string& quantity, const std::string& unit, int exponent);

}  // namespace rigor
