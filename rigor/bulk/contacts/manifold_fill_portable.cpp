#include "rigor/bulk/contacts/manifold_kernels.hpp"
#include "rigor/bulk/lanes/fused_floats.hpp"
#include "rigor/bulk/lanes/lane_bits.hpp"
#include "rigor/core/index.hpp"

#include <algorithm>
#include <cstddef>
#include <cstring>

#include "rigor/bulk/lanes/portable_begin.inl"

namespace rigor::portable_lanes {

#include "rigor/bulk/lanes/fused_lanes.inl"

#include "rigor/bulk/contacts/manifold_lanes.inl"

#include "rigor/bulk/contacts/manifold_fill.inl"

#define RIGOR_INSTANTIATE(index) \
  template void fill(std::span<const BlockLane>, const BulkBodies&, ManifoldBlock<block_kinds[index]>&)
RIGOR_FOR_BLOCK_KINDS(RIGOR_INSTANTIATE);
#undef RIGOR_INSTANTIATE

}  // namespace rigor::portable_lanes
