#pragma once

#include "rigor/bulk/lanes/list_room.hpp"
#include "rigor/bulk/narrow_phase/collide_polytopes.hpp"
#include "rigor/bulk/narrow_phase/narrow_phase.hpp"
#include "rigor/core/index.hpp"

#include <compare>
#include <cstdint>
#include <vector>

namespace rigor {

/// Where the narrow phase found the answer for a pair in the previous call, and so looks first. It never
/// changes an answer, only the time.
struct PairHint {
  Vec3f n = Vec3f::Zero();  ///< A direction from A to B that separated the pair, or 0.
  AxisCode axis = 0;        ///< The axis of cores that touched; not 0 if they did.
};

/// The hints of the pairs that need them, by their indices among these pairs, handed on from one list of
/// pairs to the next: both are in the order of (body_A, body_B, shape_A, shape_B).
class PairHints {
 public:
  /// Pairs in a block; the index of the first hint of each block is kept.
  static constexpr int block = 128;

  /// Begins a list of pairs; the current one becomes the list before it. needs_hint(pair) has the same answer
  /// for a pair of shapes each time.
  template <class NeedsHint>
  void begin(const std::vector<ShapePair>& pairs, const NeedsHint& needs_hint);
  /// How many pairs before this block need hints; there is one entry more than there are blocks.
  int first_of(int block_number) const { return first_[at(block_number)]; }
  /// Takes over the hint of the pair as the one of this index. `from` is where to look in the list before:
  /// find_before() for the first of several pairs, and then left where the next one continues. May be called
  /// from several threads at once. If the pairs are the same as before, the hint is already in its place.
  PairHint& take_over(const ShapePair& pair, int number, std::size_t& from) {
    return is_same_ ? now_.hints[at(number)] : take_from_before(pair, number, from);
  }
  std::size_t find_before(const ShapePair& pair) const;
  /// Forgets the hints of pairs of bodies that have changed: has_changed, by body.
  void forget(const std::vector<char>& has_changed);

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
  // Counts the hints before each block, and compares the pairs with those before: in what rests they are the
  // same, and nothing is moved.
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
  // Otherwise hints are taken over one by one.
  std::swap(now_, before_);
  renew(at(count), now_.keys);
  renew(at(count), now_.hints);
}

}  // namespace rigor
