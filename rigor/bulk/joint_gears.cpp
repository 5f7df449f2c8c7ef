#include "rigor/bulk/joint_gears.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace rigor {

namespace {

constexpr double whole_turn = 2 * std::numbers::pi;

/// Numbers of teeth, at most 1000 of the second wheel, decide what whole turns of two angles make of a gear.
double turn_period(double ratio, bool first_turns, bool second_turns) {
  if (first_turns && second_turns) {
    for (int q = 1; q <= 1000; ++q) {
      const double p = std::round(ratio * q);
      if (std::abs(ratio * q - p) <= 2 * std::numeric_limits<double>::epsilon() * std::abs(p)) {
        return whole_turn / q;
      }
    }
    return 0;
  }
  if (first_turns) return whole_turn * std::abs(ratio);
  return second_turns ? whole_turn : std::numeric_limits<double>::infinity();
}

GearWheel find_wheel(int joint, const std::vector<BulkJointBlock*>& blocks) {
  for (BulkJointBlock* block : blocks) {
    for (std::size_t i = 0; i < block->lanes.trees.links.size(); ++i) {
      const JointLink& link = block->lanes.trees.links[i];
      for (int lane = 0; link.has_joint && lane < kLaneCount; ++lane) {
        if (link.joints[static_cast<std::size_t>(lane)] != joint) continue;
        return {block, i, held_row_count(link.type, true), lane};
      }
    }
  }
  return {};
}

double dot_lane(const FloatVec3& a, const FloatVec3& b, int lane) {
  return static_cast<double>(a.x[lane]) * b.x[lane] + static_cast<double>(a.y[lane]) * b.y[lane] +
         static_cast<double>(a.z[lane]) * b.z[lane];
}

/// Slots of the two bodies of a wheel.
struct WheelSides {
  JointSlot &A, &B;
};
WheelSides sides_of(const GearWheel& wheel) {
  JointBlock& lanes = wheel.block->lanes;
  const JointLink& link = lanes.trees.links[wheel.link];
  JointSlot& child = lanes.slots[wheel.link];
  JointSlot& parent = lanes.slots[static_cast<std::size_t>(link.parent)];
  return link.child_is_B ? WheelSides{parent, child} : WheelSides{child, parent};
}

double wheel_rate(const GearWheel& wheel) {
  const JointLanes& joint = wheel.block->lanes.joints[wheel.link];
  const auto [A, B] = sides_of(wheel);
  const int r = wheel.row, lane = wheel.lane;
  return dot_lane(joint.n[r], B.v, lane) - dot_lane(joint.n[r], A.v, lane) +
         dot_lane(joint.a_B[r], B.w, lane) - dot_lane(joint.a_A[r], A.w, lane);
}

/// How the last solve has changed the rate.
double wheel_response(const GearWheel& wheel) {
  const JointLanes& joint = wheel.block->lanes.joints[wheel.link];
  const JointLink& link = wheel.block->lanes.trees.links[wheel.link];
  const auto [A, B] = sides_of(wheel);
  const int r = wheel.row, lane = wheel.lane;
  const auto rate_of = [&](const JointSlot& slot, const FloatVec3& a) {
    const FloatLanes* c = slot.change;
    return dot_lane(joint.n[r], {c[0], c[1], c[2]}, lane) + dot_lane(a, {c[3], c[4], c[5]}, lane);
  };
  const bool moves_A = link.child_is_B ? link.parent_is_free : true;
  const bool moves_B = link.child_is_B ? true : link.parent_is_free;
  return (moves_B ? rate_of(B, joint.a_B[r]) : 0) - (moves_A ? rate_of(A, joint.a_A[r]) : 0);
}

void push_wheel(const GearWheel& wheel, double impulse) {
  const JointLanes& joint = wheel.block->lanes.joints[wheel.link];
  const auto [A, B] = sides_of(wheel);
  const int lane = wheel.lane;
  const FloatVec3 &n = joint.n[wheel.row], &a_A = joint.a_A[wheel.row], &a_B = joint.a_B[wheel.row];
  const auto push = [&](const FloatVec3& direction, double amount, FloatLanes* to) {
    to[0][lane] += static_cast<float>(amount * direction.x[lane]);
    to[1][lane] += static_cast<float>(amount * direction.y[lane]);
    to[2][lane] += static_cast<float>(amount * direction.z[lane]);
  };
  push(n, impulse, B.push);
  push(a_B, impulse, B.push + 3);
  push(n, -impulse, A.push);
  push(a_A, -impulse, A.push + 3);
}

/// What an impulse of the gear does to the blocks, with all their joints held.
void apply(const JointEffort& effort, double impulse, BulkGear& gear) {
  const bool is_one_block = gear.first.block == gear.second.block;
  for (BulkJointBlock* block : {gear.first.block, gear.second.block}) {
    for (JointSlot& slot : block->lanes.slots) {
      for (FloatLanes& push : slot.push) push = float_lanes(0);
    }
    for (JointLanes& joint : block->lanes.joints) {
      for (FloatLanes& residual : joint.residual) residual = float_lanes(0);
    }
  }
  push_wheel(gear.second, impulse);
  push_wheel(gear.first, -gear.ratio * impulse);
  run_stage(JointStage::solve, effort.h, effort.target, gear.first.block->lanes);
  if (!is_one_block) run_stage(JointStage::solve, effort.h, effort.target, gear.second.block->lanes);
}

double wheel_coordinate(const GearWheel& wheel) {
  return wheel.block->lanes.joints[wheel.link].coordinate[wheel.row][wheel.lane];
}

}  // namespace

BulkGear make_bulk_gear(const Model& model, int gear, const std::vector<BulkJointBlock*>& blocks) {
  const Joint& joint = model.joint(gear);
  const auto turns = [&](int index) { return is_angle(model.joint(index).type, 0); };
  return {find_wheel(joint.first_joint, blocks), find_wheel(joint.second_joint, blocks), joint.ratio,
          turn_period(joint.ratio, turns(joint.first_joint), turns(joint.second_joint))};
}

void solve_gear(const JointEffort& effort, bool before_displacements, BulkGear& gear) {
  const bool is_one_block = gear.first.block == gear.second.block;
  std::vector<BulkJointBlock*> blocks{gear.first.block};
  if (!is_one_block) blocks.push_back(gear.second.block);
  for (BulkJointBlock* block : blocks) {
    load_slots(block->records, effort.target, block->lanes);
    keep_joint_velocities(*block);
  }
  double residual = wheel_rate(gear.second) - gear.ratio * wheel_rate(gear.first);
  if (before_displacements && gear.period > 0) {
    const double off = wheel_coordinate(gear.second) - gear.ratio * wheel_coordinate(gear.first);
    residual += std::remainder(off, gear.period) / effort.h;
  }
  // A first impulse of 1 tells how the gear gives way, the second is the rest.
  apply(effort, 1, gear);
  const double mobility = wheel_response(gear.second) - gear.ratio * wheel_response(gear.first);
  const double rest = mobility > 0 ? -residual / mobility - 1 : -1;
  apply(effort, rest, gear);
  for (BulkJointBlock* block : blocks) {
    add_joint_change(*block);
    store_slots(block->records, effort.target, block->lanes);
  }
}

}  // namespace rigor
