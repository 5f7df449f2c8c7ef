#pragma once

#include "rigor/model/manifold_memory.hpp"

#include <vector>

namespace rigor {

/// Two shapes began to press on each other in a step, or ceased to.
struct ContactEvent {
  enum class Kind { begin, end };
  Kind kind = Kind::begin;
  int body_A = -1, body_B = -1;    ///< Model indices, body_A < body_B.
  int shape_A = -1, shape_B = -1;  ///< Of these bodies.
  /// Sum of the normal impulses of its points in the last substep, after the solve [N s]: of a begin in this
  /// step, of an end in the step before.
  float normal_impulse = 0;

  bool operator==(const ContactEvent& other) const = default;
};

/// What became of the contacts from one step to the next, in the order of their keys. Both lists are in the
/// order of keys, as BulkWorld::memory() is. Shapes whose points carry no impulse do not press, however near
/// they are; a pair with several manifolds is one pair. Contacts that begin and end between the last substeps
/// of two steps are not seen.
std::vector<ContactEvent> contact_events(const std::vector<ManifoldMemory>& before,
                                         const std::vector<ManifoldMemory>& after);

/// Contacts that began with at least this impulse [N s].
std::vector<ContactEvent> find_hits(const std::vector<ContactEvent>& events, float least_impulse);

}  // namespace rigor
