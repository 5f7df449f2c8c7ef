#pragma once

#include "rigor/bulk/joint_block.hpp"

#include <vector>

namespace rigor {

/// The first coordinate of a joint, as a row of a block.
struct GearWheel {
  BulkJointBlock* block = nullptr;
  std::size_t link = 0;
  int row = 0, lane = 0;
};

/// A gear: (coordinate of the second) = ratio (of the first), but for whole turns.
struct BulkGear {
  GearWheel first, second;
  double ratio = 0;
  double period = 0;  ///< What whole turns add are multiples of this; 0: of anything, only rates are held.
};

/// The gear of that index, whose joints are among the blocks.
BulkGear make_bulk_gear(const Model& model, int gear, const std::vector<BulkJointBlock*>& blocks);

/// Holds the gear, before or after the displacements, without hurting the joints of its blocks: its impulse
/// is found from what an impulse of 1 does to them.
void solve_gear(const JointEffort& effort, bool before_displacements, BulkGear& gear);

}  // namespace rigor
