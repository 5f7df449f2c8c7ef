#pragma once

/// Declares functions of lanes once for each target: kernels are compiled in files of their own,
/// name_avx2.cpp and name_portable.cpp, each in the namespace of its target
/// (docs/decisions/0012-simd-by-target-files.md).
#if defined(__x86_64__)
#define RIGOR_FOR_LANE_TARGETS(...) \
  namespace portable_lanes {        \
  __VA_ARGS__                       \
  }                                 \
  namespace avx2_lanes {            \
  __VA_ARGS__                       \
  }
#else
#define RIGOR_FOR_LANE_TARGETS(...) \
  namespace portable_lanes {        \
  __VA_ARGS__                       \
  }                                 \
  namespace avx2_lanes = portable_lanes;
#endif
