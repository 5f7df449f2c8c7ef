#pragma once

#include "rigor/geometry/rays/ray_span.hpp"

#include <optional>
#include <vector>

namespace rigor {

/// Where a line crosses a triangle of a mesh.
struct MeshCrossing {
  double s = 0;  ///< Along the line [m].
  int triangle = -1;
  Vec3 n_M = Vec3::Zero();  ///< Unit normal of the triangle.
  bool enters = true;       ///< Against the normal.
};

/// Which crossings are wanted: not before s = from, decided exactly (the line's point there must be start_M),
/// nor after s = to.
struct MeshRay {
  ShapeLine line;
  Vec3 start_M;
  double from, to;  ///< [m].
};

/// All crossings, sorted by s, then by triangle.
std::vector<MeshCrossing> mesh_crossings(const Mesh& mesh, const MeshRay& ray);

/// The first of them.
std::optional<MeshCrossing> first_mesh_crossing(const Mesh& mesh, const MeshRay& ray);

}  // namespace rigor
