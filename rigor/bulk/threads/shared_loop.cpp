#include "rigor/bulk/threads/shared_loop.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"

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
  // All of the loop is written before its tickets are released: a thread that takes a range sees it.
  body_ = &body;
  count_ = count;
  ranges_ = ranges;
  is_running_.store(true, std::memory_order_relaxed);
  done_.store(0, std::memory_order_relaxed);
  ++number_;
  for (int member = members_; member-- > 0;) {
    const auto begin_of = [&](int k) { return static_cast<std::uint64_t>(ranges * k / members_); };
    stretches_[at(member)].ticket.store(
        std::uint64_t{number_} << 32 | begin_of(member + 1) << 16 | begin_of(member),
        std::memory_order_release);
  }
  // The calling thread takes ranges too, and then waits for those that others have taken.
  while (take_range(0)) {
  }
  for (SpinWait wait; done_.load(std::memory_order_acquire) < ranges;) wait.wait();
  is_running_.store(false, std::memory_order_relaxed);
  if (error_) std::rethrow_exception(std::exchange(error_, nullptr));
}

void SharedLoop::help(int member) {
  SpinWait wait;
  while (!is_closed_.load(std::memory_order_acquire)) {
    if (take_range(member))
      wait = {};
    else
      wait.wait();
  }
}

/// Takes the next range of the member's own stretch, or of the first after it that has any left, and runs it;
/// false if there is none.
bool SharedLoop::take_range(int member) {
  for (int k = 0; k < members_; ++k)
    if (take_range_of((member + k) % members_)) return true;
  return false;
}

bool SharedLoop::take_range_of(int member) {
  // The next range of the loop that the ticket names: if the loop has changed meanwhile, so has the ticket,
  // and the exchange fails.
  std::atomic<std::uint64_t>& own = stretches_[at(member)].ticket;
  std::uint64_t ticket = own.load(std::memory_order_acquire);
  int k = 0;
  do {
    const int end = static_cast<int>(ticket >> 16 & most_ranges);
    k = static_cast<int>(ticket & most_ranges);
    if (k >= end) return false;
  } while (!own.compare_exchange_weak(ticket, ticket + 1, std::memory_order_acq_rel));
  const auto begin_of = [&](int i) {
    return static_cast<int>(static_cast<std::int64_t>(count_) * i / ranges_);
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
