#pragma once

#include <concepts>
#include <cstddef>
#include <type_traits>

namespace rigor {

/// An index as containers want it: v[at(i)] is element i, for the signed integers that number bodies,
/// contacts, vertices and triangles, and for enumerators. It must not be negative.
template <typename Index>
requires std::integral<Index> || std::is_enum_v<Index>
constexpr std::size_t at(Index i) {
  return static_cast<std::size_t>(i);
}

}  // namespace rigor
