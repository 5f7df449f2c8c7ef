#include "rigor/geometry/distance/mesh_overlap.hpp"

#include "rigor/core/rounding.hpp"
#include "rigor/geometry/distance/mesh_pair.hpp"
#include "rigor/geometry/distance/mesh_side.hpp"
#include "rigor/geometry/mesh/triangle_pair.hpp"
#include "rigor/geometry/shape/triangle_mesh.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace rigor {
namespace {

/// The shortest translation that separates two triangles that meet.
struct SeparatingTranslation {
  double depth = std::numeric_limits<double>::infinity();  ///< ≥ 0 [m].
  Vec3 n_A;                                                ///< Direction in which B moves, unit.
  Vec3 p_AP;                                               ///< The point of A that loses contact last.
};

/// The separating translations of pairs of triangles of two meshes, both in the frame of A.
class SeparatingTranslations {
 public:
  SeparatingTranslations(const Mesh& a, const Mesh& b, const Pose& X_AB, double rounding)
      : a_(a, X_AA_, rounding), b_(b, X_AB, rounding), pairs_(find_meeting_triangles(a, b, X_AB)) {
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      const auto [t, u] = pairs_[i];
      directions_.push_back(directions_of(t, u));
      for (int k = 0; k < 9; ++k) neighbours_[{a_.vertex_of(t, k / 3), b_.vertex_of(u, k % 3)}].push_back(i);
    }
  }

  SeparatingTranslation deepest() const {
    SeparatingTranslation deepest{-1, Vec3::UnitZ(), Vec3::Zero()};
    for (const auto& [t, u] : pairs_) {
      const SeparatingTranslation translation = separating_translation(t, u);
      if (translation.depth > deepest.depth) deepest = translation;
    }
    deepest.depth = std::max(deepest.depth, 0.0);
    return deepest;
  }

 private:
  /// The shortest translation along the directions of the pair and of those pairs that share a vertex of both
  /// meshes with it. Near an edge the right direction is often that of a neighbouring pair.
  SeparatingTranslation separating_translation(int t, int u) const {
    std::set<std::size_t> near;
    for (int k = 0; k < 9; ++k) {
      const auto& others = neighbours_.at({a_.vertex_of(t, k / 3), b_.vertex_of(u, k % 3)});
      near.insert(others.begin(), others.end());
    }
    const TriangleCorners a = {a_.corner(t, 0), a_.corner(t, 1), a_.corner(t, 2)};
    const TriangleCorners b = {b_.corner(u, 0), b_.corner(u, 1), b_.corner(u, 2)};
    SeparatingTranslation best;
    for (const std::size_t other : near) {
      for (const Direction& direction : directions_[other]) consider(direction, a, b, best);
    }
    return best;
  }

  /// A direction, and the features that decide where along it the bodies lose contact last.
  struct Direction {
    Vec3 n;
    int edge_A = -1, edge_B = -1;  ///< The edges whose common normal it is, or
    bool is_normal_of_A = false;   ///< the face.
  };

  void consider(const Direction& direction, const TriangleCorners& a, const TriangleCorners& b,
                SeparatingTranslation& best) const {
    // The triangles are separated along n when the lowest corner of B is past the highest one of A.
    const Vec3& n = direction.n;
    const auto lower = [&n](const Vec3& p, const Vec3& q) { return n.dot(p) < n.dot(q); };
    const Vec3 p = *std::max_element(a.begin(), a.end(), lower);
    const Vec3 q = *std::min_element(b.begin(), b.end(), lower);
    const double depth = n.dot(p - q);
    if (depth >= best.depth) return;
    best = {depth, n, p};
    if (direction.is_normal_of_A) best.p_AP = q + depth * n;
    if (direction.edge_A >= 0) best.p_AP = point_on_edge(direction.edge_A, direction.edge_B, n);
  }

  /// The point of an edge of A that lies over an edge of B along their common normal.
  Vec3 point_on_edge(int edge_A, int edge_B, const Vec3& n) const {
    const Vec3 a = a_.corner(edge_A / 3, edge_A % 3), b = b_.corner(edge_B / 3, edge_B % 3);
    const Vec3 along_A = a_.corner(edge_A / 3, edge_A % 3 + 1) - a;
    const Vec3 along_B = b_.corner(edge_B / 3, edge_B % 3 + 1) - b;
    const double place = (b - a).cross(along_B).dot(n) / along_A.cross(along_B).dot(n);
    return a + std::clamp(place, 0.0, 1.0) * along_A;
  }

  /// The normals of the two faces, and the common normals of two edges from which both surfaces bend away.
  std::vector<Direction> directions_of(int t, int u) const {
    std::vector<Direction> directions = {{a_.normal(t), -1, -1, true}, {-b_.normal(u)}};
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) add_directions_of_edges(3 * t + i, 3 * u + k, directions);
    }
    return directions;
  }

  void add_directions_of_edges(int edge_A, int edge_B, std::vector<Direction>& directions) const {
    const int t = edge_A / 3, i = edge_A % 3, u = edge_B / 3, k = edge_B % 3;
    if (!a_.is_edge(t, i) || !b_.is_edge(u, k)) return;
    // Parallel edges have no common normal of their own.
    const Vec3 side_A = a_.corner(t, i + 1) - a_.corner(t, i), side_B = b_.corner(u, k + 1) - b_.corner(u, k);
    const Vec3 across = side_A.cross(side_B);
    if (across.norm() <= 1e-9 * side_A.norm() * side_B.norm()) return;
    for (const double sign : {-1.0, 1.0}) {
      const Vec3 n = sign * across.normalized();
      if (a_.falls_away_at_edge(edge_A, n) && b_.falls_away_at_edge(edge_B, -n))
        directions.push_back({n, edge_A, edge_B});
    }
  }

  const Pose X_AA_;
  const MeshSide a_, b_;
  const std::vector<std::array<int, 2>> pairs_;
  std::vector<std::vector<Direction>> directions_;                      ///< Of each pair.
  std::map<std::pair<int, int>, std::vector<std::size_t>> neighbours_;  ///< Pairs with these vertices.
};

/// Largest height of a vertex along n.
double top(const Mesh& mesh, const Pose& X, const Vec3& n) {
  double height = -std::numeric_limits<double>::infinity();
  const Vec3 n_M = X.R.transpose() * n;
  for (const Vec3& vertex : mesh.mesh->vertices) height = std::max(height, n_M.dot(vertex));
  return height + n.dot(X.p);
}

double rounding_of(const Mesh& a, const Mesh& b, const Pose& X_AB) {
  const auto reach = [](const OrientedBox& box) { return box.center.norm() + box.half.norm(); };
  return 32 * kEpsilon * (reach(a.tree->wide.root) + reach(b.tree->wide.root) + X_AB.p.norm());
}

}  // namespace

DistanceResult overlap_distance(const Mesh& a, const Pose& X_WA, const Mesh& b, const Pose& X_WB) {
  const Pose X_AB = relative_pose(X_WA, X_WB);
  const double rounding = rounding_of(a, b, X_AB);
  // The measure of the overlap: the deepest of the pairs that meet.
  const SeparatingTranslation deepest = SeparatingTranslations(a, b, X_AB, rounding).deepest();
  const double depth = deepest.depth;
  const Vec3 n_W = X_WA.R * deepest.n_A;
  // Along the same direction the bodies as a whole separate when the lowest vertex of B is past the highest
  // one of A: a translation that certainly suffices, so that its negative bounds the distance from below.
  const double apart = top(a, Pose{}, deepest.n_A) + top(b, X_AB, -deepest.n_A);
  const Vec3 p_WA = X_WA * deepest.p_AP;
  return {-depth, -std::max(depth, apart) - rounding, rounding, p_WA, p_WA - depth * n_W, n_W};
}

DistanceResult enclosed_distance(const Mesh& a, const Pose& X_WA, const Vec3& p_WA, const Vec3& p_WB) {
  // A moves out along the line of the nearest points until its rearmost vertex is past the point of B.
  const Vec3 out_W = (p_WB - p_WA).stableNormalized();
  const double depth = out_W.dot(p_WB - X_WA.p) + top(a, {X_WA.R, Vec3::Zero()}, -out_W);
  const double rounding = 32 * kEpsilon * (p_WA.norm() + p_WB.norm() + depth);
  const Vec3 p_WP = p_WB - depth * out_W;
  return {-depth, -depth - rounding, rounding, p_WP, p_WB, -out_W};
}

}  // namespace rigor
