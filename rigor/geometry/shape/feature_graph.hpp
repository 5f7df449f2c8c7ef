#pragma once

#include "rigor/core/index.hpp"
#include "rigor/math/types.hpp"

#include <cstdint>
#include <vector>

namespace rigor {

/// Features (vertices, edges, faces) of a convex polyhedron in flat arrays, with the planes of their Voronoi
/// regions. Directions only: the same for every scale, the vertices are elsewhere.
struct FeatureGraph {
  /// One of the two directed sides of an edge, in the loop of the face on its left.
  struct HalfEdge {
    Vec3 direction;  ///< Unit, from -> to.
    Vec3 side;       ///< Unit, in the face, across the edge, to the inside of the face: normal × direction.
    int from, to;    ///< Vertices.
    int twin;        ///< The other half of the edge.
    int face;
  };
  /// An edge as seen from a vertex that it leaves.
  struct OutgoingEdge {
    Vec3 direction;  ///< Unit, away from the vertex.
    int half_edge;   ///< That leaves the vertex.
    int to;          ///< The vertex at its other end.
  };

  std::vector<HalfEdge> half_edges;    ///< Face by face, each loop counter-clockwise seen from outside.
  std::vector<Vec3> normals;           ///< Of the faces, outward, unit.
  std::vector<int> face_begin;         ///< First half-edge of each face, and the count of all at the end.
  std::vector<OutgoingEdge> outgoing;  ///< Vertex by vertex, in order around each.
  std::vector<int> vertex_begin;  ///< First outgoing edge of each vertex, and the count of all at the end.

  int face_count() const { return static_cast<int>(normals.size()); }
  int vertex_count() const { return static_cast<int>(vertex_begin.size()) - 1; }
  const HalfEdge& half_edge(int h) const { return half_edges[at(h)]; }
  const Vec3& normal(int face) const { return normals[at(face)]; }
  int first_of_face(int face) const { return face_begin[at(face)]; }
  int first_of_vertex(int vertex) const { return vertex_begin[at(vertex)]; }
};

/// Graph of a closed convex polyhedron: vertex loops of the faces, counter-clockwise seen from outside, and
/// their unit normals. Every edge is in exactly two loops (a broken promise otherwise).
FeatureGraph make_feature_graph(const std::vector<Vec3>& vertices, const std::vector<std::vector<int>>& faces,
                                const std::vector<Vec3>& normals);

}  // namespace rigor
