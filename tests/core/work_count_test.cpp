#include "rigor/core/work_count.hpp"

#include <gtest/gtest.h>

#include <thread>

namespace rigor {
namespace {

TEST(WorkCount, EachThreadCountsItsOwn) {
  const std::uint64_t before = work_counted();
  count_work(7);
  std::uint64_t of_other = 0;
  std::thread other([&] {
    count_work(5);
    of_other = work_counted();
  });
  other.join();
  EXPECT_EQ(of_other, 5u);
  count_work(1);
  EXPECT_EQ(work_counted() - before, 8u);
}

}  // namespace
}  // namespace rigor
