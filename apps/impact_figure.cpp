#include "apps/impact_figure.hpp"

#include "rigor/view/plot/curve_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

// From the palette for all kinds of colour vision.
constexpr const char *compression_color = "#0072b2", *restitution_color = "#d55e00";
constexpr const char *growing_color = "#cc79a7", *dying_color = "#009e73";
constexpr const char *point_color = "#1d2733", *loss_color = "#0072b2", *gain_color = "#d55e00";

/// The impact path as two kinds of curves; each point belongs to the segment that leads to it.
std::vector<PlaneCurve> curves_of(const LawResult& result) {
  std::vector<PlaneCurve> curves;
  for (std::size_t k = 1; k < result.path.size(); ++k) {
    const bool compresses = result.path[k].is_compressing;
    if (k == 1 || compresses != result.path[k - 1].is_compressing) {
      curves.push_back(
          {{result.path[k - 1].at.u.head<2>()}, compresses ? compression_color : restitution_color});
    }
    curves.back().points.push_back(result.path[k].at.u.head<2>());
  }
  return curves;
}

CurvePanel panel_of(const LawResult& result, const Collision& collision,
                    const std::vector<InvariantDirection>& directions) {
  CurvePanel panel{.title = law_title(result.law), .curves = curves_of(result), .markers = {}, .rays = {}};
  for (const InvariantDirection& direction : directions) {
    const bool grows = direction.radial_rate > 0;
    panel.rays.push_back({Vec2::Zero(), Vec2(std::cos(direction.theta), std::sin(direction.theta)), grows,
                          grows ? growing_color : dying_color});
  }
  panel.markers.push_back({collision.u.head<2>(), MarkerShape::cross, point_color});
  panel.markers.push_back({result.end.u.head<2>(), MarkerShape::dot, point_color});
  if (result.compression)
    panel.markers.push_back({result.compression->u.head<2>(), MarkerShape::ring, restitution_color});
  return panel;
}

std::vector<LegendEntry> legend_of(const std::vector<InvariantDirection>& directions) {
  std::vector<LegendEntry> legend = {{"before", point_color, true, MarkerShape::cross},
                                     {"compression", compression_color, false},
                                     {"greatest compression", restitution_color, true, MarkerShape::ring},
                                     {"restitution", restitution_color, false},
                                     {"after", point_color, true, MarkerShape::dot}};
  const auto grows = [](const InvariantDirection& direction) { return direction.radial_rate > 0; };
  if (std::any_of(directions.begin(), directions.end(), grows))
    legend.push_back({"slip grows along this direction", growing_color, false});
  if (!std::all_of(directions.begin(), directions.end(), grows))
    legend.push_back({"slip dies along this direction", dying_color, false});
  return legend;
}

Bar bar_of(const LawResult& result, double removable) {
  const double loss = -result.energy_change;
  std::string text = fmt::format("{:.4g} J", loss);
  if (std::isfinite(removable) && removable > 0) text += fmt::format(" ({:.1f} %)", 100 * loss / removable);
  if (loss < 0) text += ": gained";
  return {law_title(result.law), loss, text, loss < 0 ? gain_color : loss_color};
}

}  // namespace

Drawing impact_figure(const ImpactReport& report) {
  const Collision& collision = report.problem.collision;
  const std::vector<InvariantDirection> directions = invariant_directions_of(collision.matrix);
  CurvePlot plot{
      .panels = {}, .legend = legend_of(directions), .x_quantity = "v_x", .y_quantity = "v_y", .unit = "m/s"};
  std::vector<Bar> bars;
  const double removable = removable_energy(collision.matrix.K, collision.u);
  for (const LawResult& result : report.results) {
    plot.panels.push_back(panel_of(result, collision, directions));
    bars.push_back(bar_of(result, removable));
  }
  const Drawing paths = make_curve_plot(plot);
  const std::string title =
      std::isfinite(removable)
          ? fmt::format("Energy lost, of {:.4g} J that an impulse here can take", removable)
          : "Energy lost";
  return stacked(paths, make_bar_plot(title, bars, paths.width));
}

}  // namespace rigor
