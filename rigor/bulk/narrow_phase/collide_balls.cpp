#include "rigor/bulk/narrow_phase/collide_balls.hpp"

namespace rigor {

namespace {

RIGOR_FLOAT_LANES FloatVec3 load_vectors(const float (*p)[kLaneCount]) {
  return {load_floats(p[0]), load_floats(p[1]), load_floats(p[2])};
}
RIGOR_FLOAT_LANES void store_vectors(const FloatVec3& a, float (*p)[kLaneCount]) {
  store_floats(a.x, p[0]);
  store_floats(a.y, p[1]);
  store_floats(a.z, p[2]);
}

RIGOR_FLOAT_LANES void balls_kernel(const BallPairs& pairs, BallContacts& contacts) {
  constexpr float rounding = 1e-6f;  // The direction between centres nearer than this is lost.
  // The normal is along the centres, and z where these coincide to rounding.
  const FloatVec3 d = load_vectors(pairs.d);
  const FloatLanes radius_A = load_floats(pairs.radius_A), radius_B = load_floats(pairs.radius_B);
  const FloatLanes distance = float_sqrt(dot(d, d));
  const IntLanes has_direction = distance > float_lanes(rounding) * (radius_A + radius_B);
  const FloatLanes zero = float_lanes(0), one = float_lanes(1);
  const FloatLanes scale = one / (has_direction ? distance : one);
  const FloatVec3 n{has_direction ? scale * d.x : zero, has_direction ? scale * d.y : zero,
                    has_direction ? scale * d.z : one};
  // The point is midway between the two surfaces.
  const FloatLanes half = float_lanes(0.5f);
  store_vectors(n, contacts.normal);
  store_vectors(load_vectors(pairs.p) + half * d + (half * (radius_A - radius_B)) * n, contacts.p);
  store_floats(dot(n, d) - radius_A - radius_B, contacts.gap);
}

#if defined(__x86_64__)
[[gnu::target("avx2")]] void balls_avx2(const BallPairs& pairs, BallContacts& contacts) {
  balls_kernel(pairs, contacts);
}
#endif

}  // namespace

void collide_balls(const BallPairs& pairs, [[maybe_unused]] LaneTarget target, BallContacts& contacts) {
#if defined(__x86_64__)
  if (target == LaneTarget::avx2) return balls_avx2(pairs, contacts);
#endif
  balls_kernel(pairs, contacts);
}

Manifold ball_manifold(const BallContacts& contacts, int lane) {
  Manifold manifold{};
  manifold.point_count = 1;
  ManifoldPoint& point = manifold.points[0];
  for (int k = 0; k < 3; ++k) {
    manifold.normal[k] = contacts.normal[k][lane];
    point.p[k] = contacts.p[k][lane];
  }
  point.gap = contacts.gap[lane];
  point.feature = 0;
  return manifold;
}

}  // namespace rigor
