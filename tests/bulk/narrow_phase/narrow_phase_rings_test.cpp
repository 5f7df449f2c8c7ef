// Cylinders, cones and what they touch, on the many-body path: true circles, in 32 bits.

#include "bulk/face_preference.hpp"
#include "bulk/narrow_phase/placed_pairs.hpp"
#include "rigor/bulk/bulk_world.hpp"
#include "rigor/bulk/narrow_phase/narrow_phase.hpp"
#include "rigor/bulk/narrow_phase/ring_axes.hpp"
#include "rigor/bulk/state/bulk_shape.hpp"
#include "rigor/geometry/distance/distance.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/model/model_builder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

namespace rigor::narrow_phase_rings_test {
namespace {

using test::Draw;
using test::PlacedPair;

constexpr double kRounding = 4e-6;  // As in narrow_phase_test.cpp, at lengths of about 1 m.

Shape draw_ring_shape(Draw& draw, bool is_cone) {
  const double radius = draw.uniform(0.1, 0.5), half = draw.uniform(0.05, 0.6);
  return is_cone ? Shape(Cone{radius, half}) : Shape(Cylinder{radius, half});
}
Shape draw_other(Draw& draw, int kind) {
  return kind < 2 ? draw_ring_shape(draw, kind == 1) : test::draw_plain_shape(draw, kind - 2);
}

/// Two placed shapes. Every second pair of poses is nearly parallel, square or coaxial, turned by 1e-7 to
/// 0.1.
PlacedPair draw_pair(Draw& draw, const Shape& a, const Shape& b, int number, double gap) {
  PlacedPair pair{a, b, {draw.rotation(), Vec3::Zero()}, {draw.rotation(), draw.direction()}};
  if (number % 2 == 1) {
    const double quarter = number % 4 == 1 ? 0 : M_PI / 2, slight = std::pow(10, draw.uniform(-7, -1));
    pair.X_WB.R = rotation_matrix(rotation_exp(slight * draw.direction())) * pair.X_WA.R *
                  rotation_matrix(rotation_exp(quarter * Vec3::UnitX()));
    pair.X_WB.p = pair.X_WA.R * Vec3(draw.uniform(-0.3, 0.3), draw.uniform(-0.3, 0.3), draw.uniform(0.2, 1));
    if (number % 16 == 1) pair.X_WB.p = pair.X_WA.R.col(2) * draw.uniform(0.2, 1);
  }
  // Along the normal until the distance is the gap.
  for (int k = 0; k < 15; ++k) {
    const DistanceResult distance = signed_distance(pair.a, pair.X_WA, pair.b, pair.X_WB);
    if (std::abs(distance.distance - gap) < 1e-3 * std::abs(gap)) break;
    pair.X_WB.p += (gap - distance.distance) * distance.n_W;
  }
  return pair;
}

/// Depths from a hair to a third of a body, and apart.
double draw_gap(Draw& draw, int number) {
  constexpr double gaps[] = {-0.1, -0.01, -1e-3, -1e-5, 0.02};
  return gaps[number % 5] * draw.uniform(0.3, 1);
}

std::vector<PairManifold> manifolds_of(const PlacedPair& pair, float margin) {
  const std::shared_ptr<const Model> model = test::model_of(pair);
  NarrowPhase narrow_phase(*model);
  ManifoldList found;
  narrow_phase.find_manifolds(test::bodies_of(pair), {{0, 1, 0, 0, margin}}, Executor(1), found);
  return found.copies();
}

/// The least gap; and how far the two ends of a point's gap are outside their shapes at most. Points of a
/// second manifold that were no deeper than the pair only by being put there have no ends of their own.
struct Measured {
  double least = INFINITY, outside = -INFINITY;
};
Measured measure(const PlacedPair& pair, const std::vector<PairManifold>& manifolds) {
  Measured measured;
  for (const PairManifold& found : manifolds)
    for (int k = 0; found.part == 0 && k < found.manifold.point_count; ++k)
      measured.least = std::min(measured.least, static_cast<double>(found.manifold.points[at(k)].gap));
  for (const PairManifold& found : manifolds) {
    const Manifold& manifold = found.manifold;
    const Vec3 n(manifold.normal[0], manifold.normal[1], manifold.normal[2]);
    for (int k = 0; k < manifold.point_count; ++k) {
      const ManifoldPoint& point = manifold.points[at(k)];
      if (found.part > 0 && static_cast<double>(point.gap) == measured.least) continue;
      const Vec3 p = pair.X_WA.p + Vec3(point.p[0], point.p[1], point.p[2]);
      const Vec3 half = 0.5 * static_cast<double>(point.gap) * n;
      const auto outside = [&](const Shape& shape, const Pose& X_W, const Vec3& q) {
        return signed_distance(shape, X_W, Sphere{1e-9}, {Mat3::Identity(), q}).distance;
      };
      measured.outside = std::max(
          {measured.outside, outside(pair.a, pair.X_WA, p - half), outside(pair.b, pair.X_WB, p + half)});
    }
  }
  return measured;
}

TEST(NarrowPhaseRings, GapsAreTheSignedDistanceAndPointsAreOnBothShapes) {
  constexpr double largest = 0.5;  // No ball inside a shape is larger.
  Draw draw(1);
  int count = 0, off = 0;
  for (int kind_A = 0; kind_A < 2; ++kind_A) {
    for (int kind_B = 0; kind_B < 7; ++kind_B) {
      for (int k = 0; k < 60; ++k) {
        const Shape ring = draw_ring_shape(draw, kind_A == 1), other = draw_other(draw, kind_B);
        const bool ring_is_A = kind_B < 6 && k % 3 != 0;
        const PlacedPair pair =
            draw_pair(draw, ring_is_A ? ring : other, ring_is_A ? other : ring, k, draw_gap(draw, k));
        const double distance = signed_distance(pair.a, pair.X_WA, pair.b, pair.X_WB).distance;
        const std::vector<PairManifold> found = manifolds_of(pair, 0.05f);
        const std::string where =
            std::to_string(kind_A) + "-" + std::to_string(kind_B) + " no " + std::to_string(k);
        ASSERT_FALSE(found.empty()) << where << " distance " << distance;
        // A cap is preferred where it parts two shapes nearly as well; on a plane points are equally deep
        // that differ by a two-hundredth.
        const double preference = (static_cast<double>(kFacePreferenceOfOverlap) * std::max(-distance, 0.0) +
                                   static_cast<double>(kFacePreferenceOfSize) * largest) /
                                  (1 - static_cast<double>(kFacePreferenceOfOverlap));
        const Measured measured = measure(pair, found);
        EXPECT_NEAR(measured.least, distance, preference + kRounding) << where;
        // Circles that are tilted by up to 0.045 rad count as circles: 1e-3 of the radius.
        EXPECT_LE(measured.outside, 1e-3 * largest + kRounding) << where;
        ++count;
        if (std::abs(measured.least - distance) > kRounding) ++off;
      }
    }
  }
  EXPECT_LT(off, count / 20);
}

/// Bodies that are fast have a wide margin, within which a cap may come to lie on the other solid: its points
/// are no deeper than the pair is.
TEST(NarrowPhaseRings, ASecondManifoldIsNoDeeperThanThePair) {
  Draw draw(5);
  int seconds = 0;
  for (int k = 0; k < 600; ++k) {
    SCOPED_TRACE(k);
    const PlacedPair pair = draw_pair(draw, draw_ring_shape(draw, k % 2 == 0), draw_other(draw, k % 3), 2 * k,
                                      -draw.uniform(0.01, 0.1));
    float least[2] = {INFINITY, INFINITY};
    for (const PairManifold& found : manifolds_of(pair, 0.2f)) {
      for (int i = 0; i < found.manifold.point_count; ++i)
        least[found.part] = std::min(least[found.part], found.manifold.points[at(i)].gap);
    }
    if (least[1] < INFINITY) ++seconds;
    EXPECT_GE(least[1], least[0]);
  }
  EXPECT_GT(seconds, 50);
}

TEST(NarrowPhaseRings, NoDirectionPartsTwoSolidsOfRevolutionBetterThanTheirDistance) {
  const auto numbers_of = [](const Shape& shape, const Pose& X_W) {
    FloatHulls hulls;
    const BodyShape body{.shape = shape};
    const FloatRings rings = make_bulk_shape(body, hulls).rings;
    RingNumbers numbers{{}, {rings.z[0], rings.z[1]}, {rings.r[0], rings.r[1]}, rings.k, rings.square};
    for (int k = 0; k < 3; ++k) numbers.axis[k] = static_cast<float>(X_W.R(k, 2));
    return numbers;
  };
  Draw draw(2);
  int count = 0, missed = 0;
  for (int k = 0; k < 2000; ++k) {
    const PlacedPair pair = draw_pair(draw, draw_ring_shape(draw, k % 3 == 0),
                                      draw_ring_shape(draw, k % 7 < 2), k, draw_gap(draw, k));
    RingPairNumbers numbers{numbers_of(pair.a, pair.X_WA), numbers_of(pair.b, pair.X_WB), {}};
    for (int c = 0; c < 3; ++c) numbers.d[c] = static_cast<float>(pair.X_WB.p[c] - pair.X_WA.p[c]);
    RingAxes axes, portable;
    find_flat_ring_axes(numbers, best_lane_target(), axes);
    find_flat_ring_axes(numbers, LaneTarget::portable, portable);
    for (const auto find : {find_side_ring_axes, find_two_ring_axes}) {
      find(numbers, best_lane_target(), axes);
      find(numbers, LaneTarget::portable, portable);
    }
    ASSERT_EQ(std::memcmp(&axes, &portable, sizeof axes), 0) << k;
    float best = -INFINITY;
    for (const auto& group : axes.separation) best = std::max(best, *std::max_element(group, group + 8));
    const double distance = signed_distance(pair.a, pair.X_WA, pair.b, pair.X_WB).distance;
    EXPECT_LE(static_cast<double>(best), distance + kRounding) << k;
    EXPECT_GE(static_cast<double>(best), distance - 0.02) << k;
    ++count;
    if (static_cast<double>(best) < distance - kRounding) ++missed;
  }
  EXPECT_LT(missed, count / 33);
}

/// Where sides and rims touch, and no cap is preferred, the gap is the distance however deep they are: a
/// direction that is not the best of all does not prove itself.
TEST(NarrowPhaseRings, SidesAndRimsThatTouchHaveTheirDistanceForAGap) {
  Draw draw(4);
  int count = 0, missed = 0;
  for (int k = 0; k < 1500; ++k) {
    const double depth = draw.uniform(0.02, 0.2);
    const PlacedPair pair = draw_pair(draw, Cylinder{draw.uniform(0.1, 0.3), draw.uniform(0.1, 0.6)},
                                      draw_ring_shape(draw, k % 3 == 0), 2 * k, -depth);
    const std::vector<PairManifold> found = manifolds_of(pair, 0);
    if (found.empty()) continue;
    const Vec3 n(found[0].manifold.normal[0], found[0].manifold.normal[1], found[0].manifold.normal[2]);
    if (std::max(std::abs(n.dot(pair.X_WA.R.col(2))), std::abs(n.dot(pair.X_WB.R.col(2)))) > 0.999) continue;
    const double distance = signed_distance(pair.a, pair.X_WA, pair.b, pair.X_WB).distance;
    ++count;
    if (std::abs(measure(pair, found).least - distance) > 2 * kRounding) ++missed;
  }
  EXPECT_GT(count, 500);
  // One in 200 pairs misses the best of its directions.
  EXPECT_LE(missed, count / 100);
}

/// Solids that lie along each other, askew by up to 0.12 rad, touch at one point and rotate about it onto the
/// ends of their sides: these are in the manifold, with the height of each over the other's round side.
TEST(NarrowPhaseRings, SidesAlongEachOtherHaveTheirEnds) {
  Draw draw(3);
  for (int k = 0; k < 100; ++k) {
    SCOPED_TRACE(k);
    const double long_half = draw.uniform(0.5, 0.8), half = draw.uniform(0.2, 0.45);
    const Shape below = Cylinder{draw.uniform(0.2, 0.4), long_half};
    const Shape above = k % 3 == 0 ? Shape(Capsule{draw.uniform(0.2, 0.4), half})
                                   : Shape(Cylinder{draw.uniform(0.2, 0.4), half});
    PlacedPair pair{below, above, {draw.rotation(), Vec3::Zero()}, {}};
    // About the normal by more than a milliradian, and about the line across it.
    const double askew = draw.uniform(0.002, 0.12), lean = draw.uniform(-0.02, 0.02);
    pair.X_WB.R = pair.X_WA.R * rotation_matrix(rotation_exp(askew * Vec3::UnitX())) *
                  rotation_matrix(rotation_exp(lean * Vec3::UnitY()));
    pair.X_WB.p = pair.X_WA.R * Vec3(1, 0, 0);
    for (int i = 0; i < 15; ++i) {
      const DistanceResult now = signed_distance(pair.a, pair.X_WA, pair.b, pair.X_WB);
      pair.X_WB.p -= (now.distance + 0.005) * pair.X_WA.R.col(0);
    }
    if (k % 2 == 1) std::swap(pair.a, pair.b), std::swap(pair.X_WA, pair.X_WB);
    const std::vector<PairManifold> found = manifolds_of(pair, 0.1f);
    ASSERT_FALSE(found.empty());

    // They reach from end to end of the shorter one, and their ends are on both surfaces.
    const Vec3 axis = (k % 2 == 1 ? pair.X_WA : pair.X_WB).R.col(2);
    double least = INFINITY, most = -INFINITY;
    const Manifold& manifold = found.front().manifold;
    const Vec3 n(manifold.normal[0], manifold.normal[1], manifold.normal[2]);
    for (int i = 0; i < manifold.point_count; ++i) {
      const ManifoldPoint& point = manifold.points[at(i)];
      const Vec3 p = pair.X_WA.p + Vec3(point.p[0], point.p[1], point.p[2]);
      least = std::min(least, axis.dot(p));
      most = std::max(most, axis.dot(p));
      const Vec3 gap_half = 0.5 * static_cast<double>(point.gap) * n;
      const auto off = [&](const Shape& shape, const Pose& X_W, const Vec3& q) {
        return std::abs(signed_distance(shape, X_W, Sphere{1e-9}, {Mat3::Identity(), q}).distance);
      };
      // The lowest point of a capsule's end that leans by x is 1 - cos x of its radius inside.
      const double inside = k % 3 == 0 ? 0.5 * lean * lean * 0.4 : 0;
      EXPECT_LE(off(pair.a, pair.X_WA, p - gap_half), inside + kRounding);
      EXPECT_LE(off(pair.b, pair.X_WB, p + gap_half), inside + kRounding);
    }
    EXPECT_NEAR(most - least, 2 * half, 0.05 * half);
  }
}

struct Scene {
  std::shared_ptr<const Model> model;
  std::unique_ptr<BulkWorld> world;
  State state;

  explicit Scene(const std::vector<BodyDescription>& bodies, const Vec3& gravity) {
    ModelBuilder builder;
    builder.set_gravity(gravity);
    builder.add_material({"m", 1000, 0.5, 0});
    for (const BodyDescription& body : bodies) builder.add_body(body);
    model = builder.build();
    world = std::make_unique<BulkWorld>(model, BulkSettings{});
    state = make_initial_state(*model);
    world->read(state);
  }
  void step(int count) {
    for (int k = 0; k < count; ++k) world->step(1.0 / 60);
    world->write(state);
  }
};

BodyDescription body_of(const std::string& name, const Shape& shape, const Vec3& p, MotionType motion) {
  BodyDescription body;
  body.name = name;
  body.motion = motion;
  body.p_WU = p;
  body.shapes.push_back({shape, Vec3::Zero(), Quat::Identity(), "m", ""});
  return body;
}

TEST(NarrowPhaseRings, ACylinderRollsDownABoxAsACircleDoes) {
  // Rolling without slipping: the acceleration is g sin(a) / (1 + 1/2), and the height stays the radius.
  constexpr double g = 9.81, angle = 0.1, radius = 0.3, t = 2;
  BodyDescription roller =
      body_of("roller", Cylinder{radius, 0.4}, Vec3(-20, 0, radius), MotionType::dynamic);
  roller.q_WU = Quat(Eigen::AngleAxisd(M_PI / 2, Vec3::UnitX()));
  Scene scene({body_of("floor", Box{Vec3(30, 5, 1)}, Vec3(0, 0, -1), MotionType::fixed), roller},
              g * Vec3(std::sin(angle), 0, -std::cos(angle)));
  for (int k = 0; k < 60 * t; ++k) {
    scene.step(1);
    // The weight presses the springs by g / ω² at most, ω = 2 pi 60 Hz / 2.
    ASSERT_NEAR(scene.state.position(1).z(), radius, 4e-4) << k;
  }
  EXPECT_NEAR(scene.state.position(1).x() + 20, 0.5 * g * std::sin(angle) / 1.5 * t * t, 0.02);
  EXPECT_NEAR(scene.state.position(1).y(), 0, 1e-3);
}

TEST(NarrowPhaseRings, AStackOfCylindersStands) {
  std::vector<BodyDescription> bodies = {
      body_of("floor", HalfSpace{Vec3::UnitZ(), 0}, Vec3::Zero(), MotionType::fixed)};
  for (int i = 0; i < 8; ++i) {
    bodies.push_back(body_of("drum " + std::to_string(i), Cylinder{0.4 + 0.02 * (i % 3), 0.25},
                             Vec3(0.03 * (i % 2), 0, 0.25 + 0.5 * i), MotionType::dynamic));
    bodies.back().q_WU = Quat(Eigen::AngleAxisd(0.3 * i, Vec3::UnitZ()));
  }
  Scene scene(bodies, Vec3(0, 0, -9.81));
  scene.step(300);
  const State half_way = scene.state;
  scene.step(300);
  for (std::size_t i = 1; i < bodies.size(); ++i) {
    // Each contact is a spring of 60 Hz that gives way under what stands on it: 36 g / omega^2 in all, twice
    // that for pairs of equal masses.
    const Vec3 moved = scene.state.position(static_cast<int>(i)) - bodies[i].p_WU;
    // The load is 3 cm beside the middle of each second drum: the springs' moments of omega^2 r^2 / 4 let the
    // lowest joint lean by 8 g 0.03 / (omega^2 r^2 / 4) = 4e-4 rad, which is 1.6 mm at the top.
    EXPECT_NEAR(moved.head<2>().norm(), 0, 2e-3) << i;
    EXPECT_NEAR((scene.state.position(static_cast<int>(i)) - half_way.position(static_cast<int>(i))).norm(),
                0, 1e-4)
        << i;
    EXPECT_NEAR(moved.z(), 0, 2 * 36 * 9.81 / std::pow(2 * M_PI * 60, 2)) << i;
    EXPECT_LT(scene.state.linear_momentum(static_cast<int>(i)).norm(), 1e-2) << i;
  }
}

}  // namespace
}  // namespace rigor::narrow_phase_rings_test
