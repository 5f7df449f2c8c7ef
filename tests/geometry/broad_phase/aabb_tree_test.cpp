#include "rigor/geometry/broad_phase/aabb_tree.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace rigor::aabb_tree_test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

class RandomBoxes {
 public:
  explicit RandomBoxes(unsigned seed) : engine_(seed) {}

  /// Boxes of sides up to `side` in a unit cube, on a coarse grid now and then so that faces coincide.
  Aabb next(double side) {
    Aabb box;
    const bool on_grid = uniform_(engine_) < 0.2;
    for (int i = 0; i < 3; ++i) {
      box.lower(i) = on_grid ? std::floor(8 * uniform_(engine_)) / 8 : uniform_(engine_);
      box.upper(i) = box.lower(i) + (on_grid ? 0.125 : side * uniform_(engine_));
    }
    return box;
  }
  int integer(int count) { return std::min(count - 1, static_cast<int>(count * uniform_(engine_))); }
  double number() { return uniform_(engine_); }

 private:
  std::mt19937_64 engine_;
  std::uniform_real_distribution<double> uniform_{0, 1};
};

TEST(AabbTree, IsEmptyAtFirstAndAfterClear) {
  AabbTree tree;
  const Aabb all{Vec3::Constant(-kInfinity), Vec3::Constant(kInfinity)};
  EXPECT_TRUE(tree.overlapping(all).empty());
  EXPECT_EQ(tree.height(), 0);
  tree.set(3, {Vec3::Zero(), Vec3::Ones()});
  tree.set(5, all);
  EXPECT_EQ(tree.overlapping(all), (std::vector<int>{3, 5}));
  tree.clear();
  EXPECT_TRUE(tree.overlapping(all).empty());
  tree.remove(3);
  tree.remove(1000);
}

TEST(AabbTree, ReportsBoxesThatOnlyTouch) {
  AabbTree tree;
  tree.set(0, {Vec3::Zero(), Vec3::Ones()});
  EXPECT_EQ(tree.overlapping({Vec3(1, 1, 1), Vec3(2, 2, 2)}), std::vector<int>{0});
  EXPECT_TRUE(tree.overlapping({Vec3(1 + 1e-15, 0, 0), Vec3(2, 2, 2)}).empty());
}

TEST(AabbTree, AgreesWithBruteForceUnderRandomSetRemoveAndQuery) {
  RandomBoxes random(7);
  AabbTree tree;
  std::vector<Aabb> boxes(200);
  std::vector<bool> is_in(200, false);
  std::vector<int> hits;
  for (int step = 0; step < 20000; ++step) {
    const int id = random.integer(200);
    const std::size_t index = static_cast<std::size_t>(id);
    const double action = random.number();
    if (action < 0.3) {
      boxes[index] = random.next(0.2);
      is_in[index] = true;
      tree.set(id, boxes[index]);
    } else if (action < 0.5 && is_in[index]) {
      boxes[index].lower.array() += 0.01 * (random.number() - 0.5);  // A small motion takes the short way.
      boxes[index].upper = boxes[index].lower + Vec3::Constant(0.05);
      tree.set(id, boxes[index]);
    } else if (action < 0.52) {
      boxes[index] = {Vec3(-kInfinity, -kInfinity, -kInfinity), Vec3(kInfinity, kInfinity, 0.1)};
      is_in[index] = true;
      tree.set(id, boxes[index]);
    } else if (action < 0.7) {
      is_in[index] = false;
      tree.remove(id);
    } else {
      const Aabb query = random.next(0.3);
      std::vector<int> expected;
      for (int k = 0; k < 200; ++k) {
        const std::size_t j = static_cast<std::size_t>(k);
        if (is_in[j] && boxes[j].overlaps(query)) expected.push_back(k);
      }
      tree.overlapping(query, hits);
      ASSERT_EQ(hits, expected) << "step " << step;
    }
  }
}

TEST(AabbTree, StaysLowForSortedAndForCoincidentItems) {
  AabbTree line, heap;
  for (int id = 0; id < 4096; ++id) {
    const Vec3 p(id, 0, 0);
    line.set(id, {p, p + Vec3::Ones()});
    heap.set(id, {Vec3::Zero(), Vec3::Ones()});
  }
  // A perfect tree of 4096 leaves has height 12; a heuristic one may be a few times as high, a list would be
  // 4095.
  EXPECT_LE(line.height(), 36);
  EXPECT_LE(heap.height(), 36);
}

TEST(AabbTree, InsertsAndQueriesTenThousandItemsQuickly) {
  RandomBoxes random(11);
  std::vector<Aabb> boxes;
  for (int id = 0; id < 10000; ++id) boxes.push_back(random.next(0.03));
  AabbTree tree;
  const auto start = std::chrono::steady_clock::now();
  for (int id = 0; id < 10000; ++id) tree.set(id, boxes[static_cast<std::size_t>(id)]);
  const auto built = std::chrono::steady_clock::now();
  std::vector<int> hits;
  std::size_t hit_count = 0;
  for (const Aabb& box : boxes) {
    tree.overlapping(box, hits);
    hit_count += hits.size();
  }
  const auto done = std::chrono::steady_clock::now();
  const double ns_set = std::chrono::duration<double, std::nano>(built - start).count() / 10000;
  const double ns_query = std::chrono::duration<double, std::nano>(done - built).count() / 10000;
  RecordProperty("ns_per_set", std::to_string(ns_set));
  RecordProperty("ns_per_query", std::to_string(ns_query));
  EXPECT_GE(hit_count, 10000u);  // Each box meets itself.
  EXPECT_LE(tree.height(), 40);  // log2 of 10,000 is 13.3.
}

}  // namespace
}  // namespace rigor::aabb_tree_test
