#pragma once

#include "rigor/bulk/lanes/float_lanes.hpp"

namespace rigor {

/// One bit for each lane whose mask is set.
RIGOR_FLOAT_LANES unsigned lane_bits(const IntLanes& mask) {
#if defined(__SSE__)
  __m128 half[2];
  std::memcpy(half, &mask, sizeof half);
  return static_cast<unsigned>(_mm_movemask_ps(half[0]) | _mm_movemask_ps(half[1]) << 4);
#else
  unsigned bits = 0;
  for (int i = 0; i < kLaneCount; ++i) bits |= (mask[i] != 0 ? 1u : 0u) << i;
  return bits;
#endif
}

/// In all lanes the largest of them.
RIGOR_FLOAT_LANES FloatLanes spread_max(const FloatLanes& x) {
  const FloatLanes half = float_max(x, __builtin_shufflevector(x, x, 4, 5, 6, 7, 0, 1, 2, 3));
  const FloatLanes quarter = float_max(half, __builtin_shufflevector(half, half, 2, 3, 0, 1, 6, 7, 4, 5));
  return float_max(quarter, __builtin_shufflevector(quarter, quarter, 1, 0, 3, 2, 5, 4, 7, 6));
}

}  // namespace rigor
