#include "rigor/geometry/convex/gjk.hpp"

#include "geometry/random_pairs.hpp"
#include "rigor/geometry/exact/double_double.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rigor::gjk_test {
namespace {

using test::Draw;

/// The optimality condition of the nearest point v of a convex set: p · v ≥ v · v for all its points p.
void expect_nearest(const std::array<Vec3, 4>& points, int count, const SimplexPoint& nearest,
                    double tolerance) {
  Vec3 sum = Vec3::Zero();
  double weights = 0;
  for (int i = 0; i < nearest.count; ++i) {
    const std::size_t k = static_cast<std::size_t>(i);
    EXPECT_GT(nearest.weight[k], 0);
    weights += nearest.weight[k];
    sum += nearest.weight[k] * points[static_cast<std::size_t>(nearest.index[k])];
  }
  EXPECT_NEAR(weights, 1, tolerance);
  EXPECT_LT((sum - nearest.v).norm(), tolerance);
  for (int i = 0; i < count; ++i) {
    EXPECT_GE(points[static_cast<std::size_t>(i)].dot(nearest.v), nearest.squared - tolerance);
  }
}

TEST(Simplex, NearestPointSatisfiesTheOptimalityCondition) {
  Draw draw(1);
  for (int i = 0; i < 2000; ++i) {
    const int count = 1 + i % 4;
    const Vec3 offset = draw.uniform(0, 2) * draw.direction();
    std::array<Vec3, 4> points;
    for (Vec3& p : points) p = draw.direction() + offset;
    expect_nearest(points, count, nearest_on_simplex(points, count), 1e-13);
  }
}

TEST(Simplex, WithoutAreaOrVolumeItsSidesAnswer) {
  Draw draw(2);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 p = 2 * draw.direction();
    const Vec3 e = draw.direction();
    const Vec3 f = draw.direction();
    // Three points on a line; four points in a plane; a point that comes twice.
    const std::array<Vec3, 4> line{p, p + e, p + draw.uniform(-2, 2) * e, p};
    expect_nearest(line, 3, nearest_on_simplex(line, 3), 1e-13);
    const std::array<Vec3, 4> plane{p, p + e, p + f, p + draw.uniform(-2, 2) * e + draw.uniform(-2, 2) * f};
    expect_nearest(plane, 4, nearest_on_simplex(plane, 4), 1e-13);
    const std::array<Vec3, 4> twice{p, p + e, p + f, p + f};
    expect_nearest(twice, 4, nearest_on_simplex(twice, 4), 1e-13);
  }
}

TEST(Simplex, ThinTrianglesAreAsExactAsOthers) {
  // Nearest point h n in the plane at height h: all corners at this height but for their own rounding, which
  // tilts the plane by its ratio to the thickness; the distance feels the square of that.
  Draw draw(4);
  for (int i = 0; i < 2000; ++i) {
    const double thickness = std::pow(10, draw.uniform(-12, -7));
    const Mat3 R = draw.rotation();
    const double height = draw.uniform(0.5, 1);
    const std::array<Vec3, 4> points{
        R * Vec3(-1, -0.3 * thickness, height), R * Vec3(1, -0.3 * thickness, height),
        R * Vec3(draw.uniform(-0.5, 0.5), 0.7 * thickness, height), Vec3::Zero()};
    const SimplexPoint nearest = nearest_on_simplex(points, 3);
    EXPECT_NEAR(nearest.v.norm(), height, 1e-15 + 1e-15 / thickness * 1e-15 / thickness);
    // It is the point of those three corners that the weights say, and along the normal of their plane.
    Vec3 sum = Vec3::Zero();
    for (int k = 0; k < nearest.count; ++k) {
      sum += nearest.weight[static_cast<std::size_t>(k)] *
             points[static_cast<std::size_t>(nearest.index[static_cast<std::size_t>(k)])];
    }
    EXPECT_LT((sum - nearest.v).norm(), 1e-14);
    const Vec3 n = nearest.direction.normalized();
    EXPECT_LT(std::abs(n.dot(points[1] - points[0])), 1e-15);
  }
}

TEST(DoubleDouble, KeepsThirtyDigits) {
  Draw draw(5);
  for (int i = 0; i < 1000; ++i) {
    const DoubleDouble a{draw.uniform(1, 2), 0};
    const DoubleDouble b{draw.uniform(1, 2), 0};
    // (a / b) b - a and (a + b)(a - b) - (a² - b²) vanish.
    EXPECT_LT(std::abs((a / b * b - a).high), 1e-30);
    EXPECT_LT(std::abs(((a + b) * (a - b) - (a * a - b * b)).high), 1e-30);
    EXPECT_EQ(((a + b) - a - b).high, 0);
  }
}

TEST(Simplex, ATetrahedronAroundTheOriginHoldsIt) {
  const std::array<Vec3, 4> points{Vec3(1, 1, 1), Vec3(-1, -1, 1), Vec3(-1, 1, -1), Vec3(1, -1, -1)};
  const SimplexPoint nearest = nearest_on_simplex(points, 4);
  EXPECT_EQ(nearest.count, 4);
  EXPECT_EQ(nearest.squared, 0);
  for (const double weight : nearest.weight) EXPECT_DOUBLE_EQ(weight, 0.25);
}

TEST(Gjk, BoundsEncloseAndMeetForSeparatedShapes) {
  Draw draw(3);
  for (int i = 0; i < 5 * 81; ++i) {
    const Shape a = draw.shape(i % Draw::kKinds);
    const Shape b = draw.shape(i / Draw::kKinds % Draw::kKinds);
    const ConvexCore core_a = make_core(a);
    const ConvexCore core_b = make_core(b);
    const CorePair pair(core_a, core_b, {draw.rotation(), draw.uniform(2.2, 4) * draw.direction()});
    GjkState state = start_gjk(pair);
    double lower = state.separation;
    double upper = state.upper;
    for (const double tolerance : {1e-2, 1e-4, 1e-6, 1e-8}) {
      advance_gjk(pair, tolerance, state);
      EXPECT_GE(state.separation, lower);
      EXPECT_LE(state.upper, upper);
      EXPECT_LE(state.separation, state.upper + pair.rounding);
      EXPECT_LE(state.upper - state.separation, tolerance);
      EXPECT_EQ(state.outcome, GjkState::Outcome::converged);
      lower = state.separation;
      upper = state.upper;
    }
    EXPECT_NEAR(state.n.norm(), 1, 1e-15);
  }
}

TEST(Gjk, PolytopesNeedFewSteps) {
  Draw draw(4);
  int steps = 0;
  const int pairs = 300;
  for (int i = 0; i < pairs; ++i) {
    const Shape a = draw.hull(32);
    const Shape b = draw.hull(32);
    const ConvexCore core_a = make_core(a);
    const ConvexCore core_b = make_core(b);
    const CorePair pair(core_a, core_b, {draw.rotation(), draw.uniform(1.5, 3) * draw.direction()});
    GjkState state = start_gjk(pair);
    advance_gjk(pair, pair.rounding, state);
    EXPECT_LT(state.iterations, 20);
    steps += state.iterations;
  }
  EXPECT_LT(steps, 6 * pairs);
}

TEST(Gjk, OverlapIsReportedAsTouching) {
  Draw draw(5);
  for (int i = 0; i < 500; ++i) {
    const Shape a = draw.shape(1 + i % (Draw::kKinds - 1));
    const Shape b = draw.shape(1 + i / 7 % (Draw::kKinds - 1));
    const ConvexCore core_a = make_core(a);
    const ConvexCore core_b = make_core(b);
    // All but segments and small hulls hold a ball of 0.03 about their origin.
    const auto is_thick = [](const ConvexCore& core) {
      return core.kind != ConvexCore::Kind::segment && (core.hull == nullptr || core.points.size() > 8);
    };
    if (!is_thick(core_a) || !is_thick(core_b)) continue;
    const CorePair pair(core_a, core_b, {draw.rotation(), 0.03 * draw.direction()});
    GjkState state = start_gjk(pair);
    advance_gjk(pair, pair.rounding, state);
    EXPECT_EQ(state.outcome, GjkState::Outcome::touching);
    EXPECT_LE(state.separation, 0);
  }
}

}  // namespace
}  // namespace rigor::gjk_test
