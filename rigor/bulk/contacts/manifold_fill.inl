// Makes blocks of manifolds (docs/theory/bulk.md, section 2). Included once for each target, after
// manifold_lanes.inl.

/// Inverse of the matrix ((a, c), (c, b)); zero where it is singular (nothing moves).
RIGOR_FLOAT_LANES void invert(const FloatLanes& a, const FloatLanes& b, const FloatLanes& c,
                              LaneArray (&inverse)[3]) {
  const FloatLanes zero = splat(0);
  const FloatLanes determinant = fused(a, b, -(c * c));
  const FloatLanes per = determinant > zero ? splat(1) / determinant : zero;
  put(b * per, inverse[0]);
  put(a * per, inverse[1]);
  put(-(c * per), inverse[2]);
}

RIGOR_FLOAT_LANES FloatLanes inverse_or_zero(const FloatLanes& x) {
  const FloatLanes zero = splat(0);
  return x > zero ? splat(1) / x : zero;
}

/// Adds to K the response by the rotation of one body to impulses at the centre of the manifold and to
/// moments, for the vectors e = n, t1, t2. r: the centre of the manifold from that of the body; I: its
/// inverse inertia.
RIGOR_FLOAT_LANES void add_rotation_response(const BlockFrame& f, const FloatVec3& r, const FloatSym3& I,
                                             FloatSym3& vv, FloatSym3& ww, FloatLanes (&vw)[3][3]) {
  const FloatVec3 axes[3] = {f.n, f.t1, f.t2};
  // r × e_i, and the angular velocities I⁻¹ (r × e_i) and I⁻¹ e_i.
  FloatVec3 arm[3], by_impulse[3], by_moment[3];
  for (int i = 0; i < 3; ++i) {
    arm[i] = fused_cross(r, axes[i]);
    by_impulse[i] = fused_product(I, arm[i]);
    by_moment[i] = fused_product(I, axes[i]);
  }

  // V by F: (r × e_i) · I⁻¹ (r × e_j).
  vv = {vv.xx + fused_dot(arm[0], by_impulse[0]), vv.yy + fused_dot(arm[1], by_impulse[1]),
        vv.zz + fused_dot(arm[2], by_impulse[2]), vv.xy + fused_dot(arm[0], by_impulse[1]),
        vv.xz + fused_dot(arm[0], by_impulse[2]), vv.yz + fused_dot(arm[1], by_impulse[2])};
  // Ω by T: e_i · I⁻¹ e_j.
  ww = {ww.xx + fused_dot(axes[0], by_moment[0]), ww.yy + fused_dot(axes[1], by_moment[1]),
        ww.zz + fused_dot(axes[2], by_moment[2]), ww.xy + fused_dot(axes[0], by_moment[1]),
        ww.xz + fused_dot(axes[0], by_moment[2]), ww.yz + fused_dot(axes[1], by_moment[2])};
  // V by T: (r × e_i) · I⁻¹ e_j.
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) vw[i][j] = vw[i][j] + fused_dot(arm[i], by_moment[j]);
  }
}

/// Inverse masses and inertias of the two bodies; zero in empty lanes.
struct LaneMobilities {
  FloatSym3 IA, IB;
  FloatLanes mA, mB;
};

/// K, and the inverses that friction needs; of one point without moments its mass, too.
template <class Block>
RIGOR_FLOAT_LANES void find_responses(const BlockFrame& f, const LaneMobilities& own, Block& block) {
  const FloatLanes zero = splat(0);
  // K = (1/mA + 1/mB) of the impulses, and the rotations of both bodies.
  const FloatLanes m = own.mA + own.mB;
  FloatSym3 vv = {m, m, m, zero, zero, zero}, ww = {zero, zero, zero, zero, zero, zero};
  FloatLanes vw[3][3] = {{zero, zero, zero}, {zero, zero, zero}, {zero, zero, zero}};
  add_rotation_response(f, f.rA, own.IA, vv, ww, vw);
  add_rotation_response(f, f.rB, own.IB, vv, ww, vw);

  // The rows that the kind of block reads.
  put(vv.xy, block.Kvt[0]);
  put(vv.xz, block.Kvt[1]);
  invert(vv.yy, vv.zz, vv.yz, block.tangent_mass);
  if constexpr (Block::kind.turns()) {
    put(vv.xx, block.Kvn);
    put(ww, block.Kww);
#pragma GCC unroll 3
    for (int i = 0; i < 3; ++i) put({vw[i][0], vw[i][1], vw[i][2]}, block.Kvw[i]);
    put(inverse_or_zero(ww.xx), block.twist_mass);
  } else {
    put(inverse_or_zero(vv.xx), block.points[0].mass);
  }
  if constexpr (Block::kind.has_moments) invert(ww.yy, ww.zz, ww.yz, block.roll_mass);
}

/// Two unit vectors that make a right-handed frame with the unit vector n; the first of them.
///
/// Source: Duff et al., Building an Orthonormal Basis, Revisited, J. Computer Graphics Techniques 6(1), 2017,
/// listing 3.
RIGOR_FLOAT_LANES FloatVec3 tangent(const FloatVec3& n) {
  const FloatLanes one = splat(1);
  IntLanes bits;
  std::memcpy(&bits, &n.z, sizeof bits);
  const FloatLanes sign = bits < 0 ? -one : one;
  const FloatLanes a = -one / (sign + n.z);
  return {fused(sign * n.x, n.x * a, one), sign * (n.x * n.y * a), -(sign * n.x)};
}

RIGOR_FLOAT_LANES void gather_inertia(const std::array<std::int32_t, kLaneCount>& indices,
                                      const BulkBodies& bodies, const IntLanes& in_use, FloatSym3& I,
                                      FloatLanes& m) {
  // Two loads of four floats a body: xx yy zz xy, then xz yz 1/m and whether joints hold it.
  std::array<const float*, kLaneCount> from;
  for (std::size_t i = 0; i < kLaneCount; ++i) from[i] = &bodies.inertia.data()[indices[i]].xx;
  const TwoSquares first = gather_fours(from);
  for (std::size_t i = 0; i < kLaneCount; ++i) from[i] += 4;
  const TwoSquares second = gather_fours(from);

  // Neither empty lanes nor held bodies respond to anything.
  const FloatLanes zero = splat(0);
  const IntLanes is_there = in_use & (second.d == zero);
  I = {is_there ? first.a : zero, is_there ? first.b : zero,  is_there ? first.c : zero,
       is_there ? first.d : zero, is_there ? second.a : zero, is_there ? second.b : zero};
  m = is_there ? second.c : zero;
}
RIGOR_FLOAT_LANES void put_inertia(const FloatSym3& I, LaneArray (&rows)[6]) {
  put(I, rows);
}
/// Of round bodies: all three moments are the same.
RIGOR_FLOAT_LANES void put_inertia(const FloatSym3& I, LaneArray (&rows)[1]) {
  put(I.xx, rows[0]);
}

/// The tilts by which springs let bodies lean.
RIGOR_FLOAT_LANES FloatVec3 gather_tilts(const std::array<std::int32_t, kLaneCount>& indices,
                                         const BulkBodies& bodies) {
  std::array<const float*, kLaneCount> from;
  for (std::size_t i = 0; i < kLaneCount; ++i) from[i] = bodies.tilts.data()[indices[i]].data();
  const TwoSquares tilt = gather_fours(from);
  return {tilt.a, tilt.b, tilt.c};
}

/// Normals, points and arms. x_BA [m]: from the centres of the bodies A to those of the bodies B.
template <class Block>
RIGOR_FLOAT_LANES BlockFrame fill_geometry(std::span<const BlockLane> lanes, const FloatVec3& x_BA,
                                           const IntLanes& is_there, const BulkBodies& bodies, Block& block) {
  // Empty lanes repeat the first manifold.
  const FloatLanes zero = splat(0), one = splat(1);
  std::array<const float*, kLaneCount> from;
  std::array<std::int32_t, kLaneCount> counts;
  constexpr std::size_t count = Block::point_count;
  for (std::size_t i = 0; i < kLaneCount; ++i) {
    const ManifoldView& manifold = lanes[i < lanes.size() ? i : 0].manifold;
    from[i] = manifold.normal;
    counts[i] = manifold.point_count;
  }
  IntLanes point_counts;
  std::memcpy(&point_counts, counts.data(), sizeof point_counts);

  // The frame: the normal and two tangents.
  const TwoSquares normals = gather_fours(from);
  BlockFrame f;
  f.n = {normals.a, normals.b, normals.c};
  f.t1 = tangent(f.n);
  f.t2 = fused_cross(f.n, f.t1);
  put(f.n, block.n);
  put(f.t1, block.t1);

  // The points, from the centre of body A; those that a manifold does not have get no mass.
  FloatVec3 p[count];
  FloatVec3 sum = {zero, zero, zero};
  for (std::size_t k = 0; k < count; ++k) {
    for (std::size_t i = 0; i < kLaneCount; ++i) {
      const ManifoldView& manifold = lanes[i < lanes.size() ? i : 0].manifold;
      from[i] = manifold.points[k < at(counts[i]) ? k : 0].p;
    }
    const TwoSquares point = gather_fours(from);
    const IntLanes is_point = is_there & (point_counts > static_cast<std::int32_t>(k));
    p[k] = {point.a, point.b, point.c};
    sum = fused(is_point ? one : zero, p[k], sum);
    put(is_point ? point.d : zero, block.points[k].gap);
    put(is_point ? one : zero, block.points[k].mass);
  }

  // The centre of the manifold is the mean of its points.
  const FloatLanes per_count = one / __builtin_convertvector(point_counts, FloatLanes);
  f.rA = per_count * sum;
  const FloatVec3 centre = f.rA;
  f.rB = f.rA - x_BA;
  if (!bodies.tilts.empty()) {
    // Without the tilts φ by which springs let the bodies lean, r - φ × r.
    f.rA = fused_cross(f.rA, gather_tilts(block.body_A, bodies), f.rA);
    f.rB = fused_cross(f.rB, gather_tilts(block.body_B, bodies), f.rB);
  }
  put(f.rA, block.rA);
  put(f.rB, block.rB);

  // Where the points are in the frame, from the centre.
  if constexpr (Block::kind.turns()) {
    for (std::size_t k = 0; k < count; ++k) {
      const FloatVec3 arm = p[k] - centre;
      const IntLanes is_point = lane(block.points[k].mass) > zero;
      const FloatLanes p1 = is_point ? fused_dot(f.t1, arm) : zero;
      const FloatLanes p2 = is_point ? fused_dot(f.t2, arm) : zero;
      put(p1, block.arms[k].p1);
      put(p2, block.arms[k].p2);
      put(root(fused(p1, p1, p2 * p2)), block.arms[k].length);
    }
  }
  return f;
}

/// Impulses that the points and their friction begin with: those that the State remembers, in the new frame.
template <class Block>
RIGOR_FLOAT_LANES void fill_impulses(std::span<const BlockLane> lanes, const BlockFrame& f, Block& block) {
  // Where the impulses of each lane lie; zeros where nothing is remembered.
  static constexpr float nothing[4] = {};
  std::array<std::array<float, Manifold::max_points>, kLaneCount> normal{};
  std::array<const float*, kLaneCount> from, friction, rolling;
  LaneArray twist{};
  for (std::size_t i = 0; i < kLaneCount; ++i) {
    friction[i] = rolling[i] = nothing;
    from[i] = normal[i].data();
    if (i >= lanes.size() || !lanes[i].memory.is_there()) continue;
    const ManifoldMemories::View& memory = lanes[i].memory;
    normal[i] = remembered_impulses(memory, lanes[i].manifold);
    friction[i] = memory.friction_impulse_W;
    twist[i] = memory.twist_impulse;
    if (memory.rolling_impulse_W != nullptr) rolling[i] = memory.rolling_impulse_W;
  }

  // Of the points, which are found by their features.
  const TwoSquares normals = gather_fours(from);
  const FloatLanes of_points[Manifold::max_points] = {normals.a, normals.b, normals.c, normals.d};
  for (std::size_t k = 0; k < Block::point_count; ++k) put(of_points[k], block.impulses.normal(k));

  // Of friction: remembered as vectors in W, since the tangents are made anew each step.
  const TwoSquares tangential = gather_fours(friction);
  const FloatVec3 friction_W = {tangential.a, tangential.b, tangential.c};
  put(fused_dot(f.t1, friction_W), block.impulses.tangent(0));
  put(fused_dot(f.t2, friction_W), block.impulses.tangent(1));
  if constexpr (Block::kind.turns()) {
    block.impulses.twist() = twist;
    for (std::size_t k = 0; k < 2; ++k) block.first_friction[k] = block.impulses.tangent(k);
    block.first_friction[2] = twist;
  }
  if constexpr (Block::kind.has_moments) {
    const TwoSquares moments = gather_fours(rolling);
    const FloatVec3 moment_W = {moments.a, moments.b, moments.c};
    put(fused_dot(f.t1, moment_W), block.impulses.roll(0));
    put(fused_dot(f.t2, moment_W), block.impulses.roll(1));
  }
}

/// Coefficients of friction and the springs.
template <class Block>
RIGOR_FLOAT_LANES void fill_laws(std::span<const BlockLane> lanes, Block& block) {
  std::array<const float*, kLaneCount> surfaces, springs;
  for (std::size_t i = 0; i < kLaneCount; ++i) {
    const BlockLane& own = lanes[i < lanes.size() ? i : 0];
    surfaces[i] = &own.surface->friction;
    springs[i] = &own.softness->bias_rate;
  }
  const TwoSquares surface = gather_fours(surfaces), spring = gather_fours(springs);
  put(surface.a, block.friction);
  if constexpr (Block::kind.has_moments) {
    put(surface.c, block.torsional_friction);
    put(surface.d, block.rolling_friction);
  }
  put(spring.a, block.bias_rate);
  put(spring.b, block.mass_scale);
}

/// Masses of the points and normal velocities at the beginning of the step.
template <class Block>
RIGOR_FLOAT_LANES void fill_points(const BlockFrame& f, const BulkBodies& bodies, Block& block) {
  const LaneTwists A = gather_velocities(block.body_A, bodies);
  const LaneTwists B = gather_velocities(block.body_B, bodies);
  const FloatLanes zero = splat(0), speed = fused_dot(f.n, relative_motion(f, A, B));
  if constexpr (Block::kind.turns()) {
    const FloatVec3 spin = B.w - A.w;
    const NormalMotion u = {speed, fused_dot(f.t1, spin), fused_dot(f.t2, spin)};
    for (std::size_t k = 0; k < Block::point_count; ++k) {
      BlockPoint& point = block.points[k];
      const FloatLanes p1 = lane(block.arms[k].p1), p2 = lane(block.arms[k].p2);
      const FloatLanes response = at_point(response_to(block, p1, p2), p1, p2);
      put(lane(point.mass) > zero ? inverse_or_zero(response) : zero, point.mass);
      put(at_point(u, p1, p2), point.first_speed);
    }
  } else {
    put(speed, block.points[0].first_speed);
  }
}

/// Makes a block: section 2.
template <BlockKind kind>
void fill(std::span<const BlockLane> lanes, const BulkBodies& bodies, ManifoldBlock<kind>& block) {
  // Which bodies the lanes have, which of them respond, and where B is from A; empty lanes have those of the
  // first.
  std::array<std::int32_t, kLaneCount> there{};
  float x_BA[3][kLaneCount];
  block.moves_A = block.moves_B = 0;
  for (std::size_t i = 0; i < kLaneCount; ++i) {
    const BlockLane& own = lanes[i < lanes.size() ? i : 0];
    block.body_A[i] = own.body_A;
    block.body_B[i] = own.body_B;
    const std::size_t a = at(own.body_A), b = at(own.body_B);
    for (std::size_t k = 0; k < 3; ++k) {
      const Eigen::Index axis = static_cast<Eigen::Index>(k);
      x_BA[k][i] = static_cast<float>(bodies.x[b][axis] - bodies.x[a][axis]);
    }
    if (i >= lanes.size()) continue;
    there[i] = -1;
    if (bodies.gives_way(own.body_A)) block.moves_A = static_cast<std::uint8_t>(block.moves_A | 1u << i);
    if (bodies.gives_way(own.body_B)) block.moves_B = static_cast<std::uint8_t>(block.moves_B | 1u << i);
  }
  IntLanes is_there;
  std::memcpy(&is_there, there.data(), sizeof is_there);

  // Nothing has been pressed or has moved yet.
  for (std::uint8_t& pressed : block.pressed) pressed = 0;
  for (LaneArray& moved : block.moved) put(splat(0), moved);

  // The bodies' inertia, the frame and the points, impulses, laws, and the responses of it all.
  LaneMobilities own;
  gather_inertia(block.body_A, bodies, is_there, own.IA, own.mA);
  gather_inertia(block.body_B, bodies, is_there, own.IB, own.mB);
  put_inertia(own.IA, block.IA);
  put_inertia(own.IB, block.IB);
  const FloatVec3 apart = {load(x_BA[0]), load(x_BA[1]), load(x_BA[2])};
  const BlockFrame f = fill_geometry(lanes, apart, is_there, bodies, block);
  fill_impulses(lanes, f, block);
  fill_laws(lanes, block);
  find_responses(f, own, block);
  fill_points(f, bodies, block);
}
