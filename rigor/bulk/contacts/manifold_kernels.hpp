#pragma once

#include "rigor/bulk/lanes/lane_namespaces.hpp"
#include "rigor/bulk/matching/manifold_blocks.hpp"

#include <span>

namespace rigor {

/// What fill_block(), warm_start_block(), solve_block() and find_spring_energies() are for one target; for
/// all block_kinds.
RIGOR_FOR_LANE_TARGETS(
    template <BlockKind kind>
    void fill(std::span<const BlockLane> lanes, const BulkBodies& bodies, ManifoldBlock<kind>& block);
    template <BlockKind kind> void warm_start(ManifoldBlock<kind>& block, BulkBodies& bodies);
    template <BlockKind kind>
    void solve(BlockPass pass, float h, ManifoldBlock<kind>& block, BulkBodies& bodies);
    template <BlockKind kind>
    void find_spring_energies(const ManifoldBlock<kind>& block, const BlockImpulses<kind>& total,
                              const BulkBodies& bodies, const SpringStep& step, LaneArray& energies);)

/// instantiate(index) for each of block_kinds.
#define RIGOR_FOR_BLOCK_KINDS(instantiate) \
  instantiate(0);                          \
  instantiate(1);                          \
  instantiate(2);                          \
  instantiate(3);                          \
  instantiate(4);                          \
  instantiate(5);                          \
  instantiate(6)
static_assert(block_kind_count == 7);

}  // namespace rigor
