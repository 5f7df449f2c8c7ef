// What stands on soft springs stands as on rigid contacts (docs/theory/bulk.md, section 3).

#include "rigor/bulk/bulk_world.hpp"
#include "rigor/model/model_builder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

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

}  // namespace
}  // namespace rigor::elastic_tilts_test
