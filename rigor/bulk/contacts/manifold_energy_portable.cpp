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

#include "rigor/bulk/contacts/manifold_energy.inl"

#define RIGOR_INSTANTIATE(index)                                                                  \
  template void find_spring_energies(const ManifoldBlock<block_kinds[index]>&,                    \
                                     const BlockImpulses<block_kinds[index]>&, const BulkBodies&, \
                                     const SpringStep&, LaneArray&)
RIGOR_FOR_BLOCK_KINDS(RIGOR_INSTANTIATE);
#undef RIGOR_INSTANTIATE

}  // namespace rigor::portable_lanes
