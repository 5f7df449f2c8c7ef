#pragma once

#include "rigor/bulk/state/bulk_contact.hpp"
#include "rigor/bulk/state/manifold_memories.hpp"
#include "rigor/math/types.hpp"

#include <cstddef>
#include <functional>
#include <vector>

namespace rigor {

struct BulkBodies;
class BulkContacts;

/// Calls visit(number, contact) for each contact of a step whose impulses were added up, in the order of
/// blocks. number: its own among the manifolds of the step; `bodies` are as they are at its end.
void read_contacts(const BulkContacts& contacts, const BulkBodies& bodies,
                   const std::function<void(std::size_t, const BulkContact&)>& visit);

/// The contacts that began in the step and approached at least at that speed [m/s].
std::vector<BulkContact> find_hits(const std::vector<BulkContact>& contacts, double least_speed);

/// Two shapes that did not press on each other before met in a step, faster than shapes that rest.
struct BulkImpact {
  int body_A = -1, body_B = -1;  ///< Model indices, body_A < body_B.
  Vec3 p_W;                      ///< Place at the beginning of the step [m].
  Vec3 j_W;  ///< Impulse on B in the whole step [N s]; an impact may last into the next one.
};

/// Two shapes began to press on each other in a step, or stopped doing so.
struct ContactEvent {
  enum class Kind { begin, end };
  Kind kind = Kind::begin;
  int body_A = -1, body_B = -1;    ///< Model indices, body_A < body_B.
  int shape_A = -1, shape_B = -1;  ///< Indices among the shapes of these bodies.
  /// Sum of the normal impulses of its points in the last substep, after the solve [N s]: of this step for a
  /// begin, of the previous step for an end.
  float normal_impulse = 0;

  bool operator==(const ContactEvent& other) const = default;
};

/// The contacts that began and ended from one step to the next, in the order of their keys. Both lists are in
/// the order of keys, as BulkWorld::memory() is. Shapes whose points carry no impulse do not press, however
/// near they are; a pair with several manifolds is one pair. Contacts that begin and end between the last
/// substeps of two steps are not seen.
std::vector<ContactEvent> contact_events(const ManifoldMemories& before, const ManifoldMemories& after);

}  // namespace rigor
