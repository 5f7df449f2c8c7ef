#include "rigor/sim/event_driven/event_queue.hpp"

#include <algorithm>

namespace rigor {

namespace {

/// Heap order of the standard library: the largest comes first, so "later" is "larger".
bool is_later(const QueuedEvent& a, const QueuedEvent& b) {
  return b.is_before(a);
}

}  // namespace

void EventQueue::push(const QueuedEvent& event) {
  heap_.push_back(event);
  std::push_heap(heap_.begin(), heap_.end(), is_later);
}

void EventQueue::pop() {
  std::pop_heap(heap_.begin(), heap_.end(), is_later);
  heap_.pop_back();
}

void EventQueue::restore() {
  std::make_heap(heap_.begin(), heap_.end(), is_later);
}

}  // namespace rigor
