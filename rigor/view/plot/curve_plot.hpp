#pragma once

#include "rigor/view/plot/drawing.hpp"

#include <string>
#include <vector>

namespace rigor {

enum class MarkerShape { dot, ring, cross };

/// A curve in the plane of two quantities; its points are joined in order.
struct PlaneCurve {
  Polyline points;
  std::string color;  ///< "#rrggbb".
};
struct PlaneMarker {
  Vec2 at;
  MarkerShape shape;
  std::string color;
};
/// A half-line to the edge of the panel, with an arrow along it or against it.
struct PlaneRay {
  Vec2 from, direction;  ///< The direction is a unit vector.
  bool leads_away;       ///< The arrow points along the direction.
  std::string color;
};

/// The contents of one panel.
struct CurvePanel {
  std::string title;
  std::vector<PlaneCurve> curves;
  std::vector<PlaneMarker> markers;
  std::vector<PlaneRay> rays;
};

/// An entry of a legend: a marker or, without one, a stroke.
struct LegendEntry {
  std::string text;
  std::string color;
  bool is_marker;
  MarkerShape shape = MarkerShape::dot;
};

/// Panels side by side with common axes.
struct CurvePlot {
  std::vector<CurvePanel> panels;
  std::vector<LegendEntry> legend;
  std::string x_quantity, y_quantity;
  std::string unit;  ///< Unit of both quantities.
};

/// The panels with the same scale along x and y, so that angles are true. All curves and markers are inside,
/// and so is the origin, where the axes cross in grey; values must be finite.
Drawing make_curve_plot(const CurvePlot& plot);

struct Bar {
  std::string label;
  double value;
  std::string text;  ///< Shown beside the bar.
  std::string color;
};
/// Horizontal bars from a common zero, one below the other.
Drawing make_bar_plot(const std::string& title, const std::vector<Bar>& bars, double width);

/// One drawing above the other.
Drawing stacked(const Drawing& above, const Drawing& below);

}  // namespace rigor
