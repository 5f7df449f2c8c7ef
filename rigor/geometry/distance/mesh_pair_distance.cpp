#include "rigor/geometry/distance/mesh_pair_distance.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"
#include "rigor/geometry/distance/mesh_overlap.hpp"
#include "rigor/geometry/distance/mesh_pair.hpp"
#include "rigor/geometry/mesh/mesh_point.hpp"
#include "rigor/geometry/mesh/triangle_tree.hpp"
#include "rigor/geometry/shape/triangle_mesh.hpp"

#include <algorithm>
#include <span>

namespace rigor {
namespace {

/// Whether a shell of mesh A lies inside the closed mesh B; their surfaces do not meet.
bool is_enclosed(const Mesh& a, const Mesh& b, const Pose& X_BA) {
  if (!b.tree->is_closed || b.tree->wide.nodes.empty()) return false;
  const OrientedBox& box = b.tree->wide.root;
  return std::ranges::any_of(a.tree->shell_vertices, [&](int v) {
    // One vertex of a shell stands for all of it, as the surfaces do not meet. A vertex outside the box of B
    // is outside B.
    const Vec3 p_B = X_BA * a.mesh->vertices[at(v)];
    if (((p_B - box.center).cwiseAbs() - box.half).maxCoeff() > 0) return false;
    const MeshPoint nearest = nearest_mesh_point(b, p_B);
    return (p_B - nearest.p_M).dot(nearest.normal_M) < 0;
  });
}

template <typename Number>
int compare(std::span<const Number> a, std::span<const Number> b) {
  const auto order = std::lexicographical_compare_three_way(a.begin(), a.end(), b.begin(), b.end());
  return order < 0 ? -1 : order > 0 ? 1 : 0;
}

std::span<const double> numbers(const std::vector<Vec3>& points) {
  return {points.empty() ? nullptr : points.front().data(), 3 * points.size()};
}
std::span<const int> numbers(const std::vector<std::array<int, 3>>& triangles) {
  return {triangles.empty() ? nullptr : triangles.front().data(), 3 * triangles.size()};
}

}  // namespace

DistanceResult mesh_pair_signed_distance(const Mesh& a, const Pose& X_WA, const Mesh& b, const Pose& X_WB) {
  const Pose X_AB = relative_pose(X_WA, X_WB);
  const MeshPairDistance found = mesh_pair_distance(a, b, X_AB);
  // Surfaces that meet overlap; surfaces that do not may still lie one inside the other.
  if (found.distance == 0) return overlap_distance(a, X_WA, b, X_WB);
  const Vec3 p_WA = X_WA * found.p_AP, p_WB = X_WA * found.p_AQ;
  if (is_enclosed(a, b, X_AB.inverse())) return enclosed_distance(a, X_WA, p_WA, p_WB);
  if (is_enclosed(b, a, X_AB)) {
    DistanceResult result = enclosed_distance(b, X_WB, p_WB, p_WA);
    std::swap(result.p_WA, result.p_WB);
    result.n_W = -result.n_W;
    return result;
  }
  // The difference of points in A keeps its digits far from the origin.
  const Vec3 n_W = X_WA.R * (found.p_AQ - found.p_AP).stableNormalized();
  return {found.distance, found.distance - found.rounding, found.distance + found.rounding,
          p_WA,           p_WA + found.distance * n_W,     n_W};
}

int compare_meshes(const Mesh& a, const Mesh& b) {
  if (a.mesh == b.mesh) return 0;
  const int vertices = compare(numbers(a.mesh->vertices), numbers(b.mesh->vertices));
  return vertices != 0 ? vertices : compare(numbers(a.mesh->triangles), numbers(b.mesh->triangles));
}

bool is_mesh_pair_swapped(const Mesh& a, const Pose& X_WA, const Mesh& b, const Pose& X_WB) {
  RIGOR_ASSERT(a.mesh != nullptr && b.mesh != nullptr);
  const int order = compare_meshes(a, b);
  if (order != 0) return order > 0;
  const auto place = [](const Pose& X) { return std::span<const double>(X.p.data(), 3); };
  const auto turn = [](const Pose& X) { return std::span<const double>(X.R.data(), 9); };
  const int places = compare(place(X_WA), place(X_WB));
  return places != 0 ? places > 0 : compare(turn(X_WA), turn(X_WB)) > 0;
}

}  // namespace rigor
