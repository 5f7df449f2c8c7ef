#include "rigor/geometry/mesh/mesh_point.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"
#include "rigor/geometry/mesh/triangle_tree.hpp"
#include "rigor/geometry/shape/triangle_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace rigor {
namespace {

/// Nearest point of a triangle and its location: corners[k] says whether corner k takes part, so that one
/// corner is a vertex, two are an edge and three the face.
struct TrianglePoint {
  Vec3 p;
  std::array<bool, 3> corners;
};

/// Nearest point of the segment ab, whose ends are the corners i and j of a triangle.
TrianglePoint nearest_on_side(const Vec3& a, const Vec3& b, std::size_t i, std::size_t j, const Vec3& q) {
  const Vec3 ab = b - a;
  const double along = (q - a).dot(ab);
  TrianglePoint nearest{a, {false, false, false}};
  if (along >= ab.squaredNorm()) nearest.p = b;
  if (along > 0 && along < ab.squaredNorm()) nearest.p = a + along / ab.squaredNorm() * ab;
  nearest.corners[i] = along < ab.squaredNorm();
  nearest.corners[j] = along > 0;
  return nearest;
}

TrianglePoint nearest_on_triangle(const std::array<Vec3, 3>& corners, const Vec3& normal, const Vec3& q) {
  // The face, if q projects into it.
  bool is_above = true;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 side = corners[(k + 1) % 3] - corners[k];
    is_above = is_above && normal.cross(side).dot(q - corners[k]) > 0;
  }
  if (is_above) return {q - normal.dot(q - corners[0]) * normal, {true, true, true}};
  // Otherwise the nearest side.
  TrianglePoint best = nearest_on_side(corners[0], corners[1], 0, 1, q);
  for (std::size_t k = 1; k < 3; ++k) {
    const TrianglePoint next = nearest_on_side(corners[k], corners[(k + 1) % 3], k, (k + 1) % 3, q);
    if ((next.p - q).squaredNorm() < (best.p - q).squaredNorm()) best = next;
  }
  return best;
}

/// The angle-weighted pseudonormal at the point: the face normal, the sum of both face normals at an edge, or
/// the weighted sum at a vertex. Its product with q - p has the sign of the distance.
Vec3 pseudo_normal(const Mesh& mesh, std::size_t t, const TrianglePoint& point) {
  const TriangleTree::Triangle& triangle = mesh.tree->triangles[t];
  const long corner_count = std::count(point.corners.begin(), point.corners.end(), true);
  if (corner_count == 3) return triangle.normal;
  for (std::size_t k = 0; k < 3; ++k) {
    if (!point.corners[k]) continue;
    if (corner_count == 1) {
      return mesh.tree->vertex_normals[at(mesh.mesh->triangles[t][k])];
    }
    // Two corners: the edge from corner k to the next.
    if (!point.corners[(k + 1) % 3]) continue;
    const int neighbour = triangle.neighbour[k];
    if (neighbour < 0) return triangle.normal;
    return triangle.normal + mesh.tree->triangles[at(neighbour)].normal;
  }
  return triangle.normal;
}

double squared_distance(const Aabb& box, const Vec3& q) {
  return (box.lower - q).cwiseMax(q - box.upper).cwiseMax(0.0).squaredNorm();
}

/// Branch and bound over the tree: a box farther away than the best point is skipped.
class NearestPoint {
 public:
  NearestPoint(const Mesh& mesh, const Vec3& q_M) : mesh_(mesh), q_M_(q_M) {
    if (!mesh.tree->nodes.empty()) search(0);
  }

  MeshPoint result() const {
    if (triangle_ < 0) return {q_M_, Vec3::Zero(), std::numeric_limits<double>::infinity()};
    const std::size_t t = at(triangle_);
    return {point_.p, pseudo_normal(mesh_, t, point_), std::sqrt(squared_)};
  }

 private:
  void search(std::size_t index) {
    const TriangleTree& tree = *mesh_.tree;
    const TriangleTree::Node& node = tree.nodes[index];
    // Bound: no point of the box is nearer than the box itself.
    if (squared_distance(node.box, q_M_) >= squared_) return;
    for (int k = 0; k < node.count; ++k) try_triangle(tree.order[at(node.first + k)]);
    if (node.count > 0) return;
    // The nearer child first, so that the bound falls early.
    const std::size_t left = index + 1, right = at(node.first);
    const bool left_first =
        squared_distance(tree.nodes[left].box, q_M_) <= squared_distance(tree.nodes[right].box, q_M_);
    search(left_first ? left : right);
    search(left_first ? right : left);
  }

  void try_triangle(int t) {
    const std::size_t index = at(t);
    std::array<Vec3, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = mesh_.mesh->vertices[at(mesh_.mesh->triangles[index][k])];
    }
    // Of equally near triangles the first one stays.
    const TrianglePoint point = nearest_on_triangle(corners, mesh_.tree->triangles[index].normal, q_M_);
    const double squared = (point.p - q_M_).squaredNorm();
    if (squared >= squared_) return;
    squared_ = squared;
    point_ = point;
    triangle_ = t;
  }

  const Mesh& mesh_;
  const Vec3 q_M_;
  double squared_ = std::numeric_limits<double>::infinity();
  TrianglePoint point_{Vec3::Zero(), {false, false, false}};
  int triangle_ = -1;
};

}  // namespace

MeshPoint nearest_mesh_point(const Mesh& mesh, const Vec3& q_M) {
  RIGOR_ASSERT(mesh.tree != nullptr);
  return NearestPoint(mesh, q_M).result();
}

}  // namespace rigor
