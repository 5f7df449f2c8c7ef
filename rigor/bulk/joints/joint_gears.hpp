#pragma once

#include "rigor/bulk/joints/joint_lanes.hpp"

namespace rigor {

/// Gears of a block: (coordinate of the second joint) = ratio (of the first), but for whole turns.
std::vector<GearLanes> make_gears(const Model& model, const JointSystems& systems);

/// Residuals of the gears: by how much they will be off after the time h [s], over h.
void set_gear_errors(float h, JointBlock& block);
/// The same: their rates.
void set_gear_drifts(JointBlock& block);

}  // namespace rigor
