#include "rigor/bulk/contacts/tilt_kernels.hpp"
#include "rigor/bulk/lanes/fused_floats.hpp"
#include "rigor/bulk/lanes/lane_bits.hpp"
#include "rigor/core/index.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

#if defined(__x86_64__)

#include "rigor/bulk/lanes/avx2_begin.inl"

namespace rigor::avx2_lanes {

#include "rigor/bulk/lanes/fused_lanes.inl"

#include "rigor/bulk/contacts/tilt_kernels.inl"

}  // namespace rigor::avx2_lanes

#include "rigor/bulk/lanes/avx2_end.inl"

#endif
