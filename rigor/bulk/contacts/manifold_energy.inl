// What the springs of blocks of manifolds hold at the end of a step (docs/theory/bulk.md, section 8), in
// double precision, since it is the difference of energies that decides. Included once for each target, after
// manifold_lanes.inl.

/// Four lanes of a block: a register of doubles. (The vectors of geometry/lanes have no target of their own,
/// and clang++ lets no function with AVX call one without that returns lanes.)
using FourDoubles = double __attribute__((vector_size(32)));
struct FourVectors {
  FourDoubles x, y, z;
};

/// The first or the second four of eight lanes.
RIGOR_FLOAT_LANES FourDoubles four_of(const FloatLanes& a, int half) {
  using FourFloats = float __attribute__((vector_size(16)));
  FourFloats four;
  std::memcpy(&four, reinterpret_cast<const float*>(&a) + 4 * half, sizeof four);
  return __builtin_convertvector(four, FourDoubles);
}
RIGOR_FLOAT_LANES FourDoubles four_of(const LaneArray& a, int half) {
  using FourFloats = float __attribute__((vector_size(16)));
  FourFloats four;
  std::memcpy(&four, a.data() + 4 * half, sizeof four);
  return __builtin_convertvector(four, FourDoubles);
}
template <class Rows>
RIGOR_FLOAT_LANES FourVectors four_vectors_of(const Rows& x, const Rows& y, const Rows& z, int half) {
  return {four_of(x, half), four_of(y, half), four_of(z, half)};
}
RIGOR_FLOAT_LANES FourDoubles dot_of(const FourVectors& a, const FourVectors& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
RIGOR_FLOAT_LANES FourVectors cross_of(const FourVectors& a, const FourVectors& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
RIGOR_FLOAT_LANES FourDoubles positive_part(const FourDoubles& a) {
  const FourDoubles zero = {};
  return a > zero ? a : zero;
}

/// Displacements of the bodies A and B of a block in the step.
struct LaneWays {
  LaneTwists A, B;
};

/// Of four lanes.
template <BlockKind kind>
RIGOR_FLOAT_LANES FourDoubles spring_energies_of(const ManifoldBlock<kind>& block,
                                                 const BlockImpulses<kind>& total, const LaneWays& ways,
                                                 const SpringStep& step, const LaneArray& held, int half) {
  const auto rows_of = [&](const LaneArray(&rows)[3]) {
    return four_vectors_of(rows[0], rows[1], rows[2], half);
  };
  const auto lanes_of = [&](const FloatVec3& a) { return four_vectors_of(a.x, a.y, a.z, half); };
  const FourVectors n = rows_of(block.n), turn_A = lanes_of(ways.A.w), turn_B = lanes_of(ways.B.w);
  const FourVectors way_A = lanes_of(ways.A.v), way_B = lanes_of(ways.B.v);
  const FourVectors by_B = cross_of(turn_B, rows_of(block.rB)), by_A = cross_of(turn_A, rows_of(block.rA));
  // Displacements of the step that change the gaps: u_n of section 2 with displacements in place of
  // velocities.
  const FourVectors moved = {way_B.x + by_B.x - way_A.x - by_A.x, way_B.y + by_B.y - way_A.y - by_A.y,
                             way_B.z + by_B.z - way_A.z - by_A.z};
  const FourDoubles u0 = dot_of(n, moved);
  FourDoubles u1 = {}, u2 = {};
  if constexpr (kind.turns()) {
    const FourVectors t1 = rows_of(block.t1);
    const FourVectors turn = {turn_B.x - turn_A.x, turn_B.y - turn_A.y, turn_B.z - turn_A.z};
    u1 = dot_of(t1, turn);
    u2 = dot_of(cross_of(n, t1), turn);
  }
  // At rest λ = -(mass_scale / (1 - mass_scale)) m bias_rate s, an impulse of h k |s|.
  const FourDoubles mass_scale = four_of(block.mass_scale, half);
  const FourDoubles stiffness_of_mass =
      mass_scale / (1.0 - mass_scale) * four_of(block.bias_rate, half) / step.h;
  FourDoubles energy = {}, work = {};
#pragma GCC unroll 4
  for (std::size_t k = 0; k < kind.points; ++k) {
    const BlockPoint& point = block.points[k];
    const FourDoubles first_gap = four_of(point.gap, half);
    FourDoubles gap = first_gap + u0;
    if constexpr (kind.turns())
      gap = gap + four_of(block.arms[k].p2, half) * u1 - four_of(block.arms[k].p1, half) * u2;
    const FourDoubles overlap = positive_part(-gap), before = positive_part(-first_gap);
    energy += 0.5 * four_of(point.mass, half) * stiffness_of_mass * overlap * overlap;
    work += four_of(total.normal(k), half) / (step.h * step.substeps) * positive_part(overlap - before);
  }
  const FourDoubles most = four_of(held, half) + work;
  return most < energy ? most : energy;
}

/// In place of what they held at the beginning of the step.
template <BlockKind kind>
void find_spring_energies(const ManifoldBlock<kind>& block, const BlockImpulses<kind>& total,
                          const BulkBodies& bodies, const SpringStep& step, LaneArray& energies) {
  const LaneWays ways = {gather_displacements(block.body_A, bodies),
                         gather_displacements(block.body_B, bodies)};
  const LaneArray held = energies;
  for (int half = 0; half < 2; ++half) {
    const FourDoubles found = spring_energies_of(block, total, ways, step, held, half);
    for (int i = 0; i < 4; ++i) energies[at(4 * half + i)] = static_cast<float>(found[i]);
  }
}
