#include "rigor/bulk/bulk_joints.hpp"

#include "rigor/bulk/joint_block.hpp"
#include "rigor/bulk/joint_errors.hpp"
#include "rigor/math/rotation.hpp"

#include <algorithm>

namespace rigor {

struct BulkJoints::Blocks {
  const Model* model = nullptr;
  LaneTarget target = LaneTarget::portable;
  float h = 0;
  std::vector<BulkJointBlock> blocks;
  std::vector<int> moved;  ///< A dynamic body of each joint.

  JointEffort effort() const { return {*model, h, target}; }

  template <class Work>
  void for_each(const Executor& executor, const Work& work) {
    executor.for_ranges(static_cast<int>(blocks.size()), 1, [&](int begin, int end) {
      for (int i = begin; i < end; ++i) work(blocks[static_cast<std::size_t>(i)]);
    });
  }
};

BulkJoints::BulkJoints(const Model& model, LaneTarget target) : blocks_(std::make_unique<Blocks>()) {
  blocks_->model = &model;
  blocks_->target = target;
  for (int joint = 0; joint < static_cast<int>(model.joints().size()); ++joint) {
    const std::vector<int> bodies = model.bodies_of_joint(joint);
    const auto is_dynamic = [&](int body) { return model.body(body).motion == MotionType::dynamic; };
    const auto found = std::find_if(bodies.begin(), bodies.end(), is_dynamic);
    blocks_->moved.push_back(found == bodies.end() ? bodies.front() : *found);
  }
  JointForest forest = make_joint_forest(model);
  for (JointSystems& systems : forest.systems) {
    blocks_->blocks.push_back(make_joint_block(model, std::move(systems)));
  }
}

BulkJoints::~BulkJoints() = default;

void BulkJoints::prepare(BulkBodies& bodies, double h, const Executor& executor) {
  blocks_->h = static_cast<float>(h);
  blocks_->for_each(executor,
                    [&](BulkJointBlock& block) { prepare_joint_block(blocks_->effort(), bodies, block); });
}

void BulkJoints::solve(JointPass pass, const Executor& executor) {
  blocks_->for_each(executor, [&](BulkJointBlock& block) {
    if (!block.stirs) return;
    if (pass == JointPass::rates) {
      solve_after_displacements(blocks_->effort(), block);
    } else {
      solve_before_displacements(blocks_->effort(), pass == JointPass::places_anew, block);
    }
  });
}

void BulkJoints::read_impulses(const BulkBodies& bodies, std::vector<float>& impulses) const {
  impulses.resize(6 * blocks_->model->joints().size(), 0);
  for (const BulkJointBlock& block : blocks_->blocks) {
    for (std::size_t i = 0; i < block.lanes.joints.size(); ++i) {
      const JointLink& link = block.lanes.systems.links[i];
      for (int lane = 0; lane < kLaneCount; ++lane) {
        const int joint = link.joints[static_cast<std::size_t>(lane)];
        if (joint < 0 || !bodies.is_dynamic(blocks_->moved[static_cast<std::size_t>(joint)])) continue;
        for (int r = 0; r < row_count(link); ++r) {
          impulses[static_cast<std::size_t>(6 * joint + r)] = block.lanes.joints[i].impulse[r][lane];
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
    const BodyPlace A = place_of(bodies, joint.body_A), B = place_of(bodies, joint.body_B);
    double error = 0;
    if (joint.type == JointType::ball) {
      error = ((B.x - A.x) + B.q * joint.X_BK.p - A.q * joint.X_AJ.p).norm();
    } else {
      const double lever = std::max({joint.X_AJ.p.norm(), joint.X_BK.p.norm(), model.length_scale()});
      error = joint_error(joint, {rotation_matrix(A.q), A.x}, {rotation_matrix(B.q), B.x}, lever);
    }
    if (error > worst.first) worst = {error, i};
  }
  return worst;
}

}  // namespace rigor
