#pragma once

#include "rigor/geometry/rays/ray_span.hpp"

#include <optional>
#include <vector>

namespace rigor {

/// A point where a line crosses a triangle of a mesh.
struct MeshCrossing {
  double s = 0;  ///< Parameter on the line [m].
  int triangle = -1;
  Vec3 n_M = Vec3::Zero();  ///< Unit normal of the triangle.
  bool enters = true;       ///< Whether the line runs against the normal.
};

/// The part of a line whose crossings are wanted: not before s = from, which is decided exactly (start_M must
/// be the point of the line there), nor after s = to.
struct MeshRay {
  ShapeLine line;
  Vec3 start_M;
  double from, to;  ///< [m].
};

/// All crossings, sorted by s, then by triangle.
std::vector<MeshCrossing> mesh_crossings(const Mesh& mesh, const MeshRay& ray);

/// The first of these crossings, or nothing.
std::optional<MeshCrossing> first_mesh_crossing(const Mesh& mesh, const MeshRay& ray);

}  // namespace rigor
