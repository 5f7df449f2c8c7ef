#pragma once

#include "rigor/geometry/broad_phase/broad_phase_method.hpp"
#include "rigor/geometry/shape/aabb.hpp"

#include <memory>
#include <vector>

namespace rigor {

/// Boxes with ids, and queries for those that overlap a given box. The answers depend on the boxes alone, not
/// on the method or on the calls that led there. Boxes may be unbounded.
class BroadPhase {
 public:
  virtual ~BroadPhase() = default;
  /// Inserts the box of the item, or replaces the box it had. id ≥ 0 and small (it is used as an index).
  virtual void set(int id, const Aabb& box) = 0;
  /// Removes the item; nothing happens if it is not there.
  virtual void remove(int id) = 0;
  /// Ids of all items whose box overlaps or touches the given one, in ascending order, into a buffer of the
  /// caller, which is cleared first.
  virtual void overlapping(const Aabb& box, std::vector<int>& ids) const = 0;
};

/// An empty broad phase of the given method.
std::unique_ptr<BroadPhase> make_broad_phase(BroadPhaseMethod method);

/// A box with the id of its item.
struct BoxItem {
  int id;
  Aabb box;
};

/// Two items, the lower id first.
struct BoxPair {
  int a, b;

  auto operator<=>(const BoxPair& other) const = default;
};

}  // namespace rigor
