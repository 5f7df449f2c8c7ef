#include "rigor/bulk/narrow_phase/ellipsoid_pairs.hpp"

namespace rigor {

bool EllipsoidMeeting::find(const RingPair& pair, int number, PairHint& hint, ManifoldList& manifolds) {
  if (part_by_centres(pair, hint)) return true;
  hint = {};
  const bool own_is_A = pair.a.kind == BulkShape::Kind::ellipsoid;
  const BulkShape &own = own_is_A ? pair.a : pair.b, &other = own_is_A ? pair.b : pair.a;
  if (other.kind == BulkShape::Kind::rings) return false;
  // The ellipsoid first, B where both are.
  const Vec3f zero = Vec3f::Zero();
  const EllipsoidCore core =
      place_ellipsoid(own, own_is_A ? pair.placed_A : pair.placed_B, own_is_A ? zero : pair.d);
  const PlacedShape& placed = own_is_A ? pair.placed_B : pair.placed_A;
  const Vec3f p_other = own_is_A ? pair.d : zero;
  const float limit = pair.margin + other.radius;
  std::optional<SmoothTouch> touch;
  if (other.kind == BulkShape::Kind::ellipsoid) {
    touch = touch_ellipsoids(core, place_ellipsoid(other, placed, p_other), limit);
  } else {
    place_polytope(other, place_of(other, placed, p_other), polytope_);
    touch = touch_polytope(core, polytope_, limit);
  }
  if (!touch) return false;
  const Vec3f n = own_is_A ? touch->n : Vec3f(-touch->n);
  hint = {n, touch->separation > limit ? 0u : 1u};
  if (touch->separation > limit) return true;
  // Midway between the ellipsoid's point and that of the other shape, which is grown by its radius.
  const float gap = touch->separation - other.radius;
  candidates_.clear();
  candidates_.push_back({touch->p + 0.5f * gap * touch->n, gap, 0});
  manifolds.push_back({number, 0, make_manifold(n, 0, candidates_)});
  return true;
}

}  // namespace rigor
