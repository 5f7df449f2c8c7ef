#include "rigor/bulk/threads/executor.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

namespace rigor::executor_test {
namespace {

/// The ranges of a loop, ascending.
std::vector<std::pair<int, int>> ranges_of(const Executor& executor, int count, int grain) {
  std::mutex mutex;
  std::vector<std::pair<int, int>> ranges;
  executor.for_ranges(count, grain, [&](int begin, int end) {
    const std::lock_guard<std::mutex> lock(mutex);
    ranges.emplace_back(begin, end);
  });
  std::sort(ranges.begin(), ranges.end());
  return ranges;
}

TEST(Executor, RangesMakeUpTheLoopAndHaveAtLeastAGrain) {
  for (const int threads : {1, 2, 3, 8}) {
    const Executor executor(threads);
    for (const int count : {0, 1, 7, 64, 1000, 100003}) {
      for (const int grain : {1, 10, 64}) {
        int end = 0;
        for (const auto& [begin, range_end] : ranges_of(executor, count, grain)) {
          EXPECT_EQ(begin, end);
          EXPECT_GE(range_end - begin, std::min(grain, count));
          end = range_end;
        }
        EXPECT_EQ(end, count) << threads << " threads, grain " << grain;
      }
    }
  }
}

TEST(Executor, OneThreadIsTheCallersAndOneRange) {
  const Executor executor(1);
  const std::thread::id own = std::this_thread::get_id();
  int calls = 0;
  executor.for_ranges(1000, 1, [&](int begin, int end) {
    EXPECT_EQ(std::this_thread::get_id(), own);
    EXPECT_EQ(end - begin, 1000);
    ++calls;
  });
  EXPECT_EQ(calls, 1);
}

TEST(Executor, ResultsAreTheSameForAnyNumberOfThreads) {
  const auto results = [](int threads) {
    const Executor executor(threads);
    std::vector<float> values(20000);
    for (int pass = 0; pass < 20; ++pass) {
      executor.for_ranges(static_cast<int>(values.size()), 16, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) {
          float& value = values[static_cast<std::size_t>(i)];
          value = std::sin(value + static_cast<float>(i + pass));
        }
      });
    }
    return values;
  };
  const std::vector<float> alone = results(1);
  for (const int threads : {2, 3, 8}) EXPECT_EQ(results(threads), alone) << threads;
}

TEST(Executor, TwoThreadsWorkAtOnce) {
  if (std::thread::hardware_concurrency() < 2) GTEST_SKIP() << "one processor";
  const Executor executor(2);
  // Each range waits until another one has begun: alone, the first would wait to the deadline.
  std::atomic<int> begun = 0;
  std::atomic<bool> met = false;
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  executor.for_ranges(2, 1, [&](int, int) {
    ++begun;
    while (begun < 2 && std::chrono::steady_clock::now() < deadline) std::this_thread::yield();
    if (begun >= 2) met = true;
  });
  EXPECT_TRUE(met);
}

TEST(Executor, ATeamRunsTheSameLoops) {
  for (const int threads : {1, 2, 3, 8}) {
    const Executor executor(threads);
    const Executor::Team team(executor);
    for (const int count : {0, 1, 7, 64, 1000, 100003}) {
      int end = 0;
      for (const auto& [begin, range_end] : ranges_of(executor, count, 10)) {
        EXPECT_EQ(begin, end);
        EXPECT_GE(range_end - begin, std::min(10, count));
        end = range_end;
      }
      EXPECT_EQ(end, count) << threads << " threads";
    }
  }
}

TEST(Executor, ATeamDoesEachRoundOfManyShortLoopsOnceAndInOrder) {
  const Executor executor(2);
  std::vector<int> values(256, 0);
  for (int step = 0; step < 20; ++step) {
    const Executor::Team team(executor);
    for (int loop = 0; loop < 500; ++loop) {
      executor.for_ranges(static_cast<int>(values.size()), 16, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) {
          int& value = values[static_cast<std::size_t>(i)];
          value = value == 500 * step + loop ? value + 1 : -1;
        }
      });
    }
  }
  EXPECT_EQ(values, std::vector<int>(256, 20 * 500));
}

TEST(Executor, TwoOfATeamWorkAtOnce) {
  if (std::thread::hardware_concurrency() < 2) GTEST_SKIP() << "one processor";
  const Executor executor(2);
  const Executor::Team team(executor);
  std::atomic<int> begun = 0;
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  executor.for_ranges(2, 1, [&](int, int) {
    ++begun;
    while (begun < 2 && std::chrono::steady_clock::now() < deadline) std::this_thread::yield();
  });
  EXPECT_EQ(begun, 2);
  EXPECT_LT(std::chrono::steady_clock::now(), deadline);
}

TEST(Executor, BothOfTwoAreRun) {
  for (const int threads : {1, 2, 8}) {
    const Executor executor(threads);
    for (const bool has_team : {false, true}) {
      const std::unique_ptr<Executor::Team> team =
          has_team ? std::make_unique<Executor::Team>(executor) : nullptr;
      for (int round = 0; round < 50; ++round) {
        std::atomic<int> one = 0, other = 0;
        const auto count_up = [&](std::atomic<int>& sum) {
          executor.for_ranges(100, 1, [&](int begin, int end) { sum += end - begin; });
        };
        executor.run_both([&] { count_up(one); }, [&] { count_up(other); });
        EXPECT_EQ(one, 100) << threads << " threads";
        EXPECT_EQ(other, 100) << threads << " threads";
      }
    }
  }
}

TEST(Executor, WhatOneOfTwoThrowsComesOut) {
  const Executor executor(2);
  const Executor::Team team(executor);
  const auto fail = [] { throw std::runtime_error("failed"); };
  EXPECT_THROW(executor.run_both(fail, [] {}), std::runtime_error);
  EXPECT_THROW(executor.run_both([] {}, fail), std::runtime_error);
}

TEST(Executor, ALoopInALoopOfATeamRunsAlone) {
  const Executor executor(2);
  const Executor::Team team(executor);
  std::atomic<int> rounds = 0;
  executor.for_ranges(8, 1, [&](int begin, int end) {
    for (int i = begin; i < end; ++i)
      executor.for_ranges(10, 1, [&](int first, int last) { rounds += last - first; });
  });
  EXPECT_EQ(rounds, 80);
}

TEST(Executor, WhatABodyOfATeamThrowsComesOutAndTheNextLoopRuns) {
  const Executor executor(3);
  const Executor::Team team(executor);
  EXPECT_THROW(executor.for_ranges(100, 1, [](int, int) { throw std::runtime_error("broken"); }),
               std::runtime_error);
  std::atomic<int> rounds = 0;
  executor.for_ranges(100, 1, [&](int begin, int end) { rounds += end - begin; });
  EXPECT_EQ(rounds, 100);
}

TEST(Executor, WhatABodyThrowsComesOut) {
  for (const int threads : {1, 3}) {
    const Executor executor(threads);
    EXPECT_THROW(executor.for_ranges(100, 1, [](int, int) { throw std::runtime_error("broken"); }),
                 std::runtime_error);
  }
}

}  // namespace
}  // namespace rigor::executor_test
