// Sweeps over blocks of manifolds (docs/theory/bulk.md, sections 2 to 4). Included once for each target,
// inside its namespace and after manifold_lanes.inl.

/// Fastest at which overlaps are put back [m/s]: a deep one is not an explosion.
constexpr float max_push_speed = 3;
/// The points of a manifold are solved this often one after the other: near enough to a block.
constexpr int block_sweeps = 3;

/// Displacements of B against A that change the gaps of the points.
template <class Block>
RIGOR_FLOAT_LANES NormalMotion find_displacements(const BlockFrame& f, const Block& block,
                                                  const BulkBodies& bodies) {
  const LaneTwists A = gather_displacements(block.body_A, bodies);
  const LaneTwists B = gather_displacements(block.body_B, bodies);
  const FloatVec3 turn = B.w - A.w;
  return {fused_dot(f.n, relative_motion(f, A, B)), fused_dot(f.t1, turn), fused_dot(f.t2, turn)};
}

/// The impulse of a point is to become max(keep old - (meet u_n + shift), 0).
struct PointRule {
  FloatLanes keep, meet, shift;
};
/// gap [m]: as bodies are now.
template <BlockPass pass, class Block>
RIGOR_FLOAT_LANES PointRule rule_of(float h, const FloatLanes& gap, const Block& block,
                                    const BlockPoint& point) {
  const FloatLanes zero = splat(0), one = splat(1);
  const FloatLanes mass = lane(point.mass);
  const FloatLanes closing = mass * larger(gap, zero) * splat(1 / h);
  if constexpr (pass == BlockPass::relax) return {one, mass, closing};
  const IntLanes is_apart = gap > zero;
  // The spring keeps as much of the old impulse as it meets of the speed: make_softness.
  const FloatLanes scale = lane(block.mass_scale);
  const FloatLanes soft_mass = mass * scale;
  const FloatLanes back = larger(lane(block.bias_rate) * gap, splat(-max_push_speed));
  return {is_apart ? one : scale, is_apart ? mass : soft_mass, is_apart ? closing : soft_mass * back};
}
RIGOR_FLOAT_LANES FloatLanes next_impulse(const PointRule& rule, const FloatLanes& speed,
                                          const FloatLanes& impulse) {
  const FloatLanes kept = fused(rule.keep, impulse, -rule.shift);
  return larger(fused(-rule.meet, speed, kept), splat(0));
}

template <class Block>
RIGOR_FLOAT_LANES void put_normal(std::size_t point, const FloatLanes& impulse, Block& block) {
  put(impulse, block.impulses.normal(point));
  block.pressed[point] = static_cast<std::uint8_t>(block.pressed[point] | bits_of(impulse > splat(0)));
}

/// Normal impulses of all points, one after the other by what each does to the others; their wrench.
template <BlockPass pass, class Block>
RIGOR_FLOAT_LANES NormalMotion solve_normals(float h, const NormalMotion& moved, const NormalMotion& u,
                                             Block& block) {
  constexpr int count = Block::point_count;
  const FloatLanes zero = splat(0);
  PointRule rule[count];
  FloatLanes p1[count], p2[count], old[count], impulse[count], speed[count], response[count][count];
#pragma GCC unroll 4
  for (int k = 0; k < count; ++k) {
    const std::size_t i = static_cast<std::size_t>(k);
    p1[k] = lane(block.arms[i].p1);
    p2[k] = lane(block.arms[i].p2);
    rule[k] =
        rule_of<pass>(h, lane(block.points[i].gap) + at_point(moved, p1[k], p2[k]), block, block.points[i]);
    old[k] = impulse[k] = lane(block.impulses.normal(i));
    speed[k] = at_point(u, p1[k], p2[k]);
    const NormalMotion answer = response_to(block, p1[k], p2[k]);
#pragma GCC unroll 4
    for (int j = 0; j <= k; ++j) response[j][k] = response[k][j] = at_point(answer, p1[j], p2[j]);
  }
  // One point alone is solved by one sweep: what it does to itself is the inverse of its mass.
  for (int sweep = 0; sweep < (count == 1 ? 1 : block_sweeps); ++sweep) {
#pragma GCC unroll 4
    for (int k = 0; k < count; ++k) {
      const FloatLanes next = next_impulse(rule[k], speed[k], impulse[k]);
      const FloatLanes change = next - impulse[k];
      impulse[k] = next;
#pragma GCC unroll 4
      for (int j = 0; j < count; ++j) speed[j] = fused(response[j][k], change, speed[j]);
    }
  }
  NormalMotion wrench{zero, zero, zero};
#pragma GCC unroll 4
  for (int k = 0; k < count; ++k) {
    const FloatLanes change = impulse[k] - old[k];
    wrench = {wrench.u0 + change, fused(p2[k], change, wrench.u1), fused(-p1[k], change, wrench.u2)};
    put_normal(static_cast<std::size_t>(k), impulse[k], block);
  }
  return wrench;
}

/// Keeps (x, y) within a disc.
RIGOR_FLOAT_LANES void clamp_to_disc(const FloatLanes& radius, FloatLanes& x, FloatLanes& y) {
  const FloatLanes one = splat(1);
  const FloatLanes length = root(fused(x, x, y * y));
  const FloatLanes scale = length > radius ? radius / length : one;
  x = x * scale;
  y = y * scale;
}

/// Coulomb friction at the centre of the manifold, on the disc of all its normal impulses. u: of B against A
/// there. What it changes of the impulses along t1 and t2.
struct SlipImpulse {
  FloatLanes f1, f2;
};
template <class Block>
RIGOR_FLOAT_LANES SlipImpulse solve_slip(const FloatLanes& pressed, const FloatVec3& u, Block& block) {
  const FloatLanes old1 = lane(block.impulses.tangent(0)), old2 = lane(block.impulses.tangent(1));
  const FloatLanes m11 = lane(block.tangent_mass[0]), m22 = lane(block.tangent_mass[1]),
                   m12 = lane(block.tangent_mass[2]);
  FloatLanes f1 = fused(-m12, u.z, fused(-m11, u.y, old1));
  FloatLanes f2 = fused(-m22, u.z, fused(-m12, u.y, old2));
  clamp_to_disc(lane(block.friction) * pressed, f1, f2);
  put(f1, block.impulses.tangent(0));
  put(f2, block.impulses.tangent(1));
  return {f1 - old1, f2 - old2};
}

/// Rolling friction: a disc of moments along t1 and t2.
template <class Block>
RIGOR_FLOAT_LANES void solve_rolling(const FloatLanes& pressed, Block& block, LaneTwists& u,
                                     LaneTwists& wrench) {
  const FloatLanes was1 = lane(block.impulses.roll(0)), was2 = lane(block.impulses.roll(1));
  const FloatLanes r11 = lane(block.roll_mass[0]), r22 = lane(block.roll_mass[1]),
                   r12 = lane(block.roll_mass[2]);
  FloatLanes m1 = fused(-r12, u.w.z, fused(-r11, u.w.y, was1));
  FloatLanes m2 = fused(-r22, u.w.z, fused(-r12, u.w.y, was2));
  clamp_to_disc(lane(block.rolling_friction) * pressed, m1, m2);
  put(m1, block.impulses.roll(0));
  put(m2, block.impulses.roll(1));
  m1 = m1 - was1;
  m2 = m2 - was2;
  wrench.w.y = wrench.w.y + m1;
  wrench.w.z = wrench.w.z + m2;
  u.v.x = fused(lane(block.Kvw[0][2]), m2, fused(lane(block.Kvw[0][1]), m1, u.v.x));
  u.w.y = fused(lane(block.Kww[5]), m2, fused(lane(block.Kww[1]), m1, u.w.y));
  u.w.z = fused(lane(block.Kww[2]), m2, fused(lane(block.Kww[5]), m1, u.w.z));
}

/// All friction of a patch: against turning about n, against slip, against rolling. u: B against A, changed
/// by it but for the slip itself; wrench: its impulses are added.
template <class Block>
RIGOR_FLOAT_LANES void solve_friction(Block& block, LaneTwists& u, LaneTwists& wrench) {
  FloatLanes pressed = splat(0), spread = splat(0);
  for (std::size_t i = 0; i < Block::point_count; ++i) {
    const FloatLanes impulse = lane(block.impulses.normal(i));
    pressed = pressed + impulse;
    spread = fused(impulse, lane(block.arms[i].length), spread);
  }
  FloatLanes twist_limit = lane(block.friction) * spread;
  if constexpr (Block::kind.has_moments)
    twist_limit = fused(lane(block.torsional_friction), pressed, twist_limit);
  const FloatLanes old_twist = lane(block.impulses.twist());
  const FloatLanes free_twist = fused(-lane(block.twist_mass), u.w.x, old_twist);
  const FloatLanes twist = smaller(larger(free_twist, -twist_limit), twist_limit);
  const FloatLanes turn = twist - old_twist;
  put(twist, block.impulses.twist());
  wrench.w.x = wrench.w.x + turn;
  u.v = fused(turn, {lane(block.Kvw[0][0]), lane(block.Kvw[1][0]), lane(block.Kvw[2][0])}, u.v);
  u.w = fused(turn, {lane(block.Kww[0]), lane(block.Kww[3]), lane(block.Kww[4])}, u.w);

  const SlipImpulse slip = solve_slip(pressed, u.v, block);
  wrench.v.y = wrench.v.y + slip.f1;
  wrench.v.z = wrench.v.z + slip.f2;
  u.v.x = fused(lane(block.Kvt[1]), slip.f2, fused(lane(block.Kvt[0]), slip.f1, u.v.x));
  u.w = fused(slip.f2, lane(block.Kvw[2]), fused(slip.f1, lane(block.Kvw[1]), u.w));

  if constexpr (Block::kind.has_moments) solve_rolling(pressed, block, u, wrench);
}

/// What normal impulses change of the rest of the motion.
template <class Block>
RIGOR_FLOAT_LANES void add_normals(const Block& block, const NormalMotion& change, LaneTwists& u) {
  u.v.y = fused(lane(block.Kvt[0]), change.u0, u.v.y);
  u.v.z = fused(lane(block.Kvt[1]), change.u0, u.v.z);
  u.v.y = fused(lane(block.Kvw[1][2]), change.u2, fused(lane(block.Kvw[1][1]), change.u1, u.v.y));
  u.v.z = fused(lane(block.Kvw[2][2]), change.u2, fused(lane(block.Kvw[2][1]), change.u1, u.v.z));
  u.w = fused(change.u0, lane(block.Kvw[0]), u.w);
  u.w = fused(change.u1, {lane(block.Kww[3]), lane(block.Kww[1]), lane(block.Kww[5])}, u.w);
  u.w = fused(change.u2, {lane(block.Kww[4]), lane(block.Kww[5]), lane(block.Kww[2])}, u.w);
}

// Friction first while overlaps are put back: that bodies do not enter each other matters more. Last where
// its bound is that of the impulse that remains: the spring gives way before, and takes a part of the
// pressure with it.

/// The wrench of a patch in a sweep. u: of B against A.
template <BlockPass pass, class Block>
RIGOR_FLOAT_LANES LaneTwists solve_patch(float h, const NormalMotion& moved, LaneTwists& u, Block& block) {
  const FloatLanes zero = splat(0);
  LaneTwists wrench = {{zero, zero, zero}, {zero, zero, zero}};
  if constexpr (pass == BlockPass::push) solve_friction(block, u, wrench);
  const NormalMotion normals = solve_normals<pass>(h, moved, {u.v.x, u.w.y, u.w.z}, block);
  wrench.v.x = normals.u0;
  wrench.w.y = wrench.w.y + normals.u1;
  wrench.w.z = wrench.w.z + normals.u2;
  if constexpr (pass == BlockPass::relax) {
    add_normals(block, normals, u);
    solve_friction(block, u, wrench);
  }
  return wrench;
}

/// The impulse of one point without moments in a sweep. u: of B against A there.
template <BlockPass pass, class Block>
RIGOR_FLOAT_LANES FloatVec3 solve_point(float h, const FloatLanes& moved, FloatVec3& u, Block& block) {
  const FloatLanes old = lane(block.impulses.normal(0));
  SlipImpulse slip;
  if constexpr (pass == BlockPass::push) {
    slip = solve_slip(old, u, block);
    u.x = fused(lane(block.Kvt[1]), slip.f2, fused(lane(block.Kvt[0]), slip.f1, u.x));
  }
  const PointRule rule = rule_of<pass>(h, lane(block.points[0].gap) + moved, block, block.points[0]);
  const FloatLanes impulse = next_impulse(rule, u.x, old);
  const FloatLanes change = impulse - old;
  put_normal(0, impulse, block);
  if constexpr (pass == BlockPass::relax) {
    u.y = fused(lane(block.Kvt[0]), change, u.y);
    u.z = fused(lane(block.Kvt[1]), change, u.z);
    slip = solve_slip(impulse, u, block);
  }
  return {change, slip.f1, slip.f2};
}

template <BlockPass pass, class Block>
void solve_pass(float h, Block& block, BulkBodies& bodies) {
  const BlockFrame f = frame_of(block);
  LaneBodies A = gather_velocities(block.body_A, bodies);
  LaneBodies B = gather_velocities(block.body_B, bodies);
  FloatVec3 u = along_axes(f, relative_motion(f, A, B));
  // Bodies stay where they are between the second sweep of a substep and the first of the next.
  if constexpr (Block::kind.turns()) {
    LaneTwists twist = {u, along_axes(f, B.w - A.w)};
    NormalMotion moved{lane(block.moved[0]), lane(block.moved[1]), lane(block.moved[2])};
    if constexpr (pass == BlockPass::relax) {
      moved = find_displacements(f, block, bodies);
      put({moved.u0, moved.u1, moved.u2}, block.moved);
    }
    apply_wrench(block, f, solve_patch<pass>(h, moved, twist, block), A, B);
  } else {
    FloatLanes moved = lane(block.moved[0]);
    if constexpr (pass == BlockPass::relax) {
      const LaneTwists moved_A = gather_displacements(block.body_A, bodies);
      const LaneTwists moved_B = gather_displacements(block.body_B, bodies);
      moved = fused_dot(f.n, relative_motion(f, moved_A, moved_B));
      put(moved, block.moved[0]);
    }
    apply_impulse(block, f, solve_point<pass>(h, moved, u, block), A, B);
  }
  scatter_velocities(block.body_A, block.moves_A, A, bodies);
  scatter_velocities(block.body_B, block.moves_B, B, bodies);
}

template <BlockKind kind>
void solve(BlockPass pass, float h, ManifoldBlock<kind>& block, BulkBodies& bodies) {
  switch (pass) {
    case BlockPass::push:
      return solve_pass<BlockPass::push>(h, block, bodies);
    case BlockPass::relax:
      return solve_pass<BlockPass::relax>(h, block, bodies);
  }
}

template <BlockKind kind>
void warm_start(ManifoldBlock<kind>& block, BulkBodies& bodies) {
  const BlockFrame f = frame_of(block);
  LaneBodies A = gather_velocities(block.body_A, bodies);
  LaneBodies B = gather_velocities(block.body_B, bodies);
  const auto& impulses = block.impulses;
  const FloatVec3 slip = {splat(0), lane(impulses.tangent(0)), lane(impulses.tangent(1))};
  if constexpr (kind.turns()) {
    LaneTwists wrench = {slip, {lane(impulses.twist()), splat(0), splat(0)}};
    if constexpr (kind.has_moments) {
      wrench.w.y = lane(impulses.roll(0));
      wrench.w.z = lane(impulses.roll(1));
    }
    for (std::size_t i = 0; i < impulses.points; ++i) {
      const FloatLanes impulse = lane(impulses.normal(i));
      wrench.v.x = wrench.v.x + impulse;
      wrench.w.y = fused(lane(block.arms[i].p2), impulse, wrench.w.y);
      wrench.w.z = fused(-lane(block.arms[i].p1), impulse, wrench.w.z);
    }
    apply_wrench(block, f, wrench, A, B);
  } else {
    apply_impulse(block, f, {lane(impulses.normal(0)), slip.y, slip.z}, A, B);
  }
  scatter_velocities(block.body_A, block.moves_A, A, bodies);
  scatter_velocities(block.body_B, block.moves_B, B, bodies);
}
