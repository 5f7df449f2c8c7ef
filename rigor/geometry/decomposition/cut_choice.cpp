#include "rigor/geometry/decomposition/cut_choice.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"
#include "rigor/core/interrupt.hpp"
#include "rigor/geometry/decomposition/hull_excess.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>

namespace rigor {
namespace {

/// Number of notches and faces from which planes are made; of more than that, evenly spaced ones are taken.
constexpr std::size_t kMostSampled = 64;
/// Number of planes that are compared by the fragments they cut.
constexpr std::size_t kMostCompared = 24;
/// Number of planes through the line out of a pocket, at even angles.
constexpr int kTurns = 6;

/// At most `count` entries, evenly spaced.
template <typename T>
std::vector<T> sampled(const std::vector<T>& all, std::size_t count) {
  if (all.size() <= count) return all;
  std::vector<T> result;
  for (std::size_t i = 0; i < count; ++i) result.push_back(all[i * all.size() / count]);
  return result;
}

bool is_in_plane(const Notch& notch, const CutPlane& plane, double tolerance) {
  return std::abs(plane.height(notch.p)) <= tolerance && std::abs(plane.height(notch.q)) <= tolerance;
}

/// Number of notches of both cells after the cut: a notch that is crossed counts twice, one that is resolved
/// not at all.
std::size_t notches_left(const SolidCell& cell, const CutPlane& plane, double tolerance) {
  std::size_t count = 0;
  for (const Notch& notch : cell.notches) {
    const double hp = plane.height(notch.p), hq = plane.height(notch.q);
    const bool is_crossed = std::min(hp, hq) < -tolerance && std::max(hp, hq) > tolerance;
    const bool is_resolved = is_in_plane(notch, plane, tolerance) && side_of_faces(notch, plane) == 0;
    count += is_crossed ? 2 : (is_resolved ? 0 : 1);
  }
  return count;
}

/// Number of fragments that the plane cuts in two.
std::size_t fragments_cut(const SolidCell& cell, const CutPlane& plane, double tolerance) {
  std::size_t count = 0;
  for (const SurfaceFragment& fragment : cell.fragments) {
    bool has_back = false, has_front = false;
    for (const Vec3& p : fragment.polygon) {
      has_back = has_back || plane.height(p) < -tolerance;
      has_front = has_front || plane.height(p) > tolerance;
    }
    count += has_back && has_front ? 1 : 0;
  }
  return count;
}

/// A plane that may be cut along, and its rank among equally good ones: 0, or 1 half-way between two faces.
struct Candidate {
  CutPlane plane;
  int rank;
};

void add_plane(const Vec3& normal, const Vec3& through, std::vector<CutPlane>& planes) {
  if (!(normal.norm() > 0)) return;
  const Vec3 unit = normal.normalized();
  planes.push_back({unit, unit.dot(through)});
}

/// Planes that resolve at least one notch.
std::vector<Candidate> notch_planes(const SolidCell& cell, const FacePlanes& planes) {
  std::vector<Candidate> result;
  const std::vector<Notch> notches = sampled(cell.notches, kMostSampled);
  for (std::size_t i = 0; i < notches.size(); ++i) {
    const Notch& notch = notches[i];
    const Vec3 along = notch.q - notch.p;
    // Along one of the faces of the notch.
    for (const int f : notch.face_plane) result.push_back({planes.planes[at(f)].plane, 0});
    // Half-way between the two faces.
    std::vector<CutPlane> between;
    add_plane(notch.in_face[0] - notch.in_face[1], notch.p, between);
    for (const CutPlane& plane : between) result.push_back({plane, 1});
    for (std::size_t k = i + 1; k < notches.size(); ++k) {
      const Notch& other = notches[k];
      // Through a second notch that is coplanar with the first: one cut may resolve both. The farther end of
      // the second notch determines the plane best.
      const Vec3 to_p = other.p - notch.p, to_q = other.q - notch.p;
      const bool is_p_farther = to_p.cross(along).norm() > to_q.cross(along).norm();
      std::vector<CutPlane> common;
      add_plane(along.cross(is_p_farther ? to_p : to_q), notch.p, common);
      if (common.empty() || !is_in_plane(other, common[0], 4 * planes.tolerance)) continue;
      if (side_of_faces(notch, common[0]) == 0) result.push_back({common[0], 0});
    }
  }
  return result;
}

/// Planes of faces that have some of the points in front of them.
std::vector<Candidate> planes_in_conflict(const SolidCell& cell, const std::vector<Vec3>& points,
                                          const FacePlanes& planes) {
  std::vector<Candidate> result;
  for (const int i : sampled(conflict_planes(cell, points, planes), kMostSampled)) {
    result.push_back({planes.planes[at(i)].plane, 0});
  }
  return result;
}

/// Sum of the volumes of the hulls of what lies on each side of the plane; infinite if everything lies on one
/// side.
double hull_volumes(const SolidCell& cell, const std::vector<Vec3>& points, const CutPlane& plane,
                    double tolerance) {
  // The points on each side are those of the part itself and the corners that the cut makes on the fragments.
  std::array<std::vector<Vec3>, 2> sides;
  for (const Vec3& p : points) {
    const double height = plane.height(p);
    if (height <= tolerance) sides[0].push_back(p);
    if (height >= -tolerance) sides[1].push_back(p);
  }
  for (const SurfaceFragment& fragment : cell.fragments) {
    const PolygonParts parts = cut_polygon(fragment.polygon, plane, tolerance);
    if (parts.back.empty() || parts.front.empty()) continue;
    sides[0].insert(sides[0].end(), parts.back.begin(), parts.back.end());
    sides[1].insert(sides[1].end(), parts.front.begin(), parts.front.end());
  }
  double volume = 0;
  for (const std::vector<Vec3>& side : sides) {
    const std::variant<ConvexHull, std::string> hull = make_convex_hull(side);
    if (!std::holds_alternative<ConvexHull>(hull)) return std::numeric_limits<double>::infinity();
    volume += hull_volume(std::get<ConvexHull>(hull));
  }
  return volume;
}

}  // namespace

CutPlane choose_exact_cut(const SolidCell& cell, const std::vector<Vec3>& points, const FacePlanes& planes) {
  std::vector<Candidate> candidates = notch_planes(cell, planes);
  if (candidates.empty()) candidates = planes_in_conflict(cell, points, planes);
  RIGOR_ASSERT(!candidates.empty());
  // The fewest notches left decide first, then the rank.
  std::vector<std::tuple<std::size_t, int, std::size_t>> order;  // notches left, rank, index
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const std::size_t left = notches_left(cell, candidates[i].plane, planes.tolerance);
    order.emplace_back(left, candidates[i].rank, i);
  }
  std::sort(order.begin(), order.end());

  // Among equals, the plane that cuts the fewest fragments keeps the pieces simple.
  const auto& [least_left, least_rank, first] = order[0];
  std::size_t best = first, least_cut = std::numeric_limits<std::size_t>::max();
  for (std::size_t n = 0; n < std::min(order.size(), kMostCompared); ++n) {
    poll_interrupt();
    const auto& [left, rank, i] = order[n];
    if (left != least_left || rank != least_rank) break;
    const std::size_t cut = fragments_cut(cell, candidates[i].plane, planes.tolerance);
    if (cut >= least_cut) continue;
    least_cut = cut;
    best = i;
  }
  return candidates[best].plane;
}

CutPlane choose_rough_cut(const SolidCell& cell, const std::vector<Vec3>& points, const FacePlanes& planes,
                          const Vec3& deepest, const Vec3& nearest) {
  std::vector<CutPlane> candidates;
  // Six planes contain the line out of the pocket, three are perpendicular to the axes; all pass through its
  // bottom.
  for (int axis = 0; axis < 3; ++axis) add_plane(Vec3::Unit(axis), nearest, candidates);
  const Vec3 offset = deepest - nearest;
  if (offset.norm() > planes.tolerance) {
    const Vec3 x = offset.unitOrthogonal(), y = offset.normalized().cross(x);
    for (int i = 0; i < kTurns; ++i) {
      const double angle = std::numbers::pi * i / kTurns;
      add_plane(std::cos(angle) * x + std::sin(angle) * y, nearest, candidates);
    }
  }
  // The volume of the hulls measures how much of the pockets is left.
  CutPlane best = candidates[0];
  double least = std::numeric_limits<double>::infinity();
  for (const CutPlane& plane : candidates) {
    const double volume = hull_volumes(cell, points, plane, planes.tolerance);
    if (volume >= least) continue;
    least = volume;
    best = plane;
  }
  return best;
}

}  // namespace rigor
