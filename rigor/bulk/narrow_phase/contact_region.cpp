#include "rigor/bulk/narrow_phase/contact_region.hpp"

#include "rigor/bulk/narrow_phase/collide_polytopes.hpp"
#include "rigor/core/index.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace rigor {

namespace {

using SideKind = ShownSide::Kind;

/// Sides at a smaller cosine to the direction have no heights: these are lost in rounding.
constexpr float kLeastSlope = 0.05f;
/// Borders of discs that are tilted by less than 0.045 rad are circles as seen along n, to a thousandth.
constexpr float kCircleSlope = 0.999f;

/// Two sides that meet along n.
struct SidePair {
  const ShownSide &a, &b;
  const Vec3f& n;
  const RegionScale& scale;

  Vec3f flat(const Vec3f& p) const { return p - n.dot(p) * n; }
};

bool is_flat(const ShownSide& side) {
  return side.kind == SideKind::disc || side.kind == SideKind::polygon;
}

/// How far the side is from p along n, over the place of p.
float height_over(const SidePair& pair, const ShownSide& side, const Vec3f& p) {
  const Vec3f q = side.kind == SideKind::disc ? side.center : side.corner(0);
  return side.m.dot(q - p) / side.m.dot(pair.n);
}

/// Whether a point lies over the side along n.
bool lies_over(const SidePair& pair, const ShownSide& side, const Vec3f& p) {
  if (std::abs(side.m.dot(pair.n)) < kLeastSlope) return false;
  if (side.kind == SideKind::disc)
    return (p + height_over(pair, side, p) * pair.n - side.center).norm() <= side.r + pair.scale.slack;
  // Of a polygon: inside all borders.
  const Vec3f up = side.m.dot(pair.n) > 0 ? pair.n : Vec3f(-pair.n);
  for (std::size_t k = 0; k < side.corners.size(); ++k) {
    const Vec3f q = side.corner(k), inward = up.cross(side.corner((k + 1) % side.corners.size()) - q);
    if (inward.dot(p - q) < -pair.scale.slack * inward.norm()) return false;
  }
  return true;
}

/// A point of one side, over which the other is at the height h along n.
void add_over(const SidePair& pair, bool is_of_A, const Vec3f& p, float h, std::uint32_t feature,
              std::vector<ManifoldCandidate>& candidates) {
  const Vec3f q = p + h * pair.n;
  add_between(is_of_A ? p : q, is_of_A ? q : p, pair.n, feature, pair.scale, candidates);
}

/// The corners of one side over the other.
void add_corners(const SidePair& pair, bool is_of_A, std::vector<ManifoldCandidate>& candidates) {
  const ShownSide &own = is_of_A ? pair.a : pair.b, &other = is_of_A ? pair.b : pair.a;
  for (std::size_t k = 0; k < own.corner_count(); ++k) {
    const Vec3f p = own.corner(k);
    if (!lies_over(pair, other, p)) continue;
    const int name = own.corner_name(k);
    add_over(pair, is_of_A, p, height_over(pair, other, p),
             is_of_A ? vertex_A_feature(name) : vertex_B_feature(name), candidates);
  }
}

/// A point where the borders of both sides cross, on one of them.
struct BorderCrossing {
  Vec3f p;
  int border, other_border;
};
void add_crossing(const SidePair& pair, bool is_of_A, const BorderCrossing& crossing,
                  std::vector<ManifoldCandidate>& candidates) {
  const ShownSide& other = is_of_A ? pair.b : pair.a;
  const std::uint32_t feature = is_of_A
                                    ? crossing_feature(crossing.border, crossing.other_border, kMaxHullEdges)
                                    : crossing_feature(crossing.other_border, crossing.border, kMaxHullEdges);
  add_over(pair, is_of_A, crossing.p, height_over(pair, other, crossing.p), feature, candidates);
}

/// Where a straight border of one side crosses the circle of the other.
void cross_circle(const SidePair& pair, bool line_is_of_A, const std::array<Vec3f, 2>& line, int border,
                  std::vector<ManifoldCandidate>& candidates) {
  const ShownSide& disc = line_is_of_A ? pair.b : pair.a;
  const Vec3f u = pair.flat(line[1] - line[0]), w = pair.flat(line[0] - disc.center);
  // |w + s u| = r.
  const float uu = u.squaredNorm(), uw = u.dot(w),
              square = uw * uw - uu * (w.squaredNorm() - disc.r * disc.r);
  if (!(square > 0) || !(uu > 0)) return;
  // Both crossings count unless they are at an end of the border, which is a corner already.
  const float root = std::sqrt(square), slack = pair.scale.slack / std::sqrt(uu);
  for (const int k : {0, 1}) {
    const float s = (-uw + (k == 0 ? -root : root)) / uu;
    if (s > slack && s < 1 - slack)
      add_crossing(pair, line_is_of_A, {line[0] + s * (line[1] - line[0]), border, disc.first_name + k},
                   candidates);
  }
}

/// Where two circles cross.
void cross_circles(const SidePair& pair, std::vector<ManifoldCandidate>& candidates) {
  const ShownSide &a = pair.a, &b = pair.b;
  const Vec3f d = pair.flat(b.center - a.center);
  const float distance = d.norm();
  if (!(distance > pair.scale.slack)) return;
  // The chord that both have is at the distance x from the centre of A.
  const float x = 0.5f * (distance + (a.r - b.r) * (a.r + b.r) / distance), square = a.r * a.r - x * x;
  if (!(square > 0)) return;
  const Vec3f along = d / distance, across = std::sqrt(square) * pair.n.cross(along);
  // The ends of the chord, first over the side of A and then on it.
  const float height = height_over(pair, a, a.center + x * along);
  for (const int k : {0, 1}) {
    const Vec3f over = a.center + x * along + (k == 0 ? across : Vec3f(-across)) + height * pair.n;
    const Vec3f p = over + height_over(pair, a, over) * pair.n;
    add_crossing(pair, true, {p, a.first_name + k, b.first_name}, candidates);
  }
}

/// Where a segment of one side crosses the borders of a polygon of the other.
void cross_polygon(const SidePair& pair, bool line_is_of_A, const ShownSide& segment,
                   std::vector<ManifoldCandidate>& candidates) {
  const ShownSide& polygon = line_is_of_A ? pair.b : pair.a;
  // The inner side of each border is to the left of it about `up`.
  const Vec3f up = polygon.m.dot(pair.n) > 0 ? pair.n : Vec3f(-pair.n);
  const Vec3f u = segment.ends[1] - segment.ends[0];
  for (std::size_t k = 0; k < polygon.corners.size(); ++k) {
    const Vec3f q = polygon.corner(k), side = polygon.corner((k + 1) % polygon.corners.size()) - q;
    const Vec3f inward = up.cross(side).normalized();
    const float d0 = inward.dot(segment.ends[0] - q), d1 = inward.dot(segment.ends[1] - q);
    // The segment crosses the line of the border only if its ends are on two sides of it.
    if (std::min(d0, d1) >= -pair.scale.slack || std::max(d0, d1) <= pair.scale.slack) continue;
    // It counts if it meets the border between its ends.
    const Vec3f p = segment.ends[0] + d0 / (d0 - d1) * u;
    const float along = pair.flat(side).dot(p - q), length = pair.flat(side).norm();
    if (along > pair.scale.slack * length && along < length * (length - pair.scale.slack))
      add_crossing(pair, line_is_of_A, {p, 0, polygon.edges[k]}, candidates);
  }
}

void add_crossings(const SidePair& pair, std::vector<ManifoldCandidate>& candidates) {
  const auto is_circle = [&](const ShownSide& side) {
    return side.kind == SideKind::disc && std::abs(side.m.dot(pair.n)) > kCircleSlope;
  };
  // Tilted discs are seen as ellipses, and only their corners count.
  if (is_circle(pair.a) && is_circle(pair.b)) cross_circles(pair, candidates);
  for (const bool is_of_A : {true, false}) {
    const ShownSide &own = is_of_A ? pair.a : pair.b, &other = is_of_A ? pair.b : pair.a;
    if (own.kind == SideKind::segment && other.kind == SideKind::polygon)
      cross_polygon(pair, is_of_A, own, candidates);
    if (!is_circle(other)) continue;
    if (own.kind == SideKind::segment) cross_circle(pair, is_of_A, {own.ends[0], own.ends[1]}, 0, candidates);
    if (own.kind != SideKind::polygon) continue;
    for (std::size_t k = 0; k < own.corners.size(); ++k)
      cross_circle(pair, is_of_A, {own.corner(k), own.corner((k + 1) % own.corners.size())}, own.edges[k],
                   candidates);
  }
}

/// Ends of the stretch where two segments run side by side; false if they do not.
bool add_side_by_side(const SidePair& pair, std::vector<ManifoldCandidate>& candidates) {
  constexpr float square_sine = 1e-6f;  // A milliradian.
  const ShownSide &a = pair.a, &b = pair.b;
  const Vec3f u = pair.flat(a.ends[1] - a.ends[0]), v = pair.flat(b.ends[1] - b.ends[0]);
  const float uu = u.squaredNorm(), vv = v.squaredNorm();
  if (!(uu > 0 && vv > 0) || u.cross(v).squaredNorm() > square_sine * uu * vv) return false;
  // The ends of B along A cut the stretch out of [0, 1].
  const float s0 = u.dot(b.ends[0] - a.ends[0]) / uu, s1 = u.dot(b.ends[1] - a.ends[0]) / uu;
  const float begin = std::max(0.0f, std::min(s0, s1)), end = std::min(1.0f, std::max(s0, s1));
  if (!(begin < end)) return false;
  int name = 0;
  for (const float s : {begin, end}) {
    const Vec3f p = a.ends[0] + s * (a.ends[1] - a.ends[0]);
    const float t = std::clamp((s - s0) / (s1 - s0), 0.0f, 1.0f);
    add_between(p, b.ends[0] + t * (b.ends[1] - b.ends[0]), pair.n,
                crossing_feature(name++, 0, kMaxHullEdges), pair.scale, candidates);
  }
  return true;
}

/// How far below p, along the unit vector `up`, the round side is that shows the segment, grown by `radius`
/// [m]. Nothing where it has no radius, where p is beyond its circles, or nearer to its border than half of
/// its radius, where it is steep.
std::optional<float> height_over_side(const ShownSide& side, float radius, const Vec3f& p, const Vec3f& up) {
  constexpr float least_square = 0.5f;  // Of the cosine of the slope.
  const Vec3f w = p - side.center;
  const float z = side.m.dot(w), c = side.m.dot(up), length = side.m.dot(side.ends[1] - side.ends[0]);
  const Vec3f across = w - z * side.m, n = up - c * side.m;
  // Points at the height t below p are at the distance |across - t n| from the axis, where the radius is
  // R - t c slope.
  const float r = (side.ends[0] - side.center).norm(),
              slope = ((side.ends[1] - side.center - length * side.m).norm() - r) / length,
              R = r + slope * z + radius, nn = n.squaredNorm();
  // The quadratic equation a t² - 2 b t + ... = 0 of the nearer one of the two heights.
  const float a = nn - slope * slope * c * c, b = across.dot(n) - slope * c * R,
              square = b * b - a * (across.squaredNorm() - R * R);
  if (!(R > 0) || !(a > 0) || !(square > least_square * nn * R * R)) return std::nullopt;
  // It must be on the frustum between its circles.
  const float t = (b - std::sqrt(square)) / a, below = z - t * c;
  if (!(below >= 0 && below <= length)) return std::nullopt;
  return t;
}

/// The ends of each segment over the round side of the other: solids that lie along each other touch at one
/// point, but rotate about it onto these within the step.
void add_ends(const SidePair& pair, std::vector<ManifoldCandidate>& candidates) {
  const RegionScale& scale = pair.scale;
  for (const bool is_of_A : {true, false}) {
    const ShownSide &own = is_of_A ? pair.a : pair.b, &other = is_of_A ? pair.b : pair.a;
    // Away from the other solid.
    const Vec3f up = is_of_A ? Vec3f(-pair.n) : pair.n;
    const float own_radius = is_of_A ? scale.radius_A : scale.radius_B,
                other_radius = is_of_A ? scale.radius_B : scale.radius_A;
    for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
      const int name = own.end_names[k];
      if (!own.is_straight && name == own.lowest_name) continue;  // It is the nearest point.
      const Vec3f p = own.ends[k] - own_radius * up;
      const std::optional<float> gap = height_over_side(other, other_radius, p, up);
      if (gap && *gap <= scale.margin)
        candidates.push_back(
            {p - 0.5f * *gap * up, *gap, is_of_A ? vertex_A_feature(name) : vertex_B_feature(name)});
    }
  }
}

/// One point where neither side is a disc or a polygon; returns how far its two points are beside each other.
float add_nearest(const SidePair& pair, std::vector<ManifoldCandidate>& candidates) {
  const auto begin_of = [](const ShownSide& side) { return side.is_straight ? side.ends[0] : side.lowest; };
  const auto way_of = [&](const ShownSide& side) {
    return side.is_straight ? Vec3f(side.ends[1] - side.ends[0]) : Vec3f(Vec3f::Zero());
  };
  // The nearest points of both lines as seen along n, which for points are the points themselves.
  const Vec3f p = begin_of(pair.a), q = begin_of(pair.b), u = way_of(pair.a), v = way_of(pair.b);
  const SegmentPoints nearest = nearest_on_segments(pair.flat(p), pair.flat(u), pair.flat(q), pair.flat(v));
  const Vec3f p_A = p + nearest.s * u, p_B = q + nearest.t * v;
  add_between(p_A, p_B, pair.n, vertices_feature(pair.a.lowest_name, pair.b.lowest_name, 16), pair.scale,
              candidates);
  return pair.flat(p_B - p_A).norm();
}

}  // namespace

Vec3f ShownSide::corner(std::size_t k) const {
  switch (kind) {
    case SideKind::point:
      return lowest;
    case SideKind::segment:
      return ends[k];
    case SideKind::disc:
      return k == 4 ? lowest : k < 2 ? Vec3f(center + radii[k]) : Vec3f(center - radii[k - 2]);
    case SideKind::polygon: {
      const std::size_t i = at(corners[k]);
      return Vec3f(points.x[i], points.y[i], points.z[i]);
    }
  }
  return lowest;
}

std::size_t ShownSide::corner_count() const {
  switch (kind) {
    case SideKind::point:
      return 1;
    case SideKind::segment:
      return 2;
    case SideKind::disc:
      return lowest_name >= 0 ? 5 : 4;
    case SideKind::polygon:
      return corners.size();
  }
  return 0;
}

int ShownSide::corner_name(std::size_t k) const {
  switch (kind) {
    case SideKind::point:
      return lowest_name;
    case SideKind::segment:
      return end_names[k];
    case SideKind::disc:
      return k == 4 ? lowest_name : first_name + static_cast<int>(k);
    case SideKind::polygon:
      return corners[k];
  }
  return 0;
}

void add_between(const Vec3f& p_A, const Vec3f& p_B, const Vec3f& n, std::uint32_t feature,
                 const RegionScale& scale, std::vector<ManifoldCandidate>& candidates) {
  const float gap = n.dot(p_B - p_A) - scale.radius_A - scale.radius_B;
  if (gap > scale.margin) return;
  candidates.push_back({0.5f * (p_A + p_B) + 0.5f * (scale.radius_A - scale.radius_B) * n, gap, feature});
}

RegionResult find_region(const ShownSide& a, const ShownSide& b, const Vec3f& n, const RegionScale& scale,
                         std::vector<ManifoldCandidate>& candidates) {
  const SidePair pair{a, b, n, scale};
  RegionResult result{std::numeric_limits<float>::infinity(), 0};
  if (!is_flat(a) && !is_flat(b)) {
    const bool are_segments = a.kind == SideKind::segment && b.kind == SideKind::segment;
    if (!(are_segments && add_side_by_side(pair, candidates))) {
      result.beside = add_nearest(pair, candidates);
      if (are_segments) add_ends(pair, candidates);
    }
  } else {
    if (is_flat(b)) add_corners(pair, true, candidates);
    if (is_flat(a)) add_corners(pair, false, candidates);
    add_crossings(pair, candidates);
  }
  for (const ManifoldCandidate& candidate : candidates) result.least = std::min(result.least, candidate.gap);
  return result;
}

}  // namespace rigor
