#pragma once

#include "rigor/bulk/narrow_phase/narrow_phase.hpp"

#include <cstring>

namespace rigor::test {

/// Of what a manifold has; points that it does not have may differ.
inline bool are_same_bits(const PairManifold& a, const PairManifold& b) {
  if (a.pair != b.pair || a.part != b.part || a.manifold.point_count != b.manifold.point_count) return false;
  if (std::memcmp(a.manifold.normal, b.manifold.normal, sizeof a.manifold.normal) != 0) return false;
  const std::size_t count = static_cast<std::size_t>(a.manifold.point_count);
  return std::memcmp(a.manifold.points.data(), b.manifold.points.data(), count * sizeof(ManifoldPoint)) == 0;
}

}  // namespace rigor::test
