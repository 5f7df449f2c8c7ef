// The equations of trees of ball joints (docs/theory/bulk_joints.md, section 2) for contact-free chains.
// Included once for each target, after fused_lanes.inl and rotation_lanes.inl.

/// A body, and the joint between it (the child) and its parent.
struct alignas(32) FreeNode {
  FloatVec3 v, w, dp, dr;
  FloatVec3 free_v, free_w;  ///< Before joints hold.
  FloatVec3 dv, dw;          ///< What forces change in a substep.
  FloatVec3 turned_w;      ///< After the gyroscopic torque of a substep, before all else that changes ω, ...
  FloatVec3 others;        ///< ... and what that changes.
  LaneRotation rotation;   ///< By h ω.
  FloatVec3 axes[2];       ///< The first two principal axes.
  FloatVec3 push, moment;  ///< Impulse that children give, and its moment about the centre of mass.
  FloatVec3 change_v, change_w;
  // Articulated inertia that children add to velocities v and ω: (M, B; Bᵀ, J), with the columns of Bᵀ.
  FloatSym3 M, J;
  FloatVec3 B[3];

  FloatVec3 arm_child, arm_parent;  ///< From the centres to the anchor [m].
  FloatVec3 apart;                  ///< From the anchor on the parent to that on the child [m], ...
  FloatVec3 left_out;               ///< ... but for this, which is put back later: as in JointApproach.
  FloatVec3 wanted;                 ///< Change of the anchor's velocity on the child against the parent.
  FloatVec3 impulse;                ///< On the child [N s].
  FloatVec3 first_impulse;  ///< What counts of it before a half substep, each round of which begins with it.
  // Factors as in BallLanes.
  FloatLanes inverse_D[3], L[3];
  FloatVec3 G[3];
  FloatSym3 S;
  FloatVec3 free_dw,
      reaction;  ///< As in BallLanes: the change of ω if the anchor is held, and what is taken up there.
};

using FreeTables = ContactFreeChains::Tables;
using FreeJoint = ContactFreeChains::Joint;

/// x = J⁻¹ b with the factors J = L D Lᵀ.
RIGOR_FLOAT_LANES FloatVec3 solve_rotation(const FreeNode& node, const FloatVec3& b) {
  // Forwards through L, by D, back through Lᵀ.
  const FloatLanes y = fused(-node.L[0], b.x, b.y);
  const FloatLanes z = fused(-node.L[2], y, fused(-node.L[1], b.x, b.z)) * node.inverse_D[2];
  const FloatLanes x_y = fused(-node.L[2], z, y * node.inverse_D[1]);
  return {fused(-node.L[0], x_y, fused(-node.L[1], z, b.x * node.inverse_D[0])), x_y, z};
}
/// S⁻¹ b, by the factors L D Lᵀ of S.
RIGOR_FLOAT_LANES FloatVec3 solve_symmetric(const FloatSym3& S, const FloatVec3& b) {
  const FloatLanes one = splat(1);
  FreeNode factors;
  factors.inverse_D[0] = one / S.xx;
  factors.L[0] = S.xy * factors.inverse_D[0];
  factors.L[1] = S.xz * factors.inverse_D[0];
  const FloatLanes rest = fused(-factors.L[1], S.xy, S.yz);
  factors.inverse_D[1] = one / fused(-factors.L[0], S.xy, S.yy);
  factors.L[2] = rest * factors.inverse_D[1];
  factors.inverse_D[2] = one / fused(-factors.L[2], rest, fused(-factors.L[1], S.xz, S.zz));
  return solve_rotation(factors, b);
}
/// c - a · b.
RIGOR_FLOAT_LANES FloatLanes less_dot(const FloatLanes& c, const FloatVec3& a, const FloatVec3& b) {
  return fused(-a.z, b.z, fused(-a.y, b.y, fused(-a.x, b.x, c)));
}

/// Adds the articulated inertia S of the child, at the anchor of the parent, to that of the parent: with u =
/// v - s × ω it is (S, s~ S; ., -s~ S s~) for v and ω, s being the arm of the parent.
RIGOR_FLOAT_LANES void add_to_parent(const FreeJoint& joint, const FreeNode& node, FreeNode& parent) {
  const FloatSym3& S = node.S;
  const FloatVec3& s = node.arm_parent;
  const FloatVec3 N[3] = {fused_cross(s, {S.xx, S.xy, S.xz}), fused_cross(s, {S.xy, S.yy, S.yz}),
                          fused_cross(s, {S.xz, S.yz, S.zz})};  // Columns of s~ S.
  // -s~ S s~.
  const FloatSym3 about = {fused(s.y, N[2].x, -(s.z * N[1].x)), fused(s.z, N[0].y, -(s.x * N[2].y)),
                           fused(s.x, N[1].z, -(s.y * N[0].z)), fused(s.y, N[2].y, -(s.z * N[1].y)),
                           fused(s.y, N[2].z, -(s.z * N[1].z)), fused(s.z, N[0].z, -(s.x * N[2].z))};

  // The first child of a parent begins the sum.
  if (joint.is_first) {
    parent.M = S;
    parent.J = about;
    for (int j = 0; j < 3; ++j) parent.B[j] = N[j];
    return;
  }
  parent.M = {parent.M.xx + S.xx, parent.M.yy + S.yy, parent.M.zz + S.zz,
              parent.M.xy + S.xy, parent.M.xz + S.xz, parent.M.yz + S.yz};
  parent.J = {parent.J.xx + about.xx, parent.J.yy + about.yy, parent.J.zz + about.zz,
              parent.J.xy + about.xy, parent.J.xz + about.xz, parent.J.yz + about.yz};
  for (int j = 0; j < 3; ++j) parent.B[j] = parent.B[j] + N[j];
}

/// Inertia about the centre of mass where the body is: I₂ E + (I₀ - I₂) e₀ e₀ᵀ + (I₁ - I₂) e₁ e₁ᵀ; of bodies
/// of revolution without the last term, since I₁ = I₂.
template <bool of_revolution>
RIGOR_FLOAT_LANES FloatSym3 inertia_of(const ContactFreeChains::Body& body, const FreeNode& node) {
  const FloatLanes* I = body.moments;
  const FloatVec3& e = node.axes[0];
  const FloatVec3 a = (I[0] - I[2]) * e;
  FloatSym3 sum = {
      fused(a.x, e.x, I[2]), fused(a.y, e.y, I[2]), fused(a.z, e.z, I[2]), a.x * e.y, a.x * e.z, a.y * e.z};
  if constexpr (!of_revolution) {
    const FloatVec3& f = node.axes[1];
    const FloatVec3 b = (I[1] - I[2]) * f;
    sum = {fused(b.x, f.x, sum.xx), fused(b.y, f.y, sum.yy), fused(b.z, f.z, sum.zz),
           fused(b.x, f.y, sum.xy), fused(b.x, f.z, sum.xz), fused(b.y, f.z, sum.yz)};
  }
  return sum;
}

/// As factor_ball(): the articulated inertia of the child to velocities u of its anchor and ω, and S of the
/// anchor if the child rotates freely.
template <bool of_revolution>
RIGOR_FLOAT_LANES void factor_free(const ContactFreeChains::Body& body, const FreeJoint& joint,
                                   const FloatSym3* stiffening, FreeNode& node) {
  // The articulated inertia (M, B; Bᵀ, J) about the centre of mass: of the body and of all that hangs on it.
  const FloatLanes zero = splat(0);
  const FloatVec3& r = node.arm_child;
  FloatSym3 M = {body.mass, body.mass, body.mass, zero, zero, zero};
  FloatSym3 J = inertia_of<of_revolution>(body, node);
  if (stiffening != nullptr) {
    J = {J.xx + stiffening->xx, J.yy + stiffening->yy, J.zz + stiffening->zz,
         J.xy + stiffening->xy, J.xz + stiffening->xz, J.yz + stiffening->yz};
  }
  FloatVec3 B[3] = {{zero, zero, zero}, {zero, zero, zero}, {zero, zero, zero}};
  if (joint.has_children) {
    M = {
        body.mass + node.M.xx, body.mass + node.M.yy, body.mass + node.M.zz, node.M.xy, node.M.xz, node.M.yz};
    J = {J.xx + node.J.xx, J.yy + node.J.yy, J.zz + node.J.zz,
         J.xy + node.J.xy, J.xz + node.J.xz, J.yz + node.J.yz};
    for (int j = 0; j < 3; ++j) B[j] = node.B[j];
  }

  // About the anchor: H = B - r~ M by rows, J + Hᵀ r~ + (B r~)ᵀ.
  const FloatVec3 H[3] = {fused_cross({M.xx, M.xy, M.xz}, r, B[0]), fused_cross({M.xy, M.yy, M.yz}, r, B[1]),
                          fused_cross({M.xz, M.yz, M.zz}, r, B[2])};
  const FloatVec3 HB[3] = {H[0] + B[0], H[1] + B[1], H[2] + B[2]};
  const FloatLanes xx = fused(HB[1].x, r.z, fused(-HB[2].x, r.y, J.xx));
  const FloatLanes yy = fused(HB[2].y, r.x, fused(-HB[0].y, r.z, J.yy));
  const FloatLanes zz = fused(HB[0].z, r.y, fused(-HB[1].z, r.x, J.zz));
  const FloatLanes yx =
      fused(H[1].y, r.z, fused(-H[2].y, r.y, fused(B[2].x, r.x, fused(-B[0].x, r.z, J.xy))));
  const FloatLanes zx =
      fused(H[1].z, r.z, fused(-H[2].z, r.y, fused(B[0].x, r.y, fused(-B[1].x, r.x, J.xz))));
  const FloatLanes zy =
      fused(H[2].z, r.x, fused(-H[0].z, r.z, fused(B[0].y, r.y, fused(-B[1].y, r.x, J.yz))));

  // J = L D Lᵀ.
  const FloatLanes one = splat(1);
  node.inverse_D[0] = one / xx;
  node.L[0] = yx * node.inverse_D[0];
  node.L[1] = zx * node.inverse_D[0];
  const FloatLanes rest = fused(-node.L[1], yx, zy);
  node.inverse_D[1] = one / fused(-node.L[0], yx, yy);
  node.L[2] = rest * node.inverse_D[1];
  node.inverse_D[2] = one / fused(-node.L[2], rest, fused(-node.L[1], zx, zz));

  // G = H J⁻¹ and S = M - H J⁻¹ Hᵀ.
  for (int j = 0; j < 3; ++j) node.G[j] = solve_rotation(node, H[j]);
  node.S = {less_dot(M.xx, H[0], node.G[0]), less_dot(M.yy, H[1], node.G[1]),
            less_dot(M.zz, H[2], node.G[2]), less_dot(M.xy, H[1], node.G[0]),
            less_dot(M.xz, H[2], node.G[0]), less_dot(M.yz, H[2], node.G[1])};
}

/// On the way to the root: the push q that the anchor of the child takes up, and what the parent feels of it.
RIGOR_FLOAT_LANES void gather_free(const FreeJoint& joint, FreeNode& node, FreeNode* parent) {
  // The push that has come up from the children, its moment about the anchor.
  const FloatLanes zero = splat(0);
  FloatVec3 push = {zero, zero, zero}, torque = {zero, zero, zero};
  if (joint.has_children) {
    push = node.push;
    torque = fused_cross(push, node.arm_child, node.moment);
  }

  // J⁻¹ p_ω and q = p_u - H J⁻¹ p_ω.
  node.free_dw = solve_rotation(node, torque);
  node.reaction = {less_dot(push.x, node.G[0], torque), less_dot(push.y, node.G[1], torque),
                   less_dot(push.z, node.G[2], torque)};
  if (!joint.parent_is_free) return;

  // The parent feels q - S b at its anchor.
  const FloatSym3& S = node.S;
  const FloatVec3& u = node.wanted;
  const FloatVec3 f = {less_dot(node.reaction.x, {S.xx, S.xy, S.xz}, u),
                       less_dot(node.reaction.y, {S.xy, S.yy, S.yz}, u),
                       less_dot(node.reaction.z, {S.xz, S.yz, S.zz}, u)};
  if (joint.is_first) {
    parent->push = f;
    parent->moment = fused_cross(node.arm_parent, f);
  } else {
    parent->push = parent->push + f;
    parent->moment = fused_cross(node.arm_parent, f, parent->moment);
  }
}

/// On the way back: the velocity of the anchor, the change of the child's velocities and the impulse of the
/// joint.
RIGOR_FLOAT_LANES void spread_free(const FreeJoint& joint, const FreeNode* parent, FreeNode& node) {
  // u = b + u_parent; the root of a tree that floats moves as its own articulated inertia lets it.
  FloatVec3 u;
  if (joint.parent < 0) {
    u = solve_symmetric(node.S, node.reaction);
  } else if (joint.parent_is_free) {
    u = fused_cross(parent->change_w, node.arm_parent, node.wanted + parent->change_v);
  } else {
    u = node.wanted;
  }

  // Δω = J⁻¹ (p_ω - Hᵀ u), Δv = u + r × Δω, λ = S u - q.
  const FloatVec3* G = node.G;
  node.change_w = fused(-u.x, G[0], fused(-u.y, G[1], fused(-u.z, G[2], node.free_dw)));
  node.change_v = fused_cross(node.arm_child, node.change_w, u);
  node.impulse = node.impulse + (fused_product(node.S, u) - node.reaction);
  node.v = node.v + node.change_v;
  node.w = node.w + node.change_w;
}

/// b: minus the distance of the anchors after the time h, over h; 0 in lanes in which `part` is 0.
RIGOR_FLOAT_LANES void miss_free(float h, const FloatLanes& part, const FreeNode& parent, FreeNode& node) {
  const FloatVec3 arms =
      displacement_of(node.rotation, node.arm_child) - displacement_of(parent.rotation, node.arm_parent);
  const FloatVec3 errors = fused(splat(1 / h), node.apart + arms, node.v - parent.v);
  node.wanted = (-part) * errors;
}
