#include "rigor/core/interrupt.hpp"

#include <utility>

namespace rigor {

namespace {

thread_local const std::function<bool()>* present_interrupt = nullptr;

}  // namespace

InterruptScope::InterruptScope(const std::function<bool()>& interrupt)
    : outer_(std::exchange(present_interrupt, &interrupt)) {}

InterruptScope::~InterruptScope() {
  present_interrupt = outer_;
}

void poll_interrupt() {
  if (present_interrupt != nullptr && *present_interrupt && (*present_interrupt)()) throw Interrupted();
}

}  // namespace rigor
