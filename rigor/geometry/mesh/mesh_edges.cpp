#include "rigor/geometry/mesh/mesh_edges.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace rigor {
namespace {

/// Two triangles form one flat piece if each corner of one lies in the plane of the other, up to this part of
/// their size. It is more than the rounding of coordinates in single precision, as mesh files hold them.
constexpr double kFlatness = 1e-7;

/// One side of one triangle, identified by its end vertices in ascending order.
struct Side {
  int low, high;
  int triangle;
  int k;  ///< From corner k to corner k + 1.
};

const Vec3& corner(const TriangleMesh& mesh, int triangle, int k) {
  const std::array<int, 3>& t = mesh.triangles[at(triangle)];
  return mesh.vertices[at(t[at(k % 3)])];
}

int corner_index(const TriangleMesh& mesh, int triangle, int k) {
  return mesh.triangles[at(triangle)][at(k % 3)];
}

double longest_side(const TriangleMesh& mesh, int t) {
  double length = 0;
  for (int k = 0; k < 3; ++k) length = std::max(length, (corner(mesh, t, k + 1) - corner(mesh, t, k)).norm());
  return length;
}

/// Unit normal; zero where the height over the longest side is lost in the rounding of the sides.
Vec3 triangle_normal(const TriangleMesh& mesh, int t) {
  const Vec3 n = (corner(mesh, t, 1) - corner(mesh, t, 0)).cross(corner(mesh, t, 2) - corner(mesh, t, 0));
  const double length = longest_side(mesh, t);
  const double area = n.norm();
  if (!(area > 1e-14 * length * length)) return Vec3::Zero();
  return n / area;
}

/// All sides, sorted so that those between the same two vertices follow each other.
std::vector<Side> sorted_sides(const TriangleMesh& mesh) {
  std::vector<Side> sides;
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    for (int k = 0; k < 3; ++k) {
      const int a = corner_index(mesh, t, k), b = corner_index(mesh, t, k + 1);
      sides.push_back({std::min(a, b), std::max(a, b), t, k});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& x, const Side& y) {
    return std::tie(x.low, x.high, x.triangle, x.k) < std::tie(y.low, y.high, y.triangle, y.k);
  });
  return sides;
}

/// The kind of the edge that two triangles share.
MeshEdgeKind edge_kind(const TriangleMesh& mesh, const TriangleTree& tree, const Side& a, const Side& b) {
  const Vec3& n_a = tree.triangles[at(a.triangle)].normal;
  const Vec3& n_b = tree.triangles[at(b.triangle)].normal;
  if (n_a.isZero(0) || n_b.isZero(0)) return MeshEdgeKind::boundary;
  // Heights of the two opposite corners over the plane of the other triangle: negative where the surface
  // bends away. Their sum decides, as one of the two may be rounding.
  const Vec3& p = corner(mesh, a.triangle, a.k);
  const double rise_b = n_a.dot(corner(mesh, b.triangle, b.k + 2) - p);
  const double rise_a = n_b.dot(corner(mesh, a.triangle, a.k + 2) - p);
  const double size = std::max(longest_side(mesh, a.triangle), longest_side(mesh, b.triangle));
  // Coplanar triangles are flat only if they face alike; folded onto each other they are a convex or concave
  // edge.
  const bool is_flat = std::max(std::abs(rise_a), std::abs(rise_b)) <= kFlatness * size;
  if (is_flat && n_a.dot(n_b) > 0) return MeshEdgeKind::flat;
  return rise_a + rise_b < 0 ? MeshEdgeKind::convex : MeshEdgeKind::concave;
}

/// Links the triangles across their edges and classifies these.
void find_neighbours(const TriangleMesh& mesh, TriangleTree& tree) {
  const std::vector<Side> sides = sorted_sides(mesh);
  tree.is_closed = !sides.empty();
  for (TriangleTree::Triangle& t : tree.triangles) t.neighbour = {-1, -1, -1};
  for (std::size_t first = 0, last = 0; first < sides.size(); first = last) {
    while (last < sides.size() && sides[last].low == sides[first].low &&
           sides[last].high == sides[first].high)
      ++last;
    // An orientable surface has exactly two triangles at an edge, which run through it in opposite
    // directions. Any other edge stays a boundary and leaves the mesh open.
    const Side& a = sides[first];
    const bool is_pair = last - first == 2;
    const bool runs_both_ways =
        is_pair && corner_index(mesh, a.triangle, a.k) !=
                       corner_index(mesh, sides[first + 1].triangle, sides[first + 1].k);
    if (!runs_both_ways) {
      tree.is_closed = false;
      continue;
    }
    const Side& b = sides[first + 1];
    const MeshEdgeKind kind = edge_kind(mesh, tree, a, b);
    for (const auto& [side, other] : {std::pair(a, b), std::pair(b, a)}) {
      TriangleTree::Triangle& t = tree.triangles[at(side.triangle)];
      t.neighbour[at(side.k)] = other.triangle;
      t.edge[at(side.k)] = kind;
    }
  }
}

/// Finds the flat patches by flooding across flat edges; each is named by its least triangle index.
void find_patches(TriangleTree& tree) {
  for (TriangleTree::Triangle& t : tree.triangles) t.patch = -1;
  std::vector<int> todo;
  for (int seed = 0; seed < static_cast<int>(tree.triangles.size()); ++seed) {
    if (tree.triangles[at(seed)].patch >= 0) continue;
    todo.push_back(seed);
    tree.triangles[at(seed)].patch = seed;
    while (!todo.empty()) {
      const TriangleTree::Triangle& t = tree.triangles[at(todo.back())];
      todo.pop_back();
      for (std::size_t k = 0; k < 3; ++k) {
        if (t.edge[k] != MeshEdgeKind::flat) continue;
        TriangleTree::Triangle& next = tree.triangles[at(t.neighbour[k])];
        if (next.patch >= 0) continue;
        next.patch = seed;
        todo.push_back(t.neighbour[k]);
      }
    }
  }
}

void find_patch_areas(const TriangleMesh& mesh, TriangleTree& tree) {
  tree.patch_areas.assign(mesh.triangles.size(), 0.0);
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    const Vec3 n = (corner(mesh, t, 1) - corner(mesh, t, 0)).cross(corner(mesh, t, 2) - corner(mesh, t, 0));
    const int patch = tree.triangles[at(t)].patch;
    tree.patch_areas[at(patch)] += 0.5 * n.norm();
  }
}

/// Finds one vertex of each shell, by flooding across all edges from each triangle that was not seen before.
void find_shell_vertices(const TriangleMesh& mesh, TriangleTree& tree) {
  tree.shell_vertices.clear();
  std::vector<bool> is_seen(mesh.triangles.size(), false);
  std::vector<int> todo;
  for (int seed = 0; seed < static_cast<int>(mesh.triangles.size()); ++seed) {
    if (is_seen[at(seed)]) continue;
    tree.shell_vertices.push_back(corner_index(mesh, seed, 0));
    is_seen[at(seed)] = true;
    todo.push_back(seed);
    while (!todo.empty()) {
      const int t = todo.back();
      todo.pop_back();
      for (const int next : tree.triangles[at(t)].neighbour) {
        if (next < 0 || is_seen[at(next)]) continue;
        is_seen[at(next)] = true;
        todo.push_back(next);
      }
    }
  }
}

/// Whether the creases at a vertex, given by their directions away from it, form a corner. They do not if
/// there are none, or two that make one straight line.
bool is_corner(const std::vector<Vec3>& creases) {
  if (creases.empty()) return false;
  if (creases.size() != 2) return true;
  return creases[0].cross(creases[1]).norm() > kFlatness || creases[0].dot(creases[1]) > 0;
}

/// Unit directions of the creases at vertex v, in triangles of the patch (or all if patch is -1). A crease
/// between two triangles of the set counts once.
std::vector<Vec3> creases_at(const TriangleMesh& mesh, const TriangleTree& tree, int v, int patch) {
  std::vector<std::pair<int, Vec3>> creases;
  for (const int t : tree.vertex_triangles[at(v)]) {
    const TriangleTree::Triangle& triangle = tree.triangles[at(t)];
    // Edges of the triangle that leave the vertex and are not flat. Both triangles of a crease name it; the
    // far end tells it apart.
    if (patch >= 0 && triangle.patch != patch) continue;
    for (int k = 0; k < 3; ++k) {
      const int a = corner_index(mesh, t, k), b = corner_index(mesh, t, k + 1);
      if ((a != v && b != v) || triangle.edge[at(k)] == MeshEdgeKind::flat) continue;
      const int far = a == v ? b : a;
      const Vec3 along = mesh.vertices[at(far)] - mesh.vertices[at(v)];
      const bool is_known =
          std::any_of(creases.begin(), creases.end(), [far](const auto& c) { return c.first == far; });
      if (!is_known) creases.emplace_back(far, along.normalized());
    }
  }
  std::vector<Vec3> directions;
  directions.reserve(creases.size());
  for (const auto& [far, along] : creases) directions.push_back(along);
  return directions;
}

/// Collects the triangles about each vertex, and its pseudonormal: the sum of their normals weighted by their
/// angles, which gives the sign of a distance whatever the triangulation (Bærentzen and Aanæs 2005).
void find_vertices(const TriangleMesh& mesh, TriangleTree& tree) {
  tree.vertex_triangles.assign(mesh.vertices.size(), {});
  tree.vertex_normals.assign(mesh.vertices.size(), Vec3::Zero());
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    const Vec3& normal = tree.triangles[at(t)].normal;
    if (normal.isZero(0)) continue;
    for (int k = 0; k < 3; ++k) {
      const std::size_t v = at(corner_index(mesh, t, k));
      // The angle of the triangle at this corner is its weight.
      const Vec3 a = corner(mesh, t, k + 1) - corner(mesh, t, k);
      const Vec3 b = corner(mesh, t, k + 2) - corner(mesh, t, k);
      tree.vertex_triangles[v].push_back(t);
      tree.vertex_normals[v] += std::atan2(a.cross(b).norm(), a.dot(b)) * normal;
    }
  }
}

/// Marks the corners of the creases of the surface, and those of each flat patch by itself.
void find_corners(const TriangleMesh& mesh, TriangleTree& tree) {
  tree.is_crease_corner.assign(mesh.vertices.size(), false);
  for (int v = 0; v < static_cast<int>(mesh.vertices.size()); ++v) {
    tree.is_crease_corner[at(v)] = is_corner(creases_at(mesh, tree, v, -1));
  }
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    TriangleTree::Triangle& triangle = tree.triangles[at(t)];
    for (int k = 0; k < 3; ++k) {
      const int v = corner_index(mesh, t, k);
      triangle.is_patch_corner[at(k)] = is_corner(creases_at(mesh, tree, v, triangle.patch));
    }
  }
}

}  // namespace

void find_mesh_edges(const TriangleMesh& mesh, TriangleTree& tree) {
  const int vertex_count = static_cast<int>(mesh.vertices.size());
  tree.triangles.assign(mesh.triangles.size(), {});
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    for (int k = 0; k < 3; ++k) {
      // All later passes rely on valid indices.
      RIGOR_ASSERT(corner_index(mesh, t, k) >= 0 && corner_index(mesh, t, k) < vertex_count);
    }
    tree.triangles[at(t)].normal = triangle_normal(mesh, t);
  }
  // Patches need the kinds of edges, and corners need the patches.
  find_neighbours(mesh, tree);
  find_patches(tree);
  find_patch_areas(mesh, tree);
  find_shell_vertices(mesh, tree);
  find_vertices(mesh, tree);
  find_corners(mesh, tree);
}

}  // namespace rigor
