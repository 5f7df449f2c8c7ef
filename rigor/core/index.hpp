#pragma once

#include <concepts>
#include <cstddef>

namespace rigor {

/// An index as containers want it: v[at(i)] is element i, for the signed integers that bodies, contacts,
/// vertices and triangles are numbered by. The index must not be negative.
template <std::integral Integer>
constexpr std::size_t at(Integer i) {
  return static_cast<std::size_t>(i);
}

}  // namespace rigor
