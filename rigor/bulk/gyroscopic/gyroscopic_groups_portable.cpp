#include "rigor/bulk/gyroscopic/gyroscopic_groups.hpp"
#include "rigor/bulk/lanes/fused_floats.hpp"
#include "rigor/bulk/lanes/lane_bits.hpp"

#include <cstring>

#include "rigor/bulk/lanes/portable_begin.inl"

namespace rigor::portable_lanes {

#include "rigor/bulk/lanes/fused_lanes.inl"

#include "rigor/bulk/lanes/rotation_lanes.inl"

#include "rigor/bulk/gyroscopic/gyroscopic_kernels.inl"

#include "rigor/bulk/gyroscopic/gyroscopic_groups.inl"

}  // namespace rigor::portable_lanes
