#pragma once

#include "rigor/math/types.hpp"

#include <array>
#include <string>
#include <vector>

namespace rigor {

/// Surface of polygons as read from a file: faces counter-clockwise seen from outside, possibly concave.
struct PolygonMesh {
  std::vector<Vec3> vertices;           ///< [m].
  std::vector<std::vector<int>> faces;  ///< Vertex loops, each of at least 3.
};

/// Surface of triangles, counter-clockwise seen from outside.
struct TriangleMesh {
  std::vector<Vec3> vertices;                 ///< [m].
  std::vector<std::array<int, 3>> triangles;  ///< Vertex indices.
};

/// The mesh with each face cut into triangles between its own vertices (no vertex is added, moved or
/// dropped), in the order of the faces. Indices are valid and coordinates finite; faces need not be quite
/// planar.
TriangleMesh triangulated(const PolygonMesh& mesh);

/// The triangles as three-sided polygons.
PolygonMesh as_polygons(const TriangleMesh& mesh);

}  // namespace rigor
