// Ellipsoids and what they touch, on the many-body path, in 32 bits.

#include "bulk/narrow_phase/placed_pairs.hpp"
#include "rigor/bulk/narrow_phase/collide_ellipsoids.hpp"
#include "rigor/bulk/narrow_phase/narrow_phase.hpp"
#include "rigor/geometry/distance/distance.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/model/model_builder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace rigor::narrow_phase_ellipsoids_test {
namespace {

using test::Draw;
using test::PlacedPair;

constexpr double kRounding = 4e-6;  // As in narrow_phase_test.cpp, at lengths of about 1 m.

Shape draw_ellipsoid(Draw& draw) {
  return Ellipsoid{Vec3(draw.uniform(0.1, 0.5), draw.uniform(0.1, 0.5), draw.uniform(0.1, 0.5))};
}
Shape draw_other(Draw& draw, int kind) {
  return kind == 0 ? draw_ellipsoid(draw) : test::draw_plain_shape(draw, kind - 1);
}

/// Two placed shapes whose distance is the gap.
PlacedPair draw_pair(Draw& draw, const Shape& a, const Shape& b, double gap) {
  PlacedPair pair{a, b, {draw.rotation(), Vec3::Zero()}, {draw.rotation(), draw.direction()}};
  for (int k = 0; k < 20; ++k) {
    const DistanceResult distance = signed_distance(pair.a, pair.X_WA, pair.b, pair.X_WB);
    if (std::abs(distance.distance - gap) < 1e-4 * std::abs(gap)) break;
    pair.X_WB.p += (gap - distance.distance) * distance.n_W;
  }
  return pair;
}

/// The pair as a world of two bodies, seen by the narrow phase at one pose after the other.
class Seen {
 public:
  explicit Seen(const PlacedPair& pair) : model_(test::model_of(pair)), narrow_phase_(*model_) {}

  std::vector<PairManifold> at(const PlacedPair& pair, float margin) {
    ManifoldList found;
    narrow_phase_.find_manifolds(test::bodies_of(pair), {{0, 1, 0, 0, margin}}, Executor(1), found);
    return found.copies();
  }

 private:
  std::shared_ptr<const Model> model_;
  NarrowPhase narrow_phase_;
};

/// The distance of a point from the surface of a shape; of what has curved sides a ball stands for the point.
double outside(const Shape& shape, const Pose& X_W, const Vec3& q) {
  return signed_distance(shape, X_W, Sphere{1e-9}, {Mat3::Identity(), q}).distance;
}

void expect_touch(const PlacedPair& pair, const std::vector<PairManifold>& found) {
  const DistanceResult truth = signed_distance(pair.a, pair.X_WA, pair.b, pair.X_WB);
  ASSERT_EQ(found.size(), 1u) << "distance " << truth.distance;
  ASSERT_EQ(found[0].manifold.point_count, 1);
  const Manifold& manifold = found[0].manifold;
  const ManifoldPoint& point = manifold.points[0];
  EXPECT_NEAR(static_cast<double>(point.gap), truth.distance, kRounding);
  // Both ends of the gap are on their shapes.
  const Vec3 n(manifold.normal[0], manifold.normal[1], manifold.normal[2]);
  const Vec3 p = pair.X_WA.p + Vec3(point.p[0], point.p[1], point.p[2]);
  const Vec3 half = 0.5 * static_cast<double>(point.gap) * n;
  EXPECT_NEAR(outside(pair.a, pair.X_WA, p - half), 0, kRounding);
  EXPECT_NEAR(outside(pair.b, pair.X_WB, p + half), 0, kRounding);
}

TEST(NarrowPhaseEllipsoids, TouchAtOnePointAtTheSignedDistance) {
  constexpr double gaps[] = {-0.05, -0.01, -1e-3, -1e-5, 0.02};
  Draw draw(1);
  for (int kind = 0; kind < 6; ++kind) {
    for (int k = 0; k < 100; ++k) {
      SCOPED_TRACE(testing::Message() << "kind " << kind << " no " << k);
      const Shape own = draw_ellipsoid(draw), other = draw_other(draw, kind);
      const bool own_is_A = kind < 5 && k % 2 == 0;
      const PlacedPair pair =
          draw_pair(draw, own_is_A ? own : other, own_is_A ? other : own, gaps[k % 5] * draw.uniform(0.3, 1));
      expect_touch(pair, Seen(pair).at(pair, 0.05f));
    }
  }
}

/// Overlaps deeper than the balls that roll inside prove nothing: the answer is that of geometry.
TEST(NarrowPhaseEllipsoids, DeepOverlapsAreTheDistance) {
  Draw draw(2);
  for (int k = 0; k < 200; ++k) {
    SCOPED_TRACE(k);
    const Shape own = draw_ellipsoid(draw), other = draw_other(draw, k % 5);
    const PlacedPair pair = draw_pair(draw, own, other, -draw.uniform(0.05, 0.15));
    const double truth = signed_distance(pair.a, pair.X_WA, pair.b, pair.X_WB).distance;
    double least = INFINITY;
    for (const PairManifold& found : Seen(pair).at(pair, 0))
      least = std::min(least, static_cast<double>(found.manifold.points[0].gap));
    EXPECT_NEAR(least, truth, kRounding);
  }
}

TEST(NarrowPhaseEllipsoids, NearlyAllTouchesAreProvenIn32Bits) {
  Draw draw(3);
  int proven = 0;
  constexpr int count = 400;
  for (int k = 0; k < count; ++k) {
    FloatHulls hulls;
    const BodyShape own{.shape = draw_ellipsoid(draw)}, other{.shape = draw_other(draw, k % 5)};
    const PlacedPair pair = draw_pair(draw, own.shape, other.shape, -draw.uniform(0, 0.01));
    const auto place = [&](const BodyShape& shape, const Pose& X_W) {
      return place_shape(make_bulk_shape(shape, hulls), Quat(X_W.R));
    };
    const BulkShape a = make_bulk_shape(own, hulls), b = make_bulk_shape(other, hulls);
    const PlacedShape placed_A = place(own, pair.X_WA), placed_B = place(other, pair.X_WB);
    const Vec3f d = (pair.X_WB.p - pair.X_WA.p).cast<float>();
    const EllipsoidCore core = place_ellipsoid(a, placed_A, Vec3f::Zero());
    PlacedPolytope polytope;
    if (k % 5 > 0) place_polytope(b, place_of(b, placed_B, d), polytope);
    const auto touch = k % 5 == 0 ? touch_ellipsoids(core, place_ellipsoid(b, placed_B, d), 0)
                                  : touch_polytope(core, polytope, b.radius);
    if (touch) ++proven;
  }
  EXPECT_GE(proven, count * 99 / 100);
}

/// What was seen before changes no bit.
TEST(NarrowPhaseEllipsoids, AnswersDependOnThePosesAlone) {
  Draw draw(4);
  for (int k = 0; k < 60; ++k) {
    SCOPED_TRACE(k);
    PlacedPair pair = draw_pair(draw, draw_ellipsoid(draw), draw_other(draw, k % 5), 0.02);
    Seen seen(pair);
    for (int step = 0; step < 20; ++step) {
      pair.X_WB.p -= 0.002 * pair.X_WB.p.normalized();
      pair.X_WB.R = pair.X_WB.R * rotation_matrix(rotation_exp(0.05 * draw.direction()));
      const std::vector<PairManifold> found = seen.at(pair, 0.01f), anew = Seen(pair).at(pair, 0.01f);
      ASSERT_EQ(found.size(), anew.size());
      for (std::size_t i = 0; i < found.size(); ++i)
        EXPECT_EQ(std::memcmp(&found[i].manifold, &anew[i].manifold, sizeof(Manifold)), 0);
    }
  }
}

}  // namespace
}  // namespace rigor::narrow_phase_ellipsoids_test
