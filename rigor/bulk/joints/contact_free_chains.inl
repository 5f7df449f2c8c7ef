// A step of contact-free chains of ball joints (docs/theory/bulk_joints.md, section 2). Included once for
// each target, after fused_lanes.inl, rotation_lanes.inl and gyroscopic_kernels.inl.

/// Anchors that a correction leaves farther apart than about this [m] get another one in the same substep.
constexpr float kLeastMiss = 4e-5F;

/// A body, and the joint between it (the child) and its parent.
struct alignas(32) FreeNode {
  FloatVec3 v, w, dp, dr;
  FloatVec3 dv, dw;        ///< What forces change in a substep.
  LaneTurn turn;           ///< By h ω.
  FloatVec3 axes[2];       ///< The first two principal axes.
  FloatVec3 push, moment;  ///< Impulse that children give, and its moment about the centre of mass.
  FloatVec3 change_v, change_w;
  // Resistance that children add to velocities v and ω: (M, B; Bᵀ, J), with the columns of Bᵀ.
  FloatSym3 M, J;
  FloatVec3 B[3];

  FloatVec3 arm_child, arm_parent;  ///< From the centres to the anchor [m].
  FloatVec3 apart;                  ///< From the anchor on the parent to that on the child [m].
  FloatVec3 wanted;                 ///< Change of the anchor's velocity on the child against the parent.
  FloatVec3 impulse;                ///< On the child [N s].
  // Factors as in BallLanes.
  FloatLanes inverse_D[3], L[3];
  FloatVec3 G[3];
  FloatSym3 S;
  FloatVec3 turning, pull;
};

using FreeTables = ContactFreeChains::Tables;
using FreeJoint = ContactFreeChains::Joint;

/// x = (L D Lᵀ)⁻¹ x.
RIGOR_FLOAT_LANES FloatVec3 solve_turning(const FreeNode& node, const FloatVec3& b) {
  const FloatLanes y = fused(-node.L[0], b.x, b.y);
  const FloatLanes z = fused(-node.L[2], y, fused(-node.L[1], b.x, b.z)) * node.inverse_D[2];
  const FloatLanes turned_y = fused(-node.L[2], z, y * node.inverse_D[1]);
  return {fused(-node.L[0], turned_y, fused(-node.L[1], z, b.x * node.inverse_D[0])), turned_y, z};
}
/// S⁻¹ b.
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
  return solve_turning(factors, b);
}
/// c - a · b.
RIGOR_FLOAT_LANES FloatLanes less_dot(const FloatLanes& c, const FloatVec3& a, const FloatVec3& b) {
  return fused(-a.z, b.z, fused(-a.y, b.y, fused(-a.x, b.x, c)));
}

/// What of the child's resistance the parent feels at its anchor.
RIGOR_FLOAT_LANES void give_resistance(const FreeJoint& joint, const FreeNode& node, FreeNode& parent) {
  const FloatSym3& S = node.S;
  const FloatVec3& s = node.arm_parent;
  const FloatVec3 N[3] = {fused_cross(s, {S.xx, S.xy, S.xz}), fused_cross(s, {S.xy, S.yy, S.yz}),
                          fused_cross(s, {S.xz, S.yz, S.zz})};  // Columns of s~ S.
  // -s~ S s~.
  const FloatSym3 turned = {fused(s.y, N[2].x, -(s.z * N[1].x)), fused(s.z, N[0].y, -(s.x * N[2].y)),
                            fused(s.x, N[1].z, -(s.y * N[0].z)), fused(s.y, N[2].y, -(s.z * N[1].y)),
                            fused(s.y, N[2].z, -(s.z * N[1].z)), fused(s.z, N[0].z, -(s.x * N[2].z))};
  if (joint.is_first) {
    parent.M = S;
    parent.J = turned;
    for (int j = 0; j < 3; ++j) parent.B[j] = N[j];
    return;
  }
  parent.M = {parent.M.xx + S.xx, parent.M.yy + S.yy, parent.M.zz + S.zz,
              parent.M.xy + S.xy, parent.M.xz + S.xz, parent.M.yz + S.yz};
  parent.J = {parent.J.xx + turned.xx, parent.J.yy + turned.yy, parent.J.zz + turned.zz,
              parent.J.xy + turned.xy, parent.J.xz + turned.xz, parent.J.yz + turned.yz};
  for (int j = 0; j < 3; ++j) parent.B[j] = parent.B[j] + N[j];
}

/// Inertia about the centre of mass where the body is.
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

/// As factor_ball().
template <bool of_revolution>
RIGOR_FLOAT_LANES void factor_free(const ContactFreeChains::Body& body, const FreeJoint& joint,
                                   FreeNode& node) {
  const FloatLanes zero = splat(0);
  const FloatVec3& r = node.arm_child;
  FloatSym3 M = {body.mass, body.mass, body.mass, zero, zero, zero};
  FloatSym3 J = inertia_of<of_revolution>(body, node);
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

  const FloatLanes one = splat(1);
  node.inverse_D[0] = one / xx;
  node.L[0] = yx * node.inverse_D[0];
  node.L[1] = zx * node.inverse_D[0];
  const FloatLanes rest = fused(-node.L[1], yx, zy);
  node.inverse_D[1] = one / fused(-node.L[0], yx, yy);
  node.L[2] = rest * node.inverse_D[1];
  node.inverse_D[2] = one / fused(-node.L[2], rest, fused(-node.L[1], zx, zz));

  for (int j = 0; j < 3; ++j) node.G[j] = solve_turning(node, H[j]);
  node.S = {less_dot(M.xx, H[0], node.G[0]), less_dot(M.yy, H[1], node.G[1]),
            less_dot(M.zz, H[2], node.G[2]), less_dot(M.xy, H[1], node.G[0]),
            less_dot(M.xz, H[2], node.G[0]), less_dot(M.yz, H[2], node.G[1])};
}

/// On the way to the root.
RIGOR_FLOAT_LANES void gather_free(const FreeJoint& joint, FreeNode& node, FreeNode* parent) {
  const FloatLanes zero = splat(0);
  FloatVec3 push = {zero, zero, zero}, torque = {zero, zero, zero};
  if (joint.has_children) {
    push = node.push;
    torque = fused_cross(push, node.arm_child, node.moment);
  }
  node.turning = solve_turning(node, torque);
  node.pull = {less_dot(push.x, node.G[0], torque), less_dot(push.y, node.G[1], torque),
               less_dot(push.z, node.G[2], torque)};
  if (!joint.parent_is_free) return;
  const FloatSym3& S = node.S;
  const FloatVec3& u = node.wanted;
  const FloatVec3 f = {less_dot(node.pull.x, {S.xx, S.xy, S.xz}, u),
                       less_dot(node.pull.y, {S.xy, S.yy, S.yz}, u),
                       less_dot(node.pull.z, {S.xz, S.yz, S.zz}, u)};
  if (joint.is_first) {
    parent->push = f;
    parent->moment = fused_cross(node.arm_parent, f);
  } else {
    parent->push = parent->push + f;
    parent->moment = fused_cross(node.arm_parent, f, parent->moment);
  }
}

/// On the way back: gives the body what has been found.
RIGOR_FLOAT_LANES void spread_free(const FreeJoint& joint, const FreeNode* parent, FreeNode& node) {
  FloatVec3 u;
  if (joint.parent < 0) {
    u = solve_symmetric(node.S, node.pull);
  } else if (joint.parent_is_free) {
    u = fused_cross(parent->change_w, node.arm_parent, node.wanted + parent->change_v);
  } else {
    u = node.wanted;
  }
  const FloatVec3* G = node.G;
  node.change_w = fused(-u.x, G[0], fused(-u.y, G[1], fused(-u.z, G[2], node.turning)));
  node.change_v = fused_cross(node.arm_child, node.change_w, u);
  node.impulse = node.impulse + (fused_product(node.S, u) - node.pull);
  node.v = node.v + node.change_v;
  node.w = node.w + node.change_w;
}

/// By how much the anchors will be apart after the time h, over h; lanes in which `part` is 0 stay.
RIGOR_FLOAT_LANES void miss_free(float h, const FloatLanes& part, const FreeNode& parent, FreeNode& node) {
  const FloatVec3 ways = way_of(node.turn, node.arm_child) - way_of(parent.turn, node.arm_parent);
  const FloatVec3 misses = fused(splat(1 / h), node.apart + ways, node.v - parent.v);
  node.wanted = (-part) * misses;
}

struct FreeStep {
  const FreeTables& tables;
  std::vector<FreeNode>& nodes;
  float h;

  RIGOR_FLOAT_LANES std::size_t moved() const { return tables.joints.size(); }
  RIGOR_FLOAT_LANES FreeNode* parent_of(std::size_t i) const {
    const int parent = tables.joints[i].parent;
    return parent < 0 ? nullptr : &nodes[static_cast<std::size_t>(parent)];
  }
};

template <bool of_revolution>
RIGOR_FLOAT_LANES void factor_all(const FreeStep& step) {
  for (std::size_t i = 0; i < step.moved(); ++i) {
    const FreeJoint& joint = step.tables.joints[i];
    FreeNode& node = step.nodes[i];
    factor_free<of_revolution>(step.tables.bodies[i], joint, node);
    if (joint.parent_is_free) give_resistance(joint, node, *step.parent_of(i));
  }
}

/// What forces and turning change of velocities.
template <bool of_revolution>
RIGOR_FLOAT_LANES void push_all(const FreeStep& step) {
  const FloatLanes zero = splat(0);
  for (std::size_t i = 0; i < step.moved(); ++i) {
    FreeNode& node = step.nodes[i];
    const ContactFreeChains::Body& body = step.tables.bodies[i];
    const FloatVec3 turning = of_revolution ? change_about_axis(node.axes[0], body.spin, node.w, step.h)
                                            : change_by_newton(node.axes, body.moments, node.w, step.h);
    node.v = node.v + node.dv;
    node.w = node.w + (node.dw + turning);
    node.turn = turn_of(step.h, node.w);
    node.impulse = {zero, zero, zero};
  }
}

/// Anchors meet after the time h: one correction in the lanes where `part` is 1. Returns 1 in the lanes that
/// need another.
RIGOR_FLOAT_LANES FloatLanes hold_all(const FreeStep& step, const FloatLanes& part) {
  for (std::size_t i = 0; i < step.moved(); ++i) {
    FreeNode* const parent = step.parent_of(i);
    if (parent != nullptr) miss_free(step.h, part, *parent, step.nodes[i]);
    gather_free(step.tables.joints[i], step.nodes[i], parent);
  }
  // What is left is of the order of the arms' turn in the substep times what the correction has turned them.
  FloatLanes left = splat(0);
  for (std::size_t i = step.moved(); i-- > 0;) {
    FreeNode& node = step.nodes[i];
    spread_free(step.tables.joints[i], step.parent_of(i), node);
    node.turn = turn_of(step.h, node.w);
    const FloatLanes squared = fused_dot(node.change_w, node.change_w) * fused_dot(node.w, node.w);
    left = larger(left, squared * step.tables.bodies[i].reach);
  }
  const float most = kLeastMiss / (step.h * step.h);
  return left > splat(most * most) ? splat(1) : splat(0);
}

/// Where the bodies are after the time h.
template <bool of_revolution>
RIGOR_FLOAT_LANES void displace(float h, const FreeNode* parent, FreeNode& node) {
  const FloatVec3 way_child = way_of(node.turn, node.arm_child);
  if (parent != nullptr) {
    const FloatVec3 way_parent = way_of(parent->turn, node.arm_parent);
    node.apart = fused(splat(h), node.v - parent->v, node.apart + (way_child - way_parent));
    node.arm_child = node.arm_child + way_child;
    node.arm_parent = node.arm_parent + way_parent;
  }
  node.dp = fused(splat(h), node.v, node.dp);
  turn_further(h, node.w, node.dr);
  node.axes[0] = node.axes[0] + way_of(node.turn, node.axes[0]);
  if constexpr (!of_revolution) node.axes[1] = node.axes[1] + way_of(node.turn, node.axes[1]);
}

/// Displacements, and factors where the bodies are then.
template <bool of_revolution>
RIGOR_FLOAT_LANES void displace_all(const FreeStep& step) {
  for (std::size_t i = 0; i < step.moved(); ++i) {
    const FreeJoint& joint = step.tables.joints[i];
    FreeNode& node = step.nodes[i];
    FreeNode* const parent = step.parent_of(i);
    displace<of_revolution>(step.h, parent, node);
    factor_free<of_revolution>(step.tables.bodies[i], joint, node);
    if (joint.parent_is_free) give_resistance(joint, node, *parent);
  }
}

/// Anchors move together.
RIGOR_FLOAT_LANES void slow_all(const FreeStep& step) {
  for (std::size_t i = 0; i < step.moved(); ++i) {
    const FreeJoint& joint = step.tables.joints[i];
    FreeNode& node = step.nodes[i];
    FreeNode* const parent = step.parent_of(i);
    if (parent != nullptr) {
      const FloatVec3 on_parent = fused_cross(parent->w, node.arm_parent, parent->v);
      node.wanted = on_parent - fused_cross(node.w, node.arm_child, node.v);
    }
    gather_free(joint, node, parent);
  }
  for (std::size_t i = step.moved(); i-- > 0;) {
    spread_free(step.tables.joints[i], step.parent_of(i), step.nodes[i]);
  }
}

template <bool of_revolution>
RIGOR_FLOAT_LANES void take_substeps(int count, const FreeStep& step) {
  factor_all<of_revolution>(step);
  for (std::size_t s = step.moved(); s < step.nodes.size(); ++s) {
    step.nodes[s].turn = turn_of(step.h, step.nodes[s].w);
  }
  for (int k = 0; k < count; ++k) {
    push_all<of_revolution>(step);
    const FloatLanes again = hold_all(step, splat(1));
    if (lane_bits(again > splat(0)) != 0) hold_all(step, again);
    displace_all<of_revolution>(step);
    // Rates change no path, so they may wait: but the last impulse is that of a whole substep.
    if (k + 2 >= count) slow_all(step);
  }
}

/// a, turned by the unit quaternion (v, w).
RIGOR_FLOAT_LANES DoubleVec3 turned(const DoubleVec3& v, const DoubleLanes& w, const DoubleVec3& a) {
  const DoubleVec3 b = {v.y * a.z - v.z * a.y, v.z * a.x - v.x * a.z, v.x * a.y - v.y * a.x};
  const DoubleVec3 c = {b.x + b.x, b.y + b.y, b.z + b.z};
  return {a.x + (w * c.x + (v.y * c.z - v.z * c.y)), a.y + (w * c.y + (v.z * c.x - v.x * c.z)),
          a.z + (w * c.z + (v.x * c.y - v.y * c.x))};
}
RIGOR_FLOAT_LANES FloatVec3 rounded(const DoubleVec3& a) {
  return {__builtin_convertvector(a.x, FloatLanes), __builtin_convertvector(a.y, FloatLanes),
          __builtin_convertvector(a.z, FloatLanes)};
}

/// Where eight bodies are.
struct alignas(64) FreePlace {
  DoubleVec3 x, q;  ///< q: its vector.
  DoubleLanes w;
};
RIGOR_FLOAT_LANES FreePlace place_of_slot(const std::array<std::int32_t, kLaneCount>& who,
                                          const BulkBodies& bodies) {
  const double *x[kLaneCount], *q[kLaneCount];
  for (std::size_t i = 0; i < kLaneCount; ++i) {
    static constexpr double origin[4] = {0, 0, 0, 1};
    x[i] = who[i] < 0 ? origin : bodies.x[static_cast<std::size_t>(who[i])].data();
    q[i] = who[i] < 0 ? origin : bodies.q[static_cast<std::size_t>(who[i])].coeffs().data();
  }
  DoubleLanes lanes[7];
  for (int k = 0; k < 7; ++k) {
    const double** from = k < 3 ? x : q;
    const int j = k < 3 ? k : k - 3;
    lanes[k] = DoubleLanes{from[0][j], from[1][j], from[2][j], from[3][j],
                           from[4][j], from[5][j], from[6][j], from[7][j]};
  }
  return {{lanes[0], lanes[1], lanes[2]}, {lanes[3], lanes[4], lanes[5]}, lanes[6]};
}

/// Axes, arms and gaps of the anchors at the begin of a step.
RIGOR_FLOAT_LANES void place_nodes(const FreeTables& tables, const BulkBodies& bodies,
                                   std::vector<FreeNode>& nodes) {
  std::vector<FreePlace> places(tables.slots.size());
  for (std::size_t s = 0; s < places.size(); ++s) places[s] = place_of_slot(tables.slots[s], bodies);
  for (std::size_t i = 0; i < tables.joints.size(); ++i) {
    const FreeJoint& joint = tables.joints[i];
    const FreePlace& child = places[i];
    FreeNode& node = nodes[i];
    for (int k = 0; k < (tables.are_of_revolution ? 1 : 2); ++k) {
      node.axes[k] = rounded(turned(child.q, child.w, tables.bodies[i].axes_B[k]));
    }
    const DoubleVec3 arm_child = turned(child.q, child.w, joint.arm_child_B);
    node.arm_child = rounded(arm_child);
    if (joint.parent < 0) continue;
    const FreePlace& parent = places[static_cast<std::size_t>(joint.parent)];
    const DoubleVec3 arm_parent = turned(parent.q, parent.w, joint.arm_parent_B);
    node.arm_parent = rounded(arm_parent);
    node.apart = rounded({(child.x.x - parent.x.x) + (arm_child.x - arm_parent.x),
                          (child.x.y - parent.x.y) + (arm_child.y - arm_parent.y),
                          (child.x.z - parent.x.z) + (arm_child.z - arm_parent.z)});
  }
}

std::pair<double, int> worst_gap(const FreeTables& tables, const BulkBodies& bodies) {
  std::vector<FreePlace> places(tables.slots.size());
  for (std::size_t s = 0; s < places.size(); ++s) places[s] = place_of_slot(tables.slots[s], bodies);
  DoubleLanes worst = {};
  NumberLanes which = {};
  for (std::size_t i = 0; i < tables.joints.size(); ++i) {
    const FreeJoint& joint = tables.joints[i];
    if (joint.parent < 0) continue;
    const FreePlace &child = places[i], &parent = places[static_cast<std::size_t>(joint.parent)];
    const DoubleVec3 arm_child = turned(child.q, child.w, joint.arm_child_B);
    const DoubleVec3 arm_parent = turned(parent.q, parent.w, joint.arm_parent_B);
    const DoubleLanes x = (child.x.x - parent.x.x) + (arm_child.x - arm_parent.x);
    const DoubleLanes y = (child.x.y - parent.x.y) + (arm_child.y - arm_parent.y);
    const DoubleLanes z = (child.x.z - parent.x.z) + (arm_child.z - arm_parent.z);
    const DoubleLanes squared = x * x + y * y + z * z;
    const NumberLanes number = NumberLanes{} + static_cast<std::int64_t>(i);
    which = squared > worst ? number : which;
    worst = squared > worst ? squared : worst;
  }
  std::pair<double, int> found{0, -1};
  for (std::size_t lane = 0; lane < kLaneCount; ++lane) {
    const int k = static_cast<int>(lane);
    const int number = tables.joints[static_cast<std::size_t>(which[k])].numbers[lane];
    const double squared = worst[k];
    if (number >= 0 && squared > found.first) found = {squared, number};
  }
  return {std::sqrt(found.first), found.second};
}

RIGOR_FLOAT_LANES FloatSquare load_rows(const std::array<const float*, kLaneCount>& from, int at) {
  FloatSquare square;
  for (int i = 0; i < kLaneCount; ++i) square.row[i] = load(from[static_cast<std::size_t>(i)] + at);
  return transpose(square);
}

/// Velocities and what forces change of them, of the lanes that count and of bodies that joints do not move.
RIGOR_FLOAT_LANES void load_nodes(const FreeTables& tables, const ContactFreeChains::Step& step,
                                  unsigned lanes, const BulkBodies& bodies, std::vector<FreeNode>& nodes) {
  static constexpr MotionRecord nothing{};
  static constexpr MotionRow no_row{};
  const FloatLanes zero = splat(0);
  for (std::size_t s = 0; s < nodes.size(); ++s) {
    std::array<const float*, kLaneCount> records, rows;
    for (std::size_t i = 0; i < kLaneCount; ++i) {
      const int body = tables.slots[s][i];
      const bool counts = body >= 0 && (lanes >> i & 1) != 0;
      records[i] = counts ? bodies.motion[static_cast<std::size_t>(body)].v : nothing.v;
      rows[i] = counts ? step.accelerations[static_cast<std::size_t>(body)].data() : no_row.data();
    }
    FreeNode& node = nodes[s];
    FloatSquare square = load_rows(records, 0);
    node.v = {square.row[0], square.row[1], square.row[2]};
    node.w = {square.row[4], square.row[5], square.row[6]};
    node.dp = node.dr = {zero, zero, zero};
    if (s >= tables.joints.size()) continue;
    square = load_rows(rows, 0);
    const FloatLanes h = splat(step.h);
    node.dv = h * FloatVec3{square.row[0], square.row[1], square.row[2]};
    node.dw = h * FloatVec3{square.row[4], square.row[5], square.row[6]};
  }
}

RIGOR_FLOAT_LANES void store_nodes(const FreeTables& tables, unsigned lanes,
                                   const std::vector<FreeNode>& nodes, BulkBodies& bodies) {
  const FloatLanes zero = splat(0);
  for (std::size_t s = 0; s < tables.joints.size(); ++s) {
    const FreeNode& node = nodes[s];
    const FloatLanes& inverse_mass = tables.bodies[s].inverse_mass;
    const FloatSquare moving = transpose(
        FloatSquare{{node.v.x, node.v.y, node.v.z, inverse_mass, node.w.x, node.w.y, node.w.z, zero}});
    const FloatSquare moved = transpose(
        FloatSquare{{node.dp.x, node.dp.y, node.dp.z, zero, node.dr.x, node.dr.y, node.dr.z, zero}});
    for (std::size_t i = 0; i < kLaneCount; ++i) {
      if ((lanes >> i & 1) == 0) continue;
      float* record = bodies.motion[static_cast<std::size_t>(tables.slots[s][i])].v;
      store_floats(moving.row[i], record);
      store_floats(moved.row[i], record + kLaneCount);
    }
  }
}

void advance(const FreeTables& tables, const ContactFreeChains::Step& step, unsigned lanes,
             BulkBodies& bodies, std::vector<ContactFreeChains::Impulse>& impulses) {
  std::vector<FreeNode> nodes(tables.slots.size());
  load_nodes(tables, step, lanes, bodies, nodes);
  place_nodes(tables, bodies, nodes);
  const FreeStep work{tables, nodes, step.h};
  tables.are_of_revolution ? take_substeps<true>(step.substeps, work)
                           : take_substeps<false>(step.substeps, work);
  store_nodes(tables, lanes, nodes, bodies);
  for (std::size_t i = 0; i < impulses.size(); ++i) {
    impulses[i].on_B = tables.joints[i].sign * nodes[i].impulse;
  }
}
