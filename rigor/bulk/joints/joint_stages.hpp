#pragma once

#include "rigor/bulk/joints/joint_lanes.hpp"
#include "rigor/geometry/lanes/lane_target.hpp"

#include <array>

namespace rigor {

/// Where the bodies of a slot are: records of 16 floats (v, 1/m, ω, 0, dp, 0, dr, 0).
using JointRecords = std::array<float*, 8>;

/// Reads the bodies of all slots.
void load_slots(const std::vector<JointRecords>& records, LaneTarget target, JointBlock& block);
/// Writes the velocities of the bodies that joints move.
void store_slots(const std::vector<JointRecords>& records, LaneTarget target, const JointBlock& block);

enum class JointStage {
  aim,             ///< Rows of the joints where the bodies are.
  factor,          ///< Factors of all articulated inertias.
  rates,           ///< Rates and mobilities of the rows of joints with laws.
  position_error,  ///< Residuals: by how much positions will be off after the time h, and the laws.
  drift,           ///< Residuals: the rates.
  solve,           ///< Takes the residuals away.
};
/// One stage of the work on the slots of a block; h [s].
void run_stage(JointStage stage, float h, LaneTarget target, JointBlock& block);

}  // namespace rigor
