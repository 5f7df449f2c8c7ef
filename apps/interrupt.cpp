#include "apps/interrupt.hpp"

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

#include <time.h>

namespace rigor {

namespace {

constexpr std::array signals = {SIGINT, SIGTERM, SIGHUP};

/// Time that no one sets [ms].
std::int64_t milliseconds_now() {
  timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  return std::int64_t{now.tv_sec} * 1000 + now.tv_nsec / 1'000'000;
}

// A signal handler can reach nothing but variables of the whole program.
volatile std::sig_atomic_t interrupt_count = 0;
std::atomic<std::int64_t> interrupt_time = 0;  ///< Of the first one [ms].
static_assert(std::atomic<std::int64_t>::is_always_lock_free);

void note_interrupt(int signal) {
  // The next signal has its default effect.
  std::signal(signal, SIG_DFL);
  if (interrupt_count == 0) interrupt_time = milliseconds_now();
  interrupt_count = interrupt_count + 1;
}

}  // namespace

InterruptWatch::InterruptWatch() {
  interrupt_count = 0;
  struct sigaction action {};
  action.sa_handler = note_interrupt;
  for (std::size_t i = 0; i < signals.size(); ++i) {
    ::sigaction(signals[i], nullptr, &previous_[i]);
    // A signal that the caller has set to be ignored (nohup) stays ignored.
    if (previous_[i].sa_handler != SIG_IGN) ::sigaction(signals[i], &action, nullptr);
  }
}

InterruptWatch::~InterruptWatch() {
  for (std::size_t i = 0; i < signals.size(); ++i) ::sigaction(signals[i], &previous_[i], nullptr);
}

bool InterruptWatch::is_requested() const {
  return interrupt_count > 0;
}

bool InterruptWatch::is_requested_since(std::chrono::milliseconds time) const {
  return is_requested() && milliseconds_now() - interrupt_time >= time.count();
}

}  // namespace rigor
