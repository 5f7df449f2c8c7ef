// What the kernels of manifold blocks share (docs/theory/bulk.md, section 2): rows of a block as lanes,
// bodies gathered and scattered, frames and wrenches. Included once for each target, inside its namespace and
// after fused_lanes.inl.

RIGOR_FLOAT_LANES FloatLanes lane(const LaneArray& a) {
  return load(a.data());
}
RIGOR_FLOAT_LANES FloatVec3 lane(const LaneArray (&a)[3]) {
  return {lane(a[0]), lane(a[1]), lane(a[2])};
}
RIGOR_FLOAT_LANES FloatSym3 lane(const LaneArray (&a)[6]) {
  return {lane(a[0]), lane(a[1]), lane(a[2]), lane(a[3]), lane(a[4]), lane(a[5])};
}
RIGOR_FLOAT_LANES void put(const FloatLanes& x, LaneArray& a) {
  store_floats(x, a.data());
}
RIGOR_FLOAT_LANES void put(const FloatVec3& v, LaneArray (&a)[3]) {
  put(v.x, a[0]);
  put(v.y, a[1]);
  put(v.z, a[2]);
}
RIGOR_FLOAT_LANES void put(const FloatSym3& m, LaneArray (&a)[6]) {
  put(m.xx, a[0]);
  put(m.yy, a[1]);
  put(m.zz, a[2]);
  put(m.xy, a[3]);
  put(m.xz, a[4]);
  put(m.yz, a[5]);
}

/// Velocities (displacements, impulses and moments) of eight bodies along W's axes, or of B against A along
/// the axes n, t1, t2 of the manifolds.
struct LaneTwists {
  FloatVec3 v, w;
};

/// Four floats of each of eight records, from the float `first` on.
RIGOR_FLOAT_LANES TwoSquares gather(const std::array<std::int32_t, kLaneCount>& indices,
                                    const BulkBodies& bodies, std::size_t first) {
  const float* motion = reinterpret_cast<const float*>(bodies.motion.data()) + first;
  constexpr std::int64_t size = sizeof(MotionRecord) / sizeof(float);
  return transpose({load_halves(motion + size * indices[0], motion + size * indices[4]),
                    load_halves(motion + size * indices[1], motion + size * indices[5]),
                    load_halves(motion + size * indices[2], motion + size * indices[6]),
                    load_halves(motion + size * indices[3], motion + size * indices[7])});
}
RIGOR_FLOAT_LANES FloatVec3 gather_vectors(const std::array<std::int32_t, kLaneCount>& indices,
                                           const BulkBodies& bodies, std::size_t first) {
  const TwoSquares columns = gather(indices, bodies, first);
  return {columns.a, columns.b, columns.c};
}
/// Velocities of eight bodies, and the inverse masses that stand between them.
struct LaneBodies : LaneTwists {
  FloatLanes inv_mass;
};
RIGOR_FLOAT_LANES LaneBodies gather_velocities(const std::array<std::int32_t, kLaneCount>& indices,
                                               const BulkBodies& bodies) {
  const TwoSquares v = gather(indices, bodies, 0);
  return {{{v.a, v.b, v.c}, gather_vectors(indices, bodies, offsetof(MotionRecord, w) / sizeof(float))}, v.d};
}
RIGOR_FLOAT_LANES LaneTwists gather_displacements(const std::array<std::int32_t, kLaneCount>& indices,
                                                  const BulkBodies& bodies) {
  return {gather_vectors(indices, bodies, offsetof(MotionRecord, dp) / sizeof(float)),
          gather_vectors(indices, bodies, offsetof(MotionRecord, dr) / sizeof(float))};
}

/// Writes the velocities of the lanes whose body is dynamic; the inverse mass stays.
RIGOR_FLOAT_LANES void scatter_velocities(const std::array<std::int32_t, kLaneCount>& indices,
                                          std::uint8_t moves, const LaneBodies& own, BulkBodies& bodies) {
  // Two transpositions of 4 x 4 squares bring (v, 1/m) and (w, 0) of each lane together.
  const TwoSquares v = transpose({own.v.x, own.v.y, own.v.z, own.inv_mass});
  const TwoSquares w = transpose({own.w.x, own.w.y, own.w.z, splat(0)});
  // The row of a lane is (v, 1/m, w, 0): the first half of a record, which one store writes.
  const FloatSquare rows = {{FloatLanes(__builtin_shufflevector(v.a, w.a, 0, 1, 2, 3, 8, 9, 10, 11)),
                             FloatLanes(__builtin_shufflevector(v.b, w.b, 0, 1, 2, 3, 8, 9, 10, 11)),
                             FloatLanes(__builtin_shufflevector(v.c, w.c, 0, 1, 2, 3, 8, 9, 10, 11)),
                             FloatLanes(__builtin_shufflevector(v.d, w.d, 0, 1, 2, 3, 8, 9, 10, 11)),
                             FloatLanes(__builtin_shufflevector(v.a, w.a, 4, 5, 6, 7, 12, 13, 14, 15)),
                             FloatLanes(__builtin_shufflevector(v.b, w.b, 4, 5, 6, 7, 12, 13, 14, 15)),
                             FloatLanes(__builtin_shufflevector(v.c, w.c, 4, 5, 6, 7, 12, 13, 14, 15)),
                             FloatLanes(__builtin_shufflevector(v.d, w.d, 4, 5, 6, 7, 12, 13, 14, 15))}};
  MotionRecord* motion = bodies.motion.data();
#pragma GCC unroll 8
  for (std::size_t i = 0; i < kLaneCount; ++i) {
    if (moves >> i & 1) store_floats(rows.row[i], motion[indices[i]].v);
  }
}

/// Frame and arms of a block.
struct BlockFrame {
  FloatVec3 n, t1, t2, rA, rB;
};
template <class Block>
RIGOR_FLOAT_LANES BlockFrame frame_of(const Block& block) {
  BlockFrame frame;
  frame.n = lane(block.n);
  frame.t1 = lane(block.t1);
  frame.t2 = fused_cross(frame.n, frame.t1);
  frame.rA = lane(block.rA);
  frame.rB = lane(block.rB);
  return frame;
}

RIGOR_FLOAT_LANES FloatVec3 along_axes(const BlockFrame& f, const FloatVec3& a_W) {
  return {fused_dot(f.n, a_W), fused_dot(f.t1, a_W), fused_dot(f.t2, a_W)};
}
RIGOR_FLOAT_LANES FloatVec3 along_W(const BlockFrame& f, const FloatVec3& a) {
  return fused(a.z, f.t2, fused(a.y, f.t1, a.x * f.n));
}

/// Velocity (or displacement) of B against A at the centre of the manifold, along W's axes.
RIGOR_FLOAT_LANES FloatVec3 relative_motion(const BlockFrame& f, const LaneTwists& A, const LaneTwists& B) {
  return fused_cross(B.w, f.rB, B.v) - fused_cross(A.w, f.rA, A.v);
}

/// The change of the angular velocity by an angular impulse a, I⁻¹ a: I has the elements of the symmetric
/// inverse inertia, or the one number of a round body.
RIGOR_FLOAT_LANES FloatVec3 angular_response(const LaneArray (&I)[6], const FloatVec3& a) {
  return fused_product(lane(I), a);
}
RIGOR_FLOAT_LANES FloatVec3 angular_response(const LaneArray (&I)[1], const FloatVec3& a) {
  return lane(I[0]) * a;
}

/// An impulse at the centre and a moment on B (their opposites on A), along the axes of the manifold.
template <class Block>
RIGOR_FLOAT_LANES void apply_wrench(const Block& block, const BlockFrame& f, const LaneTwists& wrench,
                                    LaneBodies& A, LaneBodies& B) {
  // v ± F/m and ω ± I⁻¹ (r × F + T).
  const FloatVec3 impulse = along_W(f, wrench.v), moment = along_W(f, wrench.w);
  A.v = fused(-A.inv_mass, impulse, A.v);
  A.w = A.w - angular_response(block.IA, fused_cross(f.rA, impulse, moment));
  B.v = fused(B.inv_mass, impulse, B.v);
  B.w = B.w + angular_response(block.IB, fused_cross(f.rB, impulse, moment));
}
/// An impulse alone.
template <class Block>
RIGOR_FLOAT_LANES void apply_impulse(const Block& block, const BlockFrame& f, const FloatVec3& impulse_C,
                                     LaneBodies& A, LaneBodies& B) {
  const FloatVec3 impulse = along_W(f, impulse_C);
  A.v = fused(-A.inv_mass, impulse, A.v);
  A.w = A.w - angular_response(block.IA, fused_cross(f.rA, impulse));
  B.v = fused(B.inv_mass, impulse, B.v);
  B.w = B.w + angular_response(block.IB, fused_cross(f.rB, impulse));
}

/// u = (V_n, Ω_t1, Ω_t2): what the normal velocities of the points are made of; also the wrench (F_n, T_t1,
/// T_t2) of their impulses.
struct NormalMotion {
  FloatLanes u0, u1, u2;
};
/// u_n = V_n + p2 Ω_t1 - p1 Ω_t2.
RIGOR_FLOAT_LANES FloatLanes at_point(const NormalMotion& u, const FloatLanes& p1, const FloatLanes& p2) {
  return fused(-p1, u.u2, fused(p2, u.u1, u.u0));
}
/// The response of u to a unit normal impulse at a point: K' (1, p2, -p1)ᵀ, where K' has the rows and columns
/// n, t1, t2 of K that u has.
template <class Block>
RIGOR_FLOAT_LANES NormalMotion response_to(const Block& block, const FloatLanes& p1, const FloatLanes& p2) {
  const FloatLanes k01 = lane(block.Kvw[0][1]), k02 = lane(block.Kvw[0][2]);
  const FloatLanes k11 = lane(block.Kww[1]), k22 = lane(block.Kww[2]), k12 = lane(block.Kww[5]);
  return {fused(-p1, k02, fused(p2, k01, lane(block.Kvn))), fused(-p1, k12, fused(p2, k11, k01)),
          fused(-p1, k22, fused(p2, k12, k02))};
}
