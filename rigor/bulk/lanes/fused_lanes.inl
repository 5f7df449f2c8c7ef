// Arithmetic with fused multiply and add (one rounding), which processors with FMA have and others compute
// by the mathematics library: both give the same bits. Included once for each target, inside its namespace
// and, for AVX2, between avx2_begin.inl and avx2_end.inl; RIGOR_LANES_HAVE_FMA tells which.

/// (Of float_lanes(), which is compiled for any processor, g++ 12 makes insertions, lane by lane.)
RIGOR_FLOAT_LANES FloatLanes splat(float x) {
#if RIGOR_LANES_HAVE_FMA
  return FloatLanes(_mm256_set1_ps(x));
#else
  return float_lanes(x);
#endif
}
/// a b + c.
RIGOR_FLOAT_LANES FloatLanes fused(const FloatLanes& a, const FloatLanes& b, const FloatLanes& c) {
#if RIGOR_LANES_HAVE_FMA
  return FloatLanes(_mm256_fmadd_ps(__m256(a), __m256(b), __m256(c)));
#else
  FloatLanes sum;
  fuse_floats(a, b, c, sum);
  return sum;
#endif
}
RIGOR_FLOAT_LANES FloatLanes root(const FloatLanes& x) {
#if RIGOR_LANES_HAVE_FMA
  return FloatLanes(_mm256_sqrt_ps(__m256(x)));
#else
  return float_sqrt(x);
#endif
}
/// (load_floats() and float_min() again: clang++ lets no function with AVX call one without that returns
/// lanes.)
RIGOR_FLOAT_LANES FloatLanes load(const float* p) {
  FloatLanes x;
  std::memcpy(&x, p, sizeof x);
  return x;
}
RIGOR_FLOAT_LANES FloatLanes smaller(const FloatLanes& a, const FloatLanes& b) {
  return a < b ? a : b;
}
RIGOR_FLOAT_LANES FloatLanes larger(const FloatLanes& a, const FloatLanes& b) {
#if RIGOR_LANES_HAVE_FMA
  return FloatLanes(_mm256_max_ps(__m256(a), __m256(b)));
#else
  return float_max(a, b);
#endif
}

/// One bit for each lane whose mask is set.
RIGOR_FLOAT_LANES unsigned bits_of(const IntLanes& mask) {
#if RIGOR_LANES_HAVE_FMA
  return static_cast<unsigned>(_mm256_movemask_ps(__m256(mask)));
#else
  return lane_bits(mask);
#endif
}

/// Four floats at `low` and four at `high`.
RIGOR_FLOAT_LANES FloatLanes load_halves(const float* low, const float* high) {
#if RIGOR_LANES_HAVE_FMA
  return FloatLanes(_mm256_insertf128_ps(_mm256_castps128_ps256(_mm_loadu_ps(low)), _mm_loadu_ps(high), 1));
#else
  FloatLanes x;
  std::memcpy(&x, low, sizeof x / 2);
  std::memcpy(reinterpret_cast<char*>(&x) + sizeof x / 2, high, sizeof x / 2);
  return x;
#endif
}
/// The four rows of two 4 x 4 matrices, one in the lower lanes and one in the upper: both transposed.
struct TwoSquares {
  FloatLanes a, b, c, d;
};
RIGOR_FLOAT_LANES TwoSquares transpose(const TwoSquares& m) {
  // Rows are interleaved in pairs within each half, then the pairs two floats at a time: each result is a
  // column of both matrices.
  const FloatLanes ab_low = __builtin_shufflevector(m.a, m.b, 0, 8, 1, 9, 4, 12, 5, 13);
  const FloatLanes ab_high = __builtin_shufflevector(m.a, m.b, 2, 10, 3, 11, 6, 14, 7, 15);
  const FloatLanes cd_low = __builtin_shufflevector(m.c, m.d, 0, 8, 1, 9, 4, 12, 5, 13);
  const FloatLanes cd_high = __builtin_shufflevector(m.c, m.d, 2, 10, 3, 11, 6, 14, 7, 15);
  return {__builtin_shufflevector(ab_low, cd_low, 0, 1, 8, 9, 4, 5, 12, 13),
          __builtin_shufflevector(ab_low, cd_low, 2, 3, 10, 11, 6, 7, 14, 15),
          __builtin_shufflevector(ab_high, cd_high, 0, 1, 8, 9, 4, 5, 12, 13),
          __builtin_shufflevector(ab_high, cd_high, 2, 3, 10, 11, 6, 7, 14, 15)};
}
/// Four floats of each of eight places, transposed.
RIGOR_FLOAT_LANES TwoSquares gather_fours(const std::array<const float*, kLaneCount>& from) {
  return transpose({load_halves(from[0], from[4]), load_halves(from[1], from[5]),
                    load_halves(from[2], from[6]), load_halves(from[3], from[7])});
}

/// s a + b.
RIGOR_FLOAT_LANES FloatVec3 fused(const FloatLanes& s, const FloatVec3& a, const FloatVec3& b) {
  return {fused(s, a.x, b.x), fused(s, a.y, b.y), fused(s, a.z, b.z)};
}
RIGOR_FLOAT_LANES FloatLanes fused_dot(const FloatVec3& a, const FloatVec3& b) {
  return fused(a.z, b.z, fused(a.y, b.y, a.x * b.x));
}
RIGOR_FLOAT_LANES FloatVec3 fused_cross(const FloatVec3& a, const FloatVec3& b) {
  return {fused(a.y, b.z, -(a.z * b.y)), fused(a.z, b.x, -(a.x * b.z)), fused(a.x, b.y, -(a.y * b.x))};
}
/// a x b + c.
RIGOR_FLOAT_LANES FloatVec3 fused_cross(const FloatVec3& a, const FloatVec3& b, const FloatVec3& c) {
  return {fused(a.y, b.z, fused(-a.z, b.y, c.x)), fused(a.z, b.x, fused(-a.x, b.z, c.y)),
          fused(a.x, b.y, fused(-a.y, b.x, c.z))};
}
RIGOR_FLOAT_LANES FloatVec3 fused_product(const FloatSym3& m, const FloatVec3& a) {
  return {fused(m.xz, a.z, fused(m.xy, a.y, m.xx * a.x)), fused(m.yz, a.z, fused(m.yy, a.y, m.xy * a.x)),
          fused(m.zz, a.z, fused(m.yz, a.y, m.xz * a.x))};
}
