#include "rigor/geometry/distance/mesh_pair_distance.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"
#include "rigor/core/rounding.hpp"
#include "rigor/geometry/decomposition/pieces_distance.hpp"
#include "rigor/geometry/distance/mesh_overlap.hpp"
#include "rigor/geometry/distance/mesh_pair.hpp"
#include "rigor/geometry/mesh/mesh_point.hpp"
#include "rigor/geometry/mesh/triangle_tree.hpp"
#include "rigor/geometry/shape/triangle_mesh.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <vector>

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

/// The overlap of two closed meshes by their convex pieces; nothing if they only touch or have too many.
std::optional<DistanceResult> solid_overlap(const Mesh& a, const Pose& X_WA, const Mesh& b,
                                            const Pose& X_WB) {
  if (!a.tree->is_closed || !b.tree->is_closed) return std::nullopt;
  const PlacedPieces of_a = placed_pieces(a, X_WA);
  if (of_a.empty()) return std::nullopt;
  const PlacedPieces of_b = placed_pieces(b, X_WB);
  if (of_b.empty()) return std::nullopt;
  const DistanceResult found = pieces_distance(of_a, of_b);
  return found.distance < 0 ? std::optional(found) : std::nullopt;
}

/// The overlap of two surfaces that meet, with the length of a translation along its normal that parts them
/// as the lower bound, where that is shorter than the way past all.
DistanceResult surface_overlap(const Mesh& a, const Pose& X_WA, const Mesh& b, const Pose& X_WB) {
  DistanceResult result = overlap_distance(a, X_WA, b, X_WB);
  const Pose X_AB = relative_pose(X_WA, X_WB);
  const Vec3 n_A = X_WA.R.transpose() * result.n_W;
  const double rounding = result.upper;
  const auto moved = [&](double t) { return Pose{X_AB.R, X_AB.p + t * n_A}; };
  const auto height = [&](const Mesh& mesh, const Pose& X, int t, const Vec3& n) {
    double top = -kInfinity;
    for (const int v : mesh.mesh->triangles[at(t)])
      top = std::max(top, n.dot(X * mesh.mesh->vertices[at(v)]));
    return top;
  };
  // Triangles that meet are parted, for good, once that of B is past that of A; that may bring others
  // together.
  double t = 0;
  for (std::vector<std::array<int, 2>> pairs = find_meeting_triangles(a, b, X_AB); !pairs.empty();
       pairs = find_meeting_triangles(a, b, moved(t))) {
    double needed = t;
    for (const auto& [i, k] : pairs)
      needed = std::max(needed, height(a, Pose{}, i, n_A) + height(b, X_AB, k, -n_A));
    t = needed + rounding;
    if (t >= -result.lower) return result;
  }
  const bool is_apart = !is_enclosed(a, b, moved(t).inverse()) && !is_enclosed(b, a, moved(t));
  if (is_apart) result.lower = std::max(result.lower, std::min(result.distance, -t) - rounding);
  return result;
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
  const Vec3 p_WA = X_WA * found.p_AP, p_WB = X_WA * found.p_AQ;
  const bool meet = found.distance == 0, a_is_inside = !meet && is_enclosed(a, b, X_AB.inverse());
  if (meet || a_is_inside || is_enclosed(b, a, X_AB)) {
    if (const std::optional<DistanceResult> solid = solid_overlap(a, X_WA, b, X_WB)) return *solid;
    if (meet) return surface_overlap(a, X_WA, b, X_WB);
    return a_is_inside ? enclosed_distance(a, X_WA, p_WA, p_WB)
                       : exchanged(enclosed_distance(b, X_WB, p_WB, p_WA));
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
  const auto rotation = [](const Pose& X) { return std::span<const double>(X.R.data(), 9); };
  const int places = compare(place(X_WA), place(X_WB));
  return places != 0 ? places > 0 : compare(rotation(X_WA), rotation(X_WB)) > 0;
}

}  // namespace rigor
