#include "rigor/bulk/narrow_phase/ring_pairs.hpp"

#include "rigor/bulk/narrow_phase/collide_ellipsoids.hpp"

#include <algorithm>
#include <limits>
#include <vector>

namespace rigor {

namespace {

using Outcome = RingContacts::Outcome;
using ShapeKind = BulkShape::Kind;

bool has_faces(const BulkShape& shape) {
  return shape.kind == ShapeKind::box || shape.kind == ShapeKind::hull;
}

/// How far a shape reaches along n, from the centre of its body.
float reach_of(const BulkShape& shape, const PlacedShape& placed, const Vec3f& n) {
  if (shape.kind == ShapeKind::ellipsoid) return place_ellipsoid(shape, placed, Vec3f::Zero()).reach(n);
  if (!has_faces(shape)) return place_ring(shape, placed, Vec3f::Zero()).reach(n) + shape.radius;
  const Vec3f along = shape.scale.cwiseProduct(Vec3f(placed.rotation().transpose() * n));
  return n.dot(placed.position()) + find_support(shape.hull->vertices(), along, best_lane_target()).height;
}

/// No candidate of the second manifold is deeper than the pair is: what its normal finds deeper, by as much
/// as the margin of fast bodies, is put back along the first one.
void raise_to_least(const std::vector<ManifoldCandidate>& first, std::vector<ManifoldCandidate>& second) {
  float least = std::numeric_limits<float>::infinity();
  for (const ManifoldCandidate& candidate : first) least = std::min(least, candidate.gap);
  for (ManifoldCandidate& candidate : second) candidate.gap = std::max(candidate.gap, least);
}

}  // namespace

float separation_of(const RingPair& pair, const Vec3f& n) {
  return n.dot(pair.d) - reach_of(pair.a, pair.placed_A, n) - reach_of(pair.b, pair.placed_B, -n);
}

Outcome RingMeeting::collide(const RingPair& pair) {
  const bool polytope_is_A = has_faces(pair.a), polytope_is_B = has_faces(pair.b);
  if (!polytope_is_A && !polytope_is_B)
    return collide_rings(place_ring(pair.a, pair.placed_A, Vec3f::Zero()),
                         place_ring(pair.b, pair.placed_B, pair.d), pair.margin, contacts_);
  // The ball inside the polytope is as near to the other shape as it can be.
  const BulkShape& shape = polytope_is_A ? pair.a : pair.b;
  const PlacedShape& placed = polytope_is_A ? pair.placed_A : pair.placed_B;
  const RingCore ring = polytope_is_A ? place_ring(pair.b, pair.placed_B, pair.d)
                                      : place_ring(pair.a, pair.placed_A, Vec3f::Zero());
  place_polytope(shape, place_of(shape, placed, polytope_is_A ? Vec3f(Vec3f::Zero()) : pair.d), polytope_);
  polytope_.center = middle_of(polytope_);
  move_ball(shape, ring.center, polytope_);
  return collide_ring_with_polytope(ring, polytope_, polytope_is_B, pair.margin, contacts_);
}

bool part_by_centres(const RingPair& pair, PairHint& hint) {
  const Vec3f between = pair.d + pair.placed_B.position() - pair.placed_A.position();
  const float distance = between.norm();
  const float rounding = kCollisionRounding * (pair.a.extent + pair.b.extent + distance);
  if (distance > 0 && separation_of(pair, between / distance) > pair.margin + parting_slack(rounding)) {
    hint = {between / distance, 0};
    return true;
  }
  return false;
}

bool RingMeeting::find(const RingPair& pair, int number, PairHint& hint, ManifoldList& manifolds) {
  if (part_by_centres(pair, hint)) return true;
  const Outcome outcome = collide(pair);
  hint = {contacts_.n, outcome == Outcome::apart ? 0u : 1u};
  if (outcome != Outcome::touching) return outcome == Outcome::apart;
  int part = 0;
  raise_to_least(contacts_.candidates, contacts_.beside);
  if (!contacts_.candidates.empty())
    manifolds.push_back(
        {number, part++, make_manifold(contacts_.n, contacts_.equal_depth, contacts_.candidates)});
  if (part > 0 && !contacts_.beside.empty())
    manifolds.push_back(
        {number, part, make_manifold(contacts_.beside_n, contacts_.equal_depth, contacts_.beside)});
  return true;
}

}  // namespace rigor
