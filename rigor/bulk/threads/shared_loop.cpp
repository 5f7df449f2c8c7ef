#include "rigor/bulk/threads/shared_loop.hpp"

#include "rigor/core/assert.hpp"

#include <thread>
#include <utility>

namespace rigor {

namespace {

/// Waits for a moment, at first only a pause of the processor; later the thread yields, so that the machine
/// may use its processor elsewhere.
class SpinWait {
 public:
  void wait() {
    constexpr int short_waits = 2000;
    if (++waits_ < short_waits) {
#if defined(__x86_64__)
      __builtin_ia32_pause();
#endif
      return;
    }
    std::this_thread::yield();
  }

 private:
  int waits_ = 0;
};

}  // namespace

void SharedLoop::run(int count, int ranges, const Body& body) {
  RIGOR_ASSERT(ranges >= 1 && ranges <= most_ranges);
  // All of the loop is written before its ticket is released: a thread that takes a range sees it.
  body_ = &body;
  count_ = count;
  is_running_.store(true, std::memory_order_relaxed);
  done_.store(0, std::memory_order_relaxed);
  ++number_;
  ticket_.store(std::uint64_t{number_} << 32 | static_cast<std::uint64_t>(ranges) << 16,
                std::memory_order_release);
  // The calling thread takes ranges too, and then waits for those that others have taken.
  while (take_range()) {
  }
  for (SpinWait wait; done_.load(std::memory_order_acquire) < ranges;) wait.wait();
  is_running_.store(false, std::memory_order_relaxed);
  if (error_) std::rethrow_exception(std::exchange(error_, nullptr));
}

void SharedLoop::help() {
  SpinWait wait;
  while (!is_closed_.load(std::memory_order_acquire)) {
    if (take_range())
      wait = {};
    else
      wait.wait();
  }
}

/// Takes the next range and runs it; false if there is none.
bool SharedLoop::take_range() {
  // The next range of the loop that the ticket names: if the loop has changed meanwhile, so has the ticket,
  // and the exchange fails.
  std::uint64_t ticket = ticket_.load(std::memory_order_acquire);
  int ranges = 0, k = 0;
  do {
    ranges = static_cast<int>(ticket >> 16 & most_ranges);
    k = static_cast<int>(ticket & most_ranges);
    if (k >= ranges) return false;
  } while (!ticket_.compare_exchange_weak(ticket, ticket + 1, std::memory_order_acq_rel));
  const auto begin_of = [&](int i) {
    return static_cast<int>(static_cast<std::int64_t>(count_) * i / ranges);
  };
  // The first exception is kept and thrown by run().
  try {
    (*body_)(begin_of(k), begin_of(k + 1));
  } catch (...) {
    const std::lock_guard<std::mutex> lock(error_mutex_);
    if (!error_) error_ = std::current_exception();
  }
  done_.fetch_add(1, std::memory_order_release);
  return true;
}

}  // namespace rigor
