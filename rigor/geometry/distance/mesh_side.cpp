#include "rigor/geometry/distance/mesh_side.hpp"

#include "rigor/core/index.hpp"

#include <algorithm>

namespace rigor {
namespace {

/// A normal this far outside the cone of an edge or vertex (as a sine) counts as on its border.
constexpr double kConeSlack = 1e-9;
/// Sides that rise more steeply never fall away, however far the reach is.
constexpr double kLargestSlope = 0.1;

}  // namespace

int MeshSide::edge(int t, int k) const {
  // The lower of the two triangles names the edge; the shared edge runs the other way in it.
  const int other = topology(t).neighbour[at(k)];
  if (other < 0 || other > t) return 3 * t + k;
  for (int j = 0; j < 3; ++j) {
    if (vertex_of(other, j) == vertex_of(t, k + 1) && vertex_of(other, j + 1) == vertex_of(t, k))
      return 3 * other + j;
  }
  return 3 * t + k;
}

bool MeshSide::falls_away(int t, const Vec3& p_M, const Vec3& n_M) const {
  return std::ranges::all_of(mesh_.mesh->triangles[at(t)], [&](int v) {
    // A vertex counts as below the plane if its height is within the tolerances of slope and reach.
    const Vec3 along = mesh_.mesh->vertices[at(v)] - p_M;
    return n_M.dot(along) <= kConeSlack * along.norm() + std::min(reach_, kLargestSlope * along.norm());
  });
}

bool MeshSide::falls_away_at_vertex(int v, const Vec3& n) const {
  const Vec3 n_M = X_OM_.R.transpose() * n;
  const Vec3& p_M = mesh_.mesh->vertices[at(v)];
  const std::vector<int>& around = mesh_.tree->vertex_triangles[at(v)];
  return std::ranges::all_of(around, [&](int t) { return falls_away(t, p_M, n_M); });
}

bool MeshSide::falls_away_at_edge(int edge, const Vec3& n) const {
  const Vec3 n_M = X_OM_.R.transpose() * n;
  const Vec3& p_M = mesh_.mesh->vertices[at(vertex_of(edge / 3, edge % 3))];
  return std::ranges::all_of(triangles_at(edge), [&](int t) { return t < 0 || falls_away(t, p_M, n_M); });
}

}  // namespace rigor
