#pragma once

#include "rigor/bulk/collide_polytopes.hpp"
#include "rigor/bulk/narrow_phase.hpp"

#include <compare>
#include <cstdint>
#include <vector>

namespace rigor {

/// Where the narrow phase found its answer of a pair in the call before, and so looks first. It changes no
/// answer, only the time.
struct PairHint {
  Vec3f n = Vec3f::Zero();  ///< A direction from A to B that parted the pair, or 0.
  AxisCode axis = 0;        ///< Of cores that touched; not 0 if they did.
};

/// The hints of all pairs, handed on from one list of pairs to the next: both are in the order of
/// (body_A, body_B, shape_A, shape_B).
class PairHints {
 public:
  /// Begins a list of pairs; what was is the list before it.
  void begin(const std::vector<ShapePair>& pairs);
  /// Takes over the hints of the pairs [begin, end); of disjoint ranges from several threads at once. If the
  /// list is the one before, they are there.
  void take_over(const std::vector<ShapePair>& pairs, int begin, int end);
  PairHint& of(int pair) { return now_.hints[static_cast<std::size_t>(pair)]; }

 private:
  struct Key {
    std::uint64_t bodies, shapes;
    auto operator<=>(const Key&) const = default;
  };
  struct List {
    std::vector<Key> keys;
    std::vector<PairHint> hints;
  };
  static Key key_of(const ShapePair& pair);

  List now_, before_;
  bool is_same_ = false;
};

}  // namespace rigor
