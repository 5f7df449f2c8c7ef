#include "rigor/model/contact_key.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace rigor::contact_key_test {
namespace {

TEST(ContactKey, IsOrderedByBodiesThenShapesThenFeature) {
  const std::vector<ContactKey> ascending = {{0, 1, -2, -1, 0}, {0, 1, 0, 0, 0}, {0, 1, 0, 0, 1},
                                             {0, 1, 0, 1, 0},   {0, 1, 1, 0, 0}, {0, 2, 0, 0, 0},
                                             {1, 0, 0, 0, 0}};
  for (std::size_t i = 0; i < ascending.size(); ++i) {
    for (std::size_t k = 0; k < ascending.size(); ++k) {
      EXPECT_EQ(ascending[i] < ascending[k], i < k);
      EXPECT_EQ(ascending[i] == ascending[k], i == k);
    }
  }
}

}  // namespace
}  // namespace rigor::contact_key_test
