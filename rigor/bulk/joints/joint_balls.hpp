#pragma once

#include "rigor/bulk/joints/articulated_inertia.hpp"
#include "rigor/bulk/joints/joint_factors.hpp"
#include "rigor/bulk/joints/joint_rotations.hpp"

namespace rigor {

// Ball joints without laws, whose children are taken into a tree by what their anchors resist:
// docs/theory/bulk_joints.md, §2. A is the articulated inertia of a child, lower triangle: translation, then
// rotation.

/// The arms where the bodies are.
RIGOR_FLOAT_LANES void aim_ball(const JointLink& link, const JointSlot& child, const JointSlot& parent,
                                const JointLanes& joint, BallLanes& ball) {
  ball.arm_child = rotate(child.rotation, link.child_is_B ? joint.arm_B : joint.arm_A);
  ball.arm_parent = rotate(parent.rotation, link.child_is_B ? joint.arm_A : joint.arm_B);
}

/// x = J⁻¹ x with the factors J = L D Lᵀ: forwards through L, by D, back through Lᵀ.
RIGOR_FLOAT_LANES FloatVec3 solve_rotation(const BallLanes& ball, FloatVec3 x) {
  x.y -= ball.L[0] * x.x;
  x.z -= ball.L[1] * x.x + ball.L[2] * x.y;
  x = {x.x * ball.inverse_D[0], x.y * ball.inverse_D[1], x.z * ball.inverse_D[2]};
  x.y -= ball.L[2] * x.z;
  x.x -= ball.L[0] * x.y + ball.L[1] * x.z;
  return x;
}

/// Factors of one joint, whose child has all of its articulated inertia; adds what the anchor resists to that
/// of the parent.
RIGOR_FLOAT_LANES void factor_ball(const JointLink& link, const JointSlot& child, JointSlot& parent,
                                   BallLanes& ball) {
  const FloatLanes* A = child.articulated;
  const ArticulatedInertia all = articulated_inertia_at(ball.arm_child, A);
  const FloatVec3* H = all.H;
  const FloatSym3& J = all.J;

  // J = L D Lᵀ.
  ball.inverse_D[0] = 1.0F / J.xx;
  ball.L[0] = J.xy * ball.inverse_D[0];
  ball.L[1] = J.xz * ball.inverse_D[0];
  const FloatLanes zy_rest = J.yz - ball.L[1] * J.xy;
  ball.inverse_D[1] = 1.0F / (J.yy - ball.L[0] * J.xy);
  ball.L[2] = zy_rest * ball.inverse_D[1];
  ball.inverse_D[2] = 1.0F / (J.zz - ball.L[1] * J.xz - ball.L[2] * zy_rest);

  // S = M - H J⁻¹ Hᵀ.
  for (int j = 0; j < 3; ++j) ball.G[j] = solve_rotation(ball, H[j]);
  FloatSym3& S = ball.S;
  S.xx = A[0] - dot(H[0], ball.G[0]);
  S.xy = A[1] - dot(H[1], ball.G[0]);
  S.yy = A[2] - dot(H[1], ball.G[1]);
  S.xz = A[3] - dot(H[2], ball.G[0]);
  S.yz = A[4] - dot(H[2], ball.G[1]);
  S.zz = A[5] - dot(H[2], ball.G[2]);
  if (!link.parent_is_free) return;

  // The parent feels S at its anchor, where u = v - s × ω.
  const FloatVec3& s = ball.arm_parent;
  const FloatVec3 N[3] = {cross(s, {S.xx, S.xy, S.xz}), cross(s, {S.xy, S.yy, S.yz}),
                          cross(s, {S.xz, S.yz, S.zz})};  // Columns of s~ S.
  FloatLanes* P = parent.articulated;
  P[0] += S.xx;
  P[1] += S.xy;
  P[2] += S.yy;
  P[3] += S.xz;
  P[4] += S.yz;
  P[5] += S.zz;
  const FloatVec3 rows[3] = {{N[0].x, N[1].x, N[2].x}, {N[0].y, N[1].y, N[2].y}, {N[0].z, N[1].z, N[2].z}};
  // -s~ S s~ by columns.
  const FloatVec3 about[3] = {cross(s, rows[0]), cross(s, rows[1]), cross(s, rows[2])};
  P[6] += rows[0].x;
  P[7] += rows[0].y;
  P[8] += rows[0].z;
  P[9] += about[0].x;
  P[10] += rows[1].x;
  P[11] += rows[1].y;
  P[12] += rows[1].z;
  P[13] += about[1].x;
  P[14] += about[1].y;
  P[15] += rows[2].x;
  P[16] += rows[2].y;
  P[17] += rows[2].z;
  P[18] += about[2].x;
  P[19] += about[2].y;
  P[20] += about[2].z;
}

/// What is wanted of places: the anchors' distance after the time h, over h, is taken away.
RIGOR_FLOAT_LANES void miss_ball(const JointLink& link, float h, const JointSlot& child,
                                 const JointSlot& parent, const JointLanes& joint, BallLanes& ball) {
  const JointSlot& A = link.child_is_B ? parent : child;
  const JointSlot& B = link.child_is_B ? child : parent;
  const FloatVec3 displacement = (B.dp - A.dp) + float_lanes(h) * (B.v - A.v);
  const JointPose pose = joint_pose<false>(joint, A.next_rotation, B.next_rotation, displacement);
  ball.wanted = float_lanes((link.child_is_B ? -1 : 1) / h) * pose.d;
}

/// What is wanted of rates: the relative velocity of the anchors is taken away.
RIGOR_FLOAT_LANES void drift_ball(const JointSlot& child, const JointSlot& parent, BallLanes& ball) {
  ball.wanted = (parent.v - cross(ball.arm_parent, parent.w)) - (child.v - cross(ball.arm_child, child.w));
}

/// On the way to the root: what the anchor takes up of the child's push p, and what the parent feels.
RIGOR_FLOAT_LANES void gather_ball(const JointLink& link, const JointSlot& child, JointSlot& parent,
                                   BallLanes& ball) {
  // J⁻¹ p_ω, p_ω being about the anchor, and q = p_u - H J⁻¹ p_ω.
  const FloatLanes* p = child.push;
  const FloatVec3 force{p[0], p[1], p[2]};
  const FloatVec3 torque = FloatVec3{p[3], p[4], p[5]} - cross(ball.arm_child, force);
  ball.free_dw = solve_rotation(ball, torque);
  ball.reaction = force - FloatVec3{dot(ball.G[0], torque), dot(ball.G[1], torque), dot(ball.G[2], torque)};
  if (!link.parent_is_free) return;

  // The parent feels q - S b at its anchor.
  const FloatVec3 f = ball.reaction - ball.S * ball.wanted;
  const FloatVec3 about = cross(ball.arm_parent, f);
  add_push(f, about, parent);
}

/// On the way back: the change of the child and the impulse of the joint.
RIGOR_FLOAT_LANES void spread_ball(const JointLink& link, const JointSlot& parent, JointSlot& child,
                                   JointLanes& joint, BallLanes& ball) {
  // The velocity of the anchor, u = b + u_parent.
  FloatVec3 u = ball.wanted;
  if (link.parent_is_free) {
    const FloatLanes* c = parent.change;
    u = u + (FloatVec3{c[0], c[1], c[2]} - cross(ball.arm_parent, {c[3], c[4], c[5]}));
  }

  // Δω = J⁻¹ (p_ω - Hᵀ u), Δv = u + r × Δω.
  const FloatVec3 w = ball.free_dw - (u.x * ball.G[0] + (u.y * ball.G[1] + u.z * ball.G[2]));
  const FloatVec3 v = u + cross(ball.arm_child, w);
  set_change(v, w, child);

  // λ = S u - q, on the child.
  const FloatVec3 impulse = ball.S * u - ball.reaction;
  const FloatLanes sign = float_lanes(link.child_is_B ? 1 : -1);
  joint.impulse[0] += sign * impulse.x;
  joint.impulse[1] += sign * impulse.y;
  joint.impulse[2] += sign * impulse.z;
}

}  // namespace rigor
