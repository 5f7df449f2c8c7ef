// The kernels of blocks for each target: the same text, compiled twice.

#include "rigor/bulk/lanes/lane_bits.hpp"
#include "rigor/bulk/matching/manifold_blocks.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <span>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace rigor {

namespace {

/// Fastest at which overlaps are put back [m/s]: a deep one is not an explosion.
constexpr float max_push_speed = 3;
/// The points of a manifold are solved this often one after the other: near enough to a block.
constexpr int block_sweeps = 3;

namespace portable_lanes {
#define RIGOR_LANES_HAVE_FMA 0
#include "rigor/bulk/lanes/fused_lanes.inl"

#include "rigor/bulk/contacts/manifold_kernels.inl"

#include "rigor/bulk/contacts/manifold_fill.inl"
#undef RIGOR_LANES_HAVE_FMA
}  // namespace portable_lanes

#if defined(__x86_64__)
#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("avx2,fma"))), apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx2,fma")
#endif
namespace avx2_lanes {
#define RIGOR_LANES_HAVE_FMA 1
#include "rigor/bulk/lanes/fused_lanes.inl"

#include "rigor/bulk/contacts/manifold_kernels.inl"

#include "rigor/bulk/contacts/manifold_fill.inl"
#undef RIGOR_LANES_HAVE_FMA
}  // namespace avx2_lanes
#if defined(__clang__)
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif
#else
namespace avx2_lanes = portable_lanes;
#endif

}  // namespace

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

// For all kinds.
#define RIGOR_BLOCK_KERNELS(kind)                                                             \
  template void fill_block(LaneTarget, std::span<const BlockLane>, const BulkBodies&,         \
                           ManifoldBlock<block_kinds[kind]>&);                                \
  template void warm_start_block(LaneTarget, ManifoldBlock<block_kinds[kind]>&, BulkBodies&); \
  template void solve_block(LaneTarget, BlockPass, float, ManifoldBlock<block_kinds[kind]>&, BulkBodies&)
static_assert(block_kind_count == 7);
RIGOR_BLOCK_KERNELS(0);
RIGOR_BLOCK_KERNELS(1);
RIGOR_BLOCK_KERNELS(2);
RIGOR_BLOCK_KERNELS(3);
RIGOR_BLOCK_KERNELS(4);
RIGOR_BLOCK_KERNELS(5);
RIGOR_BLOCK_KERNELS(6);
#undef RIGOR_BLOCK_KERNELS

}  // namespace rigor
