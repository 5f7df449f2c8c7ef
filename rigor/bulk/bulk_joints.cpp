#include "rigor/bulk/bulk_joints.hpp"

#include "rigor/bulk/joint_errors.hpp"
#include "rigor/bulk/joint_laws.hpp"
#include "rigor/bulk/joint_stages.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/model/force.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigor {

namespace {

using LaneArray = std::array<float, kLaneCount>;

LaneArray read_lanes(const FloatLanes& lanes) {
  LaneArray values;
  store_floats(lanes, values.data());
  return values;
}

/// Times that a solve is repeated, against what turning makes of velocities.
constexpr int kCorrections = 2;
/// Changes of pieces of laws within a solve.
constexpr int kPieceChanges = 6;
/// Turns that trees and the joints that close loops of them take.
constexpr int kLoopTurns = 8;

Pose pose_of(const BulkBodies& bodies, int body) {
  if (body == world_body) return {};
  return {rotation_matrix(bodies.q[static_cast<std::size_t>(body)]),
          bodies.x[static_cast<std::size_t>(body)]};
}

/// A joint at the begin of a step, in W.
struct JointStart {
  Vec3 arm_A, arm_B, offset;
  Quat J, K;
};
JointStart start_of(const Joint& joint, const BulkBodies& bodies) {
  const Pose X_WA = pose_of(bodies, joint.body_A), X_WB = pose_of(bodies, joint.body_B);
  JointStart start;
  start.arm_A = X_WA.R * joint.X_AJ.p;
  start.arm_B = X_WB.R * joint.X_BK.p;
  start.offset = (X_WB.p - X_WA.p) + start.arm_B - start.arm_A;
  start.J = quaternion_of(X_WA.R * joint.X_AJ.R);
  start.K = quaternion_of(X_WB.R * joint.X_BK.R);
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

/// A joint between two bodies, or of a body and the ground, as a tree of its own.
JointTrees single_tree(const Model& model, int index) {
  const Joint& joint = model.joint(index);
  const auto moves = [&](int body) {
    return body != world_body && model.body(body).motion == MotionType::dynamic;
  };
  std::array<int, 8> none;
  none.fill(-1);
  JointLink link;
  link.joints = none;
  link.joints[0] = index;
  link.type = joint.type;
  link.has_laws = has_axis_laws(joint);
  link.child_is_B = moves(joint.body_B);
  link.parent = 1;
  const int child = link.child_is_B ? joint.body_B : joint.body_A;
  const int parent = link.child_is_B ? joint.body_A : joint.body_B;
  link.parent_is_free = moves(parent);
  JointTrees trees{{link}, {none, none}};
  trees.bodies[0][0] = child;
  trees.bodies[1][0] = parent;
  if (link.parent_is_free) {
    JointLink root;
    root.joints = none;
    root.has_joint = false;
    trees.links.push_back(root);
  }
  return trees;
}

}  // namespace

/// A block with the bodies that it stands for.
struct BulkJointBlock {
  JointBlock lanes;
  std::vector<JointRecords> records;
  alignas(64) std::array<float, 16> nothing{};                        ///< The world.
  alignas(64) std::array<std::array<float, 16>, kLaneCount> empty{};  ///< Of lanes without a body.
  struct alignas(32) Made {
    FloatVec3 v, w;
  };
  std::vector<Made> before;  ///< Velocities at the begin of a solve.
  std::vector<Made> made;    ///< What this substep has changed.
  bool is_new_substep = true;
  /// Of rows of laws, in the order of links, rows and lanes: what limits do after the displacements.
  struct Law {
    int link = 0, row = 0, axis = -1;  ///< Axis -1: a ball's damper across its axis.
    std::array<LawPiece, kLaneCount> pieces{};
    LaneArray prior{};  ///< Impulses of earlier turns of this substep.
    LaneArray rate{};   ///< At its begin.
  };
  std::vector<Law> laws;
};

namespace {

using Block = BulkJointBlock;

Block make_block(JointTrees trees) {
  Block block;
  block.lanes.trees = std::move(trees);
  block.lanes.slots.resize(block.lanes.trees.bodies.size(), JointSlot{});
  block.lanes.joints.resize(block.lanes.trees.links.size(), JointLanes{});
  block.records.resize(block.lanes.slots.size());
  block.before.resize(block.lanes.trees.links.size(), Block::Made{});
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

void prepare_block(const Model& model, const BulkBodies& bodies, Block& block) {
  for (std::size_t s = 0; s < block.lanes.slots.size(); ++s) {
    for (int lane = 0; lane < kLaneCount; ++lane) {
      const int body = block.lanes.trees.bodies[s][static_cast<std::size_t>(lane)];
      if (body < 0) {
        set_empty_lane(lane, block.lanes.slots[s]);
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
        set_lane(model.joint(index), start_of(model.joint(index), bodies), lane, joint);
      } else {
        joint.J.w[lane] = joint.K.w[lane] = 1;
      }
    }
    for (int r = 0; r < kMostJointRows; ++r) {
      joint.softness[r] = float_lanes(1);
      joint.on[r] = joint.given[r] = joint.impulse[r] = float_lanes(0);
    }
  }
}

/// Where the bodies are; the vector may have moved since the last call.
void find_records(BulkBodies& bodies, Block& block) {
  for (std::size_t s = 0; s < block.records.size(); ++s) {
    for (std::size_t lane = 0; lane < 8; ++lane) {
      const int body = block.lanes.trees.bodies[s][lane];
      float* record = block.nothing.data();
      if (body >= 0) {
        static_assert(sizeof(bodies.motion[0]) == 16 * sizeof(float));
        record = bodies.motion[static_cast<std::size_t>(body)].v;
      } else if (s < block.lanes.trees.links.size()) {
        record = block.empty[lane].data();
      }
      block.records[s][lane] = record;
    }
  }
}

/// Impulses and rates from which the laws of a substep begin.
void begin_laws(Block& block) {
  for (Block::Law& law : block.laws) {
    const JointLanes& joint = block.lanes.joints[static_cast<std::size_t>(law.link)];
    law.prior = read_lanes(joint.impulse[law.row]);
    if (block.is_new_substep) law.rate = read_lanes(joint.rate[law.row]);
  }
}

/// The piece of a law in which the coordinate is; nothing of empty lanes.
LawPiece find_piece(const Model& model, const Block& block, const Block::Law& law, int lane, double h) {
  const JointLink& link = block.lanes.trees.links[static_cast<std::size_t>(law.link)];
  const JointLanes& lanes = block.lanes.joints[static_cast<std::size_t>(law.link)];
  const int index = link.joints[static_cast<std::size_t>(lane)];
  if (index < 0) return {};
  const Joint& joint = model.joint(index);
  if (law.axis < 0) {
    const double damping = joint.axes[0].damping;
    return damping > 0 ? LawPiece{true, 0, 1 / (h * damping), 0, 0} : LawPiece{};
  }
  const CoordinateMotion motion{lanes.coordinate[law.row][lane], lanes.rate[law.row][lane],
                                lanes.mobility[law.row][lane], lanes.impulse[law.row][lane]};
  return CoordinateLaw(joint, law.axis, motion, h).piece_at(motion.rate, motion.impulse);
}

bool is_same(const LawPiece& a, const LawPiece& b) {
  return a.is_held == b.is_held && a.target == b.target && a.softness == b.softness && a.impulse == b.impulse;
}

/// Writes the pieces of all laws into the rows; whether one has changed.
bool choose_pieces(const Model& model, double h, Block& block) {
  bool has_changed = false;
  for (Block::Law& law : block.laws) {
    for (int lane = 0; lane < kLaneCount; ++lane) {
      const LawPiece piece = find_piece(model, block, law, lane, h);
      LawPiece& old = law.pieces[static_cast<std::size_t>(lane)];
      has_changed = has_changed || !is_same(piece, old);
      old = piece;
    }
  }
  for (Block::Law& law : block.laws) {
    JointLanes& joint = block.lanes.joints[static_cast<std::size_t>(law.link)];
    for (int lane = 0; lane < kLaneCount; ++lane) {
      const LawPiece& piece = law.pieces[static_cast<std::size_t>(lane)];
      const float prior = law.prior[static_cast<std::size_t>(lane)];
      const float impulse = static_cast<float>(piece.impulse);
      joint.on[law.row][lane] = piece.is_held ? 1 : 0;
      joint.softness[law.row][lane] = piece.is_held ? static_cast<float>(piece.softness) : 1;
      joint.target[law.row][lane] = static_cast<float>(piece.target);
      joint.given[law.row][lane] = piece.is_held ? 0 : impulse - prior;
      joint.impulse[law.row][lane] = piece.is_held ? prior : impulse;
    }
  }
  return has_changed;
}

/// After the displacements only limits act at which a coordinate has been stopped: it leaves as the impact
/// lets it.
void choose_rebounds(const Model& model, Block& block) {
  for (Block::Law& law : block.laws) {
    JointLanes& joint = block.lanes.joints[static_cast<std::size_t>(law.link)];
    const JointLink& link = block.lanes.trees.links[static_cast<std::size_t>(law.link)];
    for (int lane = 0; lane < kLaneCount; ++lane) {
      const std::size_t k = static_cast<std::size_t>(lane);
      const LawPiece& piece = law.pieces[k];
      const bool stands = piece.is_held && piece.limit != 0;
      joint.on[law.row][lane] = stands ? 1 : 0;
      joint.softness[law.row][lane] = stands ? 0 : 1;
      joint.given[law.row][lane] = 0;
      joint.target[law.row][lane] = 0;
      if (!stands) continue;
      const double e = model.joint(link.joints[k]).axes[static_cast<std::size_t>(law.axis)].restitution;
      const double approach = std::max(0.0, piece.limit * static_cast<double>(law.rate[k]));
      joint.target[law.row][lane] = static_cast<float>(-piece.limit * e * approach);
    }
  }
}

void keep_velocities(Block& block) {
  for (std::size_t i = 0; i < block.before.size(); ++i) {
    block.before[i] = {block.lanes.slots[i].v, block.lanes.slots[i].w};
  }
}
void restore_velocities(Block& block) {
  for (std::size_t i = 0; i < block.before.size(); ++i) {
    block.lanes.slots[i].v = block.before[i].v;
    block.lanes.slots[i].w = block.before[i].w;
  }
}
void add_made(Block& block) {
  for (std::size_t i = 0; i < block.before.size(); ++i) {
    block.made[i].v = block.made[i].v + (block.lanes.slots[i].v - block.before[i].v);
    block.made[i].w = block.made[i].w + (block.lanes.slots[i].w - block.before[i].w);
  }
}

void begin_substep(Block& block) {
  if (!block.is_new_substep) return;
  for (Block::Made& made : block.made) made = Block::Made{};
  for (JointLanes& joint : block.lanes.joints) {
    for (FloatLanes& impulse : joint.impulse) impulse = float_lanes(0);
  }
}

void correct(float h, LaneTarget target, Block& block) {
  for (int k = 0; k < kCorrections; ++k) {
    run_stage(JointStage::miss, h, target, block.lanes);
    run_stage(JointStage::solve, h, target, block.lanes);
  }
}

void solve_laws(const Model& model, float h, LaneTarget target, Block& block) {
  run_stage(JointStage::rates, h, target, block.lanes);
  begin_laws(block);
  choose_pieces(model, h, block);
  for (int k = 0; k < kPieceChanges; ++k) {
    if (k > 0) restore_velocities(block);
    run_stage(JointStage::factor, h, target, block.lanes);
    block.lanes.gives = true;
    correct(h, target, block);
    run_stage(JointStage::rates, h, target, block.lanes);
    if (k + 1 < kPieceChanges && !choose_pieces(model, h, block)) break;
  }
}

void solve_before(const Model& model, float h, LaneTarget target, Block& block) {
  begin_substep(block);
  load_slots(block.records, target, block.lanes);
  keep_velocities(block);
  if (block.lanes.has_laws) {
    solve_laws(model, h, target, block);
  } else {
    correct(h, target, block);
  }
  block.is_new_substep = false;
  add_made(block);
  store_slots(block.records, target, block.lanes);
}

void solve_after(const Model& model, float h, LaneTarget target, Block& block) {
  load_slots(block.records, target, block.lanes);
  keep_velocities(block);
  run_stage(JointStage::aim, h, target, block.lanes);
  choose_rebounds(model, block);
  run_stage(JointStage::factor, h, target, block.lanes);
  run_stage(JointStage::drift, h, target, block.lanes);
  run_stage(JointStage::solve, h, target, block.lanes);
  block.is_new_substep = true;
  add_made(block);
  store_slots(block.records, target, block.lanes);
}

}  // namespace

struct BulkJoints::Blocks {
  const Model* model = nullptr;
  LaneTarget target = LaneTarget::portable;
  float h = 0;
  std::vector<Block> trees, closing;

  void prepare(const BulkBodies& bodies, Block& block) const {
    prepare_block(*model, bodies, block);
    for (JointSlot& slot : block.lanes.slots) slot.dp = slot.dr = FloatVec3{};
    run_stage(JointStage::aim, h, target, block.lanes);
    run_stage(JointStage::factor, h, target, block.lanes);
    block.is_new_substep = true;
  }
  void solve(bool before_displacements, BulkBodies& bodies, Block& block) const {
    find_records(bodies, block);
    if (before_displacements) {
      solve_before(*model, h, target, block);
    } else {
      solve_after(*model, h, target, block);
    }
  }
};

BulkJoints::BulkJoints(const Model& model, LaneTarget target) : blocks_(std::make_unique<Blocks>()) {
  blocks_->model = &model;
  blocks_->target = target;
  JointForest forest = make_joint_forest(model);
  for (JointTrees& trees : forest.trees) blocks_->trees.push_back(make_block(std::move(trees)));
  for (const int joint : forest.closing) {
    if (model.joint(joint).type == JointType::gear) continue;
    blocks_->closing.push_back(make_block(single_tree(model, joint)));
  }
}

BulkJoints::~BulkJoints() = default;

void BulkJoints::prepare(const BulkBodies& bodies, double h, const Executor& executor) {
  blocks_->h = static_cast<float>(h);
  const auto prepare_range = [&](std::vector<Block>& blocks, int begin, int end) {
    for (int i = begin; i < end; ++i) blocks_->prepare(bodies, blocks[static_cast<std::size_t>(i)]);
  };
  executor.for_ranges(static_cast<int>(blocks_->trees.size()), 1,
                      [&](int begin, int end) { prepare_range(blocks_->trees, begin, end); });
  prepare_range(blocks_->closing, 0, static_cast<int>(blocks_->closing.size()));
}

void BulkJoints::solve(bool before_displacements, BulkBodies& bodies, const Executor& executor) {
  const int turns = blocks_->closing.empty() ? 1 : kLoopTurns;
  for (int turn = 0; turn < turns; ++turn) {
    for (Block& block : blocks_->closing) blocks_->solve(before_displacements, bodies, block);
    executor.for_ranges(static_cast<int>(blocks_->trees.size()), 1, [&](int begin, int end) {
      for (int i = begin; i < end; ++i) {
        blocks_->solve(before_displacements, bodies, blocks_->trees[static_cast<std::size_t>(i)]);
      }
    });
  }
}

void BulkJoints::take_back_change(BulkBodies& bodies) const {
  for (const std::vector<Block>* blocks : {&blocks_->trees, &blocks_->closing}) {
    for (const Block& block : *blocks) {
      for (std::size_t i = 0; i < block.made.size(); ++i) {
        const Block::Made& made = block.made[i];
        for (int lane = 0; lane < kLaneCount; ++lane) {
          const int body = block.lanes.trees.bodies[i][static_cast<std::size_t>(lane)];
          if (body < 0) continue;
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

std::vector<float> BulkJoints::impulses() const {
  std::vector<float> result(6 * blocks_->model->joints().size());
  for (const std::vector<Block>* blocks : {&blocks_->trees, &blocks_->closing}) {
    for (const Block& block : *blocks) {
      for (std::size_t i = 0; i < block.lanes.joints.size(); ++i) {
        const JointLink& link = block.lanes.trees.links[i];
        for (int lane = 0; lane < kLaneCount; ++lane) {
          const int joint = link.joints[static_cast<std::size_t>(lane)];
          for (int r = 0; joint >= 0 && r < row_count(link); ++r) {
            result[static_cast<std::size_t>(6 * joint + r)] = block.lanes.joints[i].impulse[r][lane];
          }
        }
      }
    }
  }
  return result;
}

std::pair<double, int> BulkJoints::worst_error(const BulkBodies& bodies) const {
  std::pair<double, int> worst{0, -1};
  const Model& model = *blocks_->model;
  for (int i = 0; i < static_cast<int>(model.joints().size()); ++i) {
    const Joint& joint = model.joint(i);
    if (joint.type == JointType::gear) continue;
    const double lever = std::max({joint.X_AJ.p.norm(), joint.X_BK.p.norm(), model.length_scale()});
    const double error =
        joint_error(joint, pose_of(bodies, joint.body_A), pose_of(bodies, joint.body_B), lever);
    if (error > worst.first) worst = {error, i};
  }
  return worst;
}

}  // namespace rigor
