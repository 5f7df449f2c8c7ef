#include "rigor/bulk/narrow_phase/pair_hints.hpp"

#include "rigor/core/index.hpp"

#include <algorithm>

namespace rigor {

std::size_t PairHints::find_before(const ShapePair& pair) const {
  if (is_same_) return 0;
  const auto found = std::lower_bound(before_.keys.begin(), before_.keys.end(), key_of(pair));
  return at(found - before_.keys.begin());
}

void PairHints::forget(const std::vector<char>& has_changed) {
  for (std::size_t k = 0; k < now_.keys.size(); ++k) {
    const std::uint64_t both = now_.keys[k].bodies;
    if (has_changed[both >> 32] != 0 || has_changed[both & 0xffffffffu] != 0) now_.hints[k] = {};
  }
}

PairHint& PairHints::take_from_before(const ShapePair& pair, int number, std::size_t& from) {
  // Both lists are in the order of keys: one pass over each.
  const std::size_t k = at(number);
  const Key key = key_of(pair);
  while (from < before_.keys.size() && before_.keys[from] < key) ++from;
  const bool is_known = from < before_.keys.size() && before_.keys[from] == key;
  now_.keys[k] = key;
  now_.hints[k] = is_known ? before_.hints[from] : PairHint{};
  return now_.hints[k];
}

}  // namespace rigor
