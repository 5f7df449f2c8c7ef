#include "rigor/bulk/joints/joint_tension.hpp"

#include "rigor/bulk/joints/joint_factors.hpp"
#include "rigor/bulk/lanes/lane_bits.hpp"
#include "rigor/core/index.hpp"

#include <algorithm>
#include <vector>

namespace rigor {

namespace {

/// Arms of rows along the axes of W.
FloatVec3 arm_of(const FloatVec3* a) {
  return {a[1].z, -a[0].z, a[0].y};
}

/// Their sum is the trace of the inertia.
FloatLanes moments_of(const JointSlot& slot) {
  return slot.moments[0] + slot.moments[1] + slot.moments[2];
}

/// What the impulse of a joint pulls at.
TautLink taut_link(const JointBlock& block, std::size_t i) {
  const JointLink& link = block.systems.links[i];
  const JointLanes& joint = block.joints[i];
  // Rows along the axes of W: the impulses are those on B.
  const FloatVec3 on_B{joint.impulse[0], joint.impulse[1], joint.impulse[2]};
  TautLink taut{link.child, link.parent, float_lanes(link.child_is_B ? 1 : -1) * on_B, {}, {}};
  if (link.is_plain_ball() && !block.loops) {
    taut.arm_child = block.balls[i].arm_child;
    taut.arm_parent = block.balls[i].arm_parent;
  } else {
    taut.arm_child = arm_of(link.child_is_B ? joint.a_B : joint.a_A);
    taut.arm_parent = arm_of(link.child_is_B ? joint.a_A : joint.a_B);
  }
  return taut;
}

void find_links(JointBlock& block) {
  block.taut_links.clear();
  for (std::size_t i = 0; i < block.joints.size(); ++i) {
    if (holds_point_alone(block.systems.links[i])) block.taut_links.push_back(taut_link(block, i));
  }
}

void stiffen_block(float h, const JointBlock& block, std::vector<TautBody>& bodies) {
  bodies.resize(block.slots.size(), TautBody{});
  for (std::size_t s = 0; s < block.slots.size(); ++s)
    bodies[s].inverse_inertia = moments_in_W(block.slots[s], block.slots[s].inverse_moments);
  stiffen(h, block.taut_links, bodies);
}

}  // namespace

bool holds_point_alone(const JointLink& link) {
  const JointTraits& traits = joint_traits(link.type);
  return link.has_joint && traits.holds_point() && traits.held_rotation != LockedRotation::all;
}

void find_taut(float h, JointBlock& block) {
  block.is_taut = block.may_be_taut;
  if (!block.is_taut) return;
  find_links(block);
  stiffen_block(h, block, block.taut_bodies);
}

bool may_be_taut(float h, const JointBlock& block) {
  // Infinite slack of joints that do not hold a point alone.
  IntLanes is_more = {};
  for (const JointLanes& joint : block.joints) {
    const FloatVec3 f = float_lanes(h) * FloatVec3{joint.impulse[0], joint.impulse[1], joint.impulse[2]};
    is_more |= dot(f, f) > joint.slack;
  }
  return lane_bits(is_more) != 0;
}

unsigned find_tauter(float h, JointBlock& block) {
  block.may_be_taut = may_be_taut(h, block);
  if (!block.may_be_taut) return 0;
  find_links(block);
  std::vector<TautBody> tauter;
  stiffen_block(h, block, tauter);
  if (!block.is_taut) block.taut_bodies.assign(block.slots.size(), TautBody{});
  unsigned lanes = 0;
  for (std::size_t s = 0; s < block.systems.moved; ++s)
    lanes |= raise(moments_of(block.slots[s]), tauter[s], block.taut_bodies[s]);
  block.is_taut = block.is_taut || lanes != 0;
  return lanes;
}

void invert_raised(const JointBlock& block, std::size_t s, FloatSym3& inverse) {
  FloatSym3 inertia = moments_in_W(block.slots[s], block.slots[s].moments);
  add_stiffening(block.taut_bodies[s], inertia);
  invert(inertia, inverse);
}

void calm_taut(JointBlock& block) {
  if (!block.is_taut) return;
  for (std::size_t s = 0; s < block.slots.size(); ++s) block.taut_bodies[s].w = block.slots[s].w;
  calm(block.taut_links, block.taut_bodies);
  // What joints change is known, so that it can be taken back.
  for (std::size_t s = 0; s < block.systems.moved; ++s) {
    JointSlot& slot = block.slots[s];
    slot.made_w = slot.made_w + (block.taut_bodies[s].w - slot.w);
    slot.w = block.taut_bodies[s].w;
  }
}

double square_of_vibration(float h, const JointBlock& block) {
  // tr(I⁻¹ K) of each body, by its place in the block.
  std::vector<FloatLanes> squares(block.slots.size(), float_lanes(0));
  const auto add = [&](int place, const FloatVec3& f, const FloatVec3& r) {
    const JointSlot& slot = block.slots[at(place)];
    const FloatSym3& W = slot.inverse_inertia;
    const FloatLanes trace = W.xx + W.yy + W.zz;
    squares[at(place)] += float_max(float_lanes(0), dot(f, r) * trace - dot(f, W * r));
  };
  for (std::size_t i = 0; i < block.joints.size(); ++i) {
    const JointLink& link = block.systems.links[i];
    const JointLanes& joint = block.joints[i];
    if (!link.has_joint || !joint_traits(link.type).holds_point()) continue;
    // Rows along the axes of W: the impulses are the force on B, and the rows have its arms.
    const FloatVec3 f{joint.impulse[0], joint.impulse[1], joint.impulse[2]};
    const int A = link.child_is_B ? link.parent : link.child, B = link.child_is_B ? link.child : link.parent;
    add(B, f, arm_of(joint.a_B));
    add(A, float_lanes(-1) * f, arm_of(joint.a_A));
  }
  float most = 0;
  for (std::size_t s = 0; s < block.systems.moved; ++s) {
    for (int lane = 0; lane < kLaneCount; ++lane) most = std::max(most, squares[s][lane]);
  }
  return static_cast<double>(most) / static_cast<double>(h);
}

}  // namespace rigor
