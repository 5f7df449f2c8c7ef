#pragma once

#include "rigor/core/index.hpp"
#include "rigor/geometry/mesh/triangle_tree.hpp"
#include "rigor/geometry/shape/shape.hpp"
#include "rigor/geometry/shape/triangle_mesh.hpp"
#include "rigor/math/pose.hpp"

#include <vector>

namespace rigor {

/// A mesh placed in a common frame O, as one side of a pair: its corners, edges and faces with their
/// neighbourhoods.
class MeshSide {
 public:
  /// reach: neighbours that rise by no more than this along a normal, and by a tenth of their distance, still
  /// count as falling away [m].
  MeshSide(const Mesh& mesh, const Pose& X_OM, double reach) : mesh_(mesh), X_OM_(X_OM), reach_(reach) {}

  Vec3 vertex(int v) const { return X_OM_ * mesh_.mesh->vertices[at(v)]; }
  int vertex_of(int t, int k) const { return mesh_.mesh->triangles[at(t)][at(k % 3)]; }
  Vec3 corner(int t, int k) const { return vertex(vertex_of(t, k)); }
  Vec3 normal(int t) const { return X_OM_.R * topology(t).normal; }
  const TriangleTree::Triangle& topology(int t) const { return mesh_.tree->triangles[at(t)]; }
  bool is_corner(int v) const { return mesh_.tree->is_crease_corner[at(v)]; }
  double patch_area(int t) const { return mesh_.tree->patch_areas[at(topology(t).patch)]; }
  /// Whether the surface bends away at this edge, or ends there.
  bool is_edge(int t, int k) const {
    const MeshEdgeKind kind = topology(t).edge[at(k)];
    return kind == MeshEdgeKind::convex || kind == MeshEdgeKind::boundary;
  }
  /// A number for edge k of triangle t, the same from both of its sides: 3 t + k of the lower triangle.
  int edge(int t, int k) const;
  /// The triangles at the edge with this number; the second is -1 at a border.
  std::array<int, 2> triangles_at(int edge) const {
    return {edge / 3, topology(edge / 3).neighbour[at(edge % 3)]};
  }

  /// Whether the surface about the vertex, or at the edge, falls away from the direction n.
  bool falls_away_at_vertex(int v, const Vec3& n) const;
  bool falls_away_at_edge(int edge, const Vec3& n) const;

 private:
  /// Whether triangle t lies below the plane through p_M with the normal n_M, up to the slack and the reach.
  bool falls_away(int t, const Vec3& p_M, const Vec3& n_M) const;

  const Mesh& mesh_;
  const Pose& X_OM_;
  double reach_;
};

}  // namespace rigor
