#include "rigor/bulk/broad_phase/box_tree.hpp"

#include "random_vectors.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>
#include <utility>
#include <vector>

namespace rigor::box_tree_test {
namespace {

using Pairs = std::set<std::pair<int, int>>;

std::vector<FloatBox> random_boxes(test::Random& random, int count, float size) {
  std::vector<FloatBox> boxes;
  for (int i = 0; i < count; ++i) {
    FloatBox box{};
    for (int k = 0; k < 3; ++k) {
      box.lower[k] = static_cast<float>(random.uniform(-3, 3));
      box.upper[k] = box.lower[k] + size * static_cast<float>(random.uniform(0, 1));
    }
    boxes.push_back(box);
  }
  return boxes;
}

/// Each pair once; the lower number first.
Pairs own_pairs(const BoxTree& tree) {
  std::vector<BoxTree::Pair> found;
  for (int block = 0; block < tree.block_count(); ++block) tree.find_own_pairs(block, found);
  Pairs pairs;
  for (const BoxTree::Pair& pair : found)
    EXPECT_TRUE(pairs.insert(std::minmax(pair.a, pair.b)).second) << pair.a << " " << pair.b;
  return pairs;
}

Pairs expected_own_pairs(const std::vector<FloatBox>& boxes) {
  Pairs pairs;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t j = i + 1; j < boxes.size(); ++j) {
      if (boxes[i].overlaps(boxes[j])) pairs.insert({static_cast<int>(i), static_cast<int>(j)});
    }
  }
  return pairs;
}

TEST(BoxTree, FindsWhatOverlapsABoxAlsoWhenBoxesWereReplaced) {
  test::Random random(7);
  BoxTree tree;
  for (const int count : {0, 1, 8, 9, 65, 513}) {
    std::vector<FloatBox> boxes = random_boxes(random, count, 1);
    tree.build(boxes, 1);
    for (int round = 0; round < 4; ++round) {
      for (const FloatBox& box : random_boxes(random, 20, 1)) {
        std::vector<int> found, expected;
        tree.find_overlaps(box, found);
        for (int i = 0; i < count; ++i)
          if (boxes[static_cast<std::size_t>(i)].overlaps(box)) expected.push_back(i);
        std::sort(found.begin(), found.end());
        EXPECT_EQ(found, expected) << count << " boxes, round " << round;
      }
      for (int i = round; i < count; i += 5) {
        boxes[static_cast<std::size_t>(i)] = random_boxes(random, 1, 1)[0];
        tree.replace(i, boxes[static_cast<std::size_t>(i)]);
      }
      EXPECT_EQ(own_pairs(tree), expected_own_pairs(boxes)) << count << " boxes, round " << round;
    }
  }
}

TEST(BoxTree, FindsWhatOverlapsABoxAlsoWhenAllHaveMovedAndSomeAreInfinite) {
  constexpr double far = std::numeric_limits<double>::infinity();
  test::Random random(11);
  BoxTree tree;
  for (const int count : {1, 9, 65, 513}) {
    std::vector<FloatBox> boxes = random_boxes(random, count, 1);
    for (int round = 0; round < 4; ++round) {
      // A half-space, and all of space.
      boxes[0] = enclosing_box({Vec3::Constant(-far), Vec3(far, far, 0)}, Vec3::UnitX());
      boxes.back() = enclosing_box({Vec3::Constant(-far), Vec3::Constant(far)}, Vec3::UnitX());
      round == 0 ? tree.build(boxes, 1) : tree.refit(boxes);
      for (const FloatBox& box : random_boxes(random, 20, 1)) {
        std::vector<int> found, expected;
        tree.find_overlaps(box, found);
        for (int i = 0; i < count; ++i)
          if (boxes[static_cast<std::size_t>(i)].overlaps(box)) expected.push_back(i);
        std::sort(found.begin(), found.end());
        EXPECT_EQ(found, expected) << count << " boxes, round " << round;
      }
      EXPECT_EQ(own_pairs(tree), expected_own_pairs(boxes)) << count << " boxes, round " << round;
      boxes = random_boxes(random, count, 1);
    }
  }
}

TEST(BoxTree, ABoxIsWithinItsEnclosingBox) {
  test::Random random(13);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 origin = 1e6 * random.vector(), lower = origin + 100 * random.vector(),
               size = random.vector().cwiseAbs();
    const FloatBox box = enclosing_box({lower, lower + size}, origin);
    for (int k = 0; k < 3; ++k) {
      EXPECT_LE(static_cast<double>(box.lower[k]), lower[k] - origin[k]);
      EXPECT_GE(static_cast<double>(box.upper[k]), lower[k] + size[k] - origin[k]);
      EXPECT_NEAR(static_cast<double>(box.upper[k] - box.lower[k]), size[k], 1e-3);
    }
  }
}

TEST(BoxTree, FindsAllPairsOfRandomBoxesOnce) {
  test::Random random(3);
  BoxTree tree;
  for (const int count : {0, 1, 2, 7, 8, 9, 64, 65, 513, 1000}) {
    for (const float size : {0.2f, 2.0f}) {
      const std::vector<FloatBox> boxes = random_boxes(random, count, size);
      tree.build(boxes, size);
      EXPECT_EQ(own_pairs(tree), expected_own_pairs(boxes)) << count << " boxes of " << size;
    }
  }
}

TEST(BoxTree, FindsPairsWithBoxesOfVeryDifferentSizeAndFarAway) {
  test::Random random(5);
  std::vector<FloatBox> boxes = random_boxes(random, 200, 0.3f);
  boxes.push_back({{-1e9f, -1e9f, -1e9f}, {-1e9f, -1e9f, -1e9f}});
  boxes.push_back({{-10, -10, 0}, {10, 10, 0}});
  boxes.insert(boxes.end(), 30, boxes[0]);
  BoxTree tree;
  tree.build(boxes, 0.3f);
  EXPECT_EQ(own_pairs(tree), expected_own_pairs(boxes));
}

TEST(BoxTree, FindsThePairsOfTwoTrees) {
  test::Random random(7);
  for (const int other_count : {0, 1, 20, 300}) {
    const std::vector<FloatBox> boxes = random_boxes(random, 150, 0.5f);
    const std::vector<FloatBox> others = random_boxes(random, other_count, 1.0f);
    BoxTree tree, other;
    tree.build(boxes, 0.5f);
    other.build(others, 0.5f);
    std::vector<BoxTree::Pair> found;
    for (int block = 0; block < tree.block_count(); ++block) tree.find_pairs_with(other, block, found);
    Pairs pairs, expected;
    for (const BoxTree::Pair& pair : found) EXPECT_TRUE(pairs.insert({pair.a, pair.b}).second);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      for (std::size_t j = 0; j < others.size(); ++j) {
        if (boxes[i].overlaps(others[j])) expected.insert({static_cast<int>(i), static_cast<int>(j)});
      }
    }
    EXPECT_EQ(pairs, expected) << other_count;
  }
}

}  // namespace
}  // namespace rigor::box_tree_test
