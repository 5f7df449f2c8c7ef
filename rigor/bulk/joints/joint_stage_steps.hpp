#pragma once

// What stages do in lanes, for any processor: inlined into the functions of joint_stages.inl, which have a
// target and pass no lanes by value. (clang++ lets no function with AVX call one without that returns lanes.)

#include "rigor/bulk/joints/joint_aims.hpp"
#include "rigor/bulk/joints/joint_factors.hpp"
#include "rigor/bulk/joints/joint_stages.hpp"
#include "rigor/core/index.hpp"

#include <cstddef>
#include <vector>

namespace rigor {

/// Eight floats of each of eight records, from `first` on, transposed.
RIGOR_FLOAT_LANES void load_square(const JointRecords& records, int first, FloatSquare& square) {
  for (int i = 0; i < kLaneCount; ++i) {
    square.row[i] = load_floats(records[at(i)] + first);
  }
  square = transpose(square);
}

/// Velocities and displacements of the bodies of all slots.
RIGOR_FLOAT_LANES void load_lanes(const std::vector<JointRecords>& records, JointBlock& block) {
  for (std::size_t s = 0; s < records.size(); ++s) {
    JointSlot& slot = block.slots[s];
    FloatSquare square;
    // (v, 1/m, w, 0)
    load_square(records[s], 0, square);
    slot.v = {square.row[0], square.row[1], square.row[2]};
    slot.inverse_mass = square.row[3];
    slot.w = {square.row[4], square.row[5], square.row[6]};
    // (dp, 0, dr, 0)
    load_square(records[s], 8, square);
    slot.dp = {square.row[0], square.row[1], square.row[2]};
    slot.dr = {square.row[4], square.row[5], square.row[6]};
  }
}

/// Velocities of the bodies that joints move.
RIGOR_FLOAT_LANES void store_lanes(const std::vector<JointRecords>& records, const JointBlock& block) {
  for (std::size_t s = 0; s < block.systems.moved; ++s) {
    const JointSlot& slot = block.slots[s];
    const FloatSquare square = transpose(
        {{slot.v.x, slot.v.y, slot.v.z, slot.inverse_mass, slot.w.x, slot.w.y, slot.w.z, float_lanes(0)}});
    for (int i = 0; i < kLaneCount; ++i) {
      store_floats(square.row[i], records[s][at(i)]);
    }
  }
}

/// u = n · (v_B - v_A) + a_B · ω_B - a_A · ω_A.
RIGOR_FLOAT_LANES FloatLanes row_rate(const JointSides& sides, const JointLanes& joint, int r) {
  return dot(joint.n[r], sides.B.v - sides.A.v) + dot(joint.a_B[r], sides.B.w) - dot(joint.a_A[r], sides.A.w);
}

/// Impulse of one row on a body, to be taken up by the next solve.
RIGOR_FLOAT_LANES void add_push(const FloatVec3& n, const FloatVec3& a, const FloatLanes& impulse,
                                JointSlot& slot) {
  slot.push[0] += impulse * n.x;
  slot.push[1] += impulse * n.y;
  slot.push[2] += impulse * n.z;
  slot.push[3] += impulse * a.x;
  slot.push[4] += impulse * a.y;
  slot.push[5] += impulse * a.z;
}

/// Gives the two bodies of a joint the impulse of a row on a level piece of its law.
RIGOR_FLOAT_LANES void give(const JointLink& link, std::size_t i, int r, JointBlock& block) {
  const JointLanes& joint = block.joints[i];
  JointSlot& child = block.slots[at(link.child)];
  JointSlot& parent = block.slots[at(link.parent)];
  JointSlot& A = link.child_is_B ? parent : child;
  JointSlot& B = link.child_is_B ? child : parent;
  add_push(joint.n[r], joint.a_B[r], joint.given[r], B);
  add_push(joint.n[r], joint.a_A[r], -joint.given[r], A);
}

/// Of a joint with laws: rates and mobilities of their rows.
RIGOR_FLOAT_LANES void measure_rates(const JointSides& sides, JointSize count, JointLanes& joint) {
  for (int r = count.held; r < count.rows; ++r) {
    joint.rate[r] = row_rate(sides, joint, r);
    joint.mobility[r] = (sides.A.inverse_mass + sides.B.inverse_mass) * dot(joint.n[r], joint.n[r]) +
                        dot(joint.a_A[r], sides.A.inverse_inertia * joint.a_A[r]) +
                        dot(joint.a_B[r], sides.B.inverse_inertia * joint.a_B[r]);
  }
}

/// Residuals of the rows of laws that are on: u + softness λ - target.
RIGOR_FLOAT_LANES void set_law_residuals(const JointSides& sides, JointSize count, JointLanes& joint) {
  for (int r = count.held; r < count.rows; ++r) {
    joint.residual[r] =
        joint.on[r] * (row_rate(sides, joint, r) + joint.softness[r] * joint.impulse[r] - joint.target[r]);
  }
}

/// Residuals of what the joint holds: its rates.
RIGOR_FLOAT_LANES void set_held_rates(const JointSides& sides, JointSize count, JointLanes& joint) {
  for (int r = 0; r < count.held; ++r) joint.residual[r] = row_rate(sides, joint, r);
}

/// Of a body that joints hold taut.
RIGOR_FLOAT_LANES void raise_inertia(const TautBody& taut, JointSlot& slot) {
  add_stiffening(taut, slot.inertia);
  FloatSym3& W = slot.inverse_inertia;
  FloatSym3 raised;
  invert(slot.inertia, raised);
  // Lanes in which it is not taut keep their bits.
  const IntLanes is_taut = taut.share > float_lanes(0);
  W = {is_taut ? raised.xx : W.xx, is_taut ? raised.yy : W.yy, is_taut ? raised.zz : W.zz,
       is_taut ? raised.xy : W.xy, is_taut ? raised.xz : W.xz, is_taut ? raised.yz : W.yz};
}

/// What a stage needs of the bodies before its joints.
RIGOR_FLOAT_LANES void begin_stage(JointStage stage, float h, JointBlock& block) {
  for (std::size_t s = 0; s < block.slots.size(); ++s) {
    JointSlot& slot = block.slots[s];
    // Where the body is.
    if (stage == JointStage::aim) {
      slot.rotation = lane_rotation(slot.dr);
      update_inertia(slot);
      update_inverse_inertia(slot);
      if (block.is_taut) raise_inertia(block.taut_bodies[s], slot);
    }
    // What it resists without its children.
    if (stage == JointStage::factor && !block.loops) set_body_inertia(slot);
    // Where it will be, if velocities stay.
    if (stage == JointStage::position_error) {
      slot.next_rotation = rotation_on(slot.dr, float_lanes(h) * slot.w);
    }
    // Nothing has been pushed yet.
    if (stage == JointStage::position_error || stage == JointStage::drift) {
      for (FloatLanes& e : slot.push) e = float_lanes(0);
    }
  }
}

}  // namespace rigor
