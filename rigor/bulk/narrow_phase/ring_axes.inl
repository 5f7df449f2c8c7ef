// Directions that may part two solids of revolution. Included once for each target, after fused_lanes.inl.

/// A solid of revolution, the same in all lanes.
struct RingLanes {
  FloatVec3 axis;
  FloatLanes z[2], r[2], k, square;
};
RIGOR_FLOAT_LANES FloatVec3 splat_vector(const float* p) {
  return {splat(p[0]), splat(p[1]), splat(p[2])};
}
RIGOR_FLOAT_LANES RingLanes splat_ring(const RingNumbers& ring) {
  return {splat_vector(ring.axis),
          {splat(ring.z[0]), splat(ring.z[1])},
          {splat(ring.r[0]), splat(ring.r[1])},
          splat(ring.k),
          splat(ring.square)};
}
RIGOR_FLOAT_LANES FloatVec3 choose(const IntLanes& mask, const FloatVec3& a, const FloatVec3& b) {
  return {mask ? a.x : b.x, mask ? a.y : b.y, mask ? a.z : b.z};
}
/// The unit vector along a; `other` where a is 0.
RIGOR_FLOAT_LANES FloatVec3 unit(const FloatVec3& a, const FloatVec3& other) {
  const FloatLanes square = fused_dot(a, a);
  const IntLanes has_length = square > splat(1e-24F);
  return choose(has_length, (splat(1) / root(has_length ? square : splat(1))) * a, other);
}
/// How far the solid reaches along n.
RIGOR_FLOAT_LANES FloatLanes reach(const RingLanes& ring, const FloatVec3& n) {
  const FloatLanes along = fused_dot(n, ring.axis);
  const FloatVec3 beside = fused_cross(n, ring.axis);
  const FloatLanes across = root(fused_dot(beside, beside));
  return larger(fused(ring.r[0], across, ring.z[0] * along), fused(ring.r[1], across, ring.z[1] * along));
}
RIGOR_FLOAT_LANES FloatVec3 negated(const FloatVec3& a) {
  return {-a.x, -a.y, -a.z};
}
RIGOR_FLOAT_LANES void store_axes(const RingLanes& a, const RingLanes& b, const FloatVec3& d,
                                  const FloatVec3& n, RingAxes::Group group, RingAxes& axes) {
  store_floats(n.x, axes.n[group][0]);
  store_floats(n.y, axes.n[group][1]);
  store_floats(n.z, axes.n[group][2]);
  store_floats(fused_dot(n, d) - reach(a, n) - reach(b, negated(n)), axes.separation[group]);
}

/// Up and down both axes, the two normals that both sides have in common, and the normal of each side that
/// points at the middle of the other solid.
RIGOR_FLOAT_LANES FloatVec3 flat_directions(const RingLanes& a, const RingLanes& b, const FloatVec3& d) {
  // n = x a + y b + w a × b has n · a = k_A and n · b = -k_B.
  constexpr float least = 1e-12F;
  const FloatLanes zero = splat(0), cosine = fused_dot(a.axis, b.axis);
  const FloatVec3 cross = fused_cross(a.axis, b.axis);
  const FloatLanes determinant = larger(fused_dot(cross, cross), splat(least));
  const FloatLanes x = (a.k + cosine * b.k) / determinant, y = -(b.k + cosine * a.k) / determinant;
  const FloatLanes square = splat(1) - (x * x + y * y + splat(2) * cosine * x * y);
  const FloatLanes w = root(larger(square, zero) / determinant);
  // Parts of d across the axes.
  const FloatVec3 to_A = d - fused_dot(d, a.axis) * a.axis, to_B = d - fused_dot(d, b.axis) * b.axis;
  const FloatVec3 across_A = unit(to_A, d), across_B = unit(to_B, d);
  const FloatLanes of_a = {1, -1, 0, 0, x[0], x[0], a.k[0], 0}, of_b = {0, 0, 1, -1, y[0], y[0], 0, -b.k[0]};
  const FloatLanes of_cross = {0, 0, 0, 0, w[0], -w[0], 0, 0};
  const FloatLanes of_A = {0, 0, 0, 0, 0, 0, a.square[0], 0}, of_B = {0, 0, 0, 0, 0, 0, 0, b.square[0]};
  const FloatVec3 n = of_a * a.axis + of_b * b.axis + of_cross * cross + of_A * across_A + of_B * across_B;
  return unit(n, a.axis);
}

/// The normals n(θ) = k o + m (x cos θ + y sin θ) of the side of one solid, about its axis o, for which a
/// circle of the other parts best: the largest G(θ) = P cos θ + Q sin θ - r |n × p|. Newton's method in a
/// quarter of the circle, with bisection where it leaves the part in which the largest one is.
RIGOR_FLOAT_LANES FloatVec3 side_directions(const RingLanes& a, const RingLanes& b, const FloatVec3& d) {
  constexpr int steps = 8, samples = 5;
  constexpr float cosines[samples] = {1, 0.92387953F, 0.70710678F, 0.38268343F, 0};
  // Lanes 0 to 3: the side of A and the circles of B; 4 to 7 the reverse, seen from B. Each in two quarters.
  const IntLanes is_of_A = {-1, -1, -1, -1, 0, 0, 0, 0}, is_first = {-1, -1, 0, 0, -1, -1, 0, 0},
                 is_near = {-1, 0, -1, 0, -1, 0, -1, 0};
  const FloatLanes zero = splat(0), one = splat(1);
  const FloatVec3 o = choose(is_of_A, a.axis, b.axis), p = choose(is_of_A, b.axis, a.axis);
  const FloatLanes k = is_of_A ? a.k : b.k, m = is_of_A ? a.square : b.square;
  const FloatLanes z_A = is_first ? a.z[0] : a.z[1], z_B = is_first ? b.z[0] : b.z[1];
  const FloatLanes r_A = is_first ? a.r[0] : a.r[1], r_B = is_first ? b.r[0] : b.r[1];
  const FloatLanes r = is_of_A ? r_B : r_A;
  const FloatVec3 c = choose(is_of_A, d, negated(d)) + (is_of_A ? z_B : z_A) * p;
  // Axes across o, x towards p; made square twice, since p may be nearly parallel to o.
  const FloatVec3 slanted = p - fused_dot(p, o) * o, to_c = c - fused_dot(c, o) * o;
  const FloatVec3 third = {o.y, o.z, -o.x};
  const FloatVec3 start = choose(fused_dot(slanted, slanted) > splat(1e-8F), slanted, to_c);
  const FloatVec3 rough = unit(start, fused_cross(o, third));
  const FloatVec3 x = unit(rough - fused_dot(rough, o) * o, rough);
  const FloatVec3 turned = fused_cross(o, x);
  // The largest one is where y has the sign of Q.
  const FloatLanes P = m * fused_dot(x, c), signed_Q = m * fused_dot(turned, c);
  const FloatVec3 y = choose(signed_Q < zero, negated(turned), turned);
  const FloatLanes Q = signed_Q < zero ? -signed_Q : signed_Q;
  const FloatLanes alpha = k * fused_dot(p, o), beta = m * fused_dot(p, x);

  // The largest one of a few angles in the quarter, and the part of it around that.
  const FloatLanes sign = is_near ? one : -one;
  const auto at_x = [&](int i) { return sign * splat(cosines[i]); };
  const auto at_y = [&](int i) { return splat(cosines[samples - 1 - i]); };
  FloatLanes most = splat(-1e30F), cosine = zero, sine = zero, low_x = zero, low_y = zero, high_x = zero,
             high_y = zero;
  for (int i = 0; i < samples; ++i) {
    const FloatLanes u = fused(beta, at_x(i), alpha), S = root(larger(one - u * u, zero));
    const FloatLanes G = P * at_x(i) + Q * at_y(i) - r * S;
    const IntLanes is_more = G > most;
    const int before = i == 0 ? 0 : i - 1, after = i + 1 == samples ? i : i + 1;
    most = is_more ? G : most;
    cosine = is_more ? at_x(i) : cosine;
    sine = is_more ? at_y(i) : sine;
    // (The second quarter runs backwards.)
    low_x = is_more ? (is_near ? at_x(before) : at_x(after)) : low_x;
    low_y = is_more ? (is_near ? at_y(before) : at_y(after)) : low_y;
    high_x = is_more ? (is_near ? at_x(after) : at_x(before)) : high_x;
    high_y = is_more ? (is_near ? at_y(after) : at_y(before)) : high_y;
  }
  for (int step = 0; step < steps; ++step) {
    const FloatLanes u = fused(beta, cosine, alpha);
    const FloatLanes S = root(larger(one - u * u, splat(1e-12F))), inverse_S = one / S;
    const FloatLanes first = Q * cosine - sine * fused(r * beta * u, inverse_S, P);
    const FloatLanes second =
        r * beta * (beta * sine * sine * inverse_S * inverse_S - u * cosine) * inverse_S - P * cosine -
        Q * sine;
    // What is beyond is left out.
    const IntLanes is_before = first > zero;
    low_x = is_before ? cosine : low_x;
    low_y = is_before ? sine : low_y;
    high_x = is_before ? high_x : cosine;
    high_y = is_before ? high_y : sine;
    const FloatLanes turn = -first / (second < zero ? second : -one);
    const FloatLanes next_x = cosine - turn * sine, next_y = sine + turn * cosine;
    const IntLanes is_good = (second < zero) & (low_x * next_y - low_y * next_x >= zero) &
                             (next_x * high_y - next_y * high_x >= zero);
    const FloatLanes to_x = is_good ? next_x : low_x + high_x, to_y = is_good ? next_y : low_y + high_y;
    const FloatLanes scale = one / root(larger(to_x * to_x + to_y * to_y, splat(1e-20F)));
    cosine = scale * to_x;
    sine = scale * to_y;
  }
  const FloatVec3 n = unit(k * o + (m * cosine) * x + (m * sine) * y, o);
  return choose(is_of_A, n, negated(n));
}

/// Two circles in each lane.
struct RingChoice {
  IntLanes is_low_A, is_low_B;
};
struct TwoRings {
  FloatLanes r_A, r_B;
  FloatVec3 c;  ///< From the centre of the one of A to that of the one of B.
};
RIGOR_FLOAT_LANES TwoRings rings_of(const RingLanes& a, const RingLanes& b, const FloatVec3& d,
                                    const RingChoice& choice) {
  return {choice.is_low_A ? a.r[0] : a.r[1], choice.is_low_B ? b.r[0] : b.r[1],
          d + (choice.is_low_B ? b.z[0] : b.z[1]) * b.axis - (choice.is_low_A ? a.z[0] : a.z[1]) * a.axis};
}

/// Where two discs cross: the planes of both cross along a line, on which each disc has a stretch. The
/// direction across both circles at the ends that face each other, or at the two others.
RIGOR_FLOAT_LANES FloatVec3 crossing_directions(const RingLanes& a, const RingLanes& b, const TwoRings& rings,
                                                const IntLanes& is_facing, const FloatVec3& guess) {
  const FloatLanes zero = splat(0), one = splat(1);
  const FloatVec3 line = unit(fused_cross(a.axis, b.axis), fused_cross(a.axis, guess));
  const FloatVec3 v_A = fused_cross(a.axis, line), v_B = fused_cross(b.axis, line);
  // How far the line is from the centres, along v_A and v_B.
  const auto divide = [&](const FloatLanes& x, const FloatLanes& slope) {
    const IntLanes is_steep = slope * slope > splat(1e-12F);
    return is_steep ? x / (is_steep ? slope : one) : zero;
  };
  const FloatLanes mu = divide(fused_dot(rings.c, b.axis), fused_dot(v_A, b.axis)),
                   nu = -divide(fused_dot(rings.c, a.axis), fused_dot(v_B, a.axis));
  const FloatLanes half_A = root(larger(rings.r_A * rings.r_A - mu * mu, zero)),
                   half_B = root(larger(rings.r_B * rings.r_B - nu * nu, zero));
  const FloatLanes side = (fused_dot(rings.c, line) < zero) == is_facing ? -one : one;
  // Radii of the two circles there, their tangents, and the direction across both.
  const FloatVec3 to_A = mu * v_A + (side * half_A) * line, to_B = nu * v_B - (side * half_B) * line;
  const FloatVec3 across = fused_cross(fused_cross(a.axis, to_A), fused_cross(b.axis, to_B));
  const FloatVec3 outward = choose(fused_dot(across, to_A) < zero, negated(across), across);
  return unit((one / larger(rings.r_A * rings.r_B, splat(1e-12F))) * outward, guess);
}

/// From the four poles, towards the point of the other solid that is lowest over it; and `guess`.
RIGOR_FLOAT_LANES FloatVec3 pole_directions(const RingLanes& a, const RingLanes& b, const FloatVec3& d,
                                            const FloatVec3& guess, RingChoice& choice) {
  const IntLanes is_pole_of_A = {-1, -1, 0, 0, 0, 0, 0, 0}, is_pole_of_B = {0, 0, -1, -1, 0, 0, 0, 0},
                 is_up = {-1, 0, -1, 0, 0, 0, 0, 0}, is_pole = is_pole_of_A | is_pole_of_B;
  choice.is_low_A = IntLanes{0, -1, 0, 0, -1, 0, -1, 0};
  choice.is_low_B = IntLanes{0, 0, 0, -1, -1, -1, 0, 0};
  const FloatLanes zero = splat(0), one = splat(1), sign = is_up ? one : -one;
  const FloatVec3 o = choose(is_pole_of_B, b.axis, a.axis), p = choose(is_pole_of_B, a.axis, b.axis);
  const FloatVec3 to_other = choose(is_pole_of_B, negated(d), d), m = sign * o;
  // The circle of the other solid that is lowest over the pole, and its lowest point.
  const FloatLanes along = fused_dot(m, p);
  const FloatVec3 across = unit(along * p - m, to_other);
  const FloatLanes sine = root(larger(one - along * along, zero));
  const FloatLanes r0 = is_pole_of_B ? a.r[0] : b.r[0], r1 = is_pole_of_B ? a.r[1] : b.r[1];
  const FloatLanes z0 = is_pole_of_B ? a.z[0] : b.z[0], z1 = is_pole_of_B ? a.z[1] : b.z[1];
  const IntLanes is_low = z0 * along - r0 * sine < z1 * along - r1 * sine;
  choice.is_low_A = is_pole_of_B ? is_low : choice.is_low_A;
  choice.is_low_B = is_pole_of_A ? is_low : choice.is_low_B;
  const FloatVec3 lowest = to_other + (is_low ? z0 : z1) * p + (is_low ? r0 : r1) * across;
  const FloatVec3 beside = unit(lowest - fused_dot(lowest, o) * o, across);
  const FloatVec3 n = unit(m + splat(0.2F) * beside, m);
  return choose(is_pole, choose(is_pole_of_B, negated(n), n), guess);
}

/// A step of Newton's method on the sphere, from the directions n, towards the largest n · c - r_A |n × a| -
/// r_B |n × b|.
RIGOR_FLOAT_LANES FloatVec3 ring_step(const RingLanes& a, const RingLanes& b, const TwoRings& rings,
                                      const FloatVec3& n) {
  const FloatLanes zero = splat(0), one = splat(1), most = splat(0.5F);
  const auto& [r_A, r_B, c] = rings;
  const FloatLanes size = root(fused_dot(c, c)) + r_A + r_B;
  // Polar coordinates about the axis o that is nearer: of it n is at the angle ψ, in the half plane of u.
  const FloatVec3 beside_A = fused_cross(n, a.axis), beside_B = fused_cross(n, b.axis);
  const FloatLanes square_A = fused_dot(beside_A, beside_A), square_B = fused_dot(beside_B, beside_B);
  const IntLanes is_A = square_A * (r_B * r_B) <= square_B * (r_A * r_A);
  const FloatVec3 o = choose(is_A, a.axis, b.axis), p = choose(is_A, b.axis, a.axis);
  const FloatLanes r_o = is_A ? r_A : r_B, r_p = is_A ? r_B : r_A;
  const FloatLanes rho = root(larger(is_A ? square_A : square_B, splat(1e-10F))),
                   inverse_p = one / root(larger(is_A ? square_B : square_A, splat(1e-10F)));
  const FloatLanes cosine = fused_dot(n, o);
  const FloatVec3 u = (one / rho) * (n - cosine * o), u_p = inverse_p * (n - fused_dot(n, p) * p);
  // The vector between the points of the circles along n is the gradient; the circle about p bends it.
  const FloatVec3 t = fused_cross(o, u), t_p = fused_cross(p, u_p), e = rho * o - cosine * u;
  const FloatVec3 to_p = c - r_p * u_p, w = to_p - r_o * u;
  const FloatLanes s = fused_dot(n, w), bend = r_p * inverse_p;
  const FloatLanes c1 = fused_dot(t_p, t), c2 = fused_dot(t_p, e);
  const FloatLanes g1 = fused_dot(w, t), g2 = fused_dot(w, e);
  // Second derivatives by the azimuth (divided by rho) and by ψ; steps uphill where they show no maximum.
  const FloatLanes m11 = fused_dot(to_p, u) + rho * bend * c1 * c1,
                   m12 = -(cosine * g1 + rho * bend * c1 * c2), m22 = s + bend * c2 * c2;
  const FloatLanes exact = rho * m11 * m22 - m12 * m12;
  const IntLanes is_convex = (m22 > zero) & (exact > splat(1e-6F) * rho * size * size);
  const FloatLanes h11 = rho * (is_convex ? m11 : size), h12 = is_convex ? m12 : zero,
                   h22 = is_convex ? m22 : splat(0.2F) * size;
  const FloatLanes inverse = one / (h11 * h22 - h12 * h12);
  const FloatLanes x = inverse * (h22 * rho * g1 + h12 * g2), y = -inverse * (h11 * g2 + h12 * rho * g1);
  const FloatLanes turn = smaller(larger(x, -most), most), lean = smaller(larger(y, -most), most);
  const FloatVec3 to_u = unit(u + turn * t, u);
  const FloatLanes to_rho = larger(fused(lean, cosine, rho), splat(1e-5F));
  return unit(fused(-lean, rho, cosine) * o + to_rho * to_u, n);
}

void find_flat_ring_axes(const RingPairNumbers& pair, RingAxes& axes) {
  const RingLanes a = splat_ring(pair.a), b = splat_ring(pair.b);
  const FloatVec3 d = splat_vector(pair.d);
  store_axes(a, b, d, flat_directions(a, b, d), RingAxes::flat, axes);
}

void find_side_ring_axes(const RingPairNumbers& pair, RingAxes& axes) {
  const RingLanes a = splat_ring(pair.a), b = splat_ring(pair.b);
  const FloatVec3 d = splat_vector(pair.d);
  store_axes(a, b, d, side_directions(a, b, d), RingAxes::side_and_ring, axes);
}

void find_two_ring_axes(const RingPairNumbers& pair, RingAxes& axes) {
  constexpr int steps = 8;
  const RingLanes a = splat_ring(pair.a), b = splat_ring(pair.b);
  const FloatVec3 d = splat_vector(pair.d);
  // The best so far, a little towards the other solid, is where the search for circles begins.
  int group = 0, lane = 0;
  for (int g = 0; g < 2; ++g)
    for (int k = 0; k < kLaneCount; ++k)
      if (axes.separation[g][k] > axes.separation[group][lane]) group = g, lane = k;
  const FloatVec3 best = {splat(axes.n[group][0][lane]), splat(axes.n[group][1][lane]),
                          splat(axes.n[group][2][lane])};
  const FloatVec3 guess = unit(best + splat(0.25F) * unit(d, best), best);
  // Both crossings of each two circles; then from the poles, and each two circles from the guess.
  const IntLanes is_facing = {-1, -1, -1, -1, 0, 0, 0, 0};
  RingChoice choice = {{-1, 0, -1, 0, -1, 0, -1, 0}, {-1, -1, 0, 0, -1, -1, 0, 0}};
  const TwoRings crossing = rings_of(a, b, d, choice);
  FloatVec3 n = crossing_directions(a, b, crossing, is_facing, guess);
  FloatVec3 m = pole_directions(a, b, d, guess, choice);
  const TwoRings chosen = rings_of(a, b, d, choice);
  // (Two searches at once: each waits for its own square roots.)
  for (int step = 0; step < steps; ++step) {
    n = ring_step(a, b, crossing, n);
    m = ring_step(a, b, chosen, m);
  }
  store_axes(a, b, d, n, RingAxes::crossing_rings, axes);
  store_axes(a, b, d, m, RingAxes::two_rings, axes);
}
