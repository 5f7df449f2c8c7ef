// Sweeps over blocks of manifolds (docs/theory/bulk.md, sections 2 to 4). Included once for each target,
// inside its namespace and after manifold_lanes.inl.

/// Fastest at which overlaps are put back [m/s]: a deep one is not an explosion.
constexpr float max_push_speed = 3;
/// Sweeps over the points of a manifold, one point after the other: three are near enough to solving them as
/// a block.
constexpr int block_sweeps = 3;

/// Displacements of B against A since the beginning of the step, as far as they change the gaps of the
/// points.
template <class Block>
RIGOR_FLOAT_LANES NormalMotion find_displacements(const BlockFrame& f, const Block& block,
                                                  const BulkBodies& bodies) {
  const LaneTwists A = gather_displacements(block.body_A, bodies);
  const LaneTwists B = gather_displacements(block.body_B, bodies);
  const FloatVec3 rotation = B.w - A.w;
  return {fused_dot(f.n, relative_motion(f, A, B)), fused_dot(f.t1, rotation), fused_dot(f.t2, rotation)};
}

/// The impulse of a point becomes max(keep old - (meet u_n + shift), 0).
struct PointRule {
  FloatLanes keep, meet, shift;
};
/// The soft constraint of section 3 for one point; gap [m]: where the bodies are now.
template <BlockPass pass, class Block>
RIGOR_FLOAT_LANES PointRule rule_of(float h, const FloatLanes& gap, const Block& block,
                                    const BlockPoint& point) {
  const FloatLanes zero = splat(0), one = splat(1);
  // A point that is apart may close its gap within the substep: m (u_n + gap/h).
  const FloatLanes mass = lane(point.mass);
  const FloatLanes closing = mass * larger(gap, zero) * splat(1 / h);
  if constexpr (pass == BlockPass::relax) return {one, mass, closing};

  // A point that overlaps is a spring, which puts the gap back at its rate, but not faster than
  // max_push_speed. It keeps as much of the old impulse as it meets of the speed: 1 - 1/(1+a2) is a2/(1+a2),
  // the scale (make_softness).
  const FloatLanes scale = lane(block.mass_scale);
  const FloatLanes soft_mass = mass * scale;
  const FloatLanes back = larger(lane(block.bias_rate) * gap, splat(-max_push_speed));

  const IntLanes is_apart = gap > zero;
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
  // The rule, the speed and the impulse of each point, and its response a_jk to the impulse of every other
  // one.
#pragma GCC unroll 4
  for (int k = 0; k < count; ++k) {
    const std::size_t i = at(k);
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

  // Gauss-Seidel: each change of an impulse changes the speeds of all points. One point alone is solved by
  // one sweep, since its response to itself is the inverse of its mass.
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

  // The wrench (F_n, T_t1, T_t2) of all changes.
  NormalMotion wrench{zero, zero, zero};
#pragma GCC unroll 4
  for (int k = 0; k < count; ++k) {
    const FloatLanes change = impulse[k] - old[k];
    wrench = {wrench.u0 + change, fused(p2[k], change, wrench.u1), fused(-p1[k], change, wrench.u2)};
    put_normal(at(k), impulse[k], block);
  }
  return wrench;
}

/// Inverse of the response of two components of a velocity to impulses along them: 11 22 12.
struct PlaneMass {
  FloatLanes m11, m22, m12;
};
/// The impulse (f1, f2) of friction on a disc. It stops the velocity (u1, u2) if it can. If not, it lies on
/// the rim, opposed to the velocity: a step along it from the old impulse, such as would stop it where least
/// impulse is needed, and from there to the rim. (What stops the velocity, shortened to the disc, is askew to
/// it: a plank that slid at 45 degrees curved by nine.)
RIGOR_FLOAT_LANES void solve_disc(const PlaneMass& mass, const FloatLanes& radius, const FloatLanes& u1,
                                  const FloatLanes& u2, FloatLanes& f1, FloatLanes& f2) {
  const FloatLanes zero = splat(0), half = splat(0.5F);
  const FloatLanes stop1 = fused(-mass.m12, u2, fused(-mass.m11, u1, f1));
  const FloatLanes stop2 = fused(-mass.m22, u2, fused(-mass.m12, u1, f2));
  const IntLanes slides = fused(stop1, stop1, stop2 * stop2) > radius * radius;

  // The smaller eigenvalue of the mass; not less than rounding leaves of it beside a far larger one.
  const FloatLanes mean = half * (mass.m11 + mass.m22), apart = half * (mass.m11 - mass.m22);
  const FloatLanes least = larger(mean - root(fused(apart, apart, mass.m12 * mass.m12)), splat(1e-6F) * mean);
  const FloatLanes slide1 = fused(-least, u1, f1), slide2 = fused(-least, u2, f2);
  const FloatLanes length = root(fused(slide1, slide1, slide2 * slide2));
  const FloatLanes scale = length > zero ? radius / length : zero;
  f1 = slides ? scale * slide1 : stop1;
  f2 = slides ? scale * slide2 : stop2;
}

/// The part of the speed of slip and twist that a sweep takes away. In the sweep without springs a patch does
/// it by steps: bricks of a wall that twist and slide against their neighbours are coupled so closely that
/// two whole sweeps a substep, each of which begins where the one before has ended, excite them.
template <BlockPass pass, class Block>
constexpr float friction_share() {
  return pass == BlockPass::relax && Block::kind.turns() ? 0.3F : 1;
}

/// Changes of the impulses along t1 and t2.
struct SlipImpulse {
  FloatLanes f1, f2;
};
/// Coulomb friction at the centre of the manifold, on the disc μ Σ λ of all its normal impulses. u: of B
/// against A there.
template <BlockPass pass, class Block>
RIGOR_FLOAT_LANES SlipImpulse solve_slip(const FloatLanes& pressed, const FloatVec3& u, Block& block) {
  const FloatLanes old1 = lane(block.impulses.tangent(0)), old2 = lane(block.impulses.tangent(1));
  const PlaneMass mass = {lane(block.tangent_mass[0]), lane(block.tangent_mass[1]),
                          lane(block.tangent_mass[2])};
  const FloatLanes share = splat(friction_share<pass, Block>());
  FloatLanes f1 = old1, f2 = old2;
  solve_disc(mass, lane(block.friction) * pressed, share * u.y, share * u.z, f1, f2);
  put(f1, block.impulses.tangent(0));
  put(f2, block.impulses.tangent(1));
  return {f1 - old1, f2 - old2};
}

/// Rolling friction: a disc of moments along t1 and t2. Changes u by them and adds them to the wrench.
template <class Block>
RIGOR_FLOAT_LANES void solve_rolling(const FloatLanes& pressed, Block& block, LaneTwists& u,
                                     LaneTwists& wrench) {
  const FloatLanes old1 = lane(block.impulses.roll(0)), old2 = lane(block.impulses.roll(1));
  const PlaneMass mass = {lane(block.roll_mass[0]), lane(block.roll_mass[1]), lane(block.roll_mass[2])};
  FloatLanes m1 = old1, m2 = old2;
  solve_disc(mass, lane(block.rolling_friction) * pressed, u.w.y, u.w.z, m1, m2);
  put(m1, block.impulses.roll(0));
  put(m2, block.impulses.roll(1));

  // The changes, and the response of what solve_normals() reads.
  m1 = m1 - old1;
  m2 = m2 - old2;
  wrench.w.y = wrench.w.y + m1;
  wrench.w.z = wrench.w.z + m2;
  u.v.x = fused(lane(block.Kvw[0][2]), m2, fused(lane(block.Kvw[0][1]), m1, u.v.x));
  u.w.y = fused(lane(block.Kww[5]), m2, fused(lane(block.Kww[1]), m1, u.w.y));
  u.w.z = fused(lane(block.Kww[2]), m2, fused(lane(block.Kww[5]), m1, u.w.z));
}

/// All friction of a patch: against twist (rotation about n), against slip, against rolling. u: B against A,
/// changed by it but for the slip itself; wrench: its impulses are added.
template <BlockPass pass, class Block>
RIGOR_FLOAT_LANES void solve_friction(Block& block, LaneTwists& u, LaneTwists& wrench) {
  // The normal impulses Σ λ and Σ λ |p|, which bound friction.
  FloatLanes pressed = splat(0), spread = splat(0);
  for (std::size_t i = 0; i < Block::point_count; ++i) {
    const FloatLanes impulse = lane(block.impulses.normal(i));
    pressed = pressed + impulse;
    spread = fused(impulse, lane(block.arms[i].length), spread);
  }

  // Twist: the moment about n that stops it, within ±(μ Σ λ |p| + μ_t Σ λ).
  FloatLanes twist_limit = lane(block.friction) * spread;
  if constexpr (Block::kind.has_moments)
    twist_limit = fused(lane(block.torsional_friction), pressed, twist_limit);
  const FloatLanes old_twist = lane(block.impulses.twist());
  const FloatLanes share = splat(friction_share<pass, Block>());
  const FloatLanes free_twist = fused(-lane(block.twist_mass), share * u.w.x, old_twist);
  const FloatLanes twist = smaller(larger(free_twist, -twist_limit), twist_limit);
  const FloatLanes change = twist - old_twist;
  put(twist, block.impulses.twist());
  wrench.w.x = wrench.w.x + change;
  u.v = fused(change, {lane(block.Kvw[0][0]), lane(block.Kvw[1][0]), lane(block.Kvw[2][0])}, u.v);
  u.w = fused(change, {lane(block.Kww[0]), lane(block.Kww[3]), lane(block.Kww[4])}, u.w);

  // Slip: a disc of impulses at the centre.
  const SlipImpulse slip = solve_slip<pass>(pressed, u.v, block);
  wrench.v.y = wrench.v.y + slip.f1;
  wrench.v.z = wrench.v.z + slip.f2;
  u.v.x = fused(lane(block.Kvt[1]), slip.f2, fused(lane(block.Kvt[0]), slip.f1, u.v.x));
  u.w = fused(slip.f2, lane(block.Kvw[2]), fused(slip.f1, lane(block.Kvw[1]), u.w));

  // Rolling: a disc of moments.
  if constexpr (Block::kind.has_moments) solve_rolling(pressed, block, u, wrench);
}

/// The response of all velocities that friction reads to a change of the normal impulses, as a wrench (F_n,
/// T_t1, T_t2).
template <class Block>
RIGOR_FLOAT_LANES void add_normals(const Block& block, const NormalMotion& change, LaneTwists& u) {
  // V_t1 and V_t2 by F_n, then by the moments.
  u.v.y = fused(lane(block.Kvt[0]), change.u0, u.v.y);
  u.v.z = fused(lane(block.Kvt[1]), change.u0, u.v.z);
  u.v.y = fused(lane(block.Kvw[1][2]), change.u2, fused(lane(block.Kvw[1][1]), change.u1, u.v.y));
  u.v.z = fused(lane(block.Kvw[2][2]), change.u2, fused(lane(block.Kvw[2][1]), change.u1, u.v.z));

  // Ω by F_n and by the moments.
  u.w = fused(change.u0, lane(block.Kvw[0]), u.w);
  u.w = fused(change.u1, {lane(block.Kww[3]), lane(block.Kww[1]), lane(block.Kww[5])}, u.w);
  u.w = fused(change.u2, {lane(block.Kww[4]), lane(block.Kww[5]), lane(block.Kww[2])}, u.w);
}

// Friction comes first while overlaps are put back, since it matters more that bodies do not enter each
// other. It comes last in the sweep without springs, where its bound is that of the normal impulses that
// remain: the spring has given way before and taken a part of the pressure with it.

/// The changes of the wrench of a patch in a sweep. moved: displacements since the beginning of the step; u:
/// of B against A.
template <BlockPass pass, class Block>
RIGOR_FLOAT_LANES LaneTwists solve_patch(float h, const NormalMotion& moved, LaneTwists& u, Block& block) {
  const FloatLanes zero = splat(0);
  LaneTwists wrench = {{zero, zero, zero}, {zero, zero, zero}};
  if constexpr (pass == BlockPass::push) solve_friction<pass>(block, u, wrench);
  const NormalMotion normals = solve_normals<pass>(h, moved, {u.v.x, u.w.y, u.w.z}, block);
  wrench.v.x = normals.u0;
  wrench.w.y = wrench.w.y + normals.u1;
  wrench.w.z = wrench.w.z + normals.u2;
  if constexpr (pass == BlockPass::relax) {
    add_normals(block, normals, u);
    solve_friction<pass>(block, u, wrench);
  }
  return wrench;
}

/// The changes of the impulse of one point without moments in a sweep, along n, t1, t2: the same with V
/// alone. moved: its displacement along n; u: of B against A there.
template <BlockPass pass, class Block>
RIGOR_FLOAT_LANES FloatVec3 solve_point(float h, const FloatLanes& moved, FloatVec3& u, Block& block) {
  // Friction first while overlaps are put back.
  const FloatLanes old = lane(block.impulses.normal(0));
  SlipImpulse slip;
  if constexpr (pass == BlockPass::push) {
    slip = solve_slip<pass>(old, u, block);
    u.x = fused(lane(block.Kvt[1]), slip.f2, fused(lane(block.Kvt[0]), slip.f1, u.x));
  }

  // The normal impulse.
  const PointRule rule = rule_of<pass>(h, lane(block.points[0].gap) + moved, block, block.points[0]);
  const FloatLanes impulse = next_impulse(rule, u.x, old);
  const FloatLanes change = impulse - old;
  put_normal(0, impulse, block);

  // Friction last in the sweep without springs.
  if constexpr (pass == BlockPass::relax) {
    u.y = fused(lane(block.Kvt[0]), change, u.y);
    u.z = fused(lane(block.Kvt[1]), change, u.z);
    slip = solve_slip<pass>(impulse, u, block);
  }
  return {change, slip.f1, slip.f2};
}

/// One sweep over a block: the bodies are read once, all impulses are found in six numbers, or three, and the
/// bodies are written once.
template <BlockPass pass, class Block>
void solve_pass(float h, Block& block, BulkBodies& bodies) {
  // (V, Ω) of B against A, along n, t1, t2.
  const BlockFrame f = frame_of(block);
  LaneBodies A = gather_velocities(block.body_A, bodies);
  LaneBodies B = gather_velocities(block.body_B, bodies);
  FloatVec3 u = along_axes(f, relative_motion(f, A, B));

  // Impulses of friction and of the points. Displacements are those that the second sweep of the substep
  // before has found, since bodies do not move between it and the first sweep of the next.
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

/// Applies the impulses that the block begins with (section 4).
template <BlockKind kind>
void warm_start(ManifoldBlock<kind>& block, BulkBodies& bodies) {
  const BlockFrame f = frame_of(block);
  LaneBodies A = gather_velocities(block.body_A, bodies);
  LaneBodies B = gather_velocities(block.body_B, bodies);

  // The wrench of all impulses of a manifold: friction, twist, rolling and the points.
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
