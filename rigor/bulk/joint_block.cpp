#include "rigor/bulk/joint_block.hpp"

#include "rigor/math/rotation.hpp"
#include "rigor/model/force.hpp"

#include <numbers>

namespace rigor {

Pose bulk_pose(const BulkBodies& bodies, int body) {
  if (body == world_body) return {};
  return {rotation_matrix(bodies.q[static_cast<std::size_t>(body)]),
          bodies.x[static_cast<std::size_t>(body)]};
}

namespace {

/// A joint at the begin of a step, in W.
struct JointStart {
  Vec3 arm_A, arm_B, offset;
  Quat J = Quat::Identity(), K = Quat::Identity();  ///< Where rows need them.
};
JointStart start_of(const Joint& joint, bool has_laws, const BulkBodies& bodies) {
  const Pose X_WA = bulk_pose(bodies, joint.body_A), X_WB = bulk_pose(bodies, joint.body_B);
  JointStart start;
  start.arm_A = X_WA.R * joint.X_AJ.p;
  start.arm_B = X_WB.R * joint.X_BK.p;
  start.offset = (X_WB.p - X_WA.p) + start.arm_B - start.arm_A;
  if (joint.type != JointType::distance && (has_laws || joint.type != JointType::ball)) {
    start.J = quaternion_of(X_WA.R * joint.X_AJ.R);
    start.K = quaternion_of(X_WB.R * joint.X_BK.R);
  }
  return start;
}

void set_lane(const Vec3& a, int lane, FloatVec3& to) {
  to.x[lane] = static_cast<float>(a.x());
  to.y[lane] = static_cast<float>(a.y());
  to.z[lane] = static_cast<float>(a.z());
}
void set_lane(const Quat& q, int lane, FloatQuat& to) {
  to.w[lane] = static_cast<float>(q.w());
  set_lane(Vec3(q.vec()), lane, to.v);
}
void set_lane(const Mat3& m, int lane, FloatSym3& to) {
  to.xx[lane] = static_cast<float>(m(0, 0));
  to.yy[lane] = static_cast<float>(m(1, 1));
  to.zz[lane] = static_cast<float>(m(2, 2));
  to.xy[lane] = static_cast<float>(m(0, 1));
  to.xz[lane] = static_cast<float>(m(0, 2));
  to.yz[lane] = static_cast<float>(m(1, 2));
}

void set_lane(const Joint& joint, const JointStart& start, int lane, JointLanes& to) {
  set_lane(start.arm_A, lane, to.arm_A);
  set_lane(start.arm_B, lane, to.arm_B);
  set_lane(start.offset, lane, to.offset);
  set_lane(start.J, lane, to.J);
  set_lane(start.K, lane, to.K);
  to.length[lane] = static_cast<float>(joint.length);
  to.lead[lane] = static_cast<float>(joint.pitch / (2 * std::numbers::pi));
}

/// Whether a slot has no body that joints move in this lane: none at all, or one that sleeps.
bool is_empty(const BulkJointBlock& block, std::size_t slot, int lane, const BulkBodies& bodies) {
  if (slot >= block.lanes.trees.links.size()) return false;
  const int body = block.lanes.trees.bodies[slot][static_cast<std::size_t>(lane)];
  return body < 0 || !bodies.is_dynamic(body);
}

/// A lane without a body: of unit mass, at rest.
void set_empty_lane(int lane, JointSlot& slot) {
  slot.mass[lane] = slot.inverse_mass[lane] = 1;
  set_lane(Mat3(Mat3::Identity()), lane, slot.inertia);
  set_lane(Mat3(Mat3::Identity()), lane, slot.inverse_inertia);
}

void set_lane(const InverseInertia& inverse, int lane, JointSlot& slot) {
  Mat3 I;
  I << inverse.xx, inverse.xy, inverse.xz, inverse.xy, inverse.yy, inverse.yz, inverse.xz, inverse.yz,
      inverse.zz;
  slot.inverse_mass[lane] = inverse.inv_mass;
  set_lane(I, lane, slot.inverse_inertia);
  // What does not give way is a parent only: its resistance is not asked for.
  const bool gives_way = inverse.inv_mass > 0;
  slot.mass[lane] = gives_way ? 1 / inverse.inv_mass : 1;
  set_lane(gives_way ? Mat3(I.inverse()) : Mat3(Mat3::Identity()), lane, slot.inertia);
}

}  // namespace

BulkJointBlock make_joint_block(JointTrees trees) {
  BulkJointBlock block;
  block.lanes.trees = std::move(trees);
  block.lanes.slots.resize(block.lanes.trees.bodies.size(), JointSlot{});
  block.lanes.joints.resize(block.lanes.trees.links.size(), JointLanes{});
  block.records.resize(block.lanes.slots.size());
  block.before.resize(block.lanes.trees.links.size(), BulkJointBlock::Made{});
  block.made = block.before;
  for (std::size_t i = 0; i < block.lanes.trees.links.size(); ++i) {
    const JointLink& link = block.lanes.trees.links[i];
    if (!link.has_joint || !link.has_laws) continue;
    block.lanes.has_laws = true;
    const int held = held_row_count(link.type, true);
    for (int r = held; r < row_count(link); ++r) {
      const int axis = r - held < coordinate_count(link.type) ? r - held : -1;
      block.laws.push_back({static_cast<int>(i), r, axis});
    }
  }
  return block;
}

void prepare_joint_block(const JointEffort& effort, const BulkBodies& bodies, BulkJointBlock& block) {
  const Model& model = effort.model;
  block.stirs = false;
  for (const std::array<int, 8>& slot : block.lanes.trees.bodies) {
    for (const int body : slot) block.stirs = block.stirs || (body >= 0 && bodies.is_dynamic(body));
  }
  if (!block.stirs) return;
  block.empty = {};
  for (std::size_t s = 0; s < block.lanes.slots.size(); ++s) {
    for (int lane = 0; lane < kLaneCount; ++lane) {
      const int body = block.lanes.trees.bodies[s][static_cast<std::size_t>(lane)];
      if (is_empty(block, s, lane, bodies)) {
        set_empty_lane(lane, block.lanes.slots[s]);
      } else if (body < 0) {
        // The world is an inertia of zeros.
        set_lane(InverseInertia{}, lane, block.lanes.slots[s]);
      } else {
        set_lane(bodies.inertia[static_cast<std::size_t>(body)], lane, block.lanes.slots[s]);
      }
    }
  }
  for (std::size_t i = 0; i < block.lanes.joints.size(); ++i) {
    JointLanes& joint = block.lanes.joints[i];
    for (int lane = 0; lane < kLaneCount; ++lane) {
      const int index = block.lanes.trees.links[i].joints[static_cast<std::size_t>(lane)];
      if (index >= 0) {
        set_lane(model.joint(index),
                 start_of(model.joint(index), block.lanes.trees.links[i].has_laws, bodies), lane, joint);
      } else {
        joint.J.w[lane] = joint.K.w[lane] = 1;
      }
    }
    for (int r = 0; r < kMostJointRows; ++r) {
      joint.softness[r] = float_lanes(1);
      joint.on[r] = joint.given[r] = joint.impulse[r] = float_lanes(0);
    }
  }
  for (JointSlot& slot : block.lanes.slots) slot.dp = slot.dr = FloatVec3{};
  run_stage(JointStage::aim, effort.h, effort.target, block.lanes);
  run_stage(JointStage::factor, effort.h, effort.target, block.lanes);
  block.is_new_substep = true;
}

void find_joint_records(BulkBodies& bodies, BulkJointBlock& block) {
  for (std::size_t s = 0; s < block.records.size(); ++s) {
    for (std::size_t lane = 0; lane < 8; ++lane) {
      const int body = block.lanes.trees.bodies[s][lane];
      float* record = block.nothing.data();
      if (is_empty(block, s, static_cast<int>(lane), bodies)) {
        record = block.empty[lane].data();
      } else if (body >= 0) {
        static_assert(sizeof(bodies.motion[0]) == 16 * sizeof(float));
        record = bodies.motion[static_cast<std::size_t>(body)].v;
      }
      block.records[s][lane] = record;
    }
  }
}

}  // namespace rigor
