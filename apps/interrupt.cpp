#include "apps/interrupt.hpp"

#include <array>
#include <cstddef>

namespace rigor {

namespace {

constexpr std::array signals = {SIGINT, SIGTERM, SIGHUP};

// A signal handler can reach nothing but a variable of the whole program.
volatile std::sig_atomic_t interrupt_count = 0;

void note_interrupt(int signal) {
  // The next signal has its default effect.
  std::signal(signal, SIG_DFL);
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

}  // namespace rigor
