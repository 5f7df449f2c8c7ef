#include "rigor/core/interrupt.hpp"

#include <memory>
#include <mutex>
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

std::function<bool()> shared_interrupt() {
  if (present_interrupt == nullptr || !*present_interrupt) return {};
  return [interrupt = present_interrupt, turn = std::make_shared<std::mutex>()] {
    const std::lock_guard<std::mutex> lock(*turn);
    return (*interrupt)();
  };
}

void poll_interrupt() {
  if (present_interrupt != nullptr && *present_interrupt && (*present_interrupt)()) throw Interrupted();
}

}  // namespace rigor
