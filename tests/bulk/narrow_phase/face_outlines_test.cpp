#include "rigor/bulk/narrow_phase/face_outlines.hpp"
#include "geometry/random_pairs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>
#include <vector>

namespace rigor::face_outlines_test {
namespace {

using test::Draw;

using Point = Eigen::Vector2d;

/// Corners of a convex polygon about `middle`, counter-clockwise.
std::vector<Point> polygon(Draw& draw, int count, const Point& middle) {
  std::vector<double> angles;
  for (int k = 0; k < count; ++k)
    angles.push_back(2 * std::numbers::pi * (k + draw.uniform(0.1, 0.9)) / count);
  std::vector<Point> corners;
  for (const double angle : angles) corners.push_back(middle + Point(std::cos(angle), std::sin(angle)));
  return corners;
}

/// A plane in space, and how high the second outline is over it.
struct Placing {
  Vec3 origin, x, y, z;

  Vec3f operator()(const Point& p, double height) const {
    return (origin + p.x() * x + p.y() * y + height * z).cast<float>();
  }
};

/// Points in columns, with others between them.
struct Columns {
  std::vector<float> x, y, z;
  std::vector<int> corners;

  void add(const Vec3f& p) {
    for (int copy = 0; copy < 2; ++copy) {
      x.push_back(copy == 0 ? 100 : p.x());
      y.push_back(p.y());
      z.push_back(p.z());
    }
    corners.push_back(static_cast<int>(x.size()) - 1);
  }
  FaceOutline outline(std::size_t side_count) const {
    return {{x.data(), y.data(), z.data(), x.size()}, corners, side_count};
  }
};

double cross(const Point& a, const Point& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// How far p is inside of a convex polygon that runs counter-clockwise.
double depth_in(const std::vector<Point>& polygon, const Point& p) {
  double least = INFINITY;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Point side = (polygon[(k + 1) % polygon.size()] - polygon[k]).normalized();
    least = std::min(least, cross(side, p - polygon[k]));
  }
  return least;
}

/// Where two segments cross: how far from their nearest ends, negative if they do not.
double crossing_depth(const Point& a, const Point& b, const Point& c, const Point& d) {
  const Point u = b - a, v = d - c;
  const double s = cross(c - a, v) / cross(u, v), t = cross(c - a, u) / cross(u, v);
  return std::min({s, 1 - s, t, 1 - t});
}

TEST(FaceOutlines, MeetAsInThePlane) {
  Draw draw(1);
  constexpr double clear = 1e-4;  // What is closer to a border than that is not asked: floats are of order 1.
  int over = 0, under = 0, crossings = 0;
  for (int round = 0; round < 2000; ++round) {
    const std::vector<Point> face = polygon(draw, 3 + round % 9, Point::Zero());
    const std::size_t kind = static_cast<std::size_t>(round) / 9 % 12;  // A point, a segment, polygons.
    std::vector<Point> other =
        polygon(draw, 3 + static_cast<int>(kind), Point(draw.uniform(-1, 1), draw.uniform(-1, 1)));
    if (kind < 2) other.resize(kind + 1);
    const std::size_t side_count = kind < 2 ? kind : other.size();
    const Mat3 R = draw.rotation();
    const Placing placing{draw.direction(), R.col(0), R.col(1), R.col(2)};
    Columns face_columns, other_columns;
    for (const Point& p : face) face_columns.add(placing(p, 0));
    // A face that is turned to the other one runs clockwise.
    if (kind >= 2) std::reverse(other.begin(), other.end());
    for (const Point& p : other) other_columns.add(placing(p, draw.uniform(0, 0.1)));
    OutlineMeeting meeting;
    meet_outlines(face_columns.outline(face.size()), R.col(2).cast<float>(),
                  other_columns.outline(side_count), 1e-5f, meeting);

    const std::set<std::size_t> is_over(meeting.over.begin(), meeting.over.end()),
        is_under(meeting.under.begin(), meeting.under.end());
    for (std::size_t k = 0; k < other.size(); ++k) {
      const double depth = depth_in(face, other[k]);
      if (std::abs(depth) < clear) continue;
      EXPECT_EQ(is_over.contains(k), depth > 0) << round;
      over += depth > 0;
    }
    std::vector<Point> turned = other;
    std::reverse(turned.begin(), turned.end());
    for (std::size_t k = 0; k < face.size(); ++k) {
      const double depth = kind < 2 ? -1 : depth_in(turned, face[k]);
      if (std::abs(depth) < clear) continue;
      EXPECT_EQ(is_under.contains(k), depth > 0) << round;
      under += depth > 0;
    }
    std::set<std::pair<std::size_t, std::size_t>> crossed;
    for (const OutlineMeeting::Crossing& crossing : meeting.crossings)
      crossed.emplace(crossing.border, crossing.side);
    EXPECT_EQ(crossed.size(), meeting.crossings.size()) << round;
    for (std::size_t i = 0; i < face.size(); ++i) {
      for (std::size_t j = 0; j < side_count; ++j) {
        const double depth =
            crossing_depth(face[i], face[(i + 1) % face.size()], other[j], other[(j + 1) % other.size()]);
        if (std::abs(depth) < clear) continue;
        EXPECT_EQ(crossed.contains({i, j}), depth > 0) << round;
        crossings += depth > 0;
      }
    }
  }
  EXPECT_GT(over, 2000);
  EXPECT_GT(under, 2000);
  EXPECT_GT(crossings, 2000);
}

/// Two equal polygons on each other: all corners count, and no side crosses another.
TEST(FaceOutlines, CornersOnBordersCountAndSidesOnSidesDoNotCross) {
  Draw draw(2);
  for (int count = 3; count < 12; ++count) {
    const std::vector<Point> corners = polygon(draw, count, Point::Zero());
    const Mat3 R = draw.rotation();
    const Placing placing{draw.direction(), R.col(0), R.col(1), R.col(2)};
    Columns face, other;
    for (const Point& p : corners) face.add(placing(p, 0));
    for (std::size_t k = corners.size(); k-- > 0;) other.add(placing(corners[k], 0.01));
    OutlineMeeting meeting;
    meet_outlines(face.outline(corners.size()), R.col(2).cast<float>(), other.outline(corners.size()), 1e-5f,
                  meeting);
    EXPECT_EQ(meeting.over.size(), corners.size());
    EXPECT_EQ(meeting.under.size(), corners.size());
    EXPECT_TRUE(meeting.crossings.empty());
  }
}

}  // namespace
}  // namespace rigor::face_outlines_test
