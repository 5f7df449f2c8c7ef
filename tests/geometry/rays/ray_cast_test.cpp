#include "rigor/geometry/rays/ray_cast.hpp"

#include "geometry/mesh_shapes.hpp"
#include "geometry/random_pairs.hpp"
#include "rigor/geometry/decomposition/make_mesh.hpp"
#include "rigor/geometry/distance/point_distance.hpp"
#include "rigor/geometry/mesh/triangle_tree.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace rigor::ray_cast_test {
namespace {

using test::Draw;

Shape unit_ball_mesh(int levels) {
  return make_mesh(std::make_shared<const TriangleMesh>(make_icosphere(levels)));
}

/// A shape of any kind that a ray can meet: the convex ones, a mesh, a half-space.
Shape any_shape(Draw& draw, int kind) {
  if (kind == Draw::kKinds) return unit_ball_mesh(2);
  if (kind == Draw::kKinds + 1) return HalfSpace{draw.direction(), draw.uniform(-1, 1)};
  return draw.shape(kind);
}
constexpr int kAllKinds = Draw::kKinds + 2;

/// A ray that points near the shape from a few metres away, with a direction of any length.
Ray random_ray(Draw& draw, const Pose& X_WS) {
  const Vec3 origin = X_WS.p + draw.uniform(0, 4) * draw.direction();
  const Vec3 target = X_WS.p + draw.uniform(0, 0.8) * draw.direction();
  return {origin, draw.uniform(0.01, 30) * (target - origin)};
}

TEST(RayCast, HitsLieOnTheSurfaceAndTheirNormalsAreItsGradient) {
  Draw draw(11);
  int hits = 0;
  for (int kind = 0; kind < kAllKinds; ++kind) {
    for (int trial = 0; trial < 150; ++trial) {
      const Shape shape = any_shape(draw, kind);
      const Pose X_WS = draw.pose(5);
      const Ray ray = random_ray(draw, X_WS);
      for (const RayHit& hit : find_ray_hits(shape, X_WS, ray)) {
        ++hits;
        // Rounding of the coordinates.
        EXPECT_NEAR(point_distance(shape, X_WS, hit.p_W).distance, 0, 2e-15 * (1 + hit.p_W.norm()))
            << shape_type_name(shape);
        EXPECT_NEAR((ray.at(hit.fraction) - hit.p_W).norm(), 0, 1e-14 * (1 + hit.p_W.norm()));
        EXPECT_NEAR(hit.n_W.norm(), 1, 1e-15);
        EXPECT_EQ(hit.enters, hit.n_W.dot(ray.direction_W) < 0);
        // A point that is h along the normal is h away, up to the curvature: none of it nearer than that.
        const double h = 1e-5;
        const double outside = point_distance(shape, X_WS, hit.p_W + h * hit.n_W).distance;
        EXPECT_NEAR(outside, h, 1e-9 * h + 4e-14) << shape_type_name(shape);
      }
    }
  }
  EXPECT_GT(hits, 1500);
}

TEST(RayCast, ComesInAndGoesOutAlternatelyAndMissesOnlyWhatItDoesNotMeet) {
  Draw draw(12);
  int misses = 0;
  for (int kind = 0; kind < kAllKinds; ++kind) {
    for (int trial = 0; trial < 100; ++trial) {
      const Shape shape = any_shape(draw, kind);
      const Pose X_WS = draw.pose(5);
      const Ray ray = random_ray(draw, X_WS);
      const std::vector<RayHit> hits = find_ray_hits(shape, X_WS, ray);
      bool is_inside = point_distance(shape, X_WS, ray.origin_W).distance < 0;
      for (const RayHit& hit : hits) {
        EXPECT_EQ(hit.enters, !is_inside) << shape_type_name(shape);
        is_inside = !is_inside;
      }
      const std::optional<RayHit> first = find_ray_hit(shape, X_WS, ray);
      ASSERT_EQ(first.has_value(), !hits.empty());
      if (first) {
        EXPECT_EQ(first->fraction, hits[0].fraction);
      }
      // Between the places where it crosses, the sign of the distance does not change.
      double from = 0;
      for (std::size_t k = 0; k <= hits.size(); ++k) {
        const bool inside_here = hits.empty() ? is_inside : (k < hits.size() ? !hits[k].enters : is_inside);
        const double to = k < hits.size() ? hits[k].fraction : from + 5 / ray.direction_W.norm();
        for (const double part : {0.1, 0.5, 0.9}) {
          const double d = point_distance(shape, X_WS, ray.at(from + part * (to - from))).distance;
          EXPECT_LE(inside_here ? d : -d, 1e-14) << shape_type_name(shape);
        }
        from = to;
      }
      misses += hits.empty();
    }
  }
  EXPECT_GT(misses, 50);
}

TEST(RayCast, DoesNotDependOnTheFrame) {
  Draw draw(13);
  for (int kind = 0; kind < kAllKinds; ++kind) {
    for (int trial = 0; trial < 40; ++trial) {
      const Shape shape = any_shape(draw, kind);
      const Pose X_WS = draw.pose(2), X_VW = draw.pose(2);
      Ray ray = random_ray(draw, X_WS);
      ray.direction_W.normalize();
      const std::vector<RayHit> here = find_ray_hits(shape, X_WS, ray);
      const std::vector<RayHit> there =
          find_ray_hits(shape, X_VW * X_WS, {X_VW * ray.origin_W, X_VW.R * ray.direction_W});
      ASSERT_EQ(here.size(), there.size());
      for (std::size_t k = 0; k < here.size(); ++k) {
        // Rounding of a few metres, divided by the sine of the angle at which the ray meets the surface; for
        // a curved surface that is met at a grazing angle the square root of it.
        const double sine = std::abs(here[k].n_W.dot(ray.direction_W));
        EXPECT_NEAR(here[k].fraction, there[k].fraction, 4e-14 / std::max(sine, 1e-6));
        EXPECT_NEAR((X_VW * here[k].p_W - there[k].p_W).norm(), 0, 4e-14 / std::max(sine, 1e-6));
      }
    }
  }
}

TEST(RayCast, IsRightForPlacesKnownByHand) {
  const Pose here;
  const auto down = [&](const Shape& shape, double x) {
    return find_ray_hits(shape, here, {Vec3(x, 0, 10), Vec3(0, 0, -1)});
  };
  // Sphere: z = ±√(1 - x²).
  ASSERT_EQ(down(Sphere{1}, 0.6).size(), 2u);
  EXPECT_NEAR(down(Sphere{1}, 0.6)[0].fraction, 9.2, 1e-14);
  EXPECT_NEAR(down(Sphere{1}, 0.6)[1].fraction, 10.8, 1e-14);
  // Cone of radius 1, height 4 from its base at z = -2: at x = 0.25 the side is at z = 1.
  const std::vector<RayHit> cone = down(Cone{1, 2}, 0.25);
  ASSERT_EQ(cone.size(), 2u);
  EXPECT_NEAR(cone[0].fraction, 9, 1e-14);
  EXPECT_NEAR(cone[1].fraction, 12, 1e-14);
  EXPECT_TRUE(cone[1].n_W.isApprox(Vec3(0, 0, -1), 1e-15));
  // Capsule: the cap at x = 0.6 r; ellipsoid (1, 2, 3): z = 3 √(1 - x²).
  EXPECT_NEAR(down(Capsule{1, 2}, 0.6)[0].fraction, 10 - 2.8, 1e-14);
  EXPECT_NEAR(down(Ellipsoid{Vec3(1, 2, 3)}, 0.8)[0].fraction, 10 - 1.8, 1e-14);
  EXPECT_NEAR(down(Cylinder{1, 2}, 0.6)[0].fraction, 8, 1e-14);
  EXPECT_TRUE(down(Cylinder{1, 2}, 1.1).empty());
  EXPECT_NEAR(down(HalfSpace{Vec3(0, 0, 1), -1}, 5)[0].fraction, 11, 1e-14);
  // From inside there is only the way out; a segment ends where it ends.
  const std::vector<RayHit> out = find_ray_hits(Box{Vec3(1, 2, 3)}, here, {Vec3::Zero(), Vec3(0, 4, 0)});
  ASSERT_EQ(out.size(), 1u);
  EXPECT_FALSE(out[0].enters);
  EXPECT_EQ(out[0].fraction, 0.5);
  EXPECT_FALSE(find_ray_hit(Box{Vec3(1, 2, 3)}, here, {Vec3::Zero(), Vec3(0, 1, 0), 1.9}));
}

TEST(RayCast, ConesAreRightAlongTheirGeneratorsAndThroughTheirApex) {
  const Cone cone{1, 1};  // Apex at z = 1, slope ρ = (1 - z) / 2.
  const Pose here;
  const Vec3 generator = Vec3(1, 0, -2);
  // Along a generator inside the cone: in at one point of the side, out through the base.
  const std::vector<RayHit> along = find_ray_hits(cone, here, {Vec3(-1, 0, 2.5), generator});
  ASSERT_EQ(along.size(), 2u);
  EXPECT_NEAR(point_distance(cone, here, along[0].p_W).distance, 0, 1e-15);
  EXPECT_NEAR(along[1].p_W.z(), -1, 1e-15);
  // Parallel to a generator outside, towards the other nappe: nothing.
  EXPECT_TRUE(find_ray_hits(cone, here, {Vec3(2, 0, 2.5), generator}).empty());
  // Down the axis: apex and base. Through the upper nappe only: nothing.
  const std::vector<RayHit> axis = find_ray_hits(cone, here, {Vec3(0, 0, 3), Vec3(0, 0, -1)});
  ASSERT_EQ(axis.size(), 2u);
  EXPECT_NEAR(axis[0].fraction, 2, 1e-15);
  EXPECT_NEAR(axis[1].fraction, 4, 1e-15);
  EXPECT_TRUE(find_ray_hits(cone, here, {Vec3(-3, 0, 2), Vec3(1, 0, 0)}).empty());
}

TEST(RayCast, NoRaySlipsThroughTheEdgesAndVerticesOfAMesh) {
  // From the middle of a closed mesh through every vertex and many points of every edge: always out exactly
  // once, and all the way through once in and once out.
  Draw draw(14);
  for (const int levels : {0, 1, 2}) {
    const TriangleMesh ball = make_icosphere(levels);
    const Shape shape = make_mesh(std::make_shared<const TriangleMesh>(ball));
    const Pose X_WS = draw.pose(1);
    for (const std::array<int, 3>& t : ball.triangles) {
      const Vec3& a = ball.vertices[static_cast<std::size_t>(t[0])];
      const Vec3& b = ball.vertices[static_cast<std::size_t>(t[1])];
      for (const double part : {0.0, 0.25, 1.0 / 3, 0.5}) {
        const Vec3 target = X_WS * (a + part * (b - a));
        const Vec3 inside = X_WS * Vec3(0.1 * draw.direction());
        EXPECT_EQ(find_ray_hits(shape, X_WS, {inside, target - inside}).size(), 1u);
        const Vec3 outside = inside - 5 * (target - inside);
        EXPECT_EQ(find_ray_hits(shape, X_WS, {outside, target - inside}).size(), 2u);
      }
    }
  }
}

TEST(RayCast, KeepsItsDigitsFarAwayAndForThinAndSmallShapes) {
  // One millimetre of a ball seen from a kilometre, and a needle of aspect 1e4.
  const Pose X_WS{Mat3::Identity(), Vec3(1000, 0, 0)};
  const std::optional<RayHit> far = find_ray_hit(Sphere{1e-3}, X_WS, {Vec3::Zero(), Vec3(1, 0, 0)});
  ASSERT_TRUE(far);
  EXPECT_NEAR(far->fraction, 999.999, 1e-12);
  const Ellipsoid needle{Vec3(1e-4, 1e-4, 1)};
  const std::optional<RayHit> thin = find_ray_hit(needle, Pose{}, {Vec3(1, 0, 0.6), Vec3(-1, 0, 0)});
  ASSERT_TRUE(thin);
  // x = 1e-4 √(1 - 0.36).
  EXPECT_NEAR(thin->p_W.x(), 0.8e-4, 1e-16);
}

}  // namespace
}  // namespace rigor::ray_cast_test
