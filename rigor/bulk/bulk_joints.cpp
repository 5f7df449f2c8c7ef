#include "rigor/bulk/bulk_joints.hpp"

#include "rigor/bulk/joint_block.hpp"
#include "rigor/bulk/joint_errors.hpp"
#include "rigor/bulk/joint_gears.hpp"

#include <algorithm>

namespace rigor {

namespace {

using Block = BulkJointBlock;

/// Turns that trees and the joints that close loops of them take.
constexpr int kLoopTurns = 8;

}  // namespace

struct BulkJoints::Blocks {
  const Model* model = nullptr;
  LaneTarget target = LaneTarget::portable;
  float h = 0;
  std::vector<Block> trees, closing;
  std::vector<BulkGear> gears;

  JointEffort effort() const { return {*model, h, target}; }

  void solve(bool before_displacements, BulkBodies& bodies, Block& block) const {
    if (!block.stirs) return;
    find_joint_records(bodies, block);
    if (before_displacements) {
      solve_before_displacements(effort(), block);
    } else {
      solve_after_displacements(effort(), block);
    }
  }
};

BulkJoints::BulkJoints(const Model& model, LaneTarget target) : blocks_(std::make_unique<Blocks>()) {
  blocks_->model = &model;
  blocks_->target = target;
  JointForest forest = make_joint_forest(model);
  std::vector<int> gears;
  for (JointTrees& trees : forest.trees) blocks_->trees.push_back(make_joint_block(std::move(trees)));
  for (const int joint : forest.closing) {
    if (model.joint(joint).type == JointType::gear) {
      gears.push_back(joint);
    } else {
      blocks_->closing.push_back(make_joint_block(
          single_joint_tree(model, joint, forest.has_coordinates[static_cast<std::size_t>(joint)])));
    }
  }
  std::vector<Block*> all;
  for (std::vector<Block>* blocks : {&blocks_->trees, &blocks_->closing}) {
    for (Block& block : *blocks) all.push_back(&block);
  }
  for (const int gear : gears) blocks_->gears.push_back(make_bulk_gear(model, gear, all));
}

BulkJoints::~BulkJoints() = default;

void BulkJoints::prepare(const BulkBodies& bodies, double h, const Executor& executor) {
  blocks_->h = static_cast<float>(h);
  const auto prepare_range = [&](std::vector<Block>& blocks, int begin, int end) {
    for (int i = begin; i < end; ++i) {
      prepare_joint_block(blocks_->effort(), bodies, blocks[static_cast<std::size_t>(i)]);
    }
  };
  executor.for_ranges(static_cast<int>(blocks_->trees.size()), 1,
                      [&](int begin, int end) { prepare_range(blocks_->trees, begin, end); });
  prepare_range(blocks_->closing, 0, static_cast<int>(blocks_->closing.size()));
}

void BulkJoints::solve(bool before_displacements, BulkBodies& bodies, const Executor& executor) {
  const bool has_loops = !blocks_->closing.empty() || !blocks_->gears.empty();
  const int turns = has_loops ? kLoopTurns : 1;
  for (int turn = 0; turn < turns; ++turn) {
    for (Block& block : blocks_->closing) blocks_->solve(before_displacements, bodies, block);
    executor.for_ranges(static_cast<int>(blocks_->trees.size()), 1, [&](int begin, int end) {
      for (int i = begin; i < end; ++i) {
        blocks_->solve(before_displacements, bodies, blocks_->trees[static_cast<std::size_t>(i)]);
      }
    });
    for (BulkGear& gear : blocks_->gears) solve_gear(blocks_->effort(), before_displacements, gear);
  }
}

void BulkJoints::take_back_change(BulkBodies& bodies) const {
  for (const std::vector<Block>* blocks : {&blocks_->trees, &blocks_->closing}) {
    for (const Block& block : *blocks) {
      if (!block.stirs) continue;
      for (std::size_t i = 0; i < block.made.size(); ++i) {
        const Block::Made& made = block.made[i];
        for (int lane = 0; lane < kLaneCount; ++lane) {
          const int body = block.lanes.trees.bodies[i][static_cast<std::size_t>(lane)];
          if (body < 0 || !bodies.is_dynamic(body)) continue;
          float* record = bodies.motion[static_cast<std::size_t>(body)].v;
          record[0] -= made.v.x[lane];
          record[1] -= made.v.y[lane];
          record[2] -= made.v.z[lane];
          record[4] -= made.w.x[lane];
          record[5] -= made.w.y[lane];
          record[6] -= made.w.z[lane];
        }
      }
    }
  }
}

void BulkJoints::read_impulses(const BulkBodies& bodies, std::vector<float>& impulses) const {
  impulses.resize(6 * blocks_->model->joints().size(), 0);
  for (const std::vector<Block>* blocks : {&blocks_->trees, &blocks_->closing}) {
    for (const Block& block : *blocks) {
      for (std::size_t i = 0; i < block.lanes.joints.size(); ++i) {
        const JointLink& link = block.lanes.trees.links[i];
        for (int lane = 0; lane < kLaneCount; ++lane) {
          const int joint = link.joints[static_cast<std::size_t>(lane)];
          if (joint < 0 || !bodies.is_dynamic(block.lanes.trees.bodies[i][static_cast<std::size_t>(lane)]))
            continue;
          for (int r = 0; r < row_count(link); ++r) {
            impulses[static_cast<std::size_t>(6 * joint + r)] = block.lanes.joints[i].impulse[r][lane];
          }
        }
      }
    }
  }
}

std::pair<double, int> BulkJoints::worst_error(const BulkBodies& bodies) const {
  std::pair<double, int> worst{0, -1};
  const Model& model = *blocks_->model;
  for (int i = 0; i < static_cast<int>(model.joints().size()); ++i) {
    const Joint& joint = model.joint(i);
    if (joint.type == JointType::gear) continue;
    const double lever = std::max({joint.X_AJ.p.norm(), joint.X_BK.p.norm(), model.length_scale()});
    const double error =
        joint_error(joint, bulk_pose(bodies, joint.body_A), bulk_pose(bodies, joint.body_B), lever);
    if (error > worst.first) worst = {error, i};
  }
  return worst;
}

}  // namespace rigor
