#include "rigor/bulk/joints/joint_block.hpp"

#include "rigor/bulk/joints/joint_gears.hpp"
#include "rigor/bulk/joints/joint_tension.hpp"
#include "rigor/core/index.hpp"
#include "rigor/math/rotation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>
#include <utility>

namespace rigor {

BodyPlace place_of(const BulkBodies& bodies, int body) {
  if (body == world_body) return {};
  return {bodies.x[at(body)], bodies.q[at(body)]};
}

namespace {

JointStart start_of(const Joint& joint, const BulkJointBlock::Frames& frames, int lane,
                    const BulkBodies& bodies) {
  const BodyPlace A = place_of(bodies, joint.body_A), B = place_of(bodies, joint.body_B);
  JointStart start;
  start.arm_A = A.q * joint.X_AF.p;
  start.arm_B = B.q * joint.X_BK.p;
  start.offset = (B.x - A.x) + start.arm_B - start.arm_A;
  start.J = A.q * frames.q_AF[at(lane)];
  start.K = B.q * frames.q_BK[at(lane)];
  return start;
}

void set_lane(const Joint& joint, const JointStart& start, int lane, JointLanes& to) {
  set_lane(start.arm_A, lane, to.arm_A);
  set_lane(start.arm_B, lane, to.arm_B);
  set_lane(start.offset, lane, to.offset);
  set_lane(start.J, lane, to.J);
  set_lane(start.K, lane, to.K);
  to.length[lane] = static_cast<float>(joint.length);
  const bool is_per_turn = joint_traits(joint.type).parameter.is_per_turn;
  to.parameter[lane] = static_cast<float>(joint.parameter / (is_per_turn ? 2 * std::numbers::pi : 1));
}

/// Mass and moments of a body that joints move, if it is dynamic; else it does not give way, and its
/// articulated inertia is not asked for. Lanes without a body: of unit mass.
void set_masses(const Body* body, bool gives_way, int lane, JointSlot& slot) {
  slot.mass[lane] = body == nullptr || !gives_way ? 1 : static_cast<float>(body->mass);
  slot.inverse_mass[lane] = gives_way ? 1 / slot.mass[lane] : 0;
  for (int k = 0; k < 3; ++k) {
    slot.moments[k][lane] = body == nullptr || !gives_way ? 1 : static_cast<float>(body->moments[k]);
    slot.inverse_moments[k][lane] = gives_way ? 1 / slot.moments[k][lane] : 0;
  }
}

void set_all_masses(const Model& model, JointBlock& block) {
  for (std::size_t s = 0; s < block.slots.size(); ++s) {
    for (int lane = 0; lane < kLaneCount; ++lane) {
      const int index = block.systems.bodies[s][at(lane)];
      const Body* body = index < 0 ? nullptr : &model.body(index);
      set_masses(body, s < block.systems.moved, lane, block.slots[s]);
    }
  }
}

/// What joints can carry with nothing taut.
void set_slack(const Model& model, JointBlock& block) {
  const std::vector<int> joints = joint_counts(block.systems);
  for (std::size_t i = 0; i < block.joints.size(); ++i) {
    const JointLink& link = block.systems.links[i];
    for (int lane = 0; lane < kLaneCount; ++lane) {
      Slack slack;
      if (holds_point_alone(link) && link.joints[at(lane)] >= 0) {
        const Joint& joint = model.joint(link.joints[at(lane)]);
        for (const int slot : {link.child, link.parent}) {
          if (at(slot) >= block.systems.moved) continue;
          const int body = block.systems.bodies[at(slot)][at(lane)];
          const Vec3& arm = body == joint.body_A ? joint.X_AF.p : joint.X_BK.p;
          slack.add_body(model.body(body).moments, joints[at(slot)], arm);
        }
      }
      block.joints[i].slack[lane] = static_cast<float>(slack.squared);
    }
  }
}

/// Where the records of the bodies are. Lanes of systems that sleep, or are taken by ContactFreeChains, have
/// records of their own, so that nothing is done to their bodies.
void find_records(BulkBodies& bodies, BulkJointBlock& block) {
  block.is_moving = block.is_driven = false;
  block.empty = {};
  for (std::size_t s = 0; s < block.records.size(); ++s) {
    const bool is_moved = s < block.lanes.systems.moved;
    for (std::size_t lane = 0; lane < 8; ++lane) {
      const int body = block.lanes.systems.bodies[s][lane];
      float* record = block.nothing.data();
      const bool is_free = (block.free_lanes >> lane & 1) != 0;
      if (is_moved && (body < 0 || is_free || !bodies.is_dynamic(body))) {
        record = block.empty[lane].data();
      } else if (body >= 0) {
        static_assert(sizeof(bodies.motion[0]) == 16 * sizeof(float));
        record = bodies.motion[at(body)].v;
        block.is_moving = block.is_moving || is_moved;
        block.is_driven = block.is_driven || (!is_moved && bodies.has_velocity(body));
      }
      block.records[s][lane] = record;
    }
  }
}

/// Principal axes at the beginning of the step; nothing has moved or changed yet.
void place_axes(const BulkBodies& bodies, JointBlock& block) {
  for (std::size_t s = 0; s < block.slots.size(); ++s) {
    JointSlot& slot = block.slots[s];
    for (int lane = 0; lane < kLaneCount; ++lane) {
      const int body = block.systems.bodies[s][at(lane)];
      const Mat3 R = body < 0 ? Mat3(Mat3::Identity()) : place_of(bodies, body).q.toRotationMatrix();
      set_lane(Vec3(R.col(0)), lane, slot.axis0);
      set_lane(Vec3(R.col(1)), lane, slot.axis1);
    }
    slot.dp = slot.dr = slot.made_v = slot.made_w = FloatVec3{};
  }
}

/// Of joints whose rows need them.
std::vector<BulkJointBlock::Frames> frames_of(const Model& model, const JointSystems& systems) {
  std::vector<BulkJointBlock::Frames> frames(systems.links.size());
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const JointLink& link = systems.links[i];
    frames[i].q_AF.fill(Quat::Identity());
    frames[i].q_BK.fill(Quat::Identity());
    for (std::size_t lane = 0; lane < kLaneCount; ++lane) {
      if (link.joints[lane] < 0 || !needs_frames(link.type, link.has_laws)) continue;
      frames[i].q_AF[lane] = quaternion_of(model.joint(link.joints[lane]).X_AF.R);
      frames[i].q_BK[lane] = quaternion_of(model.joint(link.joints[lane]).X_BK.R);
    }
  }
  return frames;
}

/// Arms and frames of all joints at the beginning of the step; no law is on.
void place_joints(const JointEffort& effort, const BulkBodies& bodies, BulkJointBlock& own) {
  JointBlock& block = own.lanes;
  own.approaches.clear();
  for (std::size_t i = 0; i < block.joints.size(); ++i) {
    JointLanes& joint = block.joints[i];
    for (int lane = 0; lane < kLaneCount; ++lane) {
      const int index = block.systems.links[i].joints[at(lane)];
      if (index >= 0) {
        const Joint& held = effort.model.joint(index);
        const JointStart start = start_of(held, own.frames[i], lane, bodies);
        set_lane(held, start, lane, joint);
        note_approach(held, start, static_cast<int>(i), lane, static_cast<double>(effort.h), own.approaches);
      } else {
        joint.J.w[lane] = joint.K.w[lane] = 1;
      }
    }
    for (int r = 0; r < kMostJointRows; ++r) {
      joint.softness[r] = float_lanes(1);
      joint.on[r] = joint.given[r] = joint.target[r] = joint.impulse[r] = float_lanes(0);
    }
    joint.has_law_on = false;
  }
  approach(static_cast<double>(effort.h), own.approaches, block);
}

/// The impulses that hold points; those of trees that ContactFreeChains takes have no part in it.
void place_impulses(const std::vector<float>& impulses, BulkJointBlock& block) {
  if (impulses.empty()) return;
  for (std::size_t i = 0; i < block.lanes.joints.size(); ++i) {
    const JointLink& link = block.lanes.systems.links[i];
    if (!holds_point_alone(link)) continue;
    FloatLanes* const to = block.lanes.joints[i].impulse;
    for (int lane = 0; lane < kLaneCount; ++lane) {
      if (link.joints[at(lane)] < 0 || (block.free_lanes >> lane & 1) != 0) continue;
      const float* const from = &impulses[at(kMostJointRows * link.joints[at(lane)])];
      to[0][lane] = from[0], to[1][lane] = from[1], to[2][lane] = from[2];
    }
  }
}

/// The limits of a coordinate; infinite without a law, NaN where other laws act too.
std::pair<double, double> limits_alone(const Model& model, int index, int axis) {
  constexpr double infinity = std::numeric_limits<double>::infinity(),
                   unknown = std::numeric_limits<double>::quiet_NaN();
  if (index < 0 || std::max(axis, 0) >= static_cast<int>(model.joint(index).axes.size()))
    return {-infinity, infinity};
  const JointAxis& law = model.joint(index).axes[at(std::max(axis, 0))];
  // Rows across the axis of a ball have a damper alone.
  if (axis < 0) return law.damping > 0 ? std::pair(unknown, unknown) : std::pair(-infinity, infinity);
  if (law.motor || law.stiffness > 0 || law.damping > 0 || law.friction > 0) return {unknown, unknown};
  return {law.lower, law.upper};
}

}  // namespace

BulkJointBlock make_joint_block(const Model& model, JointSystems systems) {
  // Bodies, joints and what solves them: trees joint by joint, loops as a whole.
  BulkJointBlock block;
  block.lanes.slots.resize(systems.bodies.size(), JointSlot{});
  block.lanes.joints.resize(systems.links.size(), JointLanes{});
  block.lanes.gears = make_gears(model, systems);
  if (systems.has_loops) {
    block.lanes.loops = std::make_unique<LoopSolver>(systems);
  } else {
    block.lanes.balls.resize(systems.links.size(), BallLanes{});
    const bool has_hinges = std::any_of(systems.links.begin(), systems.links.end(),
                                        [](const JointLink& link) { return link.is_hinge(); });
    if (has_hinges) block.lanes.hinges.resize(systems.links.size(), HingeLanes{});
  }
  block.records.resize(systems.bodies.size());
  block.frames = frames_of(model, systems);

  // Joints with laws, and the rows of their coordinates.
  block.lanes.is_of_balls = !systems.has_loops;
  for (std::size_t i = 0; i < systems.links.size(); ++i) {
    const JointLink& link = systems.links[i];
    if (link.has_joint && !link.is_plain_ball()) block.lanes.is_of_balls = false;
    if (!link.has_joint || !link.has_laws) continue;
    block.lanes.has_laws = true;
    const int held = held_row_count(link.type, true);
    for (int r = held; r < row_count(link); ++r) {
      const int axis = r - held < coordinate_count(link.type) ? r - held : -1;
      BulkJointBlock::Law& law = block.laws.emplace_back();
      law.link = static_cast<int>(i);
      law.row = r;
      law.axis = axis;
    }
  }
  if (block.lanes.has_laws) block.before.resize(systems.moved, BulkJointBlock::Velocities{});
  block.lanes.systems = std::move(systems);
  set_all_masses(model, block.lanes);
  set_slack(model, block.lanes);
  read_limits(model, block);
  return block;
}

void read_limits(const Model& model, BulkJointBlock& block) {
  for (BulkJointBlock::Law& law : block.laws) {
    const JointLink& link = block.lanes.systems.links[at(law.link)];
    for (std::size_t lane = 0; lane < kLaneCount; ++lane)
      std::tie(law.lower[lane], law.upper[lane]) = limits_alone(model, link.joints[lane], law.axis);
  }
}

void displace_bodies(float h, BulkBodies& bodies, const BulkJointBlock& block) {
  for_moved_bodies(bodies, block, [&](int body) { displace(h, bodies.motion[at(body)]); });
}

namespace {

/// Whether nothing but joints and limits holds the system in a lane together, and it flies.
bool is_lane_flying(const BulkBodies& bodies, const std::vector<char>& flies, std::size_t lane,
                    const BulkJointBlock& block) {
  for (const BulkJointBlock::Law& law : block.laws) {
    if (std::isnan(law.lower[lane])) return false;
  }
  const JointSystems& systems = block.lanes.systems;
  for (std::size_t s = 0; s < systems.moved; ++s) {
    const int body = systems.bodies[s][lane];
    if (body < 0 || !bodies.is_dynamic(body) || flies[at(body)] == 0) return false;
  }
  return true;
}

}  // namespace

void find_flying_lanes(const BulkBodies& bodies, std::vector<char>& flies, BulkJointBlock& block) {
  const JointSystems& systems = block.lanes.systems;
  block.flying_records.clear();
  unsigned lanes = 0;
  for (std::size_t lane = 0; lane < kLaneCount; ++lane) {
    if (is_lane_flying(bodies, flies, lane, block)) {
      lanes |= 1u << lane;
      continue;
    }
    for (std::size_t s = 0; s < systems.moved; ++s) {
      if (systems.bodies[s][lane] >= 0) flies[at(systems.bodies[s][lane])] = 0;
    }
  }
  // Contact-free chains solve their rates themselves.
  lanes &= ~block.free_lanes;
  if (lanes == 0) return;
  block.flying_records = block.records;
  for (JointRecords& records : block.flying_records) {
    for (std::size_t lane = 0; lane < kLaneCount; ++lane) {
      if ((lanes >> lane & 1) == 0) records[lane] = block.empty[lane].data();
    }
  }
}

void prepare_joint_block(const JointEffort& effort, const std::vector<float>& impulses, BulkBodies& bodies,
                         BulkJointBlock& block) {
  find_records(bodies, block);
  if (!block.is_moving) return;
  // The inverse masses are those of the records, which round otherwise than these of make_joint_block.
  load_slots(block.records, effort.target, block.lanes);
  place_axes(bodies, block.lanes);
  place_joints(effort, bodies, block);
  block.lanes.is_taut = false;
  run_stage(JointStage::aim, effort.h, effort.target, block.lanes);
  // What was taut in the substep before is so in the first one.
  place_impulses(impulses, block);
  block.lanes.may_be_taut = may_be_taut(effort.h, block.lanes);
  find_taut(effort.h, block.lanes);
  if (block.lanes.is_taut) run_stage(JointStage::aim, effort.h, effort.target, block.lanes);
  run_stage(JointStage::factor, effort.h, effort.target, block.lanes);
  for (BulkJointBlock::Law& law : block.laws) {
    law.is_off = true;
    law.pieces = {};
    law.factored_on.fill(0);
    law.factored_softness.fill(1);
    law.last_impulse.fill(0);
  }
}

}  // namespace rigor
