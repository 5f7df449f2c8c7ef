#pragma once

#include "rigor/geometry/shape/triangle_mesh.hpp"

#include <array>
#include <vector>

namespace rigor {

/// Pairs of triangles that cut, touch or overlap each other anywhere but at the vertices and edges they
/// share, in ascending order; at most max_pairs of them. All decisions are exact. O(n log n) for meshes of
/// well-shaped triangles.
std::vector<std::array<int, 2>> find_self_intersections(const TriangleMesh& mesh, int max_pairs);

}  // namespace rigor
