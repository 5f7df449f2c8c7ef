// Rotations of eight bodies. Included once for each target, after fused_lanes.inl.

/// A rotation: a unit quaternion.
struct LaneRotation {
  FloatLanes w;
  FloatVec3 v;
};

/// Rotation by h ω: exact to rounding up to about a radian; beyond, the axis is still that of ω.
///
/// With y = |h ω|/4, the tangent of a quarter of the angle is taken as its Padé approximant
/// tan y = y (15 - y²)/(15 - 6 y²): there is no root, and the quaternion has unit length for any ω.
RIGOR_FLOAT_LANES LaneRotation rotation_over(float h, const FloatVec3& w) {
  // Numerator and denominator of tan y, but for the factor y.
  const FloatLanes yy = splat(h * h / 16) * fused_dot(w, w);
  const FloatLanes up = splat(15) - yy, down = fused(splat(-6), yy, splat(15));

  // The half angle by the double-angle formulas: cos 2y = (1 - t²)/(1 + t²), sin 2y = 2 t/(1 + t²), t = tan
  // y.
  const FloatLanes sines = up * up * yy, cosines = down * down;
  const FloatLanes inverse = splat(1) / (cosines + sines);
  return {(cosines - sines) * inverse, (splat(0.5F * h) * (up * down) * inverse) * w};
}
/// By how much a rotation q moves the end of a vector: R a - a = w c + v × c with c = 2 v × a.
RIGOR_FLOAT_LANES FloatVec3 displacement_of(const LaneRotation& q, const FloatVec3& a) {
  const FloatVec3 c = fused_cross(q.v + q.v, a);
  return fused_cross(q.v, c, q.w * c);
}

/// dr = the rotation vector of exp(h ω) exp(dr): see turn_further().
RIGOR_FLOAT_LANES void turn_further(float h, const FloatVec3& w, FloatVec3& dr) {
  // To third order (Baker, Campbell, Hausdorff): r + s - ½ r × s + (1/12) r × (r × s).
  const FloatVec3 r = dr, s = splat(h) * w;
  const FloatVec3 across = fused_cross(r, s), twice_across = fused_cross(r, across);
  dr = (r + s) + fused(splat(1.0F / 12), twice_across, splat(-0.5F) * across);

  // Exactly, by quaternions, in the few lanes where the series does not do.
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
    float rotated[3] = {from[0][i], from[1][i], from[2][i]};
    const float further[3] = {by[0][i], by[1][i], by[2][i]};
    turn_far(further, rotated);
    for (int k = 0; k < 3; ++k) to[k][i] = rotated[k];
  }
  dr = {load(to[0]), load(to[1]), load(to[2])};
}
