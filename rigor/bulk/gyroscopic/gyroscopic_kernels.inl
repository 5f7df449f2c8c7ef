// The change of angular velocities by the gyroscopic torque -ω × I ω. Included once for each target, after
// fused_lanes.inl.

/// Of bodies of revolution about the unit axis e: Euler's equations rotate ω about it, as seen from the body,
/// at the rate spin (e · ω) with spin = I_along / I_across - 1. It is a rotation exactly, only its angle has
/// an error (of third order), so that the energy stays the same at any speed.
RIGOR_FLOAT_LANES FloatVec3 change_about_axis(const FloatVec3& e, const FloatLanes& spin, const FloatVec3& w,
                                              float h) {
  // Rotation by the angle 2 atan t: ω + 2 t/(1 + t²) (e × ω + t e × (e × ω)).
  const FloatLanes along = fused_dot(e, w);
  const FloatLanes half = splat(0.5F * h) * spin * along;  // Tangent of half the angle.
  const FloatLanes scale = (half + half) / fused(half, half, splat(1));
  return scale * fused(half, along * e - w, fused_cross(e, w));
}

/// Of any bodies: one Newton step of the equation of the implicit midpoint, I (ω' - ω) + h m × I m = 0 with
/// m = (ω + ω')/2, then made as long as keeps the energy. axes: the first two principal ones.
///
/// Source: Catto, Numerical Methods, Game Developers Conference 2015, for the step; there it is that of the
/// implicit method of Euler, which is of first order and loses energy.
RIGOR_FLOAT_LANES FloatVec3 change_by_newton(const FloatVec3 (&axes)[2], const FloatLanes (&I)[3],
                                             const FloatVec3& w, float h) {
  // ω along the principal axes.
  const FloatVec3 e[3] = {axes[0], axes[1], fused_cross(axes[0], axes[1])};
  const FloatLanes b[3] = {fused_dot(e[0], w), fused_dot(e[1], w), fused_dot(e[2], w)};

  // J x = h ω × I ω,  J = I + h/2 (ω~ I - (I ω)~): row i has I_i on the diagonal and h/2 (I_k - I_j) of the
  // other components; x/2 is what the first half takes.
  const FloatLanes lane_h = splat(0.5F * h);
  const FloatLanes g0 = lane_h * (I[2] - I[1]), g1 = lane_h * (I[0] - I[2]), g2 = lane_h * (I[1] - I[0]);
  const FloatLanes f[3] = {g0 * b[1] * b[2], g1 * b[2] * b[0], g2 * b[0] * b[1]};
  const FloatLanes m01 = g0 * b[2], m02 = g0 * b[1];
  const FloatLanes m10 = g1 * b[2], m12 = g1 * b[0];
  const FloatLanes m20 = g2 * b[1], m21 = g2 * b[0];

  // x by Cramer's rule.
  const FloatLanes c00 = I[1] * I[2] - m12 * m21, c01 = m12 * m20 - m10 * I[2], c02 = m10 * m21 - I[1] * m20;
  const FloatLanes inverse = splat(1) / (I[0] * c00 + m01 * c01 + m02 * c02);
  const FloatLanes half[3] = {
      (f[0] * c00 + f[1] * (m02 * m21 - m01 * I[2]) + f[2] * (m01 * m12 - m02 * I[1])) * inverse,
      (f[0] * c01 + f[1] * (I[0] * I[2] - m02 * m20) + f[2] * (m02 * m10 - I[0] * m12)) * inverse,
      (f[0] * c02 + f[1] * (m01 * m20 - I[0] * m21) + f[2] * (I[0] * I[1] - m01 * m10)) * inverse};

  // The midpoint keeps the energy. One Newton step is not quite its solution.
  FloatLanes before = splat(0), after = splat(0), y[3];
  for (int j = 0; j < 3; ++j) {
    y[j] = b[j] - (half[j] + half[j]);
    before = fused(I[j] * b[j], b[j], before);
    after = fused(I[j] * y[j], y[j], after);
  }
  const FloatLanes scale = after > splat(0) ? root(before / after) : splat(1);

  // The change, back along the axes of W.
  for (int j = 0; j < 3; ++j) y[j] = scale * y[j] - b[j];
  return fused(y[0], e[0], fused(y[1], e[1], y[2] * e[2]));
}
