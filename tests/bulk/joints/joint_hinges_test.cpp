// Hinges in trees of the many-body path against the general rows of a joint.

#include "bulk/random_bodies.hpp"

#include "rigor/bulk/joints/joint_hinges.hpp"

#include "rigor/bulk/joints/joint_aims.hpp"
#include "rigor/bulk/joints/joint_factors.hpp"

#include <gtest/gtest.h>

namespace rigor::joint_hinges_test {

using random_bodies_test::Draw;

namespace {

FloatLanes draw_lanes(Draw& draw, double a, double b) {
  FloatLanes lanes = float_lanes(0);
  for (int i = 0; i < kLaneCount; ++i) lanes[i] = static_cast<float>(draw.between(a, b));
  return lanes;
}
FloatVec3 draw_vector(Draw& draw) {
  return {draw_lanes(draw, -1, 1), draw_lanes(draw, -1, 1), draw_lanes(draw, -1, 1)};
}

/// An articulated inertia G Gᵀ + 1, and a push.
void draw_slot(Draw& draw, JointSlot& slot) {
  FloatLanes G[36];
  for (FloatLanes& g : G) g = draw_lanes(draw, -1, 1);
  for (int i = 0; i < 6; ++i) {
    for (int k = 0; k <= i; ++k) {
      FloatLanes e = float_lanes(i == k ? 1 : 0);
      for (int j = 0; j < 6; ++j) e += G[6 * i + j] * G[6 * k + j];
      slot.articulated[lower(i, k)] = e;
    }
    slot.push[i] = draw_lanes(draw, -1, 1);
    slot.change[i] = draw_lanes(draw, -1, 1);
  }
}

/// A hinge with its law on in every other lane, soft or not.
JointLanes draw_hinge(Draw& draw) {
  JointLanes joint{};
  const FloatVec3 A = draw_vector(draw), B = draw_vector(draw), x = unit_or(draw_vector(draw), A);
  const FloatVec3 y = unit_or(cross(x, draw_vector(draw)), B);
  JointPose pose{};
  pose.arm_A = A;
  pose.arm_B = B;
  JointRowWriter rows{joint};
  rows.add_point(pose);
  rows.add_rotation(x);
  rows.add_rotation(y);
  rows.add_rotation(cross(x, y));
  for (FloatLanes& residual : joint.residual) residual = draw_lanes(draw, -1, 1);
  for (int lane = 0; lane < kLaneCount; ++lane) {
    joint.on[kHingeLaw][lane] = lane % 2 == 0 ? 1 : 0;
    joint.softness[kHingeLaw][lane] = lane % 2 == 1 ? 1 : lane % 4 == 0 ? 0 : 0.3F;
    if (lane % 2 == 1) joint.residual[kHingeLaw][lane] = 0;
  }
  joint.has_law_on = true;
  return joint;
}

void expect_near(const FloatLanes& a, const FloatLanes& b, const char* what) {
  // Both are solutions of systems of the condition of some hundreds in 32 bits.
  for (int lane = 0; lane < kLaneCount; ++lane) EXPECT_NEAR(a[lane], b[lane], 3e-4) << what << " " << lane;
}

}  // namespace

TEST(JointHinges, AreSolvedLikeRowsOfAnyJoint) {
  Draw draw(71);
  for (int trial = 0; trial < 200; ++trial) {
    JointLink link;
    link.type = JointType::hinge;
    link.has_laws = link.parent_is_free = true;
    link.child_is_B = trial % 2 == 0;
    JointSlot child{}, parent{};
    draw_slot(draw, child);
    draw_slot(draw, parent);
    JointLanes joint = draw_hinge(draw);
    JointSlot child_of_rows = child, parent_of_rows = parent;
    JointLanes rows = joint;
    HingeLanes hinge{};

    factor_hinge(link, child, parent, joint, hinge);
    factor_joint(link, {6, 5}, child_of_rows, parent_of_rows, rows);
    gather_hinge(link, child, parent, joint, hinge);
    gather_push(link, 6, child_of_rows, parent_of_rows, rows);
    spread_hinge(link, parent, child, joint, hinge);
    spread_change(link, 6, parent_of_rows, child_of_rows, rows);

    for (int k = 0; k < 21; ++k) expect_near(parent.articulated[k], parent_of_rows.articulated[k], "inertia");
    for (int k = 0; k < 6; ++k) expect_near(parent.push[k], parent_of_rows.push[k], "push");
    for (int k = 0; k < 6; ++k) expect_near(child.change[k], child_of_rows.change[k], "change");
    for (int k = 0; k < 6; ++k) expect_near(joint.impulse[k], rows.impulse[k], "impulse");
  }
}

}  // namespace rigor::joint_hinges_test
