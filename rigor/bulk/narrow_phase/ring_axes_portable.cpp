#include "rigor/bulk/lanes/fused_floats.hpp"
#include "rigor/bulk/lanes/lane_bits.hpp"
#include "rigor/bulk/narrow_phase/ring_axes.hpp"

#include <cstring>

#include "rigor/bulk/lanes/portable_begin.inl"

namespace rigor::portable_lanes {

#include "rigor/bulk/lanes/fused_lanes.inl"

#include "rigor/bulk/narrow_phase/ring_axes.inl"

}  // namespace rigor::portable_lanes
