#pragma once

#include "rigor/bulk/joint_lanes.hpp"

namespace rigor {

/// Place of an element of a lower triangle.
constexpr int lower(int row, int column) {
  return row * (row + 1) / 2 + column;
}

/// A = L Lᵀ in place; the diagonal holds inverses.
RIGOR_FLOAT_LANES void factor_lower(int size, FloatLanes* A) {
  for (int j = 0; j < size; ++j) {
    FloatLanes s = A[lower(j, j)];
    for (int k = 0; k < j; ++k) s -= A[lower(j, k)] * A[lower(j, k)];
    const FloatLanes inverse = 1.0F / float_sqrt(float_max(s, float_lanes(1e-30F)));
    A[lower(j, j)] = inverse;
    for (int i = j + 1; i < size; ++i) {
      FloatLanes e = A[lower(i, j)];
      for (int k = 0; k < j; ++k) e -= A[lower(i, k)] * A[lower(j, k)];
      A[lower(i, j)] = e * inverse;
    }
  }
}
/// x = L⁻¹ x.
RIGOR_FLOAT_LANES void solve_lower(int size, const FloatLanes* L, FloatLanes* x) {
  for (int i = 0; i < size; ++i) {
    FloatLanes s = x[i];
    for (int k = 0; k < i; ++k) s -= L[lower(i, k)] * x[k];
    x[i] = s * L[lower(i, i)];
  }
}
/// x = L⁻ᵀ x.
RIGOR_FLOAT_LANES void solve_upper(int size, const FloatLanes* L, FloatLanes* x) {
  for (int i = size - 1; i >= 0; --i) {
    FloatLanes s = x[i];
    for (int k = i + 1; k < size; ++k) s -= L[lower(k, i)] * x[k];
    x[i] = s * L[lower(i, i)];
  }
}

RIGOR_FLOAT_LANES void set_resistance(JointSlot& slot) {
  for (FloatLanes& e : slot.resistance) e = float_lanes(0);
  const FloatSym3& I = slot.inertia;
  for (int k = 0; k < 3; ++k) slot.resistance[lower(k, k)] = slot.mass;
  slot.resistance[lower(3, 3)] = I.xx;
  slot.resistance[lower(4, 3)] = I.xy;
  slot.resistance[lower(4, 4)] = I.yy;
  slot.resistance[lower(5, 3)] = I.xz;
  slot.resistance[lower(5, 4)] = I.yz;
  slot.resistance[lower(5, 5)] = I.zz;
}

/// How many rows a joint has, and how many of them it holds.
struct JointSize {
  int rows, held;
};

/// Factors of one joint, whose child has all of its resistance; adds to that of its parent.
RIGOR_FLOAT_LANES void factor_joint(const JointLink& link, JointSize count, JointSlot& child,
                                    JointSlot& parent, JointLanes& joint) {
  const auto [size, held] = count;
  for (int k = 0; k < 21; ++k) joint.L[k] = child.resistance[k];
  factor_lower(6, joint.L);
  const FloatVec3* a_child = link.child_is_B ? joint.a_B : joint.a_A;
  const FloatVec3* a_parent = link.child_is_B ? joint.a_A : joint.a_B;
  const FloatLanes sign = float_lanes(link.child_is_B ? 1 : -1);
  for (int r = 0; r < size; ++r) {
    const FloatLanes s = r < held ? sign : sign * joint.on[r];
    const FloatVec3 n = s * joint.n[r], a = s * a_child[r];
    FloatLanes* column = joint.W + 6 * r;
    column[0] = n.x, column[1] = n.y, column[2] = n.z;
    column[3] = a.x, column[4] = a.y, column[5] = a.z;
    solve_lower(6, joint.L, column);
    for (int c = 0; c <= r; ++c) {
      FloatLanes e = joint.W[6 * r] * joint.W[6 * c];
      for (int k = 1; k < 6; ++k) e += joint.W[6 * r + k] * joint.W[6 * c + k];
      joint.F[lower(r, c)] = e;
    }
    if (r >= held) joint.F[lower(r, r)] += joint.softness[r];
  }
  factor_lower(size, joint.F);
  if (!link.parent_is_free) return;
  for (int r = 0; r < size; ++r) {
    const FloatLanes s = r < held ? -sign : -sign * joint.on[r];
    const FloatVec3 n = s * joint.n[r], a = s * a_parent[r];
    FloatLanes* row = joint.X + 6 * r;
    row[0] = n.x, row[1] = n.y, row[2] = n.z;
    row[3] = a.x, row[4] = a.y, row[5] = a.z;
    for (int k = 0; k < 6; ++k) {
      FloatLanes e = row[k];
      for (int c = 0; c < r; ++c) e -= joint.F[lower(r, c)] * joint.X[6 * c + k];
      row[k] = e * joint.F[lower(r, r)];
    }
  }
  for (int i = 0; i < 6; ++i) {
    for (int k = 0; k <= i; ++k) {
      FloatLanes e = parent.resistance[lower(i, k)];
      for (int r = 0; r < size; ++r) e += joint.X[6 * r + i] * joint.X[6 * r + k];
      parent.resistance[lower(i, k)] = e;
    }
  }
}

/// On the way to the root: what the child's push and the residuals make the parent feel.
RIGOR_FLOAT_LANES void gather_push(const JointLink& link, int size, const JointSlot& child, JointSlot& parent,
                                   JointLanes& joint) {
  for (int k = 0; k < 6; ++k) joint.t[k] = child.push[k];
  solve_lower(6, joint.L, joint.t);
  for (int r = 0; r < size; ++r) {
    FloatLanes e = -joint.residual[r];
    for (int k = 0; k < 6; ++k) e -= joint.W[6 * r + k] * joint.t[k];
    joint.z[r] = e;
  }
  solve_lower(size, joint.F, joint.z);
  if (!link.parent_is_free) return;
  for (int k = 0; k < 6; ++k) {
    FloatLanes e = parent.push[k];
    for (int r = 0; r < size; ++r) e += joint.X[6 * r + k] * joint.z[r];
    parent.push[k] = e;
  }
}

/// On the way back: the impulse of the joint and what its child does.
RIGOR_FLOAT_LANES void spread_change(const JointLink& link, int size, const JointSlot& parent,
                                     JointSlot& child, JointLanes& joint) {
  FloatLanes y[kMostJointRows];
  for (int r = 0; r < size; ++r) {
    y[r] = joint.z[r];
    if (!link.parent_is_free) continue;
    for (int k = 0; k < 6; ++k) y[r] -= joint.X[6 * r + k] * parent.change[k];
  }
  solve_upper(size, joint.F, y);
  for (int k = 0; k < 6; ++k) {
    FloatLanes e = joint.t[k];
    for (int r = 0; r < size; ++r) e += joint.W[6 * r + k] * y[r];
    child.change[k] = e;
  }
  solve_upper(6, joint.L, child.change);
  for (int r = 0; r < size; ++r) joint.impulse[r] += y[r];
}

}  // namespace rigor
