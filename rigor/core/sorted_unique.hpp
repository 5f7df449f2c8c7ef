#pragma once

#include <algorithm>
#include <functional>
#include <vector>

namespace rigor {

/// The items in ascending order, each once. Of items that are equal but differ in what `equal` does not
/// compare, one remains.
template <class T, class Less = std::less<>, class Equal = std::equal_to<>>
std::vector<T> sorted_unique(std::vector<T> items, const Less& less = {}, const Equal& equal = {}) {
  std::sort(items.begin(), items.end(), less);
  items.erase(std::unique(items.begin(), items.end(), equal), items.end());
  return items;
}

}  // namespace rigor
