#include "rigor/core/sorted_unique.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <utility>
#include <vector>

namespace rigor::sorted_unique_test {
namespace {

TEST(SortedUnique, EachItemIsThereOnceInAscendingOrder) {
  EXPECT_EQ(sorted_unique(std::vector<int>{3, 1, 2, 3, 1}), (std::vector<int>{1, 2, 3}));
  EXPECT_TRUE(sorted_unique(std::vector<int>{}).empty());
}

TEST(SortedUnique, TheOrderMayBeAnother) {
  EXPECT_EQ(sorted_unique(std::vector<int>{1, 3, 2, 3}, std::greater<>()), (std::vector<int>{3, 2, 1}));
}

TEST(SortedUnique, OfEqualItemsTheFirstInOrderRemains) {
  using Item = std::pair<int, int>;
  const auto is_same = [](const Item& a, const Item& b) { return a.first == b.first; };
  EXPECT_EQ(sorted_unique(std::vector<Item>{{2, 5}, {1, 7}, {2, 4}}, std::less<>(), is_same),
            (std::vector<Item>{{1, 7}, {2, 4}}));
}

}  // namespace
}  // namespace rigor::sorted_unique_test
