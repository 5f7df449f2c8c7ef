#include "rigor/bulk/joints/joint_stages.hpp"

#include "rigor/bulk/joints/joint_factors.hpp"
#include "rigor/bulk/joints/joint_gears.hpp"
#include "rigor/bulk/joints/joint_stage_kernels.hpp"

namespace rigor {

namespace {

void add_changes(JointBlock& block) {
  for (std::size_t s = 0; s < block.systems.moved; ++s) add_change(block.slots[s]);
}

}  // namespace

void load_slots(const std::vector<JointRecords>& records, LaneTarget target, JointBlock& block) {
  target == LaneTarget::avx2 ? avx2_lanes::load_all(records, block)
                             : portable_lanes::load_all(records, block);
}

void store_slots(const std::vector<JointRecords>& records, LaneTarget target, const JointBlock& block) {
  target == LaneTarget::avx2 ? avx2_lanes::store_all(records, block)
                             : portable_lanes::store_all(records, block);
}

void run_stage(JointStage stage, float h, LaneTarget target, JointBlock& block) {
  // What each joint and body does, in lanes.
  target == LaneTarget::avx2 ? avx2_lanes::run_stage_in_lanes(stage, h, block)
                             : portable_lanes::run_stage_in_lanes(stage, h, block);
  if (stage == JointStage::position_error || stage == JointStage::drift)
    block.is_position_error = stage == JointStage::position_error;

  // What joins several joints: gears, and the equations of systems that are no trees.
  if (stage == JointStage::position_error) set_gear_errors(h, block);
  if (stage == JointStage::drift) set_gear_drifts(block);
  if (block.loops && stage == JointStage::factor) block.loops->factor(block);
  if (block.loops && stage == JointStage::solve) {
    block.loops->solve(block);
    add_changes(block);
  }
}

}  // namespace rigor
