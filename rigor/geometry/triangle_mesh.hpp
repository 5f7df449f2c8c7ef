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

}  // namespace rigor
