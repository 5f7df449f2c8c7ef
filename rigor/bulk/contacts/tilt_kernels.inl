// The slopes of the overlaps of eight manifolds (docs/theory/bulk.md, section 3). Included once for each
// target, after fused_lanes.inl. Nothing is fused.

/// Points span a face if the determinant of their moments is at least this part of the cube of the trace:
/// that of a face of the breadth b and the length l is about (b/l)²/8.
constexpr float least_spread = 1e-4F;

RIGOR_FLOAT_LANES FloatVec3 plain_cross(const FloatVec3& a, const FloatVec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Adds the square a aᵀ of a vector times a weight to a symmetric matrix.
RIGOR_FLOAT_LANES void add_square(const FloatLanes& weight, const FloatVec3& a, FloatSym3& m) {
  const FloatVec3 wa = weight * a;
  m.xx = m.xx + wa.x * a.x, m.yy = m.yy + wa.y * a.y, m.zz = m.zz + wa.z * a.z;
  m.xy = m.xy + wa.x * a.y, m.xz = m.xz + wa.x * a.z, m.yz = m.yz + wa.y * a.z;
}
RIGOR_FLOAT_LANES FloatLanes trace_of(const FloatSym3& m) {
  return m.xx + m.yy + m.zz;
}
RIGOR_FLOAT_LANES FloatLanes determinant_of(const FloatSym3& m) {
  return m.xx * (m.yy * m.zz - m.yz * m.yz) + m.xy * (m.xz * m.yz - m.xy * m.zz) +
         m.xz * (m.xy * m.yz - m.xz * m.yy);
}
/// The solution of M x = b by Cramer's rule, times the determinant of M.
RIGOR_FLOAT_LANES FloatVec3 solve_moments(const FloatSym3& m, const FloatVec3& b) {
  const FloatLanes xx = m.yy * m.zz - m.yz * m.yz, xy = m.xz * m.yz - m.xy * m.zz,
                   xz = m.xy * m.yz - m.xz * m.yy, yy = m.xx * m.zz - m.xz * m.xz,
                   yz = m.xy * m.xz - m.xx * m.yz, zz = m.xx * m.yy - m.xy * m.xy;
  return {b.x * xx + b.y * xy + b.z * xz, b.x * xy + b.y * yy + b.z * yz, b.x * xz + b.y * yz + b.z * zz};
}

void find_turns(const TiltLanes& lanes, float ahead, std::array<TiltRow, kLaneCount>& turns) {
  const FloatLanes zero = splat(0), one = splat(1);
  constexpr std::size_t most = Manifold::max_points;
  std::array<const float*, kLaneCount> from;
  std::array<std::int32_t, kLaneCount> counts;
  for (std::size_t i = 0; i < kLaneCount; ++i) {
    from[i] = lanes.manifold[i].normal;
    counts[i] = lanes.manifold[i].point_count;
  }
  IntLanes point_counts;
  std::memcpy(&point_counts, counts.data(), sizeof point_counts);
  const TwoSquares normals = gather_fours(from);
  const FloatVec3 n = {normals.a, normals.b, normals.c};

  // The means of the points and of their overlaps; those that are apart overlap by nothing, and what is no
  // point counts for nothing.
  const FloatLanes per_count = one / __builtin_convertvector(point_counts, FloatLanes);
  FloatVec3 p[most], centre = {zero, zero, zero};
  FloatLanes depth[most], weight[most], overlap = zero;
  for (std::size_t k = 0; k < most; ++k) {
    for (std::size_t i = 0; i < kLaneCount; ++i)
      from[i] = lanes.manifold[i].points[k < at(counts[i]) ? k : 0].p;
    const TwoSquares point = gather_fours(from);
    const IntLanes is_point = point_counts > static_cast<std::int32_t>(k);
    weight[k] = is_point ? one : zero;
    p[k] = {point.a, point.b, point.c};
    depth[k] = zero < point.d ? zero : point.d;
    centre = centre + (weight[k] * per_count) * p[k];
    overlap = overlap - weight[k] * depth[k];
  }

  // A rotation θ opens the gap at p by θ · a, a = p × n: the least squares are Σ a aᵀ θ = Σ a gap. All a are
  // perpendicular to n, and so is θ; n nᵀ makes the matrix regular.
  FloatSym3 moments = {zero, zero, zero, zero, zero, zero};
  FloatVec3 sum = {zero, zero, zero};
  for (std::size_t k = 0; k < most; ++k) {
    const FloatVec3 a = weight[k] * plain_cross(p[k] - centre, n);
    add_square(one, a, moments);
    sum = sum + (depth[k] + per_count * overlap) * a;
  }
  add_square(trace_of(moments), n, moments);
  const FloatLanes trace = trace_of(moments), determinant = determinant_of(moments);
  const IntLanes is_face = (overlap > zero) & (determinant > splat(least_spread) * trace * trace * trace);
  const FloatVec3 product = solve_moments(moments, sum);
  const FloatVec3 tilt = {product.x / determinant, product.y / determinant, product.z / determinant};

  // What the rotation of B against A adds.
  const TwoSquares A = gather_fours(lanes.w_A), B = gather_fours(lanes.w_B);
  const FloatVec3 w = {B.a - A.a, B.b - A.b, B.c - A.c};
  const FloatLanes spin = w.x * n.x + w.y * n.y + w.z * n.z;
  const FloatVec3 turn = load(lanes.sign.data()) * (tilt + splat(ahead) * (w - spin * n));
  const TwoSquares rows = transpose({turn.x, turn.y, turn.z, is_face ? overlap : zero});
  const FloatLanes halves[4] = {rows.a, rows.b, rows.c, rows.d};
  for (std::size_t i = 0; i < 4; ++i) {
    std::memcpy(turns[i].data(), &halves[i], sizeof turns[i]);
    std::memcpy(turns[i + 4].data(), reinterpret_cast<const float*>(&halves[i]) + 4, sizeof turns[i]);
  }
}
