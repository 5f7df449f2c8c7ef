#include "rigor/geometry/convex/inner_polytope.hpp"

#include <cmath>
#include <limits>

namespace rigor {

bool InnerPolytope::begin(const std::array<Name, 3>& triangle, const Vec3& n) {
  point_count_ = 0;
  facet_count_ = 0;
  removed_count_ = 0;
  // The triangle and the support point on the other side of the origin.
  for (const Name& name : triangle) add_point(name[0], name[1]);
  add_point(pair_.side(0).farthest(-n, triangle[0][0]),
            pair_.side(1).farthest(pair_.direction_from_a(1, n), triangle[0][1]));
  const Vec3 &p = points_[0], &q = points_[1], &r = points_[2], &s = points_[3];
  const double volume = (q - p).cross(r - p).dot(s - p);
  if (volume == 0) return false;
  // Outward orientation: facet k is opposite to point k.
  if (volume > 0) {
    facets_[0] = {{1, 2, 3}, {3, 1, 2}};
    facets_[1] = {{0, 3, 2}, {2, 0, 3}};
    facets_[2] = {{0, 1, 3}, {3, 0, 1}};
    facets_[3] = {{0, 2, 1}, {1, 0, 2}};
  } else {
    facets_[0] = {{1, 3, 2}, {2, 1, 3}};
    facets_[1] = {{0, 2, 3}, {3, 0, 2}};
    facets_[2] = {{0, 3, 1}, {1, 0, 3}};
    facets_[3] = {{0, 1, 2}, {2, 0, 1}};
  }
  facet_count_ = 4;
  bool is_solid = true;
  for (int f = 0; f < 4; ++f) {
    is_removed_[at(f)] = false;
    is_solid = measure(f) && is_solid;
  }
  return is_solid;
}

bool InnerPolytope::begin(const CachedProof& proof) {
  // The points are names of vertices, so that the former surface moves with the bodies. It is still a proof
  // if all its facets face outward at the present poses; its topology, closed and oriented, is as before.
  point_count_ = 0;
  removed_count_ = 0;
  facet_count_ = proof.facet_count;
  for (int i = 0; i < proof.point_count; ++i) add_point(proof.points[at(i)][0], proof.points[at(i)][1]);
  for (int f = 0; f < facet_count_; ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      facets_[at(f)].corners[k] = proof.corners[at(f)][k];
      facets_[at(f)].across[k] = proof.across[at(f)][k];
    }
    is_removed_[at(f)] = false;
    if (!measure(f) || heights_[at(f)] <= 0) return false;
  }
  return facet_count_ > 0;
}

int InnerPolytope::lowest() const {
  int best = -1;
  double smallest = std::numeric_limits<double>::infinity();
  for (int f = 0; f < facet_count_; ++f) {
    if (is_removed_[at(f)] || !(heights_[at(f)] < smallest)) continue;
    smallest = heights_[at(f)];
    best = f;
  }
  return best;
}

int InnerPolytope::add_point(int a, int b) {
  names_[at(point_count_)] = {a, b};
  points_[at(point_count_)] = pair_.vertex(1, b) - pair_.side(0).vertex(a);
  return point_count_++;
}

/// Computes normal and height of a facet. The height is that of the lowest corner, so that it is a lower
/// bound whatever the rounding of the normal. False if the facet has no area.
bool InnerPolytope::measure(int facet) {
  const Facet& f = facets_[at(facet)];
  const Vec3 &p = points_[at(f.corners[0])], &q = points_[at(f.corners[1])], &r = points_[at(f.corners[2])];
  const Vec3 area = (q - p).cross(r - p);
  const double squared = area.squaredNorm();
  if (!(squared > 0)) return false;
  const Vec3 m = area / std::sqrt(squared);
  normals_[at(facet)] = m;
  heights_[at(facet)] = std::min({m.dot(p), m.dot(q), m.dot(r)});
  return true;
}

/// Marks as removed the facets that w is clearly above, spreading from the given one, and collects the
/// horizon around them. False if there is no room or no horizon.
bool InnerPolytope::find_visible(int facet, const Vec3& w) {
  horizon_count_ = 0;
  // Breadth first across the sides of visible facets; `removed_` is the queue, and later the list of free
  // places.
  const int first = removed_count_;
  is_removed_[at(facet)] = true;
  removed_[at(removed_count_++)] = facet;
  for (int i = first; i < removed_count_; ++i) {
    const Facet& f = facets_[at(removed_[at(i)])];
    for (std::size_t k = 0; k < 3; ++k) {
      const int other = f.across[k];
      if (is_removed_[at(other)]) continue;
      if (normals_[at(other)].dot(w) <= heights_[at(other)] + rounding_) continue;
      is_removed_[at(other)] = true;
      if (removed_count_ == kMaxFacets) return false;
      removed_[at(removed_count_++)] = other;
    }
  }
  // The horizon: sides between a removed facet and one that stays.
  for (int i = first; i < removed_count_; ++i) {
    const Facet& f = facets_[at(removed_[at(i)])];
    for (std::size_t k = 0; k < 3; ++k) {
      if (is_removed_[at(f.across[k])]) continue;
      horizon_[at(horizon_count_++)] = {f.corners[k], f.corners[(k + 1) % 3], f.across[k]};
    }
  }
  return horizon_count_ >= 3;
}

/// Closes the surface with triangles from the horizon to the apex. False if the horizon is not one loop.
bool InnerPolytope::close(int apex) {
  // Each point of the horizon must begin one side only.
  for (int i = 0; i < point_count_; ++i) side_from_[at(i)] = -1;
  for (int i = 0; i < horizon_count_; ++i) {
    int& side = side_from_[at(horizon_[at(i)].from)];
    if (side >= 0) return false;
    side = i;
  }
  // Follow the loop side by side. Each side gives one triangle, linked with the facet beyond the horizon and
  // with the triangle before it; the loop must close after the last side and not sooner.
  int before = -1, first = -1, side = 0;
  for (int i = 0; i < horizon_count_; ++i) {
    const Side& s = horizon_[at(side)];
    if (removed_count_ == 0 && facet_count_ == kMaxFacets) return false;
    const int f = removed_count_ > 0 ? removed_[at(--removed_count_)] : facet_count_++;
    facets_[at(f)] = {{s.from, s.to, apex}, {s.facet, -1, before}};
    is_removed_[at(f)] = false;
    if (!measure(f)) return false;
    Facet& neighbour = facets_[at(s.facet)];
    for (std::size_t k = 0; k < 3; ++k) {
      if (neighbour.corners[k] == s.to && neighbour.corners[(k + 1) % 3] == s.from) neighbour.across[k] = f;
    }
    if (before >= 0) facets_[at(before)].across[1] = f;
    if (first < 0) first = f;
    before = f;
    side = side_from_[at(s.to)];
    if (side < 0 || (side == 0) != (i + 1 == horizon_count_)) return false;
  }
  facets_[at(before)].across[1] = first;
  facets_[at(first)].across[2] = before;
  return true;
}

bool InnerPolytope::expand(int facet, int a, int b) {
  if (point_count_ == kMaxPoints) return false;
  const int apex = add_point(a, b);
  return find_visible(facet, points_[at(apex)]) && close(apex);
}

void InnerPolytope::store(CachedProof& proof) const {
  proof.point_count = 0;
  proof.facet_count = 0;
  if (facet_count_ - removed_count_ > CachedProof::kMaxFacets) return;
  // Only points and facets in use are stored, and are renumbered.
  std::array<int, kMaxPoints> point_number;
  point_number.fill(-1);
  std::array<std::uint8_t, kMaxFacets> facet_number;
  int facets = 0;
  for (int f = 0; f < facet_count_; ++f) {
    if (!is_removed_[at(f)]) facet_number[at(f)] = static_cast<std::uint8_t>(facets++);
  }
  int points = 0;
  for (int f = 0; f < facet_count_; ++f) {
    if (is_removed_[at(f)]) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      int& number = point_number[at(facets_[at(f)].corners[k])];
      if (number < 0) {
        if (points == CachedProof::kMaxPoints) return;
        number = points++;
        proof.points[at(number)] = names_[at(facets_[at(f)].corners[k])];
      }
      proof.corners[facet_number[at(f)]][k] = static_cast<std::uint8_t>(number);
      proof.across[facet_number[at(f)]][k] = facet_number[at(facets_[at(f)].across[k])];
    }
  }
  proof.point_count = points;
  proof.facet_count = facets;
}

}  // namespace rigor
