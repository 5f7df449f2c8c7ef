#pragma once

#include "rigor/bulk/joints/joint_rotations.hpp"

namespace rigor {

/// Place of an element of a lower triangle.
constexpr int lower(int row, int column) {
  return row * (row + 1) / 2 + column;
}

// Factors and solves of a tree whose joints hold any rows: docs/theory/bulk_joints.md, §2.

/// A = L Lᵀ in place, column after column; the diagonal holds the inverses of that of L.
RIGOR_FLOAT_LANES void factor_lower(int size, FloatLanes* A) {
  for (int j = 0; j < size; ++j) {
    // The diagonal element; rounding must not make it negative.
    FloatLanes s = A[lower(j, j)];
    for (int k = 0; k < j; ++k) s -= A[lower(j, k)] * A[lower(j, k)];
    const FloatLanes inverse = 1.0F / float_sqrt(float_max(s, float_lanes(1e-30F)));
    A[lower(j, j)] = inverse;
    // The elements below.
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

/// The inertia of a body alone: its mass matrix.
RIGOR_FLOAT_LANES void set_body_inertia(JointSlot& slot) {
  for (FloatLanes& e : slot.articulated) e = float_lanes(0);
  const FloatSym3& I = slot.inertia;
  for (int k = 0; k < 3; ++k) slot.articulated[lower(k, k)] = slot.mass;
  slot.articulated[lower(3, 3)] = I.xx;
  slot.articulated[lower(4, 3)] = I.xy;
  slot.articulated[lower(4, 4)] = I.yy;
  slot.articulated[lower(5, 3)] = I.xz;
  slot.articulated[lower(5, 4)] = I.yz;
  slot.articulated[lower(5, 5)] = I.zz;
}

/// Inertia in W where the body is: of principal axes e and moments I, with E the identity,
///
///   I_2 E + (I_0 - I_2) e_0 e_0ᵀ + (I_1 - I_2) e_1 e_1ᵀ.
RIGOR_FLOAT_LANES FloatSym3 moments_in_W(const JointSlot& slot, const FloatLanes* I) {
  const FloatVec3 e0 = rotate(slot.rotation, slot.axis0), e1 = rotate(slot.rotation, slot.axis1);
  const FloatVec3 a = (I[0] - I[2]) * e0, b = (I[1] - I[2]) * e1;
  return {I[2] + a.x * e0.x + b.x * e1.x, I[2] + a.y * e0.y + b.y * e1.y, I[2] + a.z * e0.z + b.z * e1.z,
          a.x * e0.y + b.x * e1.y,        a.x * e0.z + b.x * e1.z,        a.y * e0.z + b.y * e1.z};
}
RIGOR_FLOAT_LANES void update_inertia(JointSlot& slot) {
  slot.inertia = moments_in_W(slot, slot.moments);
}
RIGOR_FLOAT_LANES void update_inverse_inertia(JointSlot& slot) {
  slot.inverse_inertia = moments_in_W(slot, slot.inverse_moments);
}

/// What the inertia is raised by of a body that joints hold taut (taut_links.hpp).
RIGOR_FLOAT_LANES void add_stiffening(const TautBody& taut, FloatSym3& inertia) {
  const FloatSym3& S = taut.stiffening;
  inertia = {inertia.xx + S.xx, inertia.yy + S.yy, inertia.zz + S.zz,
             inertia.xy + S.xy, inertia.xz + S.xz, inertia.yz + S.yz};
}

/// Adds the changes of the last solve to the velocities of the body.
RIGOR_FLOAT_LANES void add_change(JointSlot& slot) {
  const FloatVec3 v{slot.change[0], slot.change[1], slot.change[2]};
  const FloatVec3 w{slot.change[3], slot.change[4], slot.change[5]};
  slot.v = slot.v + v;
  slot.w = slot.w + w;
  slot.made_v = slot.made_v + v;
  slot.made_w = slot.made_w + w;
}

/// How many rows a joint has, and how many of them it holds.
struct JointSize {
  int rows, held;
};

/// Factors of one joint, whose child has all of its articulated inertia A = L Lᵀ: F Fᵀ = K = C A⁻¹ Cᵀ +
/// softness. Adds Pᵀ K⁻¹ P to the articulated inertia of the parent.
RIGOR_FLOAT_LANES void factor_joint(const JointLink& link, JointSize count, JointSlot& child,
                                    JointSlot& parent, JointLanes& joint) {
  // L of the child.
  const auto [size, held] = count;
  for (int k = 0; k < 21; ++k) joint.L[k] = child.articulated[k];
  factor_lower(6, joint.L);

  // W = L⁻¹ Cᵀ, row after row of C, and K = Wᵀ W + softness. Rows of laws count in the lanes where they are
  // on.
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

  // X = F⁻¹ P.
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

  // A_parent += Xᵀ X = Pᵀ K⁻¹ P.
  for (int i = 0; i < 6; ++i) {
    for (int k = 0; k <= i; ++k) {
      FloatLanes e = parent.articulated[lower(i, k)];
      for (int r = 0; r < size; ++r) e += joint.X[6 * r + i] * joint.X[6 * r + k];
      parent.articulated[lower(i, k)] = e;
    }
  }
}

/// The root of a tree that floats: L Lᵀ is its articulated inertia, t = L⁻¹ p, and its change is L⁻ᵀ t.
RIGOR_FLOAT_LANES void factor_root(const JointSlot& slot, JointLanes& root) {
  for (int k = 0; k < 21; ++k) root.L[k] = slot.articulated[k];
  factor_lower(6, root.L);
}
RIGOR_FLOAT_LANES void gather_root(const JointSlot& slot, JointLanes& root) {
  for (int k = 0; k < 6; ++k) root.t[k] = slot.push[k];
  solve_lower(6, root.L, root.t);
}
RIGOR_FLOAT_LANES void spread_root(const JointLanes& root, JointSlot& slot) {
  for (int k = 0; k < 6; ++k) slot.change[k] = root.t[k];
  solve_upper(6, root.L, slot.change);
}

/// On the way to the root: z = F⁻¹ (b - C A⁻¹ p) with the push p of the child and the residuals -b; the
/// parent feels Pᵀ F⁻ᵀ z.
RIGOR_FLOAT_LANES void gather_push(const JointLink& link, int size, const JointSlot& child, JointSlot& parent,
                                   JointLanes& joint) {
  // t = L⁻¹ p.
  for (int k = 0; k < 6; ++k) joint.t[k] = child.push[k];
  solve_lower(6, joint.L, joint.t);

  // C A⁻¹ p = Wᵀ t.
  for (int r = 0; r < size; ++r) {
    FloatLanes e = -joint.residual[r];
    for (int k = 0; k < 6; ++k) e -= joint.W[6 * r + k] * joint.t[k];
    joint.z[r] = e;
  }
  solve_lower(size, joint.F, joint.z);
  if (!link.parent_is_free) return;

  // p_parent += Xᵀ z.
  for (int k = 0; k < 6; ++k) {
    FloatLanes e = parent.push[k];
    for (int r = 0; r < size; ++r) e += joint.X[6 * r + k] * joint.z[r];
    parent.push[k] = e;
  }
}

/// On the way back: the impulse λ = F⁻ᵀ (z - X Δv_parent) of the joint, and the change Δv = L⁻ᵀ (t + W λ) of
/// its child.
RIGOR_FLOAT_LANES void spread_change(const JointLink& link, int size, const JointSlot& parent,
                                     JointSlot& child, JointLanes& joint) {
  // The impulse.
  FloatLanes y[kMostJointRows];
  for (int r = 0; r < size; ++r) {
    y[r] = joint.z[r];
    if (!link.parent_is_free) continue;
    for (int k = 0; k < 6; ++k) y[r] -= joint.X[6 * r + k] * parent.change[k];
  }
  solve_upper(size, joint.F, y);

  // The change of the child.
  for (int k = 0; k < 6; ++k) {
    FloatLanes e = joint.t[k];
    for (int r = 0; r < size; ++r) e += joint.W[6 * r + k] * y[r];
    child.change[k] = e;
  }
  solve_upper(6, joint.L, child.change);
  for (int r = 0; r < size; ++r) joint.impulse[r] += y[r];
}

}  // namespace rigor
