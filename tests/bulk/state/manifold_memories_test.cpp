#include "rigor/bulk/state/manifold_memories.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <vector>

namespace rigor::manifold_memories_test {
namespace {

/// Every number of it is another one.
ManifoldMemory memory(int a, int b, int points) {
  ManifoldMemory m;
  m.body_A = a, m.body_B = b;
  m.shape_A = 3, m.shape_B = 4;
  m.part = 5;
  m.point_count = points;
  for (std::size_t k = 0; k < static_cast<std::size_t>(points); ++k) {
    m.feature[k] = 0xffffff00u + static_cast<std::uint32_t>(k);  // As a float it is not a number.
    m.normal_impulse[k] = 0.1f * static_cast<float>(k + 1);
  }
  m.friction_impulse_W = {1, -2, 3};
  m.twist_impulse = 4;
  m.rolling_impulse_W = {-5, 6, 7};
  m.energy = 8;
  return m;
}

/// All, and with each of the numbers that need not be there left out.
std::vector<ManifoldMemory> samples() {
  std::vector<ManifoldMemory> all;
  for (int points = 0; points <= ManifoldMemory::max_points; ++points) {
    for (int left_out = 0; left_out < 16; ++left_out) {
      ManifoldMemory m = memory(points, left_out + 10, points);
      if (left_out & 1) m.shape_A = m.shape_B = m.part = 0;
      if (left_out & 2) m.twist_impulse = 0;
      if (left_out & 4) m.rolling_impulse_W = {};
      if (left_out & 8) m.energy = 0;
      all.push_back(m);
    }
  }
  return all;
}

TEST(ManifoldMemories, GiveBackWhatWasPutIn) {
  const std::vector<ManifoldMemory> all = samples();
  const ManifoldMemories list = all;
  ASSERT_EQ(list.size(), all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_EQ(list[i], all[i]) << i;
    EXPECT_EQ(list.key(i), all[i].key()) << i;
    EXPECT_EQ(list.energy(i), all[i].energy) << i;
  }
  EXPECT_EQ(std::vector<ManifoldMemory>(list.begin(), list.end()), all);
  EXPECT_EQ(list.values(), all);
  ManifoldMemories one_by_one;
  for (const ManifoldMemory& m : all) one_by_one.push_back(m);
  EXPECT_EQ(one_by_one, list);
}

TEST(ManifoldMemories, KeepTheSignOfZero) {
  ManifoldMemory m = memory(0, 1, 1);
  m.twist_impulse = m.energy = m.rolling_impulse_W[1] = -0.0f;
  const ManifoldMemory back = ManifoldMemories{m}[0];
  for (const float number : {back.twist_impulse, back.energy, back.rolling_impulse_W[1]})
    EXPECT_EQ(std::bit_cast<std::uint32_t>(number), 0x80000000u);
}

TEST(ManifoldMemories, WrittenIntoRoomThatWasMadeAreTheSame) {
  const std::vector<ManifoldMemory> all = samples();
  ManifoldMemories list{memory(7, 8, 2)};
  list.arrange(all.size(), [&](std::size_t i) { return ManifoldMemories::Layout{all[i].point_count}; });
  for (std::size_t i = all.size(); i-- > 0;) {
    list.set_energy(i, all[i].energy);
    list.put(i, all[i]);
  }
  EXPECT_EQ(list, ManifoldMemories(all));
  EXPECT_NE(list, ManifoldMemories{memory(7, 8, 2)});
}

TEST(ManifoldMemories, FindTheFirstKeyThatIsNotLess) {
  const ManifoldMemories list{memory(0, 1, 1), memory(0, 4, 2), memory(2, 3, 0)};
  EXPECT_EQ(list.find_from({0, 0, 0, 0, 0}), 0u);
  EXPECT_EQ(list.find_from({0, 4, 3, 4, 5}), 1u);
  EXPECT_EQ(list.find_from({0, 4, 3, 4, 6}), 2u);
  EXPECT_EQ(list.find_from({9, 0, 0, 0, 0}), 3u);
  EXPECT_EQ(ManifoldMemories{}.find_from({}), 0u);
}

TEST(ManifoldMemories, HaveANumberBehindTheFriction) {
  // Lanes load four at once; of the last memory too.
  ManifoldMemory m;
  m.shape_A = m.shape_B = 0;
  m.friction_impulse_W = {1, 2, 3};
  const ManifoldMemories list{m};
  const ManifoldMemories::View view = list.view(0);
  ASSERT_TRUE(view.is_there());
  EXPECT_EQ(view.friction_impulse_W[2], 3);
  EXPECT_EQ(view.friction_impulse_W[3], 0);
  EXPECT_EQ(view.rolling_impulse_W, nullptr);
}

TEST(ManifoldMemories, GrowOnlyWherePressedBefore) {
  // The first pressed before, the second was near, the third was not there.
  ManifoldMemory near = memory(1, 2, 2);
  near.normal_impulse = {};
  const ManifoldMemories before{memory(0, 1, 2), near},
      now{memory(0, 1, 3), memory(1, 2, 2), memory(1, 3, 1)};
  const ManifoldMemories longer = now.scaled_since(before, 100);
  EXPECT_EQ(longer[0], now.scaled(100)[0]);
  EXPECT_EQ(longer[1], now[1]);
  EXPECT_EQ(longer[2], now[2]);
  // All become less.
  EXPECT_EQ(now.scaled_since(before, 0.5f), now.scaled(0.5f));
}

}  // namespace
}  // namespace rigor::manifold_memories_test
