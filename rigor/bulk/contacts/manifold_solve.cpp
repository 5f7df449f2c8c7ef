// The kernels of blocks, by target: manifold_fill_*.cpp, manifold_sweep_*.cpp and manifold_energy_*.cpp.

#include "rigor/bulk/contacts/manifold_kernels.hpp"

namespace rigor {

template <BlockKind kind>
void fill_block(LaneTarget target, std::span<const BlockLane> lanes, const BulkBodies& bodies,
                ManifoldBlock<kind>& block) {
  target == LaneTarget::avx2 ? avx2_lanes::fill(lanes, bodies, block)
                             : portable_lanes::fill(lanes, bodies, block);
}
template <BlockKind kind>
void warm_start_block(LaneTarget target, ManifoldBlock<kind>& block, BulkBodies& bodies) {
  target == LaneTarget::avx2 ? avx2_lanes::warm_start(block, bodies)
                             : portable_lanes::warm_start(block, bodies);
}
template <BlockKind kind>
void solve_block(LaneTarget target, BlockPass pass, float h, ManifoldBlock<kind>& block, BulkBodies& bodies) {
  target == LaneTarget::avx2 ? avx2_lanes::solve(pass, h, block, bodies)
                             : portable_lanes::solve(pass, h, block, bodies);
}
template <BlockKind kind>
void find_spring_energies(LaneTarget target, const ManifoldBlock<kind>& block,
                          const BlockImpulses<kind>& total, const BulkBodies& bodies, const SpringStep& step,
                          LaneArray& energies) {
  target == LaneTarget::avx2 ? avx2_lanes::find_spring_energies(block, total, bodies, step, energies)
                             : portable_lanes::find_spring_energies(block, total, bodies, step, energies);
}

#define RIGOR_INSTANTIATE(index)                                                                            \
  template void fill_block(LaneTarget, std::span<const BlockLane>, const BulkBodies&,                       \
                           ManifoldBlock<block_kinds[index]>&);                                             \
  template void warm_start_block(LaneTarget, ManifoldBlock<block_kinds[index]>&, BulkBodies&);              \
  template void solve_block(LaneTarget, BlockPass, float, ManifoldBlock<block_kinds[index]>&, BulkBodies&); \
  template void find_spring_energies(LaneTarget, const ManifoldBlock<block_kinds[index]>&,                  \
                                     const BlockImpulses<block_kinds[index]>&, const BulkBodies&,           \
                                     const SpringStep&, LaneArray&)
RIGOR_FOR_BLOCK_KINDS(RIGOR_INSTANTIATE);
#undef RIGOR_INSTANTIATE

}  // namespace rigor
