#include "rigor/geometry/mesh/mesh_faces.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/rounding.hpp"
#include "rigor/geometry/shape/convex_hull.hpp"
#include "rigor/math/rotation.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <tuple>

namespace rigor {
namespace {

/// Corners of a face lie in its plane, and its sides turn the right way, up to this part of its size: as two
/// triangles that count as coplanar (mesh_edges.cpp).
constexpr double kFaceFlatness = 1e-7;

/// One side of a triangle on the border of its patch.
struct BorderSide {
  int to;      ///< Vertex at its end.
  int number;  ///< Of the edge: 3 t + k of the lower of its triangles.
};

/// The border of a patch as one loop of the vertices where creases end, bend or meet; nothing if it has
/// several loops or touches itself.
std::optional<MeshFace> border_loop(const TriangleMesh& mesh, const TriangleTree& tree,
                                    const std::vector<int>& triangles) {
  // The sides of the border by the vertex where they begin.
  std::map<int, BorderSide> sides;
  for (const int t : triangles) {
    for (int k = 0; k < 3; ++k) {
      if (tree.triangles[at(t)].edge[at(k)] == MeshEdgeKind::flat) continue;
      const std::array<int, 3>& corners = mesh.triangles[at(t)];
      const BorderSide side{corners[at((k + 1) % 3)], edge_number(mesh, tree, t, k)};
      if (!sides.emplace(corners[at(k)], side).second) return std::nullopt;
    }
  }
  // Once around from a corner; sides between two corners are one edge with the least of their numbers.
  const auto first =
      std::ranges::find_if(sides, [&](const auto& s) { return tree.is_crease_corner[at(s.first)]; });
  if (first == sides.end()) return std::nullopt;
  MeshFace face;
  std::size_t seen = 0;
  int v = first->first;
  do {
    const auto side = sides.find(v);
    if (side == sides.end() || ++seen > sides.size()) return std::nullopt;
    if (tree.is_crease_corner[at(v)]) {
      face.corners.push_back(v);
      face.edges.push_back(side->second.number);
    } else {
      face.edges.back() = std::min(face.edges.back(), side->second.number);
    }
    v = side->second.to;
  } while (v != first->first);
  if (seen != sides.size() || face.corners.size() < 3) return std::nullopt;
  return face;
}

std::vector<Vec3> corners_of(const TriangleMesh& mesh, const MeshFace& face) {
  std::vector<Vec3> corners;
  for (const int v : face.corners) corners.push_back(mesh.vertices[at(v)]);
  return corners;
}

/// Unit normal of a polygon by the sum over its corners (Newell).
Vec3 polygon_normal(const std::vector<Vec3>& corners) {
  Vec3 twice = Vec3::Zero();
  for (std::size_t k = 1; k + 1 < corners.size(); ++k)
    twice += (corners[k] - corners[0]).cross(corners[k + 1] - corners[0]);
  return twice.stableNormalized();
}

/// Marks the corners where the border turns; false if it is not convex or turns more than once.
bool finish_convex(const TriangleMesh& mesh, const TriangleTree& tree, MeshFace& face) {
  const std::size_t count = face.corners.size();
  const auto corner = [&](std::size_t k) -> const Vec3& {
    return mesh.vertices[at(face.corners[k % count])];
  };
  face.normal = polygon_normal(corners_of(mesh, face));
  if (face.normal.dot(tree.triangles[at(face.patch)].normal) < 0.5) return false;

  double turned = 0;
  face.is_corner.clear();
  for (std::size_t k = 0; k < count; ++k) {
    const Vec3 before = (corner(k) - corner(k + count - 1)).stableNormalized();
    const Vec3 after = (corner(k + 1) - corner(k)).stableNormalized();
    const double angle = std::atan2(face.normal.dot(before.cross(after)), before.dot(after));
    if (angle < -kFaceFlatness) return false;
    turned += angle;
    face.is_corner.push_back(angle > kFaceFlatness);
  }
  return std::abs(turned - 2 * std::numbers::pi) < 1e-3;
}

/// The largest height of a vertex of the triangles over or under the plane through p [m].
double unevenness(const TriangleMesh& mesh, const Vec3& normal, const Vec3& p,
                  const std::vector<int>& triangles) {
  double height = 0;
  for (const int t : triangles) {
    for (const int v : mesh.triangles[at(t)])
      height = std::max(height, std::abs(normal.dot(mesh.vertices[at(v)] - p)));
  }
  return height;
}

double longest_side(const std::vector<Vec3>& corners) {
  Aabb box{corners.front(), corners.front()};
  for (const Vec3& p : corners) box = box.united({p, p});
  return (box.upper - box.lower).maxCoeff();
}

/// Corners of the convex hull of a flat patch, by Andrew's monotone chain in the plane of its first triangle.
std::vector<Vec3> patch_hull(const TriangleMesh& mesh, const TriangleTree& tree,
                             const std::vector<int>& triangles) {
  const Mat3 R = frame_with_z(tree.triangles[at(triangles.front())].normal);
  std::vector<Vec3> points;
  for (const int t : triangles) {
    for (const int v : mesh.triangles[at(t)]) points.push_back(R.transpose() * mesh.vertices[at(v)]);
  }
  std::ranges::sort(
      points, [](const Vec3& p, const Vec3& q) { return std::tie(p.x(), p.y()) < std::tie(q.x(), q.y()); });
  // The lower side from left to right, then the upper one back.
  std::vector<Vec3> hull;
  for (const bool is_lower : {true, false}) {
    const std::size_t start = hull.size();
    for (const Vec3& p : points) {
      const auto turns_right = [&] {
        const Vec3 u = hull.back() - hull[hull.size() - 2], v = p - hull.back();
        return u.x() * v.y() - u.y() * v.x() <= 0;
      };
      while (hull.size() >= start + 2 && turns_right()) hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    if (is_lower) std::ranges::reverse(points);
  }
  for (Vec3& p : hull) p = R * p;
  return hull;
}

MeshPatch other_patch(const TriangleMesh& mesh, const TriangleTree& tree, const std::vector<int>& triangles) {
  MeshPatch patch{.hull = patch_hull(mesh, tree, triangles)};
  if (patch.hull.size() < 3) return patch;
  patch.normal = polygon_normal(patch.hull);
  patch.is_flat = unevenness(mesh, patch.normal, patch.hull.front(), triangles) <=
                  kFaceFlatness * longest_side(patch.hull);
  return patch;
}

/// Sides of the border between two corners are one straight edge with the least of their numbers, as those of
/// a face are. Where the border touches itself each side is by itself.
void note_straight_edges(const TriangleMesh& mesh, const std::vector<int>& triangles, TriangleTree& tree) {
  std::multimap<int, BorderSide> sides;
  for (const int t : triangles) {
    for (int k = 0; k < 3; ++k) {
      if (tree.triangles[at(t)].edge[at(k)] == MeshEdgeKind::flat) continue;
      const std::array<int, 3>& corners = mesh.triangles[at(t)];
      sides.emplace(corners[at(k)], BorderSide{corners[at((k + 1) % 3)], edge_number(mesh, tree, t, k)});
    }
  }
  for (const auto& [start, first] : sides) {
    if (!tree.is_crease_corner[at(start)]) continue;
    // From this corner to the next one.
    std::vector<int> numbers{first.number};
    for (int v = first.to; !tree.is_crease_corner[at(v)] && sides.count(v) == 1;) {
      // Of surfaces that are not orientable, borders need not come to a corner.
      if (numbers.size() > sides.size()) break;
      const BorderSide& side = sides.find(v)->second;
      numbers.push_back(side.number);
      v = side.to;
    }
    const int least = *std::ranges::min_element(numbers);
    for (const int number : numbers) {
      if (number != least) tree.straight_edges[number] = least;
    }
  }
}

/// Whether the angles of the triangles at each vertex sum to less than 2π, so that faces with convex edges
/// between them form a convex cone there.
bool has_convex_corners(const TriangleMesh& mesh, const TriangleTree& tree) {
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    if (!tree.is_crease_corner[v]) continue;
    double sum = 0;
    for (const int t : tree.vertex_triangles[v]) {
      const std::array<int, 3>& corners = mesh.triangles[at(t)];
      const std::size_t k =
          at(static_cast<int>(std::ranges::find(corners, static_cast<int>(v)) - corners.begin()));
      const Vec3 a = mesh.vertices[at(corners[(k + 1) % 3])] - mesh.vertices[v];
      const Vec3 b = mesh.vertices[at(corners[(k + 2) % 3])] - mesh.vertices[v];
      sum += std::atan2(a.cross(b).norm(), a.dot(b));
    }
    if (sum >= 2 * std::numbers::pi) return false;
  }
  return true;
}

bool has_only_convex_edges(const TriangleTree& tree) {
  return std::ranges::all_of(tree.triangles, [](const TriangleTree::Triangle& t) {
    return std::ranges::all_of(
        t.edge, [](MeshEdgeKind kind) { return kind == MeshEdgeKind::flat || kind == MeshEdgeKind::convex; });
  });
}

}  // namespace

void find_mesh_faces(const TriangleMesh& mesh, TriangleTree& tree) {
  // The triangles of each patch, which is named by its least triangle.
  std::vector<std::vector<int>> patches(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    patches[at(tree.triangles[t].patch)].push_back(static_cast<int>(t));

  tree.faces.clear();
  tree.face_of_patch.assign(mesh.triangles.size(), -1);
  tree.other_patches.clear();
  tree.other_of_patch.assign(mesh.triangles.size(), -1);
  tree.straight_edges.clear();
  bool may_be_convex = tree.is_closed && tree.shell_vertices.size() == 1 && has_only_convex_edges(tree);
  std::vector<std::vector<int>> loops;
  double uneven = 0;
  for (std::size_t patch = 0; patch < patches.size(); ++patch) {
    const std::vector<int>& triangles = patches[patch];
    const bool is_single = triangles.size() == 1;
    if (triangles.empty() || (is_single && !may_be_convex)) continue;
    if (tree.triangles[patch].normal.isZero(0)) continue;
    // A patch of several triangles becomes a face if its border is a convex polygon and it is flat as a
    // whole.
    std::optional<MeshFace> face = border_loop(mesh, tree, triangles);
    if (face) face->patch = static_cast<int>(patch);
    const auto height = [&] {
      return unevenness(mesh, face->normal, mesh.vertices[at(face->corners.front())], triangles);
    };
    const bool is_face = face && finish_convex(mesh, tree, *face) &&
                         height() <= kFaceFlatness * longest_side(corners_of(mesh, *face));
    if (!is_face) {
      may_be_convex = false;
      if (is_single) continue;
      tree.other_of_patch[patch] = static_cast<int>(tree.other_patches.size());
      tree.other_patches.push_back(other_patch(mesh, tree, triangles));
      note_straight_edges(mesh, triangles, tree);
      continue;
    }
    if (may_be_convex) loops.push_back(face->corners);
    uneven = std::max(uneven, height());
    if (is_single) continue;
    tree.face_of_patch[patch] = static_cast<int>(tree.faces.size());
    tree.faces.push_back(std::move(*face));
  }

  if (!may_be_convex || loops.empty() || !has_convex_corners(mesh, tree)) return;
  std::optional<ConvexHull> hull = make_hull_of_faces(mesh.vertices, std::move(loops));
  if (!hull) return;
  tree.convex = std::make_shared<const Shape>(Convex{std::make_shared<const ConvexHull>(std::move(*hull))});
  tree.convex_error = uneven > 16 * kEpsilon * tree.size ? uneven : 0;
}

}  // namespace rigor
