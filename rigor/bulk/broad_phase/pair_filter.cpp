#include "rigor/bulk/broad_phase/pair_filter.hpp"

#include "rigor/core/index.hpp"

#include <algorithm>

namespace rigor {

PairFilter::PairFilter(const Model& model) {
  const std::size_t count = at(model.body_count());
  // The excluded partners of each body, both ways.
  std::vector<std::vector<int>> partners(count);
  for (const auto& [a, b] : model.excluded_pairs()) {
    partners[at(a)].push_back(b);
    partners[at(b)].push_back(a);
  }
  // One list for all bodies, each with its section, ascending.
  for (std::size_t i = 0; i < count; ++i) {
    const Body& body = model.bodies()[i];
    const int begin = static_cast<int>(excluded_.size());
    std::sort(partners[i].begin(), partners[i].end());
    excluded_.insert(excluded_.end(), partners[i].begin(), partners[i].end());
    entries_.push_back({body.group, body.mask, begin, static_cast<int>(excluded_.size())});
  }
}

/// Searches the shorter of the two bodies' lists.
bool PairFilter::is_excluded(int a, int b) const {
  const Entry *list = &entries_[at(a)], *other = &entries_[at(b)];
  int wanted = b;
  if (other->excluded_end - other->excluded_begin < list->excluded_end - list->excluded_begin) {
    list = other;
    wanted = a;
  }
  return std::binary_search(excluded_.begin() + list->excluded_begin, excluded_.begin() + list->excluded_end,
                            wanted);
}

}  // namespace rigor
