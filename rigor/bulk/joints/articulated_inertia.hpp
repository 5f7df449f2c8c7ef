#pragma once

#include "rigor/bulk/joints/joint_lanes.hpp"

namespace rigor {

// What ball joints and hinges in trees share: what a body resists at an anchor, and what goes up and down a
// tree (docs/theory/bulk_joints.md, §2).

/// Force and torque of an articulated inertia at the anchor to (u, ω).
RIGOR_FLOAT_LANES void apply_inertia(const ArticulatedInertia& A, const FloatVec3& u, const FloatVec3& w,
                                     FloatVec3& force, FloatVec3& torque) {
  force = A.M * u + FloatVec3{dot(A.H[0], w), dot(A.H[1], w), dot(A.H[2], w)};
  torque = (u.x * A.H[0] + (u.y * A.H[1] + u.z * A.H[2])) + A.J * w;
}

/// The inertia A of a body, lower triangle, at an anchor at r from its centre: v = u + r × ω.
RIGOR_FLOAT_LANES ArticulatedInertia articulated_inertia_at(const FloatVec3& r, const FloatLanes* A) {
  // Hᵀ = B - r~ M and J = A_ωω + Hᵀ r~ + (B r~)ᵀ.
  const FloatVec3 M[3] = {{A[0], A[1], A[3]}, {A[1], A[2], A[4]}, {A[3], A[4], A[5]}};
  const FloatVec3 B[3] = {{A[6], A[10], A[15]}, {A[7], A[11], A[16]}, {A[8], A[12], A[17]}};  // Columns.
  ArticulatedInertia at;
  at.M = {A[0], A[2], A[5], A[1], A[3], A[4]};
  for (int j = 0; j < 3; ++j) at.H[j] = B[j] - cross(r, M[j]);
  const FloatVec3* H = at.H;
  const FloatVec3 x = cross(FloatVec3{H[0].x, H[1].x, H[2].x}, r),
                  y = cross(FloatVec3{H[0].y, H[1].y, H[2].y}, r),
                  z = cross(FloatVec3{H[0].z, H[1].z, H[2].z}, r);
  const FloatVec3 Bx = cross(FloatVec3{B[0].x, B[1].x, B[2].x}, r),
                  By = cross(FloatVec3{B[0].y, B[1].y, B[2].y}, r),
                  Bz = cross(FloatVec3{B[0].z, B[1].z, B[2].z}, r);
  at.J.xx = A[9] + x.x + Bx.x;
  at.J.xy = A[13] + y.x + Bx.y;
  at.J.yy = A[14] + y.y + By.y;
  at.J.xz = A[18] + z.x + Bx.z;
  at.J.yz = A[19] + z.y + By.z;
  at.J.zz = A[20] + z.z + Bz.z;
  return at;
}

/// Adds a force and a torque to what pushes a body of a tree.
RIGOR_FLOAT_LANES void add_push(const FloatVec3& force, const FloatVec3& torque, JointSlot& slot) {
  slot.push[0] += force.x;
  slot.push[1] += force.y;
  slot.push[2] += force.z;
  slot.push[3] += torque.x;
  slot.push[4] += torque.y;
  slot.push[5] += torque.z;
}

/// Sets the change of a body's velocities.
RIGOR_FLOAT_LANES void set_change(const FloatVec3& v, const FloatVec3& w, JointSlot& slot) {
  slot.change[0] = v.x;
  slot.change[1] = v.y;
  slot.change[2] = v.z;
  slot.change[3] = w.x;
  slot.change[4] = w.y;
  slot.change[5] = w.z;
}

}  // namespace rigor
