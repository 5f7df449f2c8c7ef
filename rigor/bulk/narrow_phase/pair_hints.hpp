#pragma once

#include "rigor/bulk/lanes/list_room.hpp"
#include "rigor/bulk/narrow_phase/collide_polytopes.hpp"
#include "rigor/bulk/narrow_phase/narrow_phase.hpp"
#include "rigor/core/index.hpp"

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

/// The hints of those pairs that need them, by their numbers among these; handed on from one list of pairs to
/// the next: both are in the order of (body_A, body_B, shape_A, shape_B).
class PairHints {
 public:
  /// Pairs of which the first number is kept.
  static constexpr int block = 128;

  /// Begins a list of pairs; what was is the list before it. needs_hint(pair): of a pair of shapes always the
  /// same.
  template <class NeedsHint>
  void begin(const std::vector<ShapePair>& pairs, const NeedsHint& needs_hint);
  /// How many pairs before this block need hints; blocks: one more than there are.
  int first_of(int block_number) const { return first_[at(block_number)]; }
  /// Takes over the hint of the pair as the one of this number. from: where in the list before to look, for
  /// the first pair of several find_before(); it goes on with them. From several threads at once. If the list
  /// is the one before, it is there.
  PairHint& take_over(const ShapePair& pair, int number, std::size_t& from) {
    return is_same_ ? now_.hints[at(number)] : take_from_before(pair, number, from);
  }
  std::size_t find_before(const ShapePair& pair) const;

 private:
  PairHint& take_from_before(const ShapePair& pair, int number, std::size_t& from);
  struct Key {
    std::uint64_t bodies, shapes;
    auto operator<=>(const Key&) const = default;
  };
  struct List {
    std::vector<Key> keys;
    std::vector<PairHint> hints;
  };
  static Key key_of(const ShapePair& pair) {
    const auto both = [](int first, int second) {
      return std::uint64_t{static_cast<std::uint32_t>(first)} << 32 | static_cast<std::uint32_t>(second);
    };
    return {both(pair.body_A, pair.body_B), both(pair.shape_A, pair.shape_B)};
  }

  List now_, before_;
  std::vector<int> first_;
  bool is_same_ = false;
};

template <class NeedsHint>
void PairHints::begin(const std::vector<ShapePair>& pairs, const NeedsHint& needs_hint) {
  first_.clear();
  int count = 0;
  is_same_ = true;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    if (k % block == 0) first_.push_back(count);
    if (!needs_hint(pairs[k])) continue;
    const std::size_t number = at(count++);
    is_same_ = is_same_ && number < now_.keys.size() && now_.keys[number] == key_of(pairs[k]);
  }
  first_.push_back(count);
  is_same_ = is_same_ && now_.keys.size() == at(count);
  if (is_same_) return;
  std::swap(now_, before_);
  renew(at(count), now_.keys);
  renew(at(count), now_.hints);
}

}  // namespace rigor
