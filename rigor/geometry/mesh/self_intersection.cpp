#include "rigor/geometry/mesh/self_intersection.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/interrupt.hpp"
#include "rigor/geometry/broad_phase/box_pairs.hpp"
#include "rigor/geometry/exact/orientation.hpp"
#include "rigor/geometry/mesh/triangle_pair.hpp"

#include <algorithm>

namespace rigor {

namespace {

using Corners = TriangleCorners;

/// The coordinate axis along which the projection of the triangle has the largest area.
int viewing_axis(const Corners& t) {
  int axis;
  (t[1] - t[0]).cross(t[2] - t[0]).cwiseAbs().maxCoeff(&axis);
  return axis;
}

/// Triangles that share corner 0: they meet elsewhere too if the edge of one opposite to that corner meets
/// the other.
bool triangles_at_vertex_meet(const Corners& t, const Corners& u) {
  // An edge strictly on one side of the plane of u cannot meet u.
  const int t1 = orientation(u[0], u[1], u[2], t[1]), t2 = orientation(u[0], u[1], u[2], t[2]);
  if (t1 * t2 > 0) return false;
  return segment_meets(t[1], t[2], u) || segment_meets(u[1], u[2], t);
}

/// Triangles that share the edge from corner 0 to corner 1: they overlap if one is folded flat onto the
/// other.
bool triangles_at_edge_meet(const Corners& t, const Corners& u) {
  // Triangles of different planes have only their common edge in common. In one plane they overlap if their
  // third corners are on the same side of that edge.
  if (orientation(t[0], t[1], t[2], u[2]) != 0) return false;
  const int axis = viewing_axis(t);
  const Vec2 p = seen_along(t[0], axis), q = seen_along(t[1], axis);
  return orientation(p, q, seen_along(t[2], axis)) * orientation(p, q, seen_along(u[2], axis)) > 0;
}

/// The corners of two triangles, with those that they share first and in the same order.
struct SharedFirst {
  Corners t, u;
  int shared = 0;
};

SharedFirst shared_first(const TriangleMesh& mesh, std::array<int, 3> a, std::array<int, 3> b) {
  SharedFirst result;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto match = std::find(b.begin() + result.shared, b.end(), a[i]);
    if (match == b.end()) continue;
    std::swap(a[at(result.shared)], a[i]);
    std::swap(b[at(result.shared)], *match);
    ++result.shared;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    result.t[i] = mesh.vertices[at(a[i])];
    result.u[i] = mesh.vertices[at(b[i])];
  }
  return result;
}

/// Whether two triangles meet other than at the vertices and edges that they share.
bool faces_meet(const TriangleMesh& mesh, int a, int b) {
  const SharedFirst pair = shared_first(mesh, mesh.triangles[at(a)], mesh.triangles[at(b)]);
  switch (pair.shared) {
    case 0:
      return triangles_meet(pair.t, pair.u);
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
  // Only triangles whose boxes overlap can meet: the broad phase leaves few pairs for the exact tests.
  std::vector<Aabb> boxes;
  boxes.reserve(mesh.triangles.size());
  for (const std::array<int, 3>& triangle : mesh.triangles) {
    const Vec3& first = mesh.vertices[at(triangle[0])];
    Aabb box{first, first};
    for (const int v : triangle) box = box.united({mesh.vertices[at(v)], mesh.vertices[at(v)]});
    boxes.push_back(box);
  }
  std::vector<std::array<int, 2>> found;
  for (const std::array<int, 2>& pair : overlapping_pairs(boxes)) {
    poll_interrupt();
    if (static_cast<int>(found.size()) >= max_pairs) break;
    if (faces_meet(mesh, pair[0], pair[1])) found.push_back(pair);
  }
  return found;
}

}  // namespace rigor
