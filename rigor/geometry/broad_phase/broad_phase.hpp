#pragma once

#include "rigor/geometry/broad_phase/broad_phase_method.hpp"
#include "rigor/geometry/shape/aabb.hpp"

#include <memory>
#include <vector>

namespace rigor {

/// Boxes by number, and which of them overlap a given one. What it answers depends on the boxes alone, not on
/// the method or on the calls that led there. Boxes may be unbounded.
class BroadPhase {
 public:
  virtual ~BroadPhase() = default;
  /// Puts the box of the item in, or replaces the box it had. id ≥ 0, small (used as an index).
  virtual void set(int id, const Aabb& box) = 0;
  /// Takes the item out; nothing happens if it is not there.
  virtual void remove(int id) = 0;
  /// Ids of all items whose box overlaps or touches, in ascending order, into a buffer of the caller (cleared
  /// first).
  virtual void overlapping(const Aabb& box, std::vector<int>& ids) const = 0;
};

/// An empty one.
std::unique_ptr<BroadPhase> make_broad_phase(BroadPhaseMethod method);

/// A box with its number.
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
