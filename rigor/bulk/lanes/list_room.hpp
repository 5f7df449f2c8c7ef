#pragma once

#include <cstddef>
#include <vector>

namespace rigor {

// Lists that grow with the number of bodies take what they hold and an eighth, not up to twice that.

/// Makes room for so many elements in all.
template <class T>
void make_room(std::size_t count, std::vector<T>& list) {
  if (count > list.capacity()) list.reserve(count + count / 8);
}

/// So many elements; whoever calls writes them all anew. Old and new ones are never held at once.
template <class T>
void renew(std::size_t count, std::vector<T>& list) {
  if (count > list.capacity()) {
    list = std::vector<T>();
    list.reserve(count + count / 8);
  }
  list.resize(count);
}

/// Merges a short list into a longer one, both in order: from the last ones on, in place.
template <class T, class IsBefore>
void merge_into(const std::vector<T>& more, const IsBefore& is_before, std::vector<T>& list) {
  std::size_t left = list.size(), next = more.size();
  make_room(left + next, list);
  list.resize(left + next);
  while (next > 0) {
    const bool is_last = left == 0 || is_before(list[left - 1], more[next - 1]);
    list[left + next - 1] = is_last ? more[next - 1] : list[left - 1];
    --(is_last ? next : left);
  }
}

}  // namespace rigor
