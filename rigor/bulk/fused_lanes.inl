// Arithmetic with fused multiply and add (one rounding), which processors with FMA have and others compute
// by the mathematics library: both give the same bits. Included once for each target, inside its namespace
// and, for AVX2, its pragma; RIGOR_LANES_HAVE_FMA tells which.

/// a b + c.
RIGOR_FLOAT_LANES FloatLanes fused(const FloatLanes& a, const FloatLanes& b, const FloatLanes& c) {
#if RIGOR_LANES_HAVE_FMA
  return FloatLanes(_mm256_fmadd_ps(__m256(a), __m256(b), __m256(c)));
#else
  FloatLanes sum;
  for (int i = 0; i < kLaneCount; ++i) sum[i] = __builtin_fmaf(a[i], b[i], c[i]);
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
