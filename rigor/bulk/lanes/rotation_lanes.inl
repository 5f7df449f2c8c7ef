// Turns of eight bodies. Included once for each target, after fused_lanes.inl.

/// A rotation: a unit quaternion.
struct LaneTurn {
  FloatLanes w;
  FloatVec3 v;
};

/// Turn by h ω: by the vector h ω up to about a radian (to rounding), by some turn about it beyond.
///
/// With y = |h ω|/4 and tan y = y (15 - y²)/(15 - 6 y²), its Padé approximant, as the tangent of a quarter of
/// the angle: no root, and a unit quaternion for any ω.
RIGOR_FLOAT_LANES LaneTurn turn_of(float h, const FloatVec3& w) {
  const FloatLanes yy = splat(h * h / 16) * fused_dot(w, w);
  const FloatLanes up = splat(15) - yy, down = fused(splat(-6), yy, splat(15));
  const FloatLanes sines = up * up * yy, cosines = down * down;
  const FloatLanes inverse = splat(1) / (cosines + sines);
  return {(cosines - sines) * inverse, (splat(0.5F * h) * (up * down) * inverse) * w};
}
/// By how much the turn moves the end of a vector.
RIGOR_FLOAT_LANES FloatVec3 way_of(const LaneTurn& turn, const FloatVec3& a) {
  const FloatVec3 across = fused_cross(turn.v + turn.v, a);
  return fused_cross(turn.v, across, turn.w * across);
}

/// dr = the rotation vector of exp(h ω) exp(dr): see turn_further().
RIGOR_FLOAT_LANES void turn_further(float h, const FloatVec3& w, FloatVec3& dr) {
  const FloatVec3 r = dr, s = splat(h) * w;
  const FloatVec3 across = fused_cross(r, s), twice_across = fused_cross(r, across);
  dr = (r + s) + fused(splat(1.0F / 12), twice_across, splat(-0.5F) * across);
  const IntLanes is_far = fused_dot(r, r) + fused_dot(s, s) > splat(kFarTurn * kFarTurn);
  if (lane_bits(is_far) == 0) return;
  float from[3][kLaneCount], by[3][kLaneCount], to[3][kLaneCount];
  const FloatVec3* vectors[] = {&r, &s, &dr};
  float(*arrays[])[kLaneCount] = {from, by, to};
  for (int k = 0; k < 3; ++k) {
    store_floats(vectors[k]->x, arrays[k][0]);
    store_floats(vectors[k]->y, arrays[k][1]);
    store_floats(vectors[k]->z, arrays[k][2]);
  }
  for (int i = 0; i < kLaneCount; ++i) {
    if (is_far[i] == 0) continue;
    float turned[3] = {from[0][i], from[1][i], from[2][i]};
    const float further[3] = {by[0][i], by[1][i], by[2][i]};
    turn_far(further, turned);
    for (int k = 0; k < 3; ++k) to[k][i] = turned[k];
  }
  dr = {load(to[0]), load(to[1]), load(to[2])};
}
