#include "rigor/geometry/convex/expanding_polytope.hpp"

#include "rigor/core/index.hpp"
#include "rigor/math/rotation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigor {
namespace {

/// The simplex of the search is used as the start if its volume is at least this part of the cube of its
/// longest edge: flat simplices make poor polytopes.
constexpr double kLeastVolume = 1e-3;

/// Six times the signed volume of the tetrahedron.
double volume_of(const std::array<DifferencePoint, 4>& p) {
  return (p[1].w - p[0].w).cross(p[2].w - p[0].w).dot(p[3].w - p[0].w);
}

/// Whether the simplex is large and thick enough that its facet normals are not rounding.
bool has_volume(const std::array<DifferencePoint, 4>& p, double rounding) {
  double longest = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < i; ++j) longest = std::max(longest, (p[i].w - p[j].w).squaredNorm());
  }
  return longest > rounding && std::abs(volume_of(p)) > kLeastVolume * longest * std::sqrt(longest);
}

}  // namespace

ExpandingPolytope::ExpandingPolytope(const CorePair& pair, const Vec3& n,
                                     std::span<const DifferencePoint> simplex)
    : pair_(pair) {
  // Start with the simplex of GJK, or else with four points far from each other. Fewer mean that the
  // difference is flat, and then the polytope stays without facets.
  std::array<DifferencePoint, 4> corners;
  if (simplex.size() == 4) std::copy(simplex.begin(), simplex.end(), corners.begin());
  const bool is_good = simplex.size() == 4 && has_volume(corners, 1e6 * pair.rounding);
  if (!is_good && find_tetrahedron(n, corners) < 4) return;
  points_.reserve(64);
  facets_.reserve(128);
  open_heights_.reserve(128);
  points_.assign(corners.begin(), corners.end());
  // Orient the tetrahedron so that all four facets are counter-clockwise seen from outside, and link each
  // facet to its neighbours across its sides.
  if (volume_of(corners) > 0) std::swap(points_[1], points_[2]);
  add_facet(0, 1, 2);
  add_facet(0, 3, 1);
  add_facet(1, 3, 2);
  add_facet(2, 3, 0);
  facets_[0].across = {1, 2, 3};
  facets_[1].across = {3, 2, 0};
  facets_[2].across = {1, 3, 0};
  facets_[3].across = {2, 1, 0};
  facet_from_.assign(points_.size(), -1);
}

/// Finds four corners of a tetrahedron. Each new corner is, among a few support points, the one farthest from
/// the point, line or plane through the corners before it. Returns how many corners were found.
int ExpandingPolytope::find_tetrahedron(const Vec3& n, std::array<DifferencePoint, 4>& corners) {
  // First the support point along n, and the one farthest from it: without a second one the difference is a
  // point.
  Mat3 frame = frame_with_z(n);
  corners[0] = pair_.lowest(n);
  flat_normal_ = n;
  const std::array<Vec3, 5> around{-n, frame.col(0), frame.col(1), -frame.col(0), -frame.col(1)};
  const auto from_point = [](const Vec3& e) { return e.norm(); };
  if (!find_corner(around, from_point, corners[0], corners[1])) return 1;

  // The point farthest from the line through both: without one the difference is a segment.
  const Vec3 axis = (corners[1].w - corners[0].w).normalized();
  frame = frame_with_z(axis);
  flat_normal_ = frame.col(0);
  const std::array<Vec3, 4> across{frame.col(0), -frame.col(0), frame.col(1), -frame.col(1)};
  const auto from_line = [&](const Vec3& e) { return axis.cross(e).norm(); };
  if (!find_corner(across, from_line, corners[0], corners[2])) return 2;

  // The point farthest from the plane of the three, on either side: without one the difference is flat.
  flat_normal_ = axis.cross(corners[2].w - corners[0].w).normalized();
  const std::array<Vec3, 2> off_plane{flat_normal_, -flat_normal_};
  const auto from_plane = [&](const Vec3& e) { return std::abs(flat_normal_.dot(e)); };
  return find_corner(off_plane, from_plane, corners[0], corners[3]) ? 4 : 3;
}

/// Among the support points along the directions, the one with the largest distance(w - w_0); false if that
/// distance is rounding.
template <class Directions, class Distance>
bool ExpandingPolytope::find_corner(const Directions& directions, const Distance& distance,
                                    const DifferencePoint& first, DifferencePoint& corner) const {
  double farthest = 4 * pair_.rounding;
  bool is_found = false;
  for (const Vec3& direction : directions) {
    const DifferencePoint p = pair_.lowest(direction, &first);
    const double d = distance(Vec3(p.w - first.w));
    if (d <= farthest) continue;
    farthest = d;
    corner = p;
    is_found = true;
  }
  return is_found;
}

/// Adds a facet in a free place, if there is one, and returns its index.
int ExpandingPolytope::add_facet(int i, int j, int k) {
  const Vec3& p = point(i).w;
  const Vec3& q = point(j).w;
  const Vec3& r = point(k).w;
  // The height is that of the lowest corner: a lower bound of all three, whatever the rounding of m. A facet
  // without area keeps an infinite height, so that it is never expanded.
  const Vec3 area = (q - p).cross(r - p);
  const double length = area.norm();
  Facet facet{{i, j, k}, {-1, -1, -1}, Vec3::Zero(), std::numeric_limits<double>::infinity()};
  if (length > 0) {
    facet.m = 1 / length * area;
    facet.height = std::min({facet.m.dot(p), facet.m.dot(q), facet.m.dot(r)});
  }
  if (free_.empty()) {
    facets_.push_back(facet);
    open_heights_.push_back(facet.height);
    return static_cast<int>(facets_.size()) - 1;
  }
  const int index = free_.back();
  free_.pop_back();
  facets_[at(index)] = facet;
  open_heights_[at(index)] = facet.height;
  return index;
}

std::optional<int> ExpandingPolytope::lowest_facet(double limit) const {
  int lowest = -1;
  for (std::size_t i = 0; i < open_heights_.size(); ++i) {
    if (!(open_heights_[i] < limit)) continue;
    limit = open_heights_[i];
    lowest = static_cast<int>(i);
  }
  if (lowest < 0) return std::nullopt;
  return lowest;
}

std::array<DifferencePoint, 3> ExpandingPolytope::corners(int i) const {
  const Facet& f = facet(i);
  return {point(f.v[0]), point(f.v[1]), point(f.v[2])};
}

/// Its place is taken again by a new facet, so that memory does not grow with the number of expansions.
void ExpandingPolytope::remove(int facet) {
  facets_[at(facet)].is_removed = true;
  open_heights_[at(facet)] = kClosed;
  free_.push_back(facet);
}

/// Removes the facets that w sees, spreading from the given one across their sides, and collects the horizon
/// around them. A facet in whose plane w lies counts as seen, so that no facet without area arises along its
/// side.
void ExpandingPolytope::remove_seen_facets(int first, const Vec3& w) {
  const double tolerance = 0.5 * pair_.rounding;
  horizon_.clear();
  stack_.assign(1, first);
  remove(first);
  while (!stack_.empty()) {
    const Facet seen = facet(stack_.back());
    stack_.pop_back();
    for (std::size_t k = 0; k < 3; ++k) {
      Facet& next = facets_[at(seen.across[k])];
      if (next.is_removed) continue;
      if (next.m.dot(w) - next.height >= -tolerance) {
        remove(seen.across[k]);
        stack_.push_back(seen.across[k]);
      } else {
        horizon_.push_back({seen.v[k], seen.v[(k + 1) % 3], seen.across[k]});
      }
    }
  }
}

/// Closes the surface with a fan of facets from the horizon to the apex; false if the horizon is not one
/// simple loop, because rounding made the seen facets inconsistent.
bool ExpandingPolytope::close(int apex) {
  // One facet for each side of the horizon. Two sides that begin at the same point are no simple loop.
  for (const Side& side : horizon_) {
    if (facet_from_[at(side.from)] >= 0) return false;
    facet_from_[at(side.from)] = add_facet(side.from, side.to, apex);
  }
  // Link each new facet with the facet that stays beyond the horizon and with the next one of the fan.
  for (const Side& side : horizon_) {
    const int inner = facet_from_[at(side.from)];
    const int next = facet_from_[at(side.to)];
    if (next < 0) return false;
    facets_[at(inner)].across[0] = side.facet;
    facets_[at(inner)].across[1] = next;
    facets_[at(next)].across[2] = inner;
    Facet& outer = facets_[at(side.facet)];
    for (std::size_t k = 0; k < 3; ++k) {
      if (outer.v[k] == side.to && outer.v[(k + 1) % 3] == side.from) outer.across[k] = inner;
    }
  }
  for (const Side& side : horizon_) facet_from_[at(side.from)] = -1;
  return horizon_.size() >= 3;
}

bool ExpandingPolytope::expand(int i, const DifferencePoint& p) {
  // A support point that is already a corner of the facet cannot raise it.
  for (const int v : facet(i).v) {
    if (point(v).w == p.w) return false;
  }
  remove_seen_facets(i, p.w);
  const int apex = static_cast<int>(points_.size());
  points_.push_back(p);
  facet_from_.push_back(-1);
  return close(apex);
}

}  // namespace rigor
