#include "rigor/bulk/pair_hints.hpp"

#include <algorithm>
#include <utility>

namespace rigor {

PairHints::Key PairHints::key_of(const ShapePair& pair) {
  const auto both = [](int first, int second) {
    return std::uint64_t{static_cast<std::uint32_t>(first)} << 32 | static_cast<std::uint32_t>(second);
  };
  return {both(pair.body_A, pair.body_B), both(pair.shape_A, pair.shape_B)};
}

void PairHints::begin(const std::vector<ShapePair>& pairs) {
  is_same_ = std::equal(pairs.begin(), pairs.end(), now_.keys.begin(), now_.keys.end(),
                        [](const ShapePair& pair, const Key& key) { return key_of(pair) == key; });
  if (is_same_) return;
  std::swap(now_, before_);
  now_.keys.resize(pairs.size());
  now_.hints.resize(pairs.size());
}

void PairHints::take_over(const std::vector<ShapePair>& pairs, int begin, int end) {
  if (is_same_ || begin == end) return;
  const std::size_t first = static_cast<std::size_t>(begin), last = static_cast<std::size_t>(end);
  auto old = std::lower_bound(before_.keys.begin(), before_.keys.end(), key_of(pairs[first]));
  for (std::size_t k = first; k < last; ++k) {
    const Key key = key_of(pairs[k]);
    while (old != before_.keys.end() && *old < key) ++old;
    const bool is_known = old != before_.keys.end() && *old == key;
    now_.keys[k] = key;
    now_.hints[k] =
        is_known ? before_.hints[static_cast<std::size_t>(old - before_.keys.begin())] : PairHint{};
  }
}

}  // namespace rigor
