#include "rigor/view/plot/curve_plot.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace rigor::curve_plot_test {
namespace {

constexpr const char *curve_color = "#0072b2", *ray_color = "#d55e00";

CurvePlot plot_of(std::vector<Polyline> curves) {
  CurvePlot plot{.panels = {}, .legend = {}, .x_quantity = "v_x", .y_quantity = "v_y", .unit = "m/s"};
  for (Polyline& curve : curves) plot.panels.push_back({"panel", {{std::move(curve), curve_color}}, {}, {}});
  return plot;
}

std::vector<Polyline> lines_of(const Drawing& drawing, const std::string& color) {
  std::vector<Polyline> lines;
  for (const Drawing::Stroke& stroke : drawing.strokes) {
    if (stroke.color == color) lines.push_back(stroke.points);
  }
  return lines;
}

void expect_inside(const Drawing& drawing) {
  for (const Drawing::Stroke& stroke : drawing.strokes) {
    for (const Vec2& point : stroke.points) {
      EXPECT_GE(point.minCoeff(), 0);
      EXPECT_LE(point.x(), drawing.width);
      EXPECT_LE(point.y(), drawing.height);
    }
  }
  for (const Drawing::Label& label : drawing.labels) {
    const double width = text_width(label.text, label.size);
    const double share = label.anchor == Anchor::start ? 0 : label.anchor == Anchor::middle ? 0.5 : 1;
    if (label.is_vertical) continue;
    EXPECT_GE(label.x - share * width, 0) << label.text;
    EXPECT_LE(label.x + (1 - share) * width, drawing.width) << label.text;
  }
}

TEST(CurvePlot, HasTheSameScaleAlongBothAxesInAllPanels) {
  // Wide, high, flat and tiny data, and a second panel far from the first.
  for (const Vec2& size :
       {Vec2(5, 1), Vec2(1, 5), Vec2(3, 0), Vec2(0, 3), Vec2(2e-9, 1e-9), Vec2(4e7, 4e7)}) {
    const Drawing drawing =
        make_curve_plot(plot_of({{Vec2(0, 0), size, Vec2(size.x(), 0)}, {-size, Vec2(0, 0)}}));
    const std::vector<Polyline> lines = lines_of(drawing, curve_color);
    ASSERT_EQ(lines.size(), 2u);
    const double scale = (lines[0][1] - lines[0][0]).norm() / size.norm();
    const Vec2 upright(scale * size.x(), -scale * size.y());
    EXPECT_LT((lines[0][1] - lines[0][0] - upright).norm(), 1e-9 * scale * size.norm());
    EXPECT_LT((lines[0][2] - lines[0][1] - Vec2(0, scale * size.y())).norm(), 1e-9 * scale * size.norm());
    EXPECT_LT((lines[1][1] - lines[1][0] - upright).norm(), 1e-9 * scale * size.norm());
    expect_inside(drawing);
    // Five panels are narrow, and yet have a scale: two numbers at least on each axis.
    const Polyline line{Vec2(0, 0), size};
    const Drawing narrow = make_curve_plot(plot_of({line, line, line, line, line}));
    const long numbers =
        std::count_if(narrow.labels.begin(), narrow.labels.end(), [](const Drawing::Label& label) {
          return label.text.find_first_not_of("−.0123456789") == std::string::npos;
        });
    EXPECT_GE(numbers, 2 + 5 * 2);
  }
}

TEST(CurvePlot, WithoutDataIsStillAPlot) {
  expect_inside(make_curve_plot(plot_of({})));
  expect_inside(make_curve_plot(plot_of({{Vec2(0, 0), Vec2(0, 0)}})));
}

TEST(CurvePlot, RaysReachTheEdgeAndTheirArrowsPointAsTold) {
  for (const bool leads_away : {true, false}) {
    CurvePlot plot = plot_of({{Vec2(-1, -1), Vec2(1, 1)}});
    plot.panels[0].rays = {{Vec2(0, 0), Vec2(0.6, -0.8), leads_away, ray_color}};
    const Drawing drawing = make_curve_plot(plot);
    const std::vector<Polyline> lines = lines_of(drawing, ray_color);
    ASSERT_EQ(lines.size(), 2u);
    const Vec2 ray = lines[0][1] - lines[0][0];
    EXPECT_NEAR(ray.x() / ray.y(), 0.6 / 0.8, 1e-12);
    EXPECT_GT(ray.y(), 0);
    // The panel ends where its axis is: the lowest horizontal line.
    double bottom = 0;
    for (const Polyline& line : lines_of(drawing, "#1d2733")) {
      if (line.size() == 3) bottom = line[1].y();
    }
    EXPECT_NEAR(lines[0][1].y(), bottom, 1e-9);
    const Vec2 wings = lines[1][1] - 0.5 * (lines[1][0] + lines[1][2]);
    EXPECT_EQ(wings.dot(ray) > 0, leads_away);
  }
}

TEST(CurvePlot, MarkersStandAtTheirPoints) {
  CurvePlot plot = plot_of({{Vec2(0, 0), Vec2(2, 1)}});
  plot.panels[0].markers = {{Vec2(2, 1), MarkerShape::ring, ray_color}};
  const Drawing drawing = make_curve_plot(plot);
  const Polyline ring = lines_of(drawing, ray_color)[0];
  Vec2 center = Vec2::Zero();
  for (std::size_t k = 1; k < ring.size(); ++k) center += ring[k] / static_cast<double>(ring.size() - 1);
  EXPECT_LT((center - lines_of(drawing, curve_color)[0][1]).norm(), 1e-9);
}

TEST(BarPlot, BarsAreAsLongAsTheirValuesOnBothSidesOfZero) {
  const std::vector<Bar> bars = {
      {"a", 3, "3 J", curve_color}, {"b", -1, "-1 J", curve_color}, {"c", 0, "0 J", curve_color}};
  const Drawing drawing = make_bar_plot("energy", bars, 700);
  ASSERT_EQ(drawing.boxes.size(), 3u);
  const auto length = [&](std::size_t k) { return drawing.boxes[k].right - drawing.boxes[k].left; };
  EXPECT_NEAR(length(0), 3 * length(1), 1e-9);
  EXPECT_EQ(length(2), 0);
  EXPECT_EQ(drawing.boxes[0].left, drawing.boxes[1].right);
  EXPECT_GT(length(1), 50);
  expect_inside(drawing);
  for (const Bar& zero : {Bar{"a", 0, "0 J", curve_color}})
    expect_inside(make_bar_plot("energy", {zero}, 700));
}

TEST(Drawing, BoxesAreFilledAndLieBelowTheLines) {
  Drawing drawing;
  drawing.width = 20, drawing.height = 10;
  drawing.boxes = {{4, 2, 12, 8, "#ff0000"}};
  drawing.strokes = {{{{0, 5}, {20, 5}}, 2, "#0000ff"}};
  const Image image = rasterised(drawing, 1);
  EXPECT_EQ(image.pixel(8, 3)[0], 255);
  EXPECT_EQ(image.pixel(8, 3)[2], 0);
  EXPECT_EQ(image.pixel(8, 4)[2], 255);
  EXPECT_EQ(image.pixel(2, 3)[2], 255);
  const std::string svg = svg_text(drawing);
  const std::size_t box =
      svg.find("<rect x=\"4.00\" y=\"2.00\" width=\"8.00\" height=\"6.00\" fill=\"#ff0000\"/>");
  ASSERT_NE(box, std::string::npos);
  EXPECT_LT(box, svg.find("<path"));
}

TEST(Drawing, StackedDrawingsKeepTheirPlacesBelowEachOther) {
  Drawing above, below;
  above.width = 30, above.height = 10;
  below.width = 50, below.height = 7;
  below.boxes = {{1, 2, 3, 4, "#ff0000"}};
  below.strokes = {{{{1, 2}, {3, 4}}, 1, "#0000ff"}};
  below.labels = {{"text", 1, 5, 11}};
  const Drawing both = stacked(above, below);
  EXPECT_EQ(both.width, 50);
  EXPECT_EQ(both.height, 17);
  EXPECT_EQ(both.boxes[0].top, 12);
  EXPECT_EQ(both.strokes[0].points[1], Vec2(3, 14));
  EXPECT_EQ(both.labels[0].y, 15);
}

}  // namespace
}  // namespace rigor::curve_plot_test
