#include "rigor/bulk/joints/joint_ball_trees.hpp"

#include "rigor/bulk/joints/joint_balls.hpp"
#include "rigor/core/index.hpp"

namespace rigor {

namespace {

JointSlot& parent_of(const JointLink& link, JointBlock& block) {
  return block.slots[at(link.parent)];
}

RIGOR_FLOAT_LANES void clear_pushes(JointBlock& block) {
  for (std::size_t s = 0; s < block.systems.moved; ++s) {
    for (FloatLanes& push : block.slots[s].push) push = float_lanes(0);
  }
}

/// From the root down: changes of all bodies.
RIGOR_FLOAT_LANES void spread_all(JointBlock& block) {
  for (std::size_t i = block.systems.links.size(); i-- > 0;) {
    const JointLink& link = block.systems.links[i];
    JointSlot& child = block.slots[i];
    if (link.has_joint) {
      spread_ball(link, parent_of(link, block), child, block.joints[i], block.balls[i]);
    } else {
      spread_root(block.joints[i], child);
    }
    add_change(child);
  }
}

/// One correction of the velocities, so that the joints hold after the substep. Lanes in which `part` is 0
/// stay as they are.
RIGOR_FLOAT_LANES void correct_places(float h, const FloatLanes& part, JointBlock& block) {
  // Where the bodies will be, if velocities stay.
  clear_pushes(block);
  for (JointSlot& slot : block.slots) {
    slot.next_rotation = rotation_on(slot.dr, float_lanes(h) * slot.w);
  }

  // From the leaves up: how far the joints will be off, and the pushes; then from the root down.
  for (std::size_t i = 0; i < block.systems.links.size(); ++i) {
    const JointLink& link = block.systems.links[i];
    if (!link.has_joint) {
      gather_root(block.slots[i], block.joints[i]);
      continue;
    }
    BallLanes& ball = block.balls[i];
    miss_ball(link, h, block.slots[i], parent_of(link, block), block.joints[i], ball);
    ball.wanted = part * ball.wanted;
    gather_ball(link, block.slots[i], parent_of(link, block), ball);
  }
  spread_all(block);
}

/// Step 2 of a substep (docs/theory/bulk_joints.md, section 1).
RIGOR_FLOAT_LANES void hold_in_lanes(float h, JointBlock& block) {
  correct_places(h, float_lanes(1), block);
  const FloatLanes part = lanes_off(h, block);
  if (!is_zero(part)) correct_places(h, part, block);
}

/// Step 4 of a substep; its factors serve step 2 of the next.
RIGOR_FLOAT_LANES void slow_in_lanes(JointBlock& block) {
  // Mass matrices where the bodies are.
  clear_pushes(block);
  for (std::size_t s = 0; s < block.slots.size(); ++s) {
    JointSlot& slot = block.slots[s];
    slot.rotation = lane_rotation(slot.dr);
    update_inertia(slot);
    if (block.is_taut) add_stiffening(block.taut_bodies[s], slot.inertia);
    set_body_inertia(slot);
  }

  // From the leaves up: factors, rates and pushes; then from the root down.
  for (std::size_t i = 0; i < block.systems.links.size(); ++i) {
    const JointLink& link = block.systems.links[i];
    JointSlot& child = block.slots[i];
    if (!link.has_joint) {
      factor_root(child, block.joints[i]);
      gather_root(child, block.joints[i]);
      continue;
    }
    JointSlot& parent = parent_of(link, block);
    BallLanes& ball = block.balls[i];
    aim_ball(link, child, parent, block.joints[i], ball);
    factor_ball(link, child, parent, ball);
    drift_ball(child, parent, ball);
    gather_ball(link, child, parent, ball);
  }
  spread_all(block);
}

#if defined(__x86_64__)
[[gnu::target("avx2")]] void hold_avx2(float h, JointBlock& block) {
  hold_in_lanes(h, block);
}
[[gnu::target("avx2")]] void slow_avx2(JointBlock& block) {
  slow_in_lanes(block);
}
#else
void hold_avx2(float h, JointBlock& block) {
  hold_in_lanes(h, block);
}
void slow_avx2(JointBlock& block) {
  slow_in_lanes(block);
}
#endif
void hold_portable(float h, JointBlock& block) {
  hold_in_lanes(h, block);
}
void slow_portable(JointBlock& block) {
  slow_in_lanes(block);
}

}  // namespace

void hold_balls(float h, LaneTarget target, JointBlock& block) {
  target == LaneTarget::avx2 ? hold_avx2(h, block) : hold_portable(h, block);
}

void slow_balls(LaneTarget target, JointBlock& block) {
  target == LaneTarget::avx2 ? slow_avx2(block) : slow_portable(block);
}

}  // namespace rigor
