#include "bulk/face_preference.hpp"
#include "bulk/same_bits.hpp"
#include "geometry/random_pairs.hpp"
#include "rigor/bulk/narrow_phase/collide_boxes.hpp"
#include "rigor/bulk/narrow_phase/hull_lanes.hpp"
#include "rigor/bulk/narrow_phase/narrow_phase.hpp"
#include "rigor/geometry/distance/distance.hpp"
#include "rigor/model/model_builder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <set>

namespace rigor::narrow_phase_lanes_test {
namespace {

using test::are_same_bits;
using test::Draw;
using test::face_preference;

/// Bodies of one shape each.
struct Crowd {
  std::vector<Shape> shapes;
  BulkBodies bodies;

  void add(const Shape& shape, const Pose& X_WB) {
    shapes.push_back(shape);
    bodies.x.push_back(X_WB.p);
    bodies.q.emplace_back(X_WB.R);
    bodies.motion.emplace_back();
    bodies.inertia.emplace_back();
  }
  std::shared_ptr<const Model> model() const {
    ModelBuilder builder;
    for (std::size_t k = 0; k < shapes.size(); ++k) {
      BodyDescription body;
      body.name = std::to_string(k);
      body.motion = MotionType::kinematic;
      body.shapes.emplace_back().shape = shapes[k];
      builder.add_body(body);
    }
    return builder.build();
  }
  std::vector<ShapePair> all_pairs(float margin) const {
    std::vector<ShapePair> pairs;
    for (int a = 0; a < bodies.count(); ++a)
      for (int b = a + 1; b < bodies.count(); ++b) pairs.push_back({a, b, 0, 0, margin});
    return pairs;
  }
};

std::vector<PairManifold> manifolds_of(NarrowPhase& narrow_phase, const Crowd& crowd,
                                       const std::vector<ShapePair>& pairs, int threads) {
  ManifoldList found;
  narrow_phase.find_manifolds(crowd.bodies, pairs, Executor(threads), found);
  return found.copies();
}

/// Boxes, hulls, spheres and capsules in a small room.
Crowd random_crowd(Draw& draw, int count) {
  constexpr int kinds[] = {0, 1, 1, 2, 6, 7};
  Crowd crowd;
  for (int k = 0; k < count; ++k) crowd.add(draw.shape(kinds[k % 6]), draw.pose(1.5));
  return crowd;
}

TEST(NarrowPhaseLanes, PairsOneByOneAndInBlocksAndWithAFreshTableGiveTheSameBits) {
  Draw draw(1);
  const Crowd crowd = random_crowd(draw, 40);
  const std::shared_ptr<const Model> model = crowd.model();
  const std::vector<ShapePair> pairs = crowd.all_pairs(0.05f);
  NarrowPhase narrow_phase(*model);
  const std::vector<PairManifold> together = manifolds_of(narrow_phase, crowd, pairs, 1);
  ASSERT_GT(together.size(), 100u);
  EXPECT_LT(together.size(), pairs.size());
  const std::vector<PairManifold> in_blocks = manifolds_of(narrow_phase, crowd, pairs, 3);
  ASSERT_EQ(in_blocks.size(), together.size());
  std::vector<PairManifold> singly;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    NarrowPhase fresh(*model);
    for (PairManifold& manifold : manifolds_of(fresh, crowd, {pairs[k]}, 1)) {
      manifold.pair = static_cast<int>(k);
      singly.push_back(manifold);
    }
  }
  ASSERT_EQ(singly.size(), together.size());
  for (std::size_t k = 0; k < together.size(); ++k) {
    EXPECT_TRUE(are_same_bits(together[k], in_blocks[k]));
    EXPECT_TRUE(are_same_bits(together[k], singly[k]));
  }
}

TEST(NarrowPhaseLanes, BothTargetsGiveTheSameBitsOfBoxes) {
  if (best_lane_target() == LaneTarget::portable) GTEST_SKIP() << "This processor has no AVX2.";
  Draw draw(2);
  FloatHulls hulls;
  for (int round = 0; round < 200; ++round) {
    std::vector<PlacedShape> placed;
    for (int k = 0; k < 2 * kLaneCount; ++k)
      placed.push_back(
          place_shape(make_bulk_shape({.shape = Box{draw.sizes()}}, hulls), Quat(draw.rotation())));
    BoxPairs pairs;
    for (int k = 0; k < kLaneCount; ++k) {
      const Vec3f d = draw.pose(0.9).p.cast<float>();
      pairs.pair[k] = {&placed[static_cast<std::size_t>(2 * k)],
                       &placed[static_cast<std::size_t>(2 * k + 1)],
                       {d.x(), d.y(), d.z()},
                       0.1f};
    }
    BoxContacts portable{}, avx2{};
    collide_boxes(pairs, LaneTarget::portable, portable);
    collide_boxes(pairs, LaneTarget::avx2, avx2);
    EXPECT_EQ(std::memcmp(&portable, &avx2, sizeof portable), 0);
  }
}

TEST(NarrowPhaseLanes, BothTargetsGiveTheSameBitsOfColumns) {
  if (best_lane_target() == LaneTarget::portable) GTEST_SKIP() << "This processor has no AVX2.";
  Draw draw(3);
  std::vector<float> columns[3];
  for (std::vector<float>& column : columns)
    for (int k = 0; k < 64; ++k) column.push_back(static_cast<float>(draw.uniform(-1, 1)));
  const LaneColumns points{columns[0].data(), columns[1].data(), columns[2].data(), 64};
  for (int round = 0; round < 20; ++round) {
    const Vec3f n = draw.direction().cast<float>();
    const Support farthest = find_support(points, n, LaneTarget::avx2);
    EXPECT_EQ(farthest.index, find_support(points, n, LaneTarget::portable).index);
    EXPECT_EQ(farthest.height, find_support(points, n, LaneTarget::portable).height);
    std::vector<float> portable(64), avx2(64);
    find_heights(points, n, nullptr, LaneTarget::portable, portable.data());
    find_heights(points, n, nullptr, LaneTarget::avx2, avx2.data());
    EXPECT_EQ(portable, avx2);
    const auto highest = std::max_element(avx2.begin(), avx2.end());
    EXPECT_EQ(*highest, farthest.height);
    EXPECT_EQ(highest - avx2.begin(), farthest.index);
    const SupportSet set = find_support_set(points, 60, n, 0.5f, LaneTarget::avx2);
    EXPECT_EQ(set.height, farthest.height);
    EXPECT_EQ(set.count, std::count_if(avx2.begin(), avx2.begin() + 60,
                                       [&](float height) { return height >= *highest - 0.5f; }));
    EXPECT_EQ(set.count, find_support_set(points, 60, n, 0.5f, LaneTarget::portable).count);
  }
}

TEST(NarrowPhaseLanes, PlacedColumnsAndListsAreThoseOfSinglePoints) {
  Draw draw(7);
  std::vector<float> columns[3], offsets;
  for (std::vector<float>& column : columns)
    for (int k = 0; k < 40; ++k) column.push_back(static_cast<float>(draw.uniform(-1, 1)));
  for (int k = 0; k < 40; ++k) offsets.push_back(static_cast<float>(draw.uniform(-1, 1)));
  const LaneColumns points{columns[0].data(), columns[1].data(), columns[2].data(), 40};
  for (const LaneTarget target : {LaneTarget::portable, best_lane_target()}) {
    const Mat3f M = draw.rotation().cast<float>();
    const Vec3f t = draw.direction().cast<float>(), n = draw.direction().cast<float>();
    PlacedColumns placed;
    placed.place(points, M, t, target);
    std::vector<float> heights(40), plain(40);
    find_heights(points, n, offsets.data(), target, heights.data());
    find_heights(points, n, nullptr, target, plain.data());
    std::vector<int> above, expected;
    list_above({heights, 0.1f}, {plain, -0.2f}, 37, target, above);
    for (int k = 0; k < 40; ++k) {
      const std::size_t i = static_cast<std::size_t>(k);
      const Vec3f p(columns[0][i], columns[1][i], columns[2][i]);
      EXPECT_EQ(placed[k], Vec3f(M * p + t));
      EXPECT_EQ(heights[i], plain[i] - offsets[i]);
      if (k < 37 && heights[i] > 0.1f && plain[i] > -0.2f) expected.push_back(k);
    }
    EXPECT_EQ(above, expected);
    EXPECT_GT(above.size(), 5u);
  }
}

/// The same pair with its bodies exchanged has the opposite normal and the same points and gaps.
TEST(NarrowPhaseLanes, ExchangedBodiesHaveTheSamePoints) {
  Draw draw(4);
  constexpr double rounding = 1e-5;
  for (int k = 0; k < 300; ++k) {
    constexpr int kinds[] = {0, 1, 2, 6, 7};
    const Shape a = draw.shape(kinds[k % 5]), b = draw.shape(kinds[k / 5 % 5]);
    const Pose X_WA = draw.pose(0.5), X_WB = draw.pose(0.5);
    Crowd crowd, exchanged;
    crowd.add(a, X_WA), crowd.add(b, X_WB);
    exchanged.add(b, X_WB), exchanged.add(a, X_WA);
    NarrowPhase first(*crowd.model()), second(*exchanged.model());
    const auto here = manifolds_of(first, crowd, crowd.all_pairs(0.02f), 1);
    const auto there = manifolds_of(second, exchanged, exchanged.all_pairs(0.02f), 1);
    ASSERT_EQ(here.size(), there.size());
    if (here.empty()) continue;
    float least[2] = {INFINITY, INFINITY};
    for (int i = 0; i < here[0].manifold.point_count; ++i)
      least[0] = std::min(least[0], here[0].manifold.points[static_cast<std::size_t>(i)].gap);
    for (int i = 0; i < there[0].manifold.point_count; ++i)
      least[1] = std::min(least[1], there[0].manifold.points[static_cast<std::size_t>(i)].gap);
    EXPECT_NEAR(least[0], least[1], rounding) << k;
  }
}

/// Parallel faces, edges above edges, identical poses, needles and plates: points are finite, at most four
/// and different, and the deepest gap is the signed distance, but for what a face is preferred by.
TEST(NarrowPhaseLanes, DegeneratePosesOfBoxesHaveTheExactGap) {
  Draw draw(5);
  const Vec3 sizes[] = {Vec3(0.5, 0.5, 0.5), Vec3(2, 0.01, 0.01), Vec3(1, 1, 0.005), Vec3(0.5, 0.25, 0.5)};
  const double turns[] = {0, 0.25, 0.5, 1e-7, 1e-4, 0.125};
  constexpr double rounding = 1e-5;  // 1e-6 for each of the lengths, of up to 10 m in sum.
  for (int round = 0; round < 600; ++round) {
    const Vec3 half_A = sizes[round % 4], half_B = sizes[round / 4 % 4];
    const auto turn = [&](int axis) {
      const double angle = turns[static_cast<int>(draw.uniform(0, 5.99))] * std::numbers::pi;
      return Quat(Eigen::AngleAxisd(angle, Vec3::Unit(axis)));
    };
    const Mat3 R_WB = (turn(0) * turn(2)).toRotationMatrix();
    // Multiples of the half extents: faces, edges and corners meet exactly.
    Vec3 p;
    for (int c = 0; c < 3; ++c) p[c] = std::floor(draw.uniform(-2, 3)) * (half_A[c] + half_B[c]) / 2;
    Crowd crowd;
    crowd.add(Box{half_A}, {Mat3::Identity(), Vec3::Zero()});
    crowd.add(Box{half_B}, {R_WB, p});
    NarrowPhase narrow_phase(*crowd.model());
    const auto found = manifolds_of(narrow_phase, crowd, crowd.all_pairs(0.01f), 1);
    const DistanceResult distance =
        signed_distance(crowd.shapes[0], {Mat3::Identity(), Vec3::Zero()}, crowd.shapes[1], {R_WB, p});
    const double preference = face_preference(crowd.shapes[0], crowd.shapes[1], distance.distance);
    if (distance.distance > 0.01 - rounding - preference) continue;
    ASSERT_TRUE(found.size() == 1 || found.size() == 2) << round;
    const Manifold& manifold = found[0].manifold;
    double least = INFINITY;
    std::set<std::uint32_t> features;
    for (int i = 0; i < manifold.point_count; ++i) {
      const ManifoldPoint& point = manifold.points[static_cast<std::size_t>(i)];
      least = std::min(least, static_cast<double>(point.gap));
      features.insert(point.feature);
      for (const float x : point.p) EXPECT_TRUE(std::isfinite(x)) << round;
    }
    EXPECT_EQ(features.size(), static_cast<std::size_t>(manifold.point_count)) << round;
    EXPECT_NEAR(least, distance.distance, rounding + preference) << round;
  }
}

TEST(NarrowPhaseLanes, PosesThatAreNotFiniteTouchNothing) {
  Draw draw(6);
  Crowd crowd = random_crowd(draw, 6);
  crowd.bodies.x[1].x() = std::numeric_limits<double>::quiet_NaN();
  NarrowPhase narrow_phase(*crowd.model());
  for (const PairManifold& found : manifolds_of(narrow_phase, crowd, crowd.all_pairs(0.1f), 1)) {
    const ShapePair pair = crowd.all_pairs(0.1f)[static_cast<std::size_t>(found.pair)];
    EXPECT_NE(pair.body_A, 1);
    EXPECT_NE(pair.body_B, 1);
  }
}

/// A box that slides and turns a little on another keeps the features it stands on.
TEST(NarrowPhaseLanes, FeaturesStayWhileABoxRests) {
  Draw draw(7);
  Crowd crowd;
  crowd.add(Box{Vec3(1, 1, 0.5)}, {});
  crowd.add(Box{Vec3(0.4, 0.4, 0.4)},
            {Quat(Eigen::AngleAxisd(0.3, Vec3::UnitZ())).toRotationMatrix(), Vec3(0.1, 0.2, 0.9)});
  NarrowPhase narrow_phase(*crowd.model());
  const auto before = manifolds_of(narrow_phase, crowd, crowd.all_pairs(0.01f), 1);
  ASSERT_EQ(before.size(), 1u);
  ASSERT_EQ(before[0].manifold.point_count, 4);
  const Crowd start = crowd;
  for (int k = 0; k < 100; ++k) {
    crowd.bodies.x[1] = start.bodies.x[1] + 1e-4 * draw.direction();
    crowd.bodies.q[1] = rotation_exp(1e-4 * draw.direction()) * start.bodies.q[1];
    const auto after = manifolds_of(narrow_phase, crowd, crowd.all_pairs(0.01f), 1);
    ASSERT_EQ(after.size(), 1u);
    ASSERT_EQ(after[0].manifold.point_count, 4);
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_EQ(after[0].manifold.points[i].feature, before[0].manifold.points[i].feature);
  }
}

}  // namespace
}  // namespace rigor::narrow_phase_lanes_test
