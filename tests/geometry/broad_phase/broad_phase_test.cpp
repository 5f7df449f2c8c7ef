#include "rigor/geometry/broad_phase/broad_phase.hpp"

#include "random_vectors.hpp"
#include "rigor/geometry/broad_phase/pair_set.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace rigor::broad_phase_test {
namespace {

using test::Random;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Boxes that fly about in a cube of side 2; some on a grid, so that faces meet, and two of planes.
class MovingBoxes {
 public:
  explicit MovingBoxes(int count) {
    for (int i = 0; i < count; ++i) {
      Vec3 p = random_.vector();
      if (i % 5 == 0) p = (8 * p).array().floor() / 8;
      const Vec3 size = i % 5 == 0 ? Vec3::Constant(0.125) : Vec3(0.06 * (random_.vector() + Vec3::Ones()));
      boxes.push_back({p, p + size});
      steps_.push_back(i % 7 == 0 ? Vec3::Zero() : random_.vector());
    }
    boxes[1] = {Vec3::Constant(-kInfinity), Vec3(kInfinity, kInfinity, -0.9)};
    boxes[2] = {Vec3::Constant(-kInfinity), Vec3::Constant(kInfinity)};
  }

  void move(double h) {
    for (std::size_t i = 3; i < boxes.size(); ++i) {
      boxes[i].lower += h * steps_[i];
      boxes[i].upper += h * steps_[i];
    }
  }
  void jump() {
    for (std::size_t i = 3; i < boxes.size(); i += 2) {
      const Vec3 by = random_.vector();
      boxes[i].lower += by;
      boxes[i].upper += by;
    }
  }
  std::vector<BoxPair> pairs() const {
    std::vector<BoxPair> all;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      for (std::size_t j = i + 1; j < boxes.size(); ++j) {
        if (boxes[i].overlaps(boxes[j])) all.push_back({static_cast<int>(i), static_cast<int>(j)});
      }
    }
    return all;
  }

  std::vector<Aabb> boxes;

 private:
  Random random_{41};
  std::vector<Vec3> steps_;
};

class BroadPhases : public testing::TestWithParam<BroadPhaseMethod> {};

TEST_P(BroadPhases, PairsAreThoseOfAllBoxesOneByOneWhateverCameBefore) {
  MovingBoxes moving(300);
  PairSet set(GetParam(), 0.02);
  std::vector<BoxPair> before;
  std::size_t changes = 0;
  for (int step = 0; step < 60; ++step) {
    // Slow, then fast, then half of them somewhere else.
    if (step % 20 == 19) moving.jump();
    moving.move(step < 30 ? 0.001 : 0.02);
    set.update(moving.boxes);
    const std::vector<BoxPair> now = moving.pairs();
    ASSERT_EQ(set.pairs(), now) << step;
    std::vector<BoxPair> entered, left;
    std::set_difference(now.begin(), now.end(), before.begin(), before.end(), std::back_inserter(entered));
    std::set_difference(before.begin(), before.end(), now.begin(), now.end(), std::back_inserter(left));
    EXPECT_EQ(set.entered(), entered);
    EXPECT_EQ(set.left(), left);
    changes += entered.size() + left.size();
    before = now;
  }
  EXPECT_GT(changes, 400u);
  // Fewer boxes, or none: all begins anew.
  moving.boxes.resize(20);
  set.update(moving.boxes);
  EXPECT_EQ(set.pairs(), moving.pairs());
  set.update({});
  EXPECT_TRUE(set.pairs().empty());
}

TEST_P(BroadPhases, AnswerQueriesAfterAnySequenceOfCalls) {
  MovingBoxes moving(200);
  const std::unique_ptr<BroadPhase> phase = make_broad_phase(GetParam());
  Random random(42);
  std::vector<bool> is_in(200, false);
  std::vector<int> found;
  for (int call = 0; call < 3000; ++call) {
    const std::size_t i = static_cast<std::size_t>(random.uniform(0, 200));
    if (call % 3 == 2) {
      phase->remove(static_cast<int>(i));
      is_in[i] = false;
    } else {
      phase->set(static_cast<int>(i), moving.boxes[i]);
      is_in[i] = true;
    }
    if (call % 50 == 0) moving.move(0.0);
    const Aabb& asked = moving.boxes[static_cast<std::size_t>(random.uniform(3, 200))];
    phase->overlapping(asked, found);
    std::vector<int> expected;
    for (std::size_t k = 0; k < 200; ++k) {
      if (is_in[k] && moving.boxes[k].overlaps(asked)) expected.push_back(static_cast<int>(k));
    }
    ASSERT_EQ(found, expected) << call;
  }
}

INSTANTIATE_TEST_SUITE_P(BothMethods, BroadPhases,
                         testing::Values(BroadPhaseMethod::tree, BroadPhaseMethod::sweep_and_prune));

TEST(AabbTreeBuild, AnswersLikeATreeOfSingleItemsAndIsLow) {
  MovingBoxes moving(2000);
  AabbTree built, single;
  std::vector<BoxItem> items;
  for (std::size_t i = 0; i < moving.boxes.size(); ++i) {
    items.push_back({static_cast<int>(i), moving.boxes[i]});
    single.set(static_cast<int>(i), moving.boxes[i]);
  }
  built.build(items);
  EXPECT_LE(built.height(), 30);  // log2 of 2000 is 11.
  EXPECT_EQ(built.overlapping_pairs(), moving.pairs());
  EXPECT_EQ(single.overlapping_pairs(), moving.pairs());
  // A built tree can be changed and refitted like any other.
  for (int id = 3; id < 2000; id += 3) built.remove(id);
  for (int id = 3; id < 2000; id += 3) built.set(id, moving.boxes[static_cast<std::size_t>(id)]);
  moving.move(0.1);
  built.refit(moving.boxes);
  EXPECT_EQ(built.overlapping_pairs(), moving.pairs());
  const std::vector<BoxItem> heap(1000, {0, {Vec3::Zero(), Vec3::Ones()}});
  std::vector<BoxItem> in_one_place = heap;
  for (int id = 0; id < 1000; ++id) in_one_place[static_cast<std::size_t>(id)].id = id;
  built.build(in_one_place);
  EXPECT_EQ(built.height(), 10);
  EXPECT_EQ(built.overlapping_pairs().size(), 1000u * 999 / 2);
}

}  // namespace
}  // namespace rigor::broad_phase_test
