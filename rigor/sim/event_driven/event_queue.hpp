#pragma once

#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

namespace rigor {

/// An event that is due at a time. Stamps are the versions of the motions it was predicted from: an event
/// whose bodies have moved on since is stale.
struct QueuedEvent {
  /// In the order of events at one instant: where the leg of a path ends, its body moves along the next one
  /// before the steps that reach until there go on.
  enum class Kind : std::uint8_t { window_end, step_end, contact, search };

  double time;
  Kind kind;
  int a, b;  ///< contact, search: bodies, a < b; window_end: body, -1; step_end: island, -1.
  std::uint64_t stamp_a, stamp_b;
  double bracket;  ///< contact: half width of the time's bracket [s].

  /// A total order, so that what happens first never depends on how the queue was filled.
  bool is_before(const QueuedEvent& other) const {
    return std::tie(time, kind, a, b) < std::tie(other.time, other.kind, other.a, other.b);
  }
};

/// Events ordered by time; ties by kind and bodies.
class EventQueue {
 public:
  void push(const QueuedEvent& event);
  bool is_empty() const { return heap_.empty(); }
  const QueuedEvent& first() const { return heap_.front(); }
  void pop();
  void clear() { heap_.clear(); }
  std::size_t size() const { return heap_.size(); }
  /// Drops every event for which is_stale(event) holds.
  template <class Predicate>
  void drop_if(const Predicate& is_stale) {
    std::erase_if(heap_, is_stale);
    restore();
  }

 private:
  void restore();
  std::vector<QueuedEvent> heap_;
};

}  // namespace rigor
