#pragma once

#include "rigor/bulk/joints/articulated_inertia.hpp"

namespace rigor {

// Hinges in a tree, taken up by what their one free rotation leaves of the child's articulated inertia:
// docs/theory/bulk_joints.md, §2. Rows: three of the anchor, two across the axis, and that of the law.

/// The rows of a hinge.
constexpr int kHingeSwing = 3, kHingeLaw = 5;

/// Adds an articulated inertia at the anchor to that of a body, whose centre is at -s from it.
RIGOR_FLOAT_LANES void add_inertia_at(const FloatVec3& s, const ArticulatedInertia& A, FloatLanes* P) {
  const FloatSym3 &M = A.M, &J = A.J;
  const FloatVec3* H = A.H;
  // u = v - s × ω: forces f at the anchor are the torques s × f about the centre.
  const FloatVec3 m[3] = {{M.xx, M.xy, M.xz}, {M.xy, M.yy, M.yz}, {M.xz, M.yz, M.zz}};
  // Rows of the force by (v, ω): (M, H - M s~), s~ ω = s × ω.
  const FloatVec3 K[3] = {H[0] + cross(s, m[0]), H[1] + cross(s, m[1]), H[2] + cross(s, m[2])};
  // Torque about the centre by ω: J - Hᵀ s~ + s~ (H - M s~).
  const FloatVec3 x = cross(s, {K[0].x, K[1].x, K[2].x}), y = cross(s, {K[0].y, K[1].y, K[2].y}),
                  z = cross(s, {K[0].z, K[1].z, K[2].z});
  const FloatVec3 Hx = cross(s, {H[0].x, H[1].x, H[2].x}), Hy = cross(s, {H[0].y, H[1].y, H[2].y}),
                  Hz = cross(s, {H[0].z, H[1].z, H[2].z});
  P[0] += M.xx;
  P[1] += M.xy;
  P[2] += M.yy;
  P[3] += M.xz;
  P[4] += M.yz;
  P[5] += M.zz;
  // Rows of the torque, by v and then by ω.
  P[6] += K[0].x;
  P[7] += K[1].x;
  P[8] += K[2].x;
  P[9] += J.xx + x.x + Hx.x;
  P[10] += K[0].y;
  P[11] += K[1].y;
  P[12] += K[2].y;
  P[13] += J.xy + y.x + Hx.y;
  P[14] += J.yy + y.y + Hy.y;
  P[15] += K[0].z;
  P[16] += K[1].z;
  P[17] += K[2].z;
  P[18] += J.xz + z.x + Hx.z;
  P[19] += J.yz + z.y + Hy.z;
  P[20] += J.zz + z.z + Hz.z;
}

/// The arm from a centre to the anchor, by the rows of the anchor.
RIGOR_FLOAT_LANES FloatVec3 arm_of(const FloatVec3* a) {
  return {a[1].z, -a[0].z, a[0].y};
}

/// S - a bᵀ, where a and b are parallel.
RIGOR_FLOAT_LANES void subtract_outer(const FloatVec3& a, const FloatVec3& b, FloatSym3& S) {
  S.xx -= a.x * b.x;
  S.xy -= a.x * b.y;
  S.yy -= a.y * b.y;
  S.xz -= a.x * b.z;
  S.yz -= a.y * b.z;
  S.zz -= a.z * b.z;
}

/// Factors of one joint, whose child has all of its articulated inertia; adds what is left of that to the
/// parent's. Where the law is off the child rotates freely about the axis s, and the anchor resists with A -
/// A s sᵀ A / sᵀ A s; where it is on only as far as it is soft.
RIGOR_FLOAT_LANES void factor_hinge(const JointLink& link, const JointSlot& child, JointSlot& parent,
                                    const JointLanes& joint, HingeLanes& hinge) {
  hinge.arm_child = arm_of(link.child_is_B ? joint.a_B : joint.a_A);
  hinge.arm_parent = arm_of(link.child_is_B ? joint.a_A : joint.a_B);
  const FloatVec3 axis = cross(joint.a_B[kHingeSwing], joint.a_B[kHingeSwing + 1]);
  const ArticulatedInertia all = articulated_inertia_at(hinge.arm_child, child.articulated);
  hinge.all = all;

  // A s, s being the rotation about the axis, and the pieces of the law.
  const FloatVec3* H = all.H;
  hinge.axis = axis;
  hinge.axis_force = {dot(H[0], axis), dot(H[1], axis), dot(H[2], axis)};
  hinge.axis_torque = all.J * axis;
  const FloatLanes D = dot(axis, hinge.axis_torque);
  const FloatLanes on = joint.on[kHingeLaw], softness = on * joint.softness[kHingeLaw];
  const FloatLanes one = float_lanes(1);
  hinge.follows = on / (one + softness * D);
  hinge.yields = softness * hinge.follows + (one - on) / D;
  if (!link.parent_is_free) return;

  // What the parent feels.
  const FloatVec3 &f = hinge.axis_force, &t = hinge.axis_torque, a = hinge.yields * f, b = hinge.yields * t;
  ArticulatedInertia left = all;
  subtract_outer(a, f, left.M);
  left.H[0] = left.H[0] - a.x * t;
  left.H[1] = left.H[1] - a.y * t;
  left.H[2] = left.H[2] - a.z * t;
  subtract_outer(b, t, left.J);
  add_inertia_at(hinge.arm_parent, left, parent.articulated);
}

/// On the way to the root: what of the child's push p the changes b that are wanted leave, p - A b, and what
/// the parent feels of it.
RIGOR_FLOAT_LANES void gather_hinge(const JointLink& link, const JointSlot& child, JointSlot& parent,
                                    const JointLanes& joint, HingeLanes& hinge) {
  // The changes of the child against the parent: of the anchor, across the axis, about it.
  const FloatLanes sign = float_lanes(link.child_is_B ? -1 : 1);
  const FloatLanes* residual = joint.residual;
  hinge.wanted_u = sign * FloatVec3{residual[0], residual[1], residual[2]};
  hinge.wanted_w = sign * (residual[kHingeSwing] * joint.a_B[kHingeSwing] +
                           residual[kHingeSwing + 1] * joint.a_B[kHingeSwing + 1]);
  hinge.wanted_turn = joint.has_law_on ? sign * residual[kHingeLaw] : float_lanes(0);

  // The push about the anchor.
  const FloatLanes* p = child.push;
  const FloatVec3 force{p[0], p[1], p[2]};
  const FloatVec3 torque = FloatVec3{p[3], p[4], p[5]} - cross(hinge.arm_child, force);
  FloatVec3 held_force, held_torque;
  apply_inertia(hinge.all, hinge.wanted_u, hinge.wanted_w, held_force, held_torque);
  hinge.force = force - held_force;
  hinge.torque = torque - held_torque;
  hinge.about_axis = dot(hinge.axis, hinge.torque);
  if (!link.parent_is_free) return;

  // What is not used up by the rotation about the axis.
  const FloatLanes turn = hinge.follows * hinge.wanted_turn + hinge.yields * hinge.about_axis;
  const FloatVec3 f = hinge.force - turn * hinge.axis_force;
  const FloatVec3 about = (hinge.torque - turn * hinge.axis_torque) + cross(hinge.arm_parent, f);
  add_push(f, about, parent);
}

/// On the way back: the change of the child and the impulses of the joint.
RIGOR_FLOAT_LANES void spread_hinge(const JointLink& link, const JointSlot& parent, JointSlot& child,
                                    JointLanes& joint, HingeLanes& hinge) {
  // The change of the parent, at the anchor.
  FloatVec3 u{}, w{};
  if (link.parent_is_free) {
    const FloatLanes* c = parent.change;
    w = {c[3], c[4], c[5]};
    u = FloatVec3{c[0], c[1], c[2]} - cross(hinge.arm_parent, w);
  }
  // The rotation about the axis.
  const FloatLanes about = hinge.about_axis - (dot(hinge.axis_force, u) + dot(hinge.axis_torque, w));
  w = w + (hinge.follows * hinge.wanted_turn + hinge.yields * about) * hinge.axis;

  // The impulse on the child, along the rows.
  FloatVec3 force, torque;
  apply_inertia(hinge.all, u, w, force, torque);
  const FloatLanes sign = float_lanes(link.child_is_B ? 1 : -1);
  force = sign * (force - hinge.force);
  torque = sign * (torque - hinge.torque);
  joint.impulse[0] += force.x;
  joint.impulse[1] += force.y;
  joint.impulse[2] += force.z;
  for (int r = kHingeSwing; r < kHingeLaw; ++r) joint.impulse[r] += dot(joint.a_B[r], torque);
  if (joint.has_law_on) joint.impulse[kHingeLaw] += joint.on[kHingeLaw] * dot(hinge.axis, torque);

  // The change of the child, Δv = u + r × Δω.
  w = w + hinge.wanted_w;
  const FloatVec3 v = u + hinge.wanted_u + cross(hinge.arm_child, w);
  set_change(v, w, child);
}

}  // namespace rigor
