#include "rigor/bulk/pair_filter.hpp"

#include <algorithm>

namespace rigor {

PairFilter::PairFilter(const Model& model) {
  const std::size_t count = static_cast<std::size_t>(model.body_count());
  std::vector<std::vector<int>> partners(count);
  for (const auto& [a, b] : model.excluded_pairs()) {
    partners[static_cast<std::size_t>(a)].push_back(b);
    partners[static_cast<std::size_t>(b)].push_back(a);
  }
  for (std::size_t i = 0; i < count; ++i) {
    const Body& body = model.bodies()[i];
    const int begin = static_cast<int>(excluded_.size());
    std::sort(partners[i].begin(), partners[i].end());
    excluded_.insert(excluded_.end(), partners[i].begin(), partners[i].end());
    entries_.push_back({body.group, body.mask, begin, static_cast<int>(excluded_.size())});
  }
}

/// In the shorter of the two lists.
bool PairFilter::is_excluded(int a, int b) const {
  const Entry *list = &entries_[static_cast<std::size_t>(a)], *other = &entries_[static_cast<std::size_t>(b)];
  int wanted = b;
  if (other->excluded_end - other->excluded_begin < list->excluded_end - list->excluded_begin) {
    list = other;
    wanted = a;
  }
  return std::binary_search(excluded_.begin() + list->excluded_begin, excluded_.begin() + list->excluded_end,
                            wanted);
}

}  // namespace rigor
