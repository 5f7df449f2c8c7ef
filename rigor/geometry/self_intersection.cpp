#include "rigor/geometry/self_intersection.hpp"

#include "rigor/geometry/box_pairs.hpp"
#include "rigor/geometry/orientation.hpp"

#include <algorithm>

namespace rigor {

namespace {

std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

using Corners = std::array<Vec3, 3>;

/// Whether the box of the segment pq holds r, which lies on the line pq.
bool is_between(const Vec2& p, const Vec2& q, const Vec2& r) {
  return (r.array() >= p.cwiseMin(q).array()).all() && (r.array() <= p.cwiseMax(q).array()).all();
}

bool segments_meet(const Vec2& p, const Vec2& q, const Vec2& r, const Vec2& s) {
  const int pqr = orientation(p, q, r), pqs = orientation(p, q, s);
  const int rsp = orientation(r, s, p), rsq = orientation(r, s, q);
  if (pqr * pqs < 0 && rsp * rsq < 0) return true;
  return (pqr == 0 && is_between(p, q, r)) || (pqs == 0 && is_between(p, q, s)) ||
         (rsp == 0 && is_between(r, s, p)) || (rsq == 0 && is_between(r, s, q));
}

/// Axis along which the triangle is seen with an area.
int viewing_axis(const Corners& t) {
  int axis;
  (t[1] - t[0]).cross(t[2] - t[0]).cwiseAbs().maxCoeff(&axis);
  return axis;
}

Vec2 seen(const Vec3& p, int axis) {
  return {p[(axis + 1) % 3], p[(axis + 2) % 3]};
}

/// Whether the segment pq, in the plane of the triangle, meets it.
bool segment_in_plane_meets(const Vec3& p, const Vec3& q, const Corners& t) {
  const int axis = viewing_axis(t);
  const Vec2 p2 = seen(p, axis), q2 = seen(q, axis);
  const std::array<Vec2, 3> c = {seen(t[0], axis), seen(t[1], axis), seen(t[2], axis)};
  for (std::size_t i = 0; i < 3; ++i) {
    if (segments_meet(p2, q2, c[i], c[(i + 1) % 3])) return true;
  }
  // No edge is crossed: the segment lies wholly inside or wholly outside.
  const int sign = orientation(c[0], c[1], c[2]);
  return orientation(c[0], c[1], p2) == sign && orientation(c[1], c[2], p2) == sign &&
         orientation(c[2], c[0], p2) == sign;
}

/// Whether the segment pq meets the triangle, borders included.
bool segment_meets(const Vec3& p, const Vec3& q, const Corners& t) {
  const int side_p = orientation(t[0], t[1], t[2], p), side_q = orientation(t[0], t[1], t[2], q);
  if (side_p * side_q > 0) return false;
  if (side_p == 0 && side_q == 0) return segment_in_plane_meets(p, q, t);
  const int s0 = orientation(p, q, t[0], t[1]), s1 = orientation(p, q, t[1], t[2]),
            s2 = orientation(p, q, t[2], t[0]);
  return (s0 >= 0 && s1 >= 0 && s2 >= 0) || (s0 <= 0 && s1 <= 0 && s2 <= 0);
}

/// Whether the plane of t has all corners of u strictly on one side.
bool is_on_one_side(const Corners& t, const Corners& u) {
  const int first = orientation(t[0], t[1], t[2], u[0]);
  if (first == 0) return false;
  return orientation(t[0], t[1], t[2], u[1]) == first && orientation(t[0], t[1], t[2], u[2]) == first;
}

bool disjoint_triangles_meet(const Corners& t, const Corners& u) {
  if (is_on_one_side(t, u) || is_on_one_side(u, t)) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    if (segment_meets(t[i], t[(i + 1) % 3], u) || segment_meets(u[i], u[(i + 1) % 3], t)) return true;
  }
  return false;
}

/// Triangles that share corner 0 of both: they meet elsewhere if the edge opposite to it of one meets the
/// other.
bool triangles_at_vertex_meet(const Corners& t, const Corners& u) {
  const int t1 = orientation(u[0], u[1], u[2], t[1]), t2 = orientation(u[0], u[1], u[2], t[2]);
  if (t1 * t2 > 0) return false;
  return segment_meets(t[1], t[2], u) || segment_meets(u[1], u[2], t);
}

/// Triangles that share the edge of corners 0 and 1 of both: they overlap if one is folded flat on the other.
bool triangles_at_edge_meet(const Corners& t, const Corners& u) {
  if (orientation(t[0], t[1], t[2], u[2]) != 0) return false;
  const int axis = viewing_axis(t);
  const Vec2 p = seen(t[0], axis), q = seen(t[1], axis);
  return orientation(p, q, seen(t[2], axis)) * orientation(p, q, seen(u[2], axis)) > 0;
}

/// The triangles' corners, those that they share first and in the same order in both.
struct SharedFirst {
  Corners t, u;
  int shared = 0;
};

SharedFirst shared_first(const TriangleMesh& mesh, std::array<int, 3> a, std::array<int, 3> b) {
  SharedFirst result;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto match = std::find(b.begin() + result.shared, b.end(), a[i]);
    if (match == b.end()) continue;
    std::swap(a[index(result.shared)], a[i]);
    std::swap(b[index(result.shared)], *match);
    ++result.shared;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    result.t[i] = mesh.vertices[index(a[i])];
    result.u[i] = mesh.vertices[index(b[i])];
  }
  return result;
}

bool triangles_meet(const TriangleMesh& mesh, int a, int b) {
  const SharedFirst pair = shared_first(mesh, mesh.triangles[index(a)], mesh.triangles[index(b)]);
  switch (pair.shared) {
    case 0:
      return disjoint_triangles_meet(pair.t, pair.u);
    case 1:
      return triangles_at_vertex_meet(pair.t, pair.u);
    case 2:
      return triangles_at_edge_meet(pair.t, pair.u);
    default:
      return true;
  }
}

}  // namespace

std::vector<std::array<int, 2>> find_self_intersections(const TriangleMesh& mesh, int max_pairs) {
  std::vector<Aabb> boxes;
  boxes.reserve(mesh.triangles.size());
  for (const std::array<int, 3>& triangle : mesh.triangles) {
    const Vec3& first = mesh.vertices[index(triangle[0])];
    Aabb box{first, first};
    for (const int v : triangle) box = box.united({mesh.vertices[index(v)], mesh.vertices[index(v)]});
    boxes.push_back(box);
  }
  std::vector<std::array<int, 2>> found;
  for (const std::array<int, 2>& pair : overlapping_pairs(boxes)) {
    if (static_cast<int>(found.size()) >= max_pairs) break;
    if (triangles_meet(mesh, pair[0], pair[1])) found.push_back(pair);
  }
  return found;
}

}  // namespace rigor
