#include "rigor/geometry/shape/triangle_mesh.hpp"

#include "rigor/geometry/shape/polygon_triangulation.hpp"

namespace rigor {

TriangleMesh triangulated(const PolygonMesh& mesh) {
  TriangleMesh result;
  result.vertices = mesh.vertices;
  for (const std::vector<int>& face : mesh.faces) {
    const std::vector<std::array<int, 3>> triangles = triangulated_polygon(mesh.vertices, face);
    result.triangles.insert(result.triangles.end(), triangles.begin(), triangles.end());
  }
  return result;
}

PolygonMesh as_polygons(const TriangleMesh& mesh) {
  PolygonMesh result;
  result.vertices = mesh.vertices;
  result.faces.reserve(mesh.triangles.size());
  for (const std::array<int, 3>& triangle : mesh.triangles) {
    result.faces.emplace_back(triangle.begin(), triangle.end());
  }
  return result;
}

}  // namespace rigor
