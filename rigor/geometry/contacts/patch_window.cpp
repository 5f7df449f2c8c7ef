#include "rigor/geometry/contacts/patch_window.hpp"

#include "rigor/core/index.hpp"
#include "rigor/geometry/mesh/triangle_tree.hpp"
#include "rigor/geometry/shape/aabb.hpp"
#include "rigor/geometry/shape/triangle_mesh.hpp"
#include "rigor/math/rotation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace rigor {
namespace {

/// Areas and turns that differ by less, in parts of the window, differ by rounding.
constexpr double kRounding = 1e-9;
/// A border that turns by less is straight, as that of a face (mesh_faces.cpp).
constexpr double kStraight = 1e-7;

double cross(const Vec2& u, const Vec2& v) {
  return u.x() * v.y() - u.y() * v.x();
}

double area_of(const std::vector<Vec2>& polygon) {
  double twice = 0;
  for (std::size_t k = 2; k < polygon.size(); ++k)
    twice += cross(polygon[k - 1] - polygon[0], polygon[k] - polygon[0]);
  return 0.5 * twice;
}

/// A rectangle in the plane of a patch, with the coordinates there.
struct Window {
  Mat3 R_MP;      ///< Axes of the plane; z is the normal.
  Vec3 origin_M;  ///< A point of the plane.
  Vec2 lower, upper;

  Vec2 in_plane(const Vec3& p_M) const { return (R_MP.transpose() * (p_M - origin_M)).head<2>(); }
  Vec3 in_mesh(const Vec2& p) const { return origin_M + R_MP.leftCols<2>() * p; }
  std::array<Vec2, 4> corners() const {
    return {lower, Vec2(upper.x(), lower.y()), upper, Vec2(lower.x(), upper.y())};
  }
  double area() const { return (upper - lower).prod(); }
};

/// The rectangle about the shape.
Window window_about(const ContactShape& shape, const Pose& X_OM, const MeshPatch& patch, double reach) {
  Window window{frame_with_z(patch.normal), patch.hull.front(), Vec2::Zero(), Vec2::Zero()};
  // How far the shape extends along the axes of the plane, and below it.
  const Pose X_MO = X_OM.inverse();
  const auto extent = [&](const Vec3& axis_M) {
    return axis_M.dot(X_MO * shape.support(X_OM.R * axis_M) - window.origin_M);
  };
  for (int k = 0; k < 2; ++k) {
    window.upper[k] = extent(window.R_MP.col(k));
    window.lower[k] = -extent(-window.R_MP.col(k));
  }
  const double depth = std::max(0.0, extent(-patch.normal));
  const double margin = depth + reach + 0.01 * (window.upper - window.lower).maxCoeff();
  window.lower.array() -= margin;
  window.upper.array() += margin;
  return window;
}

/// Triangles of the patch that may reach into the window.
std::vector<int> triangles_in(const Window& window, const TriangleTree& tree, int patch) {
  const Vec3 first = window.in_mesh(window.corners().front());
  Aabb box{first, first};
  for (const Vec2& p : window.corners()) box = box.united({window.in_mesh(p), window.in_mesh(p)});
  std::vector<int> triangles = tree.overlapping(box.grown(kStraight * tree.size));
  std::erase_if(triangles, [&](int t) { return tree.triangles[at(t)].patch != patch; });
  return triangles;
}

/// The polygon cut off at the four sides of the window (Sutherland and Hodgman).
std::vector<Vec2> clipped(std::vector<Vec2> polygon, const Window& window) {
  for (const int axis : {0, 1}) {
    for (const double sign : {-1.0, 1.0}) {
      const double limit = sign < 0 ? -window.lower[axis] : window.upper[axis];
      const auto beyond = [&](const Vec2& p) { return sign * p[axis] - limit; };
      std::vector<Vec2> kept;
      for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vec2 &p = polygon[k], &q = polygon[(k + 1) % polygon.size()];
        const double b_p = beyond(p), b_q = beyond(q);
        if (b_p <= 0) kept.push_back(p);
        if ((b_p < 0 && b_q > 0) || (b_p > 0 && b_q < 0)) kept.push_back(p + b_p / (b_p - b_q) * (q - p));
      }
      polygon = std::move(kept);
    }
  }
  return polygon;
}

/// A side of the border of the patch, as far as it lies in the window.
struct BorderPiece {
  Vec2 from, to;
  int vertex_from, vertex_to;  ///< Of the mesh; -1 where the window cuts the side.
  int edge;
};

/// The part of a side in the window (Liang and Barsky); nothing if it only touches it.
std::optional<BorderPiece> piece_in(const Window& window, const BorderPiece& side) {
  double enters = 0, leaves = 1;
  const Vec2 along = side.to - side.from;
  for (const int axis : {0, 1}) {
    for (const double sign : {-1.0, 1.0}) {
      const double limit = sign < 0 ? -window.lower[axis] : window.upper[axis];
      const double speed = sign * along[axis], left = limit - sign * side.from[axis];
      if (speed == 0 && left <= 0) return {};
      if (speed > 0) leaves = std::min(leaves, left / speed);
      if (speed < 0) enters = std::max(enters, left / speed);
    }
  }
  if (enters >= leaves) return {};
  BorderPiece piece = side;
  if (enters > 0) piece.from = side.from + enters * along, piece.vertex_from = -1;
  if (leaves < 1) piece.to = side.from + leaves * along, piece.vertex_to = -1;
  return piece;
}

/// A corner of the part of the patch in the window.
struct WindowCorner {
  Vec2 p;
  int vertex;  ///< -1 where the window cuts the border, and at its own corners.
  int edge;    ///< Of the side that begins here.
};

/// Corners of a convex part, counter-clockwise: where pieces of the border begin and leave the window, and
/// the corners of the window that lie inside all of them. Vertices on straight sides are left out.
std::vector<WindowCorner> window_corners(const Window& window, const std::vector<BorderPiece>& pieces,
                                         const TriangleTree& tree) {
  std::vector<WindowCorner> corners;
  const auto begins_at = [&](int vertex) {
    return std::ranges::any_of(pieces, [&](const BorderPiece& piece) { return piece.vertex_from == vertex; });
  };
  for (const BorderPiece& piece : pieces) {
    const bool is_straight = piece.vertex_from >= 0 && !tree.is_crease_corner[at(piece.vertex_from)];
    if (!is_straight) corners.push_back({piece.from, piece.vertex_from, piece.edge});
    if (piece.vertex_to < 0 || !begins_at(piece.vertex_to))
      corners.push_back({piece.to, piece.vertex_to, kNoMeshEdge});
  }
  for (const Vec2& p : window.corners()) {
    const bool is_inside = std::ranges::all_of(
        pieces, [&](const BorderPiece& piece) { return cross(piece.to - piece.from, p - piece.from) > 0; });
    if (is_inside) corners.push_back({p, -1, kNoMeshEdge});
  }
  // Around their mean, which is inside.
  Vec2 mean = Vec2::Zero();
  for (const WindowCorner& corner : corners) mean += corner.p / static_cast<double>(corners.size());
  const auto angle = [&](const WindowCorner& corner) {
    return std::atan2(corner.p.y() - mean.y(), corner.p.x() - mean.x());
  };
  std::ranges::sort(corners, {}, angle);
  return corners;
}

}  // namespace

std::optional<MeshFacet> patch_window(const Mesh& mesh, int patch, const Pose& X_OM,
                                      const ContactShape& shape, double reach) {
  const TriangleTree& tree = *mesh.tree;
  const int index = tree.other_of_patch[at(patch)];
  if (index < 0 || !tree.other_patches[at(index)].is_flat) return {};
  const MeshPatch& whole = tree.other_patches[at(index)];
  const Window window = window_about(shape, X_OM, whole, reach);

  // The area of the patch in the window, and the pieces of its border there.
  double area = 0;
  std::vector<BorderPiece> pieces;
  for (const int t : triangles_in(window, tree, patch)) {
    const std::array<int, 3>& vertices = mesh.mesh->triangles[at(t)];
    std::array<Vec2, 3> p;
    std::ranges::transform(vertices, p.begin(),
                           [&](int v) { return window.in_plane(mesh.mesh->vertices[at(v)]); });
    area += area_of(clipped({p.begin(), p.end()}, window));
    for (std::size_t k = 0; k < 3; ++k) {
      if (tree.triangles[at(t)].edge[k] == MeshEdgeKind::flat) continue;
      const std::size_t next = (k + 1) % 3;
      const int number = edge_number(*mesh.mesh, tree, t, static_cast<int>(k));
      const auto straight = tree.straight_edges.find(number);
      const int edge = straight == tree.straight_edges.end() ? number : straight->second;
      const auto piece = piece_in(window, {p[k], p[next], vertices[k], vertices[next], edge});
      if (piece) pieces.push_back(*piece);
    }
  }

  // The patch is convex there if it fills the polygon of its corners, and that turns to the left everywhere.
  const std::vector<WindowCorner> corners = window_corners(window, pieces, tree);
  if (corners.size() < 3) return {};
  std::vector<Vec2> polygon(corners.size());
  std::ranges::transform(corners, polygon.begin(), &WindowCorner::p);
  if (std::abs(area_of(polygon) - area) > kRounding * window.area()) return {};

  MeshFacet facet{.corners = {},
                  .normal = whole.normal,
                  .vertices = {},
                  .edges = {},
                  .corner_is_real = {},
                  .edge_is_real = {},
                  .patch = patch,
                  .patch_area = tree.patch_areas[at(patch)]};
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vec2 before = polygon[k] - polygon[(k + corners.size() - 1) % corners.size()];
    const Vec2 after = polygon[(k + 1) % corners.size()] - polygon[k];
    const double turn = std::atan2(cross(before, after), before.dot(after));
    if (turn < -kStraight) return {};
    const int vertex = corners[k].vertex;
    facet.corners.push_back(vertex < 0 ? window.in_mesh(polygon[k]) : mesh.mesh->vertices[at(vertex)]);
    facet.vertices.push_back(std::max(vertex, 0));
    facet.edges.push_back(corners[k].edge);
    facet.corner_is_real.push_back(vertex >= 0 && turn > kStraight);
    facet.edge_is_real.push_back(corners[k].edge != kNoMeshEdge);
  }
  return facet;
}

}  // namespace rigor
