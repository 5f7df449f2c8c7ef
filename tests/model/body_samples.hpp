#pragma once

#include "rigor/geometry/shape/triangle_mesh.hpp"
#include "rigor/model/model_builder.hpp"

#include <memory>
#include <string>

namespace rigor::samples {

inline BodyDescription body_of(const Shape& shape, const std::string& name = "ball") {
  BodyDescription body;
  body.name = name;
  body.shapes = {{shape}};
  return body;
}

/// All messages of a scene with this body, each with its line end.
inline std::string errors_of(const BodyDescription& body) {
  ModelBuilder builder;
  builder.add_body(body, "here: ");
  std::string text;
  for (const std::string& message : builder.check()) text += message + "\n";
  return text;
}

/// Cube of edge 1 about the origin; without its last face it is open.
inline Mesh cube_mesh(bool is_closed = true) {
  PolygonMesh polygons;
  for (int i = 0; i < 8; ++i) {
    polygons.vertices.emplace_back((i & 1) - 0.5, ((i >> 1) & 1) - 0.5, ((i >> 2) & 1) - 0.5);
  }
  polygons.faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  if (!is_closed) polygons.faces.pop_back();
  return Mesh{std::make_shared<const TriangleMesh>(triangulated(polygons)), nullptr};
}

}  // namespace rigor::samples
