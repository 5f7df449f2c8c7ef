#include "rigor/view/plot/plot.hpp"

#include "rigor/view/plot/sparkline.hpp"
#include "rigor/view/plot/ticks.hpp"
#include "view/view_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace rigor::plot_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// Ticks

TEST(Ticks, AreRoundNumbersThatHoldTheData) {
  const Ticks ticks = make_ticks(0.13, 9.2, 5, true);
  EXPECT_EQ(ticks.labels, (std::vector<std::string>{"0", "2", "4", "6", "8", "10"}));
  EXPECT_EQ(ticks.low, 0);
  EXPECT_EQ(ticks.high, 10);
  const Ticks time = make_ticks(0, 10.995, 8, false);
  EXPECT_EQ(time.high, 10.995);
  EXPECT_EQ(time.labels, (std::vector<std::string>{"0", "1", "2", "3", "4", "5", "6", "7", "8", "9", "10"}));
  EXPECT_EQ(make_ticks(-0.3, 0.3, 5, true).labels,
            (std::vector<std::string>{"−0.3", "−0.2", "−0.1", "0.0", "0.1", "0.2", "0.3"}));
}

TEST(Ticks, SmallAndLargeNumbersHaveTheirPowerInTheTitle) {
  const Ticks small = make_ticks(0, 3.9e-7, 4, true);
  EXPECT_EQ(small.exponent, -9);
  EXPECT_EQ(small.labels, (std::vector<std::string>{"0", "100", "200", "300", "400"}));
  EXPECT_EQ(unit_text("m", small.exponent), "10⁻⁹ m");
  EXPECT_EQ(make_ticks(0, 3e6, 3, true).exponent, 6);
  EXPECT_EQ(unit_text("J", 0), "J");
  EXPECT_EQ(unit_text("1", 0), "");
  EXPECT_EQ(unit_text("1", 12), "10¹²");
}

TEST(Ticks, OfAConstantDoNotShowItsRounding) {
  const Ticks ticks = make_ticks(102.940627370511, 102.940627370511 * (1 + 1e-15), 5, true);
  EXPECT_GT(ticks.high - ticks.low, 1e-5);
  for (std::size_t i = 1; i < ticks.labels.size(); ++i) EXPECT_NE(ticks.labels[i], ticks.labels[i - 1]);
  const Ticks zero = make_ticks(0, 0, 5, true);
  EXPECT_EQ(zero.low, 0);
  EXPECT_EQ(zero.high, 1);
}

// Series

TEST(PlotSeries, KeysGiveTheStoredNumbers) {
  const Recording recording = made_up_recording(scene_of(two_balls), 4, 0.1);
  EXPECT_EQ(find_series(recording, "energy.total")->values, (std::vector<double>{10.5, 11.5, 12.5, 13.5}));
  EXPECT_EQ(find_series(recording, "body.a.position.z")->values, (std::vector<double>{0, 1, 2, 3}));
  EXPECT_EQ(find_series(recording, "body.b.c.position.x")->values, (std::vector<double>{1, 1, 1, 1}));
  EXPECT_EQ(find_series(recording, "body.b.c.velocity")->values, (std::vector<double>{5, 5, 5, 5}));
  EXPECT_EQ(find_series(recording, "body.a.orientation.w")->values, (std::vector<double>{1, 1, 1, 1}));
  // Masses of 2 and 3 kg at (0, 3, 4) m/s.
  EXPECT_EQ(find_series(recording, "momentum.z")->values[0], 20);
  EXPECT_EQ(find_series(recording, "momentum")->values[0], 25);
  EXPECT_EQ(find_series(recording, "body.a.angular_velocity.z")->unit, "rad/s");
}

TEST(PlotSeries, EveryListedKeyIsThereAndOthersAreNot) {
  const Recording recording = made_up_recording(scene_of(two_balls), 2, 0.1);
  for (const std::string& key : plot_keys(recording)) {
    const std::optional<PlotSeries> series = find_series(recording, key);
    ASSERT_TRUE(series) << key;
    EXPECT_EQ(series->values.size(), 2u) << key;
    EXPECT_EQ(series->key, key);
  }
  for (const char* key : {"", "energy", "energy.", "body.a", "body.a.", "body..position.x",
                          "body.c.position.x", "body.a.position.w", "momentum.w", "body.a.orientation"}) {
    EXPECT_FALSE(find_series(recording, key)) << key;
  }
  EXPECT_EQ(body_of_key("body.b.d.position.x"), "b.d");
  EXPECT_FALSE(body_of_key("body.b.d.posture.x"));
}

/// Bodies a and b.c on a hinge, a cylindrical joint with a point in its name, and a weld.
Recording recording_with_joints() {
  const Scene scene = parse_scene(
      "rigor: 1\nbodies:\n" + two_balls +
          "joints:\n"
          "  - {name: weld, type: fixed, bodies: [world, a]}\n"
          "  - {name: elbow, type: hinge, bodies: [world, a], anchor: [0, 0, 1], axis: [0, 1, 0]}\n"
          "  - {name: the.pin, type: cylindrical, bodies: [a, b.c], anchor: [0, 0, 0], "
          "axis: [1, 0, 0]}\n",
      "test.yaml", ".");
  Recording recording = made_up_recording(scene, 2, 0.1);
  StoredTrajectory& motion = recording.motion;
  motion.joints = {"weld", "elbow", "the.pin"};
  motion.coordinate_joint = {1, 2, 2};
  motion.joint_coordinate = {1, 2, 3, 4, 5, 6};
  motion.joint_rate = {-1, -2, -3, -4, -5, -6};
  motion.joint_force = {0, 0, 1, 0, 3, 4, 7, 8, 9, 0, 0, 2, 0, 6, 8, 70, 80, 90};
  motion.joint_torque = {0, 0, 0, 1, 2, 2, 4, 5, 6, 0, 0, 0, 2, 4, 4, 40, 50, 60};
  return recording;
}

TEST(PlotSeries, KeysOfJointsGiveTheStoredNumbersWithTheirUnits) {
  const Recording recording = recording_with_joints();
  const auto expect_series = [&](const char* key, const std::vector<double>& values, const char* unit) {
    const std::optional<PlotSeries> series = find_series(recording, key);
    ASSERT_TRUE(series) << key;
    EXPECT_EQ(series->values, values) << key;
    EXPECT_EQ(series->unit, unit) << key;
  };
  expect_series("elbow.coordinate", {1, 4}, "rad");
  expect_series("elbow.rate", {-1, -4}, "rad/s");
  expect_series("elbow.force", {5, 10}, "N");
  expect_series("elbow.force.z", {4, 8}, "N");
  expect_series("elbow.torque", {3, 6}, "N m");
  expect_series("weld.force.z", {1, 2}, "N");
  // Cylindrical: the displacement, then the angle.
  expect_series("the.pin.coordinate[0]", {2, 5}, "m");
  expect_series("the.pin.coordinate[1]", {3, 6}, "rad");
  expect_series("the.pin.rate[0]", {-2, -5}, "m/s");
  expect_series("the.pin.torque.x", {4, 40}, "N m");
}

TEST(PlotSeries, EveryListedKeyOfAJointIsThereAndOthersAreNot) {
  Recording recording = recording_with_joints();
  const std::vector<std::string> keys = plot_keys(recording);
  // One coordinate, two of them, and for each joint two vectors of four keys, each with its rate.
  EXPECT_EQ(keys.size(), plot_keys(made_up_recording(scene_of(two_balls), 2, 0.1)).size() + 2 + 4 + 3 * 8);
  for (const std::string& key : keys) EXPECT_TRUE(find_series(recording, key)) << key;
  for (const char* key : {"elbow", "elbow.", "elbow.coordinate[0]", "elbow.coordinate.x", "elbow.force[0]",
                          "elbow.force.w", "weld.coordinate", "the.pin.coordinate", "the.pin.rate[2]",
                          "the.pin.coordinate[-1]", "pin.force", ".force", "elbow.forces"}) {
    EXPECT_FALSE(find_series(recording, key)) << key;
  }
  EXPECT_EQ(joint_of_key("the.pin.coordinate[7]"), "the.pin");
  EXPECT_EQ(joint_of_key("a.force.torque.x"), "a.force");
  EXPECT_FALSE(joint_of_key("elbow.position"));
  EXPECT_FALSE(joint_of_key("force"));

  // A trajectory of many joints holds no forces.
  recording.motion.joint_force.clear();
  EXPECT_FALSE(find_series(recording, "elbow.force"));
  EXPECT_TRUE(find_series(recording, "elbow.rate"));
}

// Lines

TEST(LinePieces, AValueThatIsNotFiniteBreaksTheLine) {
  const std::vector<double> time = {0, 1, 2, 3, 4, 5}, values = {1, 2, nan, 4, nan, HUGE_VAL};
  const std::vector<Polyline> pieces = line_pieces(time, values, 100);
  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_EQ(pieces[0], (Polyline{Vec2(0, 1), Vec2(1, 2)}));
  EXPECT_EQ(pieces[1], (Polyline{Vec2(3, 4), Vec2(3, 4)}));
}

TEST(LinePieces, ManyPointsKeepTheirExtremesAndEnds) {
  std::vector<double> time, values;
  for (int i = 0; i < 100000; ++i) time.push_back(i), values.push_back(std::sin(0.37 * i));
  values[54321] = 17;
  const std::vector<Polyline> pieces = line_pieces(time, values, 50);
  ASSERT_EQ(pieces.size(), 1u);
  EXPECT_LE(pieces[0].size(), 2 * 51u + 2);
  EXPECT_EQ(pieces[0].front(), Vec2(0, values[0]));
  EXPECT_EQ(pieces[0].back(), Vec2(99999, values[99999]));
  EXPECT_NE(std::find(pieces[0].begin(), pieces[0].end(), Vec2(54321, 17)), pieces[0].end());
  EXPECT_TRUE(std::is_sorted(pieces[0].begin(), pieces[0].end(),
                             [](const Vec2& a, const Vec2& b) { return a.x() < b.x(); }));
}

// Drawings

/// Tags of a document that must nest; empty if one does not.
std::vector<std::string> well_formed_tags(const std::string& xml) {
  std::vector<std::string> tags, open;
  for (std::size_t at = 0; (at = xml.find_first_of("<>&", at)) != std::string::npos; ++at) {
    if (xml[at] == '>') return {};
    if (xml[at] == '&') {
      const std::string entity = xml.substr(at, xml.find(';', at) - at);
      if (entity != "&amp" && entity != "&lt" && entity != "&gt") return {};
      continue;
    }
    const std::size_t end = xml.find('>', at);
    if (end == std::string::npos) return {};
    std::string tag = xml.substr(at + 1, end - at - 1);
    if (tag.find('<') != std::string::npos || std::count(tag.begin(), tag.end(), '"') % 2 != 0) return {};
    if (tag[0] == '/') {
      if (open.empty() || open.back() != tag.substr(1)) return {};
      open.pop_back();
    } else {
      tags.push_back(tag.substr(0, tag.find(' ')));
      if (tag.back() != '/') open.push_back(tags.back());
    }
    at = end;
  }
  return open.empty() ? tags : std::vector<std::string>{};
}

TEST(Plot, TheSvgIsWellFormedAndItsPathsPassThroughTheData) {
  const std::vector<double> time = {0, 1, 2, 4};
  const std::vector<PlotSeries> series = {{"a<b & c", "energy", "J", {0, 10, 5, 10}},
                                          {"momentum", "momentum", "kg m/s", {1, nan, 2, 3}}};
  const std::string svg = svg_text(make_plot(time, series));
  const std::vector<std::string> tags = well_formed_tags(svg);
  ASSERT_FALSE(tags.empty()) << svg;
  EXPECT_EQ(tags[0], "svg");
  EXPECT_NE(svg.find("a&lt;b &amp; c"), std::string::npos);
  for (const char* text : {"time [s]", "energy [J]", "momentum [kg m/s]", ">10<"})
    EXPECT_NE(svg.find(text), std::string::npos) << text;
  // The energy's line is the longest path of the first colour: four points, whose places are affine in the
  // data.
  std::vector<Vec2> points;
  for (std::size_t at = 0; (at = svg.find("<path d=\"", at)) != std::string::npos; ++at) {
    std::string path = svg.substr(at + 9, svg.find('"', at + 9) - at - 9);
    if (std::count(path.begin(), path.end(), 'L') != 3) continue;
    std::replace_if(
        path.begin(), path.end(), [](char c) { return c == 'M' || c == 'L'; }, ' ');
    std::istringstream numbers(path);
    for (double x, y; numbers >> x >> y;) points.push_back({x, y});
  }
  ASSERT_EQ(points.size(), 4u);
  // Written to a hundredth.
  EXPECT_NEAR(points[1].x() - points[0].x(), (points[3].x() - points[0].x()) / 4, 0.011);
  EXPECT_NEAR(points[2].x() - points[0].x(), (points[3].x() - points[0].x()) / 2, 0.011);
  EXPECT_LT(points[1].y(), points[0].y());
  EXPECT_NEAR(points[1].y(), points[3].y(), 0.011);
  EXPECT_NEAR(points[2].y(), (points[0].y() + points[1].y()) / 2, 0.011);
}

TEST(Plot, AnglesAndDisplacementsHavePanelsOfTheirOwn) {
  const Recording recording = recording_with_joints();
  const std::vector<PlotSeries> series = {*find_series(recording, "elbow.coordinate"),
                                          *find_series(recording, "the.pin.coordinate[0]")};
  const std::string svg = svg_text(make_plot(recording.motion.time, series));
  EXPECT_NE(svg.find("coordinate [rad]"), std::string::npos);
  EXPECT_NE(svg.find("coordinate [m]"), std::string::npos);
}

TEST(Plot, NothingLeavesTheDrawing) {
  std::vector<PlotSeries> series;
  for (int i = 0; i < 9; ++i)
    series.push_back(
        {"body.with_a_long_name_" + std::to_string(i) + ".position.x", "position", "m", {-1e-7, 3e-7 * i}});
  const Drawing plot = make_plot(std::vector<double>{0, 123456}, series);
  for (const Drawing::Stroke& stroke : plot.strokes) {
    for (const Vec2& point : stroke.points) {
      EXPECT_GE(point.minCoeff(), 0);
      EXPECT_LE(point.x(), plot.width);
      EXPECT_LE(point.y(), plot.height);
    }
  }
  for (const Drawing::Label& label : plot.labels) {
    const double width = text_width(label.text, label.size);
    const double left = label.x - (label.anchor == Anchor::start    ? 0
                                   : label.anchor == Anchor::middle ? 0.5
                                                                    : 1) *
                                      width;
    if (label.is_vertical) continue;
    EXPECT_GE(left, 0) << label.text;
    EXPECT_LE(left + width, plot.width) << label.text;
  }
  const Image image = rasterised(plot, 2);
  EXPECT_EQ(image.width, 1280);
  EXPECT_EQ(image, rasterised(plot, 2));
}

TEST(Plot, LinesOfSeveralRunsHaveTimesOfTheirOwnAndEachLeavesARimOfTheOneBefore) {
  const std::vector<PlotSeries> series = {{"whole", "energy", "J", {0, 4, 8}, {0, 2, 4}},
                                          {"stopped", "energy", "J", {0, 2}, {0, 1}}};
  const Drawing plot = make_plot({}, series);
  const auto line_of = [&](const char* color, std::size_t points) {
    for (const Drawing::Stroke& stroke : plot.strokes) {
      // The sample in the legend is level.
      if (stroke.color == color && stroke.points.size() == points &&
          stroke.points[0].y() != stroke.points[1].y())
        return stroke;
    }
    return Drawing::Stroke{};
  };
  const Drawing::Stroke whole = line_of("#0072b2", 3), stopped = line_of("#e69f00", 2);
  ASSERT_EQ(whole.points.size(), 3u);
  ASSERT_EQ(stopped.points.size(), 2u);
  // The second run is a quarter of the first, along the same straight line.
  EXPECT_NEAR((stopped.points[1] - whole.points[0] - 0.25 * (whole.points[2] - whole.points[0])).norm(), 0,
              1e-9);
  EXPECT_GT(whole.width, stopped.width + 0.5);
}

TEST(Plot, AQuantityThatIsNeverKnownIsAnEmptyPanel) {
  const std::vector<PlotSeries> series = {{"x", "energy", "J", {nan, nan}}};
  EXPECT_FALSE(well_formed_tags(svg_text(make_plot(std::vector<double>{0, 1}, series))).empty());
}

// Sparklines

TEST(Sparkline, LevelsGoFromTheLowestToTheHighestValue) {
  EXPECT_EQ(sparkline(std::vector<double>{0, 1, 2, 3, 4, 5, 6, 7}, 8, false), "▁▂▃▄▅▆▇█");
  EXPECT_EQ(sparkline(std::vector<double>{0, 1, 2, 3, 4, 5, 6, 7}, 8, true), "_.,-~=*#");
  EXPECT_EQ(sparkline(std::vector<double>{3, 3, 3}, 8, false), "▅▅▅");
  EXPECT_EQ(sparkline(std::vector<double>{0, nan, 1}, 8, true), "_ #");
}

TEST(Sparkline, ManyValuesAreMeansOfTheirShares) {
  // Two shares of the means 0.5 and 2.5.
  EXPECT_EQ(sparkline(std::vector<double>{0, 1, 2, 3}, 2, true), "_#");
  EXPECT_EQ(sparkline(std::vector<double>{}, 5, true), "");
  EXPECT_EQ(sparkline(std::vector<double>{1, 2}, 0, true), "");
  EXPECT_EQ(sparkline(std::vector<double>{1, 2}, -7, true), "");
}

}  // namespace
}  // namespace rigor::plot_test
