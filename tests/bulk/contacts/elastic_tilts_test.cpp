// What stands on soft springs stands as on rigid contacts (docs/theory/bulk.md, section 3).

#include "rigor/bulk/bulk_world.hpp"
#include "rigor/bulk/contacts/tilt_kernels.hpp"
#include "rigor/geometry/lanes/lane_target.hpp"
#include "rigor/model/model_builder.hpp"

#include "random_vectors.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

namespace rigor::elastic_tilts_test {
namespace {

constexpr double g = 9.81, kStep = 1.0 / 60;

ModelBuilder on_a_floor() {
  ModelBuilder builder;
  builder.set_gravity(Vec3(0, 0, -g));
  builder.add_material({"m", 1000, 0.5, 0});
  BodyDescription floor;
  floor.name = "floor";
  floor.motion = MotionType::fixed;
  floor.shapes.push_back({HalfSpace{Vec3::UnitZ(), 0}, Vec3::Zero(), Quat::Identity(), "m", ""});
  builder.add_body(floor);
  return builder;
}

BodyDescription box(int number, const Vec3& half, const Vec3& p_W) {
  BodyDescription body;
  body.name = "box " + std::to_string(number);
  body.p_WU = p_W;
  body.shapes.push_back({Box{half}, Vec3::Zero(), Quat::Identity(), "m", ""});
  return body;
}

/// The farthest that a body has gone across y after some steps [m].
double drift_across(const std::shared_ptr<const Model>& model, int steps) {
  BulkWorld world(model, BulkSettings{});
  world.read(make_initial_state(*model));
  const std::vector<Vec3> start = world.bodies().x;
  for (int k = 0; k < steps; ++k) world.step(kStep);
  double farthest = 0;
  for (std::size_t i = 0; i < start.size(); ++i)
    farthest = std::max(farthest, std::abs(world.bodies().x[i].y() - start[i].y()));
  return farthest;
}

TEST(ElasticTilts, AColumnStandsThatIsHigherThanItsSpringsBear) {
  // Cubes of 1 m buckle from (ω²/g)^(1/3) = 24 of them on, by a factor of e in less than a second; those of
  // up to 64 bodies are solved directly.
  ModelBuilder builder = on_a_floor();
  for (int i = 0; i < 100; ++i) builder.add_body(box(i, Vec3(0.5, 0.5, 0.5), Vec3(0, 0, 0.5 + i)));
  EXPECT_LT(drift_across(builder.build(), 1800), 1e-3);
}

TEST(ElasticTilts, AWallOfOneBrickStands) {
  // Running bond, 40 courses of 0.25 m, 0.25 m thick: it fell within eight seconds.
  ModelBuilder builder = on_a_floor();
  int number = 0;
  for (int row = 0; row < 40; ++row) {
    const double z = 0.25 * row + 0.125;
    const Vec3 whole(0.2495, 0.125, 0.125), half(0.1245, 0.125, 0.125);
    const bool is_even = row % 2 == 0;
    for (int j = 0; j < (is_even ? 6 : 5); ++j)
      builder.add_body(box(number++, whole, Vec3(0.5 * j + (is_even ? 0.25 : 0.5), 0, z)));
    if (is_even) continue;
    builder.add_body(box(number++, half, Vec3(0.125, 0, z)));
    builder.add_body(box(number++, half, Vec3(2.875, 0, z)));
  }
  EXPECT_LT(drift_across(builder.build(), 720), 2e-3);
}

/// Whether a tower of eight cubes of 1 m that turns about an edge of its base at this speed [rad/s] falls.
bool topples(double speed) {
  ModelBuilder builder = on_a_floor();
  const Vec3 edge(0.5, 0, 0), w(0, speed, 0);
  for (int i = 0; i < 8; ++i) {
    BodyDescription body = box(i, Vec3(0.5, 0.5, 0.5), Vec3(0, 0, 0.5 + i));
    body.velocity = w.cross(body.p_WU - edge);
    body.angular_velocity = w;
    builder.add_body(body);
  }
  const std::shared_ptr<const Model> model = builder.build();
  BulkWorld world(model, BulkSettings{});
  world.read(make_initial_state(*model));
  for (int k = 0; k < 300; ++k) world.step(kStep);
  return world.bodies().x[8].z() < 7;
}

TEST(ElasticTilts, ATowerTopplesAtTheSpeedOfARigidOne) {
  // ½ I w² lifts the centre from h/2 to half of the diagonal; I = m (a² + h²)/3 about the edge.
  const double a = 1, h = 8;
  const double lift = (std::hypot(a, h) - h) / 2, inertia = (a * a + h * h) / 3;
  const double least = std::sqrt(2 * g * lift / inertia);
  EXPECT_FALSE(topples(0.98 * least));
  EXPECT_TRUE(topples(1.02 * least));
}

/// What the arms of two cubes on each other are turned back by, which are turned by these angles about x
/// [rad] and lifted from lying 1 mm deep in what is below.
std::vector<TiltRow> tilts_of(double first, double second, double lift) {
  ModelBuilder builder = on_a_floor();
  const double angles[] = {first, second};
  for (int i = 0; i < 2; ++i) {
    BodyDescription body = box(i, Vec3(0.5, 0.5, 0.5), Vec3(0, 0, 0.5 + i - 1e-3 * (i + 1) + lift));
    body.q_WU = Quat(Eigen::AngleAxisd(angles[i], Vec3::UnitX()));
    builder.add_body(body);
  }
  const std::shared_ptr<const Model> model = builder.build();
  BulkWorld world(model, BulkSettings{});
  world.read(make_initial_state(*model));
  world.step(kStep);
  return world.bodies().tilts;
}

TEST(ElasticTilts, AreThoseOfTheBodiesWhoseFacesArePressed) {
  // The weight straightens what leans: arms are turned back by twice the tilt. Gaps are 32-bit numbers of 1
  // mm.
  const std::vector<TiltRow> tilts = tilts_of(2e-4, 5e-4, 0);
  ASSERT_EQ(tilts.size(), 3u);
  const double rounding = 1e-7;
  EXPECT_NEAR(static_cast<double>(tilts[1][0]), 2 * 2e-4, rounding);
  EXPECT_NEAR(static_cast<double>(tilts[2][0]), 2 * 5e-4, rounding);
  EXPECT_NEAR(static_cast<double>(tilts[2][1]), 0, rounding);
  EXPECT_EQ(tilts[0], TiltRow{});
}

TEST(ElasticTilts, OfABodyOnItsEdgeIsNoMoreThanItsSpringsAccountFor) {
  // Turned by 10 degrees about x, its edge d deep in the floor: the plane through overlaps d, d, 0, 0 has the
  // slope d; no manifold has it at all once the other corners are too far away to be points of it.
  const double angle = 0.01, depth = 1e-3;
  const double lift = depth + 0.5 * (std::cos(angle) + std::sin(angle) - 1) - 1e-3;
  const std::vector<TiltRow> tilts = tilts_of(angle, angle, lift);
  for (const TiltRow& tilt : tilts) EXPECT_LT(std::abs(tilt[0]), 2 * 1.1 * depth);
}

TEST(TiltKernels, FindTheSlopeOfTheOverlapsWithTheSameBitsForBothTargets) {
  test::Random random(7);
  for (int trial = 0; trial < 100; ++trial) {
    // Faces of three and four points, of which the first has no overlap and the second no breadth.
    std::array<Manifold, kLaneCount> manifolds;
    std::array<std::array<float, 4>, kLaneCount> w_A{}, w_B{};
    std::array<Vec3, kLaneCount> expected;
    TiltLanes lanes;
    const double ahead = 0.05;
    for (std::size_t i = 0; i < kLaneCount; ++i) {
      Manifold& own = manifolds[i];
      const Vec3 n = random.vector().normalized(), t1 = n.unitOrthogonal(), t2 = n.cross(t1);
      const Vec3 tilt = 1e-3 * (random.number() * t1 + random.number() * t2), w = random.vector();
      own.point_count = 3 + static_cast<int>(i % 2);
      const std::array<double, 4> along{1, -1, 0.3, 0.2}, across{0.2, -0.1, 1, -1};
      std::vector<Vec3> points;
      Vec3 centre = Vec3::Zero();
      for (std::size_t k = 0; k < static_cast<std::size_t>(own.point_count); ++k) {
        points.push_back(0.5 * along[k] * t1 + (i == 1 ? 0 : 0.3 * across[k]) * t2);
        centre += points.back() / own.point_count;
      }
      for (std::size_t k = 0; k < points.size(); ++k) {
        const Vec3 arm = points[k] - centre;
        for (int c = 0; c < 3; ++c) own.points[k].p[c] = static_cast<float>(points[k][c]);
        own.points[k].gap = static_cast<float>((i == 0 ? 0.01 : -0.01) + tilt.dot(arm.cross(n)));
      }
      for (int c = 0; c < 3; ++c) {
        own.normal[c] = static_cast<float>(n[c]);
        w_B[i][static_cast<std::size_t>(c)] = static_cast<float>(w[c]);
      }
      lanes.manifold[i] = ManifoldView(own);
      lanes.w_A[i] = w_A[i].data(), lanes.w_B[i] = w_B[i].data();
      lanes.sign[i] = i % 3 == 0 ? -1.0F : 1.0F;
      expected[i] = static_cast<double>(lanes.sign[i]) * (tilt + ahead * (w - w.dot(n) * n));
    }
    std::array<TiltRow, kLaneCount> turns;
    portable_lanes::find_turns(lanes, static_cast<float>(ahead), turns);
    EXPECT_EQ(turns[0][3], 0);
    EXPECT_EQ(turns[1][3], 0);
    for (std::size_t i = 2; i < kLaneCount; ++i) {
      EXPECT_NEAR(static_cast<double>(turns[i][3]), 0.01 * manifolds[i].point_count, 1e-6);
      for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(static_cast<double>(turns[i][c]), expected[i][static_cast<Eigen::Index>(c)], 1e-6);
    }
    if (best_lane_target() != LaneTarget::avx2) continue;
    std::array<TiltRow, kLaneCount> others;
    avx2_lanes::find_turns(lanes, static_cast<float>(ahead), others);
    EXPECT_EQ(std::memcmp(&turns, &others, sizeof turns), 0);
  }
}

}  // namespace
}  // namespace rigor::elastic_tilts_test
