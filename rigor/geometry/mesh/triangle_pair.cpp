#include "rigor/geometry/mesh/triangle_pair.hpp"

#include "rigor/core/index.hpp"
#include "rigor/geometry/exact/orientation.hpp"
#include "rigor/geometry/lanes/simd_lanes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigor {
namespace {

/// A triangle with one corner, or one edge, per lane; the fourth lane repeats the first.
struct LaneTriangle {
  LaneVec3 corner;
  LaneVec3 next;  ///< Corner where the edge ends.
};

RIGOR_LANES LaneTriangle load_triangle(const TriangleCorners& t, const Vec3& origin) {
  alignas(32) double c[3][8];
  for (std::size_t k = 0; k < 6; ++k) {
    for (int i = 0; i < 3; ++i) c[i][k] = t[k % 3][i] - origin[i];
  }
  return {{load_lanes(c[0]), load_lanes(c[1]), load_lanes(c[2])},
          {load_lanes(c[0] + 1), load_lanes(c[1] + 1), load_lanes(c[2] + 1)}};
}

RIGOR_LANES LaneVec3 broadcast(const LaneVec3& v, int lane) {
  return {lanes_of(v.x[lane]), lanes_of(v.y[lane]), lanes_of(v.z[lane])};
}

RIGOR_LANES Lanes clamped(const Lanes& s) {
  return lane_min(lane_max(s, Lanes{}), lanes_of(1));
}

/// The quotient; 0 where the divisor is 0.
RIGOR_LANES Lanes divided(const Lanes& a, const Lanes& b) {
  return b > Lanes{} ? a / b : Lanes{};
}

/// Squared distances of the segments p + s d and q + t e, s and t in [0, 1].
///
/// With n = d × e and r = q - p the lines are nearest at s = (r × e)·n / n², and t is the foot of that point
/// on the other line. Where a parameter leaves its segment, the foot of that end on the other segment takes
/// over.
RIGOR_LANES Lanes edge_distances(const LaneVec3& p, const LaneVec3& d, const LaneVec3& q, const LaneVec3& e) {
  const LaneVec3 n = cross(d, e), r = q - p;
  Lanes s = clamped(divided(dot(cross(r, e), n), dot(n, n)));
  const Lanes t = clamped(divided(dot(s * d - r, e), dot(e, e)));
  s = clamped(divided(dot(r + t * e, d), dot(d, d)));
  const LaneVec3 between = r + t * e - s * d;
  return dot(between, between);
}

/// Corners against a face: their squared distances where they project into it (infinite elsewhere), and all
/// heights times |n|.
struct HeightLanes {
  Lanes squared, height;
};
RIGOR_LANES HeightLanes face_distances(const LaneTriangle& face, const LaneVec3& n, const LaneVec3& corners) {
  const Lanes height = dot(n, corners - broadcast(face.corner, 0));
  // A corner projects into the face if it is on the inner side of all three edges.
  // NOLINTNEXTLINE(misc-redundant-expression): true in all lanes that have a number.
  LaneMask is_over = height == height;
  for (int k = 0; k < 3; ++k) {
    const LaneVec3 start = broadcast(face.corner, k), side = broadcast(face.next, k) - start;
    is_over &= dot(cross(n, side), corners - start) >= Lanes{};
  }
  const Lanes squared = divided(height * height, dot(n, n));
  const Lanes far = lanes_of(std::numeric_limits<double>::infinity());
  is_over &= dot(n, n) > Lanes{};
  return {is_over ? squared : far, height};
}

RIGOR_LANES LaneVec3 face_normal(const LaneTriangle& t) {
  const LaneVec3 p = broadcast(t.corner, 0);
  return cross(broadcast(t.corner, 1) - p, broadcast(t.corner, 2) - p);
}

/// Whether all heights are on the same side, by more than the rounding.
RIGOR_LANES bool is_one_sided(const Lanes& h, double rounding) {
  const double low = std::min(std::min(h[0], h[1]), h[2]), high = std::max(std::max(h[0], h[1]), h[2]);
  return low > rounding || high < -rounding;
}

RIGOR_LANES double largest_size(const Lanes& h) {
  const Lanes size = lane_abs(h);
  return std::max(std::max(size[0], size[1]), size[2]);
}

/// Squared distances of all pairs of features: nine of two edges, six of a corner and a face. Returns whether
/// the planes leave open that the triangles meet.
RIGOR_LANES bool all_distances(const TriangleCorners& a, const TriangleCorners& b, double* squared) {
  const LaneTriangle A = load_triangle(a, a[0]), B = load_triangle(b, a[0]);
  const LaneVec3 edge_A = A.next - A.corner, edge_B = B.next - B.corner;
  for (int i = 0; i < 3; ++i) {
    store_lanes(edge_distances(broadcast(A.corner, i), broadcast(edge_A, i), B.corner, edge_B),
                squared + 3 * i);
  }
  const LaneVec3 n_A = face_normal(A), n_B = face_normal(B);
  const HeightLanes over_A = face_distances(A, n_A, B.corner), over_B = face_distances(B, n_B, A.corner);
  store_lanes(over_A.squared, squared + 9);
  store_lanes(over_B.squared, squared + 12);
  // Error bound of the heights, as |n| ≤ 2 size² and the arms are ≤ 2 size. Triangles do not meet if the
  // plane of one has the other strictly on one side.
  const LaneVec3 far = {lane_max(lane_abs(A.corner.x), lane_abs(B.corner.x)),
                        lane_max(lane_abs(A.corner.y), lane_abs(B.corner.y)),
                        lane_max(lane_abs(A.corner.z), lane_abs(B.corner.z))};
  const Lanes total = far.x + far.y + far.z;
  const double size = std::max(std::max(total[0], total[1]), total[2]);
  const double rounding = 64 * std::numeric_limits<double>::epsilon() * size * size * size;
  if (is_one_sided(over_A.height, rounding) || is_one_sided(over_B.height, rounding)) return false;
  // Triangles in one plane meet only where edges cross or one triangle holds a corner of the other; their
  // distances are then of the order of the heights.
  const double flat = 4 * rounding;
  if (largest_size(over_A.height) > flat) return true;
  const double least = *std::min_element(squared, squared + 15);
  return !(least * dot(n_A, n_A)[0] > 16 * flat * flat);
}

bool distances_portable(const TriangleCorners& a, const TriangleCorners& b, double* squared) {
  return all_distances(a, b, squared);
}
#if defined(__x86_64__)
[[gnu::target("avx2")]] bool distances_avx2(const TriangleCorners& a, const TriangleCorners& b,
                                            double* squared) {
  return all_distances(a, b, squared);
}
#endif

/// Nearest points of two segments, by the same steps as edge_distances.
std::array<Vec3, 2> nearest_on_edges(const Vec3& p, const Vec3& d, const Vec3& q, const Vec3& e) {
  const Vec3 n = d.cross(e), r = q - p;
  const auto place = [](double a, double b) { return b > 0 ? std::clamp(a / b, 0.0, 1.0) : 0.0; };
  double s = place(r.cross(e).dot(n), n.squaredNorm());
  const double t = place((s * d - r).dot(e), e.squaredNorm());
  s = place((r + t * e).dot(d), d.squaredNorm());
  return {p + s * d, q + t * e};
}

/// The projection of p onto the plane of the face.
Vec3 foot(const Vec3& p, const TriangleCorners& face) {
  const Vec3 n = (face[1] - face[0]).cross(face[2] - face[0]).stableNormalized();
  return p - n.dot(p - face[0]) * n;
}

/// The point where the segment crosses the plane of the triangle, if the segment meets the triangle.
bool find_crossing(const Vec3& p, const Vec3& q, const TriangleCorners& t, Vec3& crossing) {
  if (!segment_meets(p, q, t)) return false;
  const Vec3 n = (t[1] - t[0]).cross(t[2] - t[0]);
  const double at_p = n.dot(p - t[0]), at_q = n.dot(q - t[0]);
  const double place = at_p == at_q ? 0 : std::clamp(at_p / (at_p - at_q), 0.0, 1.0);
  crossing = p + place * (q - p);
  return true;
}

/// A point common to two triangles that meet: an edge of one meets the other.
Vec3 common_point(const TriangleCorners& a, const TriangleCorners& b) {
  Vec3 crossing = a[0];
  for (std::size_t i = 0; i < 3; ++i) {
    if (find_crossing(a[i], a[(i + 1) % 3], b, crossing)) return crossing;
    if (find_crossing(b[i], b[(i + 1) % 3], a, crossing)) return crossing;
  }
  return crossing;
}

/// Whether the box of the segment pq holds r, which lies on the line pq.
bool is_between(const Vec2& p, const Vec2& q, const Vec2& r) {
  return (r.array() >= p.cwiseMin(q).array()).all() && (r.array() <= p.cwiseMax(q).array()).all();
}

/// Whether two segments of a plane meet: each crosses the line of the other, or an end lies on the other
/// segment. Exact.
bool segments_meet(const Vec2& p, const Vec2& q, const Vec2& r, const Vec2& s) {
  const int pqr = orientation(p, q, r), pqs = orientation(p, q, s);
  const int rsp = orientation(r, s, p), rsq = orientation(r, s, q);
  if (pqr * pqs < 0 && rsp * rsq < 0) return true;
  return (pqr == 0 && is_between(p, q, r)) || (pqs == 0 && is_between(p, q, s)) ||
         (rsp == 0 && is_between(r, s, p)) || (rsq == 0 && is_between(r, s, q));
}

/// Whether the segment pq, in the plane of the triangle, meets it.
bool segment_in_plane_meets(const Vec3& p, const Vec3& q, const TriangleCorners& t) {
  // Seen along the axis with the largest area, two coordinates decide: they are not rounded.
  int axis;
  (t[1] - t[0]).cross(t[2] - t[0]).cwiseAbs().maxCoeff(&axis);
  const Vec2 p2 = seen_along(p, axis), q2 = seen_along(q, axis);
  const std::array<Vec2, 3> c = {seen_along(t[0], axis), seen_along(t[1], axis), seen_along(t[2], axis)};
  for (std::size_t i = 0; i < 3; ++i) {
    if (segments_meet(p2, q2, c[i], c[(i + 1) % 3])) return true;
  }
  // No edge is crossed: the segment lies wholly inside or wholly outside.
  const int sign = orientation(c[0], c[1], c[2]);
  return orientation(c[0], c[1], p2) == sign && orientation(c[1], c[2], p2) == sign &&
         orientation(c[2], c[0], p2) == sign;
}

/// Whether the plane of t has all corners of u strictly on one side.
bool is_on_one_side(const TriangleCorners& t, const TriangleCorners& u) {
  const int first = orientation(t[0], t[1], t[2], u[0]);
  if (first == 0) return false;
  return orientation(t[0], t[1], t[2], u[1]) == first && orientation(t[0], t[1], t[2], u[2]) == first;
}

}  // namespace

bool segment_meets(const Vec3& p, const Vec3& q, const TriangleCorners& t) {
  const int side_p = orientation(t[0], t[1], t[2], p), side_q = orientation(t[0], t[1], t[2], q);
  if (side_p * side_q > 0) return false;
  if (side_p == 0 && side_q == 0) return segment_in_plane_meets(p, q, t);
  // The line pq passes all three edges on the same side.
  const int s0 = orientation(p, q, t[0], t[1]), s1 = orientation(p, q, t[1], t[2]),
            s2 = orientation(p, q, t[2], t[0]);
  return (s0 >= 0 && s1 >= 0 && s2 >= 0) || (s0 <= 0 && s1 <= 0 && s2 <= 0);
}

bool triangles_meet(const TriangleCorners& t, const TriangleCorners& u) {
  // A separating plane is found first, as it decides most pairs. Otherwise triangles that meet have an edge
  // that meets the other triangle.
  if (is_on_one_side(t, u) || is_on_one_side(u, t)) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    if (segment_meets(t[i], t[(i + 1) % 3], u) || segment_meets(u[i], u[(i + 1) % 3], t)) return true;
  }
  return false;
}

TriangleDistance triangle_distance(const TriangleCorners& a, const TriangleCorners& b, LaneTarget target) {
  // Each row of edges writes four numbers, the last of which is overwritten by the next row.
  std::array<double, 16> squared;
#if defined(__x86_64__)
  const bool may_meet = target == LaneTarget::avx2 ? distances_avx2(a, b, squared.data())
                                                   : distances_portable(a, b, squared.data());
#else
  const bool may_meet = distances_portable(a, b, squared.data());
#endif
  // Whether they meet is decided exactly, and only where rounding leaves it open.
  if (may_meet && triangles_meet(a, b)) return {0, -1};
  const auto least = std::min_element(squared.begin(), squared.begin() + 15);
  return {*least, static_cast<int>(least - squared.begin())};
}

std::array<Vec3, 2> nearest_points(const TriangleCorners& a, const TriangleCorners& b, int feature) {
  if (feature < 0) {
    const Vec3 p = common_point(a, b);
    return {p, p};
  }
  const std::size_t f = at(feature);
  if (f < 9) {
    const std::size_t i = f / 3, k = f % 3;
    return nearest_on_edges(a[i], a[(i + 1) % 3] - a[i], b[k], b[(k + 1) % 3] - b[k]);
  }
  if (f < 12) return {foot(b[f - 9], a), b[f - 9]};
  return {a[f - 12], foot(a[f - 12], b)};
}

}  // namespace rigor
