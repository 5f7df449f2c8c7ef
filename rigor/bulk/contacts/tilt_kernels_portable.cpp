#include "rigor/bulk/contacts/tilt_kernels.hpp"
#include "rigor/bulk/lanes/fused_floats.hpp"
#include "rigor/bulk/lanes/lane_bits.hpp"
#include "rigor/core/index.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "rigor/bulk/lanes/portable_begin.inl"

namespace rigor::portable_lanes {

#include "rigor/bulk/lanes/fused_lanes.inl"

#include "rigor/bulk/contacts/tilt_kernels.inl"

}  // namespace rigor::portable_lanes
