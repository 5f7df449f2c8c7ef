#pragma once

#include "rigor/geometry/shape/triangle_mesh.hpp"

#include <vector>

namespace rigor {

/// Half of an edge: the side that belongs to one face.
struct FaceEdge {
  int low, high;    ///< Vertices, low ≤ high.
  bool is_forward;  ///< The face runs from low to high.
  int face;
};

/// The edges of all faces, those between the same vertices next to each other.
std::vector<FaceEdge> sorted_edges(const PolygonMesh& mesh);

/// The parts of a surface that are connected by edges, each as a mesh with its own vertices.
struct MeshShells {
  std::vector<PolygonMesh> shells;
  std::vector<int> first_face;  ///< Of each shell, its lowest face in the whole mesh.
};
MeshShells find_shells(const PolygonMesh& mesh, const std::vector<FaceEdge>& edges);

/// Shells of a closed surface that are misplaced: solid ones (with a positive volume) inside another solid,
/// and cavities (with a negative one) outside any solid. Ascending. A shell is reported only if all its
/// vertices that are tried agree.
std::vector<int> find_misplaced_shells(const std::vector<PolygonMesh>& shells);

}  // namespace rigor
