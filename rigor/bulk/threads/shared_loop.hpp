#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>

namespace rigor {

/// A loop whose ranges are taken by any thread that comes: the one that runs it, and others that wait for
/// loops meanwhile. It is done when all ranges are, whether or not another thread came, so it never waits for
/// a thread that the machine has not started.
///
/// Each member, which is a thread, has a stretch of the ranges, the same one of every loop, and takes those
/// of others when its own are done: loops over the same things find them in the cache of their processor.
class SharedLoop {
 public:
  using Body = std::function<void(int, int)>;
  static constexpr int most_ranges = 0xffff, most_members = 64;

  /// Calls body(begin, end) for `ranges` (1 to most_ranges) of [0, count). Only one thread, which is member
  /// 0, may call it at a time. What a body throws is thrown from here when all are done.
  void run(int count, int ranges, const Body& body);
  /// Takes part in all loops until close(); for the other threads, whose numbers are 1 and on.
  void help(int member);
  /// Before other threads help: how many members there are, with the one that calls run() [1 to
  /// most_members].
  void set_members(int count) { members_ = count; }
  void close() { is_closed_.store(true, std::memory_order_release); }
  void open() { is_closed_.store(false, std::memory_order_relaxed); }
  /// Whether a loop is running: one inside it has to run alone.
  bool is_running() const { return is_running_.load(std::memory_order_relaxed); }

 private:
  bool take_range(int member);
  bool take_range_of(int member);

  /// The stretch of a member: the number of the loop in the upper half, below it the end of its ranges and
  /// which is the next. A thread that comes late takes no range of the next loop.
  struct alignas(64) Stretch {
    std::atomic<std::uint64_t> ticket{0};
  };
  std::array<Stretch, most_members> stretches_;
  alignas(64) std::atomic<int> done_{0};
  std::atomic<bool> is_closed_{false}, is_running_{false};
  const Body* body_ = nullptr;
  int count_ = 0, ranges_ = 0, members_ = 1;
  std::uint32_t number_ = 0;
  std::mutex error_mutex_;
  std::exception_ptr error_;
};

}  // namespace rigor
