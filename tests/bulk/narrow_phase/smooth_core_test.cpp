// Solids of revolution and ellipsoids as a mesh asks for them: against points, and about edges.

#include "rigor/bulk/narrow_phase/smooth_core.hpp"
#include "geometry/random_pairs.hpp"
#include "rigor/geometry/distance/distance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace rigor::smooth_core_test {
namespace {

using test::Draw;

constexpr double kRounding = 4e-6;  ///< At lengths of about 1 m.

/// A cylinder, a cone, a frustum or an ellipsoid at some place.
struct PlacedCore {
  Shape shape;
  Pose X;
  SmoothCore core;

  PlacedCore(Draw& draw, int kind) : shape(draw_shape(draw, kind)), X(draw.pose(0.5)) {
    FloatHulls hulls;
    const BodyShape own{.shape = shape};
    const BulkShape bulk = make_bulk_shape(own, hulls);
    core.place(bulk, place_shape(bulk, Quat(X.R)), X.p.cast<float>());
  }
  static Shape draw_shape(Draw& draw, int kind) {
    const double a = draw.uniform(0.1, 0.5), b = draw.uniform(0.05, 0.6), c = draw.uniform(0.1, 0.5);
    switch (kind) {
      case 0:
        return Cylinder{a, b};
      case 1:
        return Cone{a, b};
      case 2:
        return std::get<Revolution>(make_revolution({Vec2(a, -b), Vec2(c, b)}));
      default:
        return Ellipsoid{Vec3(a, b, c)};
    }
  }
};
constexpr int kKinds = 4;

/// A point is as far from a core as geometry says; an ellipsoid it may enter as deep as the balls that roll
/// inside.
TEST(SmoothCore, APointIsAtTheSignedDistance) {
  Draw draw(11);
  for (int k = 0; k < 4000; ++k) {
    SCOPED_TRACE(k);
    const PlacedCore placed(draw, k % kKinds);
    Vec3 q = placed.X.p + draw.uniform(0, 0.9) * draw.direction();
    DistanceResult truth = signed_distance(placed.shape, placed.X, Sphere{1e-9}, {Mat3::Identity(), q});
    if (const Ellipsoid* const own = std::get_if<Ellipsoid>(&placed.shape)) {
      const double least = own->radii.minCoeff(), rolls = least * least / own->radii.maxCoeff();
      if (truth.distance < -0.9 * rolls) continue;
    }
    const auto touch = placed.core.touch_point(q.cast<float>(), -truth.n_W.cast<float>());
    ASSERT_TRUE(touch);
    EXPECT_NEAR(static_cast<double>(touch->separation), truth.distance, kRounding);
    const Vec3 p = touch->p.cast<double>(), n = touch->n.cast<double>();
    EXPECT_LE((q + static_cast<double>(touch->separation) * n - p).norm(), 2e-5);
  }
}

/// What a direction parts a core from a line by: its lowest point along it over a point of the line.
double separation_along(const PlacedCore& placed, const NormalArc& arc, const Vec3f& n) {
  return static_cast<double>(n.dot(placed.core.farthest(-n) - arc.from));
}

/// Of all directions in an arc, none parts the core better than the one that is found; if none is, one of the
/// ends does as well as those beside it. Arcs of all angles, of gentle hills too; axes along edges, across
/// them and at random; shallow and deep.
TEST(SmoothCore, TheBestDirectionAboutAnEdgeIsThatOfAllTried) {
  Draw draw(12);
  constexpr int tried = 4000;
  int inside = 0, missed = 0;
  constexpr int count = 3000;
  for (int k = 0; k < count; ++k) {
    SCOPED_TRACE(k);
    const PlacedCore placed(draw, k % kKinds);
    const double angle = k % 3 == 0 ? draw.uniform(1e-3, 0.1) : draw.uniform(0.1, M_PI);
    // The edge passes the core's surface at the middle of the arc, more or less.
    Vec3 along = draw.direction();
    const Vec3 axis = placed.X.R.col(2);
    const double slight = std::pow(10, draw.uniform(-6, -1));
    if (k % 5 == 1) along = (axis + slight * draw.direction()).normalized();
    if (k % 5 == 2)
      along = (axis.cross(draw.direction()).normalized() + slight * draw.direction()).normalized();
    const Vec3 middle = along.cross(draw.direction()).normalized(), beside = along.cross(middle);
    const auto turned = [&](double by) -> Vec3 { return std::cos(by) * middle + std::sin(by) * beside; };
    const Vec3f lowest = placed.core.farthest(-middle.cast<float>());
    const Vec3 from =
        lowest.cast<double>() + draw.uniform(-0.02, 0.05) * middle + 0.1 * draw.uniform(-1, 1) * along;
    const NormalArc arc{from.cast<float>(), turned(-0.5 * angle).cast<float>(),
                        turned(0.5 * angle).cast<float>(), turned(-0.5 * angle + M_PI / 2).cast<float>()};
    double best = -INFINITY;
    int best_place = 0;
    for (int i = 0; i <= tried; ++i) {
      const double s =
          separation_along(placed, arc, turned(angle * (static_cast<double>(i) / tried - 0.5)).cast<float>());
      if (s > best) best = s, best_place = i;
    }
    const auto touch = part_best_about_edge(placed.core, arc, kCollisionRounding);
    if (touch) {
      ++inside;
      EXPECT_NEAR(separation_along(placed, arc, touch->n), static_cast<double>(touch->separation), kRounding);
      EXPECT_LE(std::abs(touch->n.cast<double>().dot(along)), 1e-6);
      // Where cores are deep there may be several places at which the separation is largest.
      if (static_cast<double>(touch->separation) < best - kRounding) ++missed;
      EXPECT_GE(static_cast<double>(touch->separation), best - (best > 0 ? kRounding : 0.02));
    } else {
      const double s0 = separation_along(placed, arc, arc.first),
                   s1 = separation_along(placed, arc, arc.last);
      EXPECT_GE(std::max(s0, s1), best - kRounding) << best_place;
    }
  }
  EXPECT_GT(inside, count / 2);
  EXPECT_LE(missed, count / 200);
}

}  // namespace
}  // namespace rigor::smooth_core_test
