#pragma once

#include <atomic>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>

namespace rigor {

/// A loop whose ranges are taken by any thread that comes: the one that runs it, and others that wait for
/// loops meanwhile. It is done when all ranges are, whether or not another thread came, so it never waits for
/// a thread that the machine has not started.
class SharedLoop {
 public:
  using Body = std::function<void(int, int)>;
  static constexpr int most_ranges = 0xffff;

  /// Calls body(begin, end) for `ranges` (1 to most_ranges) of [0, count). Only one thread may call it at a
  /// time. What a body throws is thrown from here when all are done.
  void run(int count, int ranges, const Body& body);
  /// Takes part in all loops until close(); for the other threads.
  void help();
  void close() { is_closed_.store(true, std::memory_order_release); }
  void open() { is_closed_.store(false, std::memory_order_relaxed); }
  /// Whether a loop is running: one inside it has to run alone.
  bool is_running() const { return is_running_.load(std::memory_order_relaxed); }

 private:
  bool take_range();

  /// The number of the loop in the upper half, below it how many ranges it has and which is the next: a
  /// thread that comes late takes no range of the next loop.
  alignas(64) std::atomic<std::uint64_t> ticket_{0};
  alignas(64) std::atomic<int> done_{0};
  std::atomic<bool> is_closed_{false}, is_running_{false};
  const Body* body_ = nullptr;
  int count_ = 0;
  std::uint32_t number_ = 0;
  std::mutex error_mutex_;
  std::exception_ptr error_;
};

}  // namespace rigor
