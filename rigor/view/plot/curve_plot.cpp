#include "rigor/view/plot/curve_plot.hpp"

#include "rigor/view/plot/plot_axes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigor {

namespace {

using plot_style::axis_color, plot_style::axis_pen, plot_style::bottom, plot_style::left,
    plot_style::legend_row, plot_style::line_pen, plot_style::right, plot_style::text_size,
    plot_style::tick_text;

// Sizes in units of a drawing, which are points on paper.
constexpr double panels_top = 12, panel_gap = 18;
constexpr double all_panels = 780, widest_panel = 420, lowest_panel = 130, highest_panel = 320;
constexpr double title_row = 22;
constexpr double ray_pen = 0.8, arrow = 7, marker_radius = 4, dot_width = 7.5;

void add_marker(MarkerShape shape, const Vec2& at, const std::string& color, Drawing& drawing) {
  constexpr int corners = 24;
  switch (shape) {
    case MarkerShape::dot:
      drawing.strokes.push_back({{at, at}, dot_width, color});
      return;
    case MarkerShape::ring: {
      Polyline ring;
      for (int k = 0; k <= corners; ++k) {
        const double angle = 2 * std::numbers::pi * k / corners;
        ring.push_back(at + marker_radius * Vec2(std::cos(angle), std::sin(angle)));
      }
      drawing.strokes.push_back({std::move(ring), line_pen, color});
      return;
    }
    case MarkerShape::cross: {
      const Vec2 rising(marker_radius, -marker_radius), falling(marker_radius, marker_radius);
      drawing.strokes.push_back({{at - rising, at + rising}, line_pen, color});
      drawing.strokes.push_back({{at - falling, at + falling}, line_pen, color});
      return;
    }
  }
}

/// Draws the rows of the legend; returns the height that they take.
double add_legend(const std::vector<LegendEntry>& legend, double width, Drawing& drawing) {
  constexpr double sample = 20, gap = 16;
  double x = left, row = panels_top + legend_row - 5;
  for (const LegendEntry& entry : legend) {
    const double needed = sample + 5 + text_width(entry.text, tick_text) + gap;
    if (x > left && x + needed > width - right) x = left, row += legend_row;
    if (entry.is_marker) {
      add_marker(entry.shape, {x + 0.5 * sample, row - 4}, entry.color, drawing);
    } else {
      drawing.strokes.push_back({{{x, row - 4}, {x + sample, row - 4}}, line_pen, entry.color});
    }
    drawing.labels.push_back({entry.text, x + sample + 5, row, tick_text});
    x += needed;
  }
  return legend.empty() ? 0 : row - panels_top + 8;
}

/// The extent of all panels: their points and the origin.
struct PlaneExtent {
  Vec2 low = Vec2::Zero(), high = Vec2::Zero();

  void add(const Vec2& point) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  Vec2 span() const { return high - low; }
};

PlaneExtent extent_of(const CurvePlot& plot) {
  PlaneExtent extent;
  for (const CurvePanel& panel : plot.panels) {
    for (const PlaneCurve& curve : panel.curves) {
      for (const Vec2& point : curve.points) extent.add(point);
    }
    for (const PlaneMarker& marker : panel.markers) extent.add(marker.at);
  }
  return extent;
}

/// The extent with a margin, made as wide and as high as a panel of this width that has the same scale in
/// both directions; sets `height` to the height of the panel.
PlaneExtent fitted_extent(const PlaneExtent& data, double width, double& height) {
  constexpr double margin = 0.08;
  Vec2 span = data.span();
  const double size = span.maxCoeff() > 0 ? span.maxCoeff() : 1;
  span.array() += 2 * margin * size;
  const double scale = std::min(width / span.x(), highest_panel / span.y());
  height = std::clamp(span.y() * scale, lowest_panel, highest_panel);
  const Vec2 half = 0.5 / scale * Vec2(width, height), middle = 0.5 * (data.low + data.high);
  return {middle - half, middle + half};
}

/// Length of the half-line inside the panel, which contains its start.
double length_inside(const PlotAxes& axes, const PlaneRay& ray) {
  const Vec2 low(axes.x_ticks.low, axes.y_ticks.low), high(axes.x_ticks.high, axes.y_ticks.high);
  double length = HUGE_VAL;
  for (int k = 0; k < 2; ++k) {
    if (ray.direction[k] != 0) {
      const double edge = ray.direction[k] > 0 ? high[k] : low[k];
      length = std::min(length, (edge - ray.from[k]) / ray.direction[k]);
    }
  }
  return length;
}

void add_ray(const PlotAxes& axes, const PlaneRay& ray, Drawing& drawing) {
  constexpr double place = 0.7;
  const double length = length_inside(axes, ray);
  const Vec2 begin = axes.place(ray.from), end = axes.place(ray.from + length * ray.direction);
  drawing.strokes.push_back({{begin, end}, ray_pen, ray.color});
  if ((end - begin).norm() < 2 * arrow) return;
  const Vec2 along = (ray.leads_away ? 1 : -1) * (end - begin).normalized();
  const Vec2 across(-along.y(), along.x()), tip = begin + place * (end - begin);
  drawing.strokes.push_back(
      {{tip - arrow * along + 0.45 * arrow * across, tip, tip - arrow * along - 0.45 * arrow * across},
       line_pen,
       ray.color});
}

void add_panel(const PlotAxes& axes, const CurvePanel& panel, bool is_first, Drawing& drawing) {
  constexpr const char* zero_color = "#9aa4b0";
  add_axes(axes, {.x = true, .y = is_first}, drawing);
  const Vec2 zero = axes.place(Vec2::Zero());
  drawing.strokes.push_back({{{axes.left, zero.y()}, {axes.right, zero.y()}}, axis_pen, zero_color});
  drawing.strokes.push_back({{{zero.x(), axes.top}, {zero.x(), axes.bottom}}, axis_pen, zero_color});
  for (const PlaneRay& ray : panel.rays) add_ray(axes, ray, drawing);
  for (const PlaneCurve& curve : panel.curves) {
    Polyline line = curve.points;
    for (Vec2& point : line) point = axes.place(point);
    drawing.strokes.push_back({std::move(line), line_pen, curve.color});
  }
  for (const PlaneMarker& marker : panel.markers)
    add_marker(marker.shape, axes.place(marker.at), marker.color, drawing);
  drawing.labels.push_back(
      {panel.title, 0.5 * (axes.left + axes.right), axes.top - 7, text_size, Anchor::middle});
}

}  // namespace

Drawing make_curve_plot(const CurvePlot& plot) {
  const double count = static_cast<double>(std::max<std::size_t>(1, plot.panels.size()));
  const double panel_width = std::min(widest_panel, (all_panels - (count - 1) * panel_gap) / count);
  Drawing drawing;
  drawing.width = left + count * panel_width + (count - 1) * panel_gap + right;
  const double y = panels_top + add_legend(plot.legend, drawing.width, drawing) + title_row;
  double height = 0;
  const PlaneExtent shown = fitted_extent(extent_of(plot), panel_width, height);
  // Three marks are requested at least, so that there are two of them and with them a scale.
  const auto marks = [](double length, double apart) {
    return std::max(3, static_cast<int>(length / apart));
  };
  const Ticks x_ticks = make_ticks(shown.low.x(), shown.high.x(), marks(panel_width, 60), false);
  const Ticks y_ticks = make_ticks(shown.low.y(), shown.high.y(), marks(height, 45), false);
  double x = left;
  for (const CurvePanel& panel : plot.panels) {
    const PlotAxes axes{x_ticks, y_ticks, x, x + panel_width, y, y + height};
    add_panel(axes, panel, &panel == &plot.panels.front(), drawing);
    drawing.labels.push_back({axis_title(plot.x_quantity, plot.unit, x_ticks.exponent),
                              0.5 * (axes.left + axes.right), axes.bottom + 36, text_size, Anchor::middle});
    x = axes.right + panel_gap;
  }
  drawing.labels.push_back({axis_title(plot.y_quantity, plot.unit, y_ticks.exponent), 16, y + 0.5 * height,
                            text_size, Anchor::middle, true});
  drawing.height = y + height + bottom;
  return drawing;
}

Drawing make_bar_plot(const std::string& title, const std::vector<Bar>& bars, double width) {
  constexpr double row = 24, thickness = 13, space = 8, head = 26;
  Drawing drawing;
  drawing.width = width;
  drawing.labels.push_back({title, left, head - 8, text_size});
  double label_width = 0, text_space = 0, low = 0, high = 0;
  for (const Bar& bar : bars) {
    label_width = std::max(label_width, text_width(bar.label, text_size));
    text_space = std::max(text_space, text_width(bar.text, tick_text));
    low = std::min(low, bar.value), high = std::max(high, bar.value);
  }
  const double begin = left + label_width + space, end = width - right - text_space - space;
  const double scale = high > low ? std::max(1.0, end - begin) / (high - low) : 0;
  const double zero = begin - low * scale;
  double y = head;
  for (const Bar& bar : bars) {
    const double tip = zero + bar.value * scale, middle = y + 0.5 * row;
    drawing.boxes.push_back({std::min(zero, tip), middle - 0.5 * thickness, std::max(zero, tip),
                             middle + 0.5 * thickness, bar.color});
    drawing.labels.push_back({bar.label, left, middle + 4, text_size});
    drawing.labels.push_back({bar.text, std::max(zero, tip) + space, middle + 4, tick_text});
    y += row;
  }
  drawing.strokes.push_back({{{zero, head}, {zero, y}}, axis_pen, axis_color});
  drawing.height = y + panels_top;
  return drawing;
}

Drawing stacked(const Drawing& above, const Drawing& below) {
  Drawing all = above;
  all.width = std::max(above.width, below.width);
  all.height = above.height + below.height;
  for (Drawing::Stroke stroke : below.strokes) {
    for (Vec2& point : stroke.points) point.y() += above.height;
    all.strokes.push_back(std::move(stroke));
  }
  for (Drawing::Label label : below.labels) {
    label.y += above.height;
    all.labels.push_back(std::move(label));
  }
  for (Drawing::Box box : below.boxes) {
    box.top += above.height, box.bottom += above.height;
    all.boxes.push_back(std::move(box));
  }
  return all;
}

}  // namespace rigor
