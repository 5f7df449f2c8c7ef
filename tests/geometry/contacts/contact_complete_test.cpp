#include "geometry/random_pairs.hpp"
#include "rigor/geometry/contacts/contact_set.hpp"
#include "rigor/geometry/distance/distance.hpp"
#include "rigor/geometry/distance/point_distance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

// Contact sets against what the region of contact is by itself, computed here in the plane.

namespace rigor::contact_complete_test {
namespace {

using test::Draw;

constexpr double kTolerance = 1e-6;

using Polygon = std::vector<Vec2>;

double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// Convex polygon around a point; on a grid of quarters its sides often run along those of another.
Polygon random_polygon(Draw& draw, bool on_grid) {
  const Vec2 center(draw.uniform(-0.5, 0.5), draw.uniform(-0.5, 0.5));
  if (on_grid) {
    const Vec2 low = (4 * center).array().round() / 4 - 0.5;
    const Vec2 high =
        low + Vec2(0.25 * std::round(draw.uniform(1, 5)), 0.25 * std::round(draw.uniform(1, 5)));
    return {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
  }
  const int count = static_cast<int>(draw.uniform(3, 9));
  const double start = draw.uniform(0, 1);
  Polygon polygon;
  for (int k = 0; k < count; ++k) {
    const double angle = 2 * std::numbers::pi * (k + start) / count;
    polygon.push_back(center + draw.uniform(0.9, 1.0) * Vec2(std::cos(angle), 0.6 * std::sin(angle)));
  }
  return polygon;
}

Shape prism(const Polygon& polygon, double z0, double z1) {
  std::vector<Vec3> points;
  for (const Vec2& p : polygon) {
    points.emplace_back(p.x(), p.y(), z0);
    points.emplace_back(p.x(), p.y(), z1);
  }
  return Convex{std::make_shared<const ConvexHull>(std::get<ConvexHull>(make_convex_hull(points)))};
}

/// What of the first lies in the second, by half-planes (Sutherland and Hodgman).
Polygon intersection(Polygon region, const Polygon& window) {
  for (std::size_t k = 0; k < window.size(); ++k) {
    const Vec2 &a = window[k], &b = window[(k + 1) % window.size()];
    const auto height = [&](const Vec2& p) { return cross(b - a, p - a) / (b - a).norm(); };
    Polygon kept;
    for (std::size_t i = 0; i < region.size(); ++i) {
      const Vec2 &p = region[i], &q = region[(i + 1) % region.size()];
      const double hp = height(p), hq = height(q);
      if (hp >= 0) kept.push_back(p);
      if ((hp > 0 && hq < 0) || (hp < 0 && hq > 0)) kept.push_back(p + hp / (hp - hq) * (q - p));
    }
    region = kept;
  }
  return region;
}

double area(const Polygon& polygon) {
  double twice = 0;
  for (std::size_t k = 0; k < polygon.size(); ++k)
    twice += cross(polygon[k], polygon[(k + 1) % polygon.size()]);
  return 0.5 * twice;
}

/// Whether a corner is one: its sides turn by more than rounding.
bool is_corner(const Polygon& polygon, std::size_t k) {
  const std::size_t n = polygon.size();
  const Vec2 before = polygon[k] - polygon[(k + n - 1) % n], after = polygon[(k + 1) % n] - polygon[k];
  return before.norm() > 1e-9 && cross(before, after) > 1e-9 * before.norm() * after.norm();
}

TEST(ContactSetIsComplete, OfTwoFacesItHasEveryCornerOfTheRegionAndNothingOutside) {
  Draw draw(51);
  int regions = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const bool on_grid = trial % 2 == 0;
    const Polygon of_a = random_polygon(draw, on_grid), of_b = random_polygon(draw, on_grid);
    const Polygon region = intersection(of_a, of_b);
    if (region.size() < 3 || area(region) < 1e-3) continue;
    ++regions;
    const double gap = kTolerance * std::round(draw.uniform(-1.4, 1.4)) * 0.5;
    const Shape a = prism(of_a, -0.5, 0), b = prism(of_b, 0, 0.5);
    const Pose X_WA = draw.pose(1), X_WB = X_WA * Pose{Mat3::Identity(), Vec3(0, 0, gap)};
    const std::vector<ContactPoint> set = contact_set(a, X_WA, b, X_WB, kTolerance);
    for (std::size_t k = 0; k < region.size(); ++k) {
      if (!is_corner(region, k)) continue;
      const Vec3 corner = X_WA * Vec3(region[k].x(), region[k].y(), 0);
      const bool is_found = std::any_of(set.begin(), set.end(), [&](const ContactPoint& point) {
        return (point.p_WA - corner).norm() < 1e-9;
      });
      EXPECT_TRUE(is_found) << trial << ": corner " << region[k].transpose() << " of " << region.size();
    }
    for (const ContactPoint& point : set) {
      EXPECT_NEAR(point.gap, gap, 1e-14) << trial;
      EXPECT_NEAR((point.n_W - X_WA.R.col(2)).norm(), 0, 1e-12) << trial;
      // On both bodies.
      EXPECT_NEAR(point_distance(a, X_WA, point.p_WA).distance, 0, 1e-12) << trial;
      EXPECT_NEAR(point_distance(b, X_WB, point.p_WB).distance, 0, 1e-12) << trial;
    }
  }
  EXPECT_GT(regions, 250);
}

TEST(ContactSetIsComplete, OfTwoBoxesThatOverlapALittleItIsTheFourCornersOfTheFace) {
  // Boxes 2 x 2 x 2 at x = 1.9999.
  const Shape box = Box{Vec3::Ones()};
  const std::vector<ContactPoint> set =
      contact_set(box, Pose{}, box, Pose{Mat3::Identity(), Vec3(1.9999, 0, 0)}, kTolerance);
  ASSERT_EQ(set.size(), 4u);
  for (const ContactPoint& point : set) {
    EXPECT_NEAR(point.gap, -1e-4, 1e-15);
    EXPECT_EQ(point.n_W, Vec3::UnitX());
    EXPECT_NEAR(std::abs(point.p_WA.y()), 1, 1e-15);
    EXPECT_NEAR(std::abs(point.p_WA.z()), 1, 1e-15);
  }
}

TEST(ContactSetIsComplete, OfAThinDiskThatWobblesWithBothRimsInReach) {
  // A disk of radius 1 and thickness 2e-7 that is tilted by so little that all of it is within the tolerance:
  // the points stay those of the lower rim, and over a turn of the tilt's direction no point comes twice. The
  // rim stands on four points; where they are higher than its lowest point, by up to the tilt times
  // 1 - cos 45°, that one joins them, on a plane as on the face of a box.
  const double half = 1e-7;
  const Shape disk = Cylinder{1, half}, plane = HalfSpace{Vec3::UnitZ(), 0}, floor = Box{Vec3(5, 5, 1)};
  const Pose X_WFloor{Mat3::Identity(), Vec3(0, 0, -1)};
  for (const double tilt : {0.0, 1e-9, 1e-7, 4e-7}) {
    for (int k = 0; k < 64; ++k) {
      const double direction = 2 * std::numbers::pi * k / 64;
      const Mat3 R = rotation_matrix(rotation_exp(tilt * Vec3(std::cos(direction), std::sin(direction), 0)));
      // The lowest point of the rim is tilt below the middle of the lower cap.
      const Pose X_WD{R, Vec3(0, 0, half + std::sin(tilt))};
      for (const bool on_plane : {true, false}) {
        const Shape& below = on_plane ? plane : floor;
        const Pose X_WA = on_plane ? Pose{} : X_WFloor;
        EXPECT_NEAR(signed_distance(below, X_WA, disk, X_WD).distance, 0, 2e-15);
        const std::vector<ContactPoint> set = contact_set(below, X_WA, disk, X_WD, kTolerance);
        ASSERT_GE(set.size(), 4u) << tilt << " " << k;
        EXPECT_LE(set.size(), 5u);
        double least = 1;
        for (const ContactPoint& point : set) {
          least = std::min(least, point.gap);
          EXPECT_GE(point.gap, -2e-15);
          EXPECT_NEAR((X_WD.inverse() * point.p_WB).z(), -half, 1e-14);
          // On the lower cap: the witness on a rim that is nearly level is sure across the rim only.
          EXPECT_LE((X_WD.inverse() * point.p_WB).norm(), 1 + 1e-12);
          EXPECT_NEAR(point.p_WA.z(), 0, 1e-14);
        }
        // Gaps that differ by less than a billionth of the size are equal to the set.
        EXPECT_LE(least, 2.1e-9) << tilt << " " << k;
        // Half-way between two of the four: 0.293 · 1e-7 is more than the billionth.
        if (tilt >= 1e-7 && k % 16 == 8) {
          EXPECT_EQ(set.size(), 5u) << tilt << " " << k;
        }
        for (std::size_t i = 1; i < set.size(); ++i) EXPECT_LT(set[i - 1].feature, set[i].feature);
      }
    }
  }
}

/// Whether (0, 0) lies in the convex hull of the points: no half-plane through it holds them all.
bool surround_origin(const std::vector<Vec2>& points) {
  return std::ranges::all_of(points, [&](const Vec2& p) {
    const Vec2 across(-p.y(), p.x());
    const auto is_left = [&](const Vec2& other) { return across.dot(other) > 0; };
    const auto is_behind = [&](const Vec2& other) { return p.dot(other) <= 0; };
    return std::ranges::any_of(points, is_behind) && std::ranges::any_of(points, is_left) &&
           !std::ranges::all_of(points, is_left);
  });
}

TEST(ContactSetIsComplete, OfWhatJutsOutOverARimItSurroundsTheCentreOfMass) {
  // A body stands on a round table and juts out over its rim, tilted by so little that the whole region of
  // contact is within the tolerance. Whichever of two faces and the rims between them separates best, the
  // points hold the body: its centre, which is well over the table, lies among them. (A rim stands on four
  // points and where it is crossed, so that the last of an arc between them is not held.)
  Draw draw(20261126);
  for (int k = 0; k < 3000; ++k) {
    const double r = draw.uniform(0.02, 0.3), table_radius = draw.uniform(4, 15) * r,
                 half = draw.uniform(0.3, 2) * r;
    const double tilt = k % 10 == 0 ? 0 : std::pow(10, draw.uniform(-11, -6.4)) / (2 * r);
    const double out = table_radius - draw.uniform(0.5, 0.9) * r,
                 azimuth = draw.uniform(0, 2 * std::numbers::pi);
    const double direction = draw.uniform(0, 2 * std::numbers::pi),
                 deep = std::pow(10, draw.uniform(-12, -7));
    const Shape table = Cylinder{table_radius, 0.1};
    const Shape body = k % 3 == 0   ? Shape(Cylinder{r, half})
                       : k % 3 == 1 ? Shape(Cone{r, half})
                                    : Shape(Box{Vec3(r, draw.uniform(0.3, 1) * r, half)});
    const Vec3 axis(std::cos(direction), std::sin(direction), 0);
    const Mat3 R = rotation_matrix(rotation_exp(tilt * axis)) *
                   rotation_matrix(rotation_exp(draw.uniform(0, 6) * Vec3::UnitZ()));
    const Vec3 centre(out * std::cos(azimuth), out * std::sin(azimuth), 0.1 + half - deep);
    const Pose X_WT{rotation_matrix(rotation_exp(draw.uniform(0, 6) * Vec3::UnitZ())), Vec3::Zero()},
        X_WB{R, centre};

    const double distance = signed_distance(table, X_WT, body, X_WB).distance;
    const std::vector<ContactPoint> set = contact_set(table, X_WT, body, X_WB, kTolerance);
    std::vector<Vec2> places;
    for (const ContactPoint& point : set) {
      places.emplace_back((point.p_WB - centre).head<2>());
      EXPECT_GE(point.gap, distance - 1e-9 * table_radius) << k;
      EXPECT_LE((point.n_W - Vec3::UnitZ()).norm(), tilt + 1e-9) << k;
    }
    EXPECT_TRUE(surround_origin(places)) << k << ": " << set.size() << " points, tilt " << tilt;
  }
}

}  // namespace
}  // namespace rigor::contact_complete_test
