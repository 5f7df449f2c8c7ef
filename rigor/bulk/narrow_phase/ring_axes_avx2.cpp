#include "rigor/bulk/lanes/fused_floats.hpp"
#include "rigor/bulk/lanes/lane_bits.hpp"
#include "rigor/bulk/narrow_phase/ring_axes.hpp"

#include <cstring>

#if defined(__x86_64__)

#include "rigor/bulk/lanes/avx2_begin.inl"

namespace rigor::avx2_lanes {

#include "rigor/bulk/lanes/fused_lanes.inl"

#include "rigor/bulk/narrow_phase/ring_axes.inl"

}  // namespace rigor::avx2_lanes

#include "rigor/bulk/lanes/avx2_end.inl"

#endif
