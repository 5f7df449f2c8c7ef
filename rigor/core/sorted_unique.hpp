#pragma once

#include "rigor/core/index.hpp"

#include <algorithm>
#include <functional>
#include <vector>

namespace rigor {

/// The items in ascending order, each once. Of items that are equal but differ in parts that `equal` does not
/// compare, one remains.
template <class T, class Less = std::less<>, class Equal = std::equal_to<>>
std::vector<T> sorted_unique(std::vector<T> items, const Less& less = {}, const Equal& equal = {}) {
  std::sort(items.begin(), items.end(), less);
  items.erase(std::unique(items.begin(), items.end(), equal), items.end());
  return items;
}

/// Whether the item is in the list, which is in ascending order.
inline bool holds(const std::vector<int>& ascending, int item) {
  return std::binary_search(ascending.begin(), ascending.end(), item);
}

/// Position of the item in the list, which is in ascending order and contains it; otherwise the position
/// where it would be inserted.
inline std::size_t place_of(const std::vector<int>& ascending, int item) {
  return at(std::lower_bound(ascending.begin(), ascending.end(), item) - ascending.begin());
}

}  // namespace rigor
