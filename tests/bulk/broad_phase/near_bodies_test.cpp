// Which bodies are near each other.

#include "rigor/bulk/broad_phase/near_bodies.hpp"

#include "random_vectors.hpp"
#include "rigor/bulk/lanes/list_room.hpp"
#include "rigor/model/model_builder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

namespace rigor::near_bodies_test {
namespace {

/// The distance of the boxes that are smaller by their radii, from their corners.
double distance_of_smaller(const FloatBox& a, double radius_A, const FloatBox& b, double radius_B) {
  double squared = 0;
  for (int k = 0; k < 3; ++k) {
    const double between = std::max(double{a.lower[k]} + radius_A - (double{b.upper[k]} - radius_B),
                                    double{b.lower[k]} + radius_B - (double{a.upper[k]} - radius_A));
    squared += std::pow(std::max(between, 0.0), 2);
  }
  return std::sqrt(squared);
}

TEST(NearBodies, RoundedBoxesTouchWhereTheirSmallerBoxesAreNoFartherThanTheRadii) {
  test::Random random(4);
  int near = 0, cut = 0;
  for (int k = 0; k < 2000; ++k) {
    FloatBox boxes[2];
    float radii[2];
    for (int i = 0; i < 2; ++i) {
      radii[i] = static_cast<float>(random.uniform(0, 0.5));
      const Vec3 center = random.vector();
      for (int c = 0; c < 3; ++c) {
        const double half = double{radii[i]} + random.uniform(0, 0.2);
        boxes[i].lower[c] = static_cast<float>(center[c] - half);
        boxes[i].upper[c] = static_cast<float>(center[c] + half);
      }
    }
    const double distance = distance_of_smaller(boxes[0], double{radii[0]}, boxes[1], double{radii[1]});
    const double reach = double{radii[0]} + double{radii[1]};
    if (std::abs(distance - reach) < 1e-5) continue;  // Rounding of 32 bits decides.
    const bool touch = rounded_boxes_touch(boxes[0], radii[0], boxes[1], radii[1]);
    EXPECT_EQ(touch, distance < reach);
    EXPECT_EQ(touch, rounded_boxes_touch(boxes[1], radii[1], boxes[0], radii[0]));
    near += touch;
    cut += boxes[0].overlaps(boxes[1]) && !touch;
  }
  EXPECT_GT(near, 200);
  EXPECT_GT(cut, 20);
}

/// Balls in a cubic lattice with room of an eighth of their size between them: those beside each other are
/// near, those across an edge or a corner of a cell are not.
TEST(NearBodies, BallsAcrossACornerAreNotNear) {
  constexpr int n = 5;
  ModelBuilder builder;
  std::vector<FloatBox> boxes;
  std::vector<int> moving;
  for (int i = 0; i < n * n * n; ++i) {
    BodyDescription ball;
    ball.name = "ball" + std::to_string(i);
    ball.shapes.emplace_back().shape = Sphere{0.5};
    builder.add_body(ball);
    FloatBox box;
    const int cells[] = {i % n, i / n % n, i / n / n};
    for (int k = 0; k < 3; ++k) {
      const float center = 1.125f * static_cast<float>(cells[k]);
      box.lower[k] = center - 0.5f;
      box.upper[k] = center + 0.5f;
    }
    boxes.push_back(box);
    moving.push_back(i);
  }
  const std::shared_ptr<const Model> model = builder.build();
  const std::vector<MotionRecord> motion(boxes.size());
  // Wide boxes have four hundredths of the cell on all sides: boxes of the scale of 2 meet in the lattice.
  NearBodies near(moving, {}, std::vector<float>(boxes.size(), 0.5f), 2);
  near.update({boxes, motion, 0, Vec3::Zero()}, PairFilter(*model), Executor(1));
  EXPECT_EQ(near.pairs().size(), 3u * n * n * (n - 1));
}

TEST(ListRoom, GrowsByAnEighthAndMergesInPlace) {
  std::vector<int> list = {1, 3, 3, 8};
  merge_into({0, 2, 4, 9, 9}, std::less<>(), list);
  EXPECT_EQ(list, (std::vector<int>{0, 1, 2, 3, 3, 4, 8, 9, 9}));
  std::vector<int> empty;
  merge_into({1, 2}, std::less<>(), empty);
  EXPECT_EQ(empty, (std::vector<int>{1, 2}));
  std::vector<int> grown;
  for (std::size_t count : {800u, 1000u, 1600u}) {
    renew(count, grown);
    EXPECT_EQ(grown.size(), count);
    EXPECT_LE(grown.capacity(), count + count / 8);
  }
}

}  // namespace
}  // namespace rigor::near_bodies_test
