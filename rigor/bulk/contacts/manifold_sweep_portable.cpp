#include "rigor/bulk/contacts/manifold_kernels.hpp"
#include "rigor/bulk/lanes/fused_floats.hpp"
#include "rigor/bulk/lanes/lane_bits.hpp"
#include "rigor/core/index.hpp"

#include <cstddef>
#include <cstring>

#include "rigor/bulk/lanes/portable_begin.inl"

namespace rigor::portable_lanes {

#include "rigor/bulk/lanes/fused_lanes.inl"

#include "rigor/bulk/contacts/manifold_lanes.inl"

#include "rigor/bulk/contacts/manifold_sweep.inl"

#define RIGOR_INSTANTIATE(index)                                                          \
  template void solve(BlockPass, float, ManifoldBlock<block_kinds[index]>&, BulkBodies&); \
  template void warm_start(ManifoldBlock<block_kinds[index]>&, BulkBodies&)
RIGOR_FOR_BLOCK_KINDS(RIGOR_INSTANTIATE);
#undef RIGOR_INSTANTIATE

}  // namespace rigor::portable_lanes
