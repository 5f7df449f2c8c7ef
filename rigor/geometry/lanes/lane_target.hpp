#pragma once

namespace rigor {

/// The instruction set that a function with lanes uses. The results do not depend on it.
enum class LaneTarget {
  portable,
  avx2  ///< AVX2 and FMA.
};

/// The best instruction set that this processor has.
inline LaneTarget best_lane_target() {
#if defined(__x86_64__)
  static const bool has_avx2 = __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0;
  return has_avx2 ? LaneTarget::avx2 : LaneTarget::portable;
#else
  return LaneTarget::portable;
#endif
}

}  // namespace rigor
