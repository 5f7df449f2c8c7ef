#pragma once

#include "rigor/bulk/joints/joint_stages.hpp"
#include "rigor/bulk/lanes/lane_namespaces.hpp"

#include <vector>

namespace rigor {

/// What load_slots(), store_slots() and run_stage() are for one target, gears and loops aside.
RIGOR_FOR_LANE_TARGETS(void load_all(const std::vector<JointRecords>& records, JointBlock& block);
                       void store_all(const std::vector<JointRecords>& records, const JointBlock& block);
                       void run_stage_in_lanes(JointStage stage, float h, JointBlock& block);)

}  // namespace rigor
