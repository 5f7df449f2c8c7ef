#include "rigor/bulk/contacts/manifold_kernels.hpp"
#include "rigor/bulk/lanes/fused_floats.hpp"
#include "rigor/bulk/lanes/lane_bits.hpp"
#include "rigor/core/index.hpp"

#include <cstddef>
#include <cstring>

#if defined(__x86_64__)

#include "rigor/bulk/lanes/avx2_begin.inl"

namespace rigor::avx2_lanes {

#include "rigor/bulk/lanes/fused_lanes.inl"

#include "rigor/bulk/contacts/manifold_lanes.inl"

#include "rigor/bulk/contacts/manifold_energy.inl"

#define RIGOR_INSTANTIATE(index)                                                                  \
  template void find_spring_energies(const ManifoldBlock<block_kinds[index]>&,                    \
                                     const BlockImpulses<block_kinds[index]>&, const BulkBodies&, \
                                     const SpringStep&, LaneArray&)
RIGOR_FOR_BLOCK_KINDS(RIGOR_INSTANTIATE);
#undef RIGOR_INSTANTIATE

}  // namespace rigor::avx2_lanes

#include "rigor/bulk/lanes/avx2_end.inl"

#endif
