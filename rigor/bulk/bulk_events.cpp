#include "rigor/bulk/bulk_events.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <tuple>

namespace rigor {

namespace {

std::tuple<int, int, int, int> key_of(const ContactEvent& event) {
  return {event.body_A, event.body_B, event.shape_A, event.shape_B};
}

/// The pairs that press, each with its impulse.
std::vector<ContactEvent> pressing_pairs(const std::vector<ManifoldMemory>& memory, ContactEvent::Kind kind) {
  std::vector<ContactEvent> pairs;
  for (const ManifoldMemory& manifold : memory) {
    float impulse = 0;
    for (int i = 0; i < manifold.point_count; ++i)
      impulse += manifold.normal_impulse[static_cast<std::size_t>(i)];
    if (!(impulse > 0)) continue;
    const ContactEvent pair{kind,   manifold.body_A, manifold.body_B, manifold.shape_A, manifold.shape_B,
                            impulse};
    if (!pairs.empty() && key_of(pairs.back()) == key_of(pair)) {
      pairs.back().normal_impulse += impulse;
    } else {
      pairs.push_back(pair);
    }
  }
  return pairs;
}

}  // namespace

std::vector<ContactEvent> contact_events(const std::vector<ManifoldMemory>& before,
                                         const std::vector<ManifoldMemory>& after) {
  const std::vector<ContactEvent> old_pairs = pressing_pairs(before, ContactEvent::Kind::end);
  const std::vector<ContactEvent> new_pairs = pressing_pairs(after, ContactEvent::Kind::begin);
  std::vector<ContactEvent> events;
  std::size_t i = 0, k = 0;
  while (i < old_pairs.size() || k < new_pairs.size()) {
    const bool has_both = i < old_pairs.size() && k < new_pairs.size();
    if (has_both && key_of(old_pairs[i]) == key_of(new_pairs[k])) {
      ++i, ++k;
    } else if (k == new_pairs.size() || (has_both && key_of(old_pairs[i]) < key_of(new_pairs[k]))) {
      events.push_back(old_pairs[i++]);
    } else {
      events.push_back(new_pairs[k++]);
    }
  }
  return events;
}

std::vector<ContactEvent> find_hits(const std::vector<ContactEvent>& events, float least_impulse) {
  std::vector<ContactEvent> hits;
  std::copy_if(events.begin(), events.end(), std::back_inserter(hits), [&](const ContactEvent& event) {
    return event.kind == ContactEvent::Kind::begin && event.normal_impulse >= least_impulse;
  });
  return hits;
}

}  // namespace rigor
