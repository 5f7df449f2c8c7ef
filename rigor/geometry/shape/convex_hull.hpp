#pragma once

#include "rigor/geometry/shape/feature_graph.hpp"
#include "rigor/geometry/shape/support_table.hpp"
#include "rigor/math/types.hpp"

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace rigor {

/// Convex polyhedron with its full adjacency. Faces are polygons (coplanar triangles merged),
/// counter-clockwise seen from outside.
struct ConvexHull {
  /// An edge between two vertices and two faces.
  struct Edge {
    /// Its vertices, by index.
    int v0, v1;  ///< Vertices; the edge runs v0 -> v1 in the loop of face f0 and v1 -> v0 in that of f1.
    /// Its faces, by index.
    int f0, f1;  ///< The two faces.
  };
  std::vector<Vec3> vertices;                       ///< Extreme points only [m].
  std::vector<std::vector<int>> faces;              ///< Vertex loops.
  std::vector<Vec3> face_normals;                   ///< Outward unit normals, one a face.
  std::vector<Edge> edges;                          ///< Each undirected edge once.
  std::vector<std::vector<int>> vertex_neighbours;  ///< For each vertex the vertices it shares an edge with.
  SupportTable support_table;                       ///< Of the vertices: made anew when they change.
  FeatureGraph features;  ///< The same adjacency, in order and in flat arrays, for walks over features.
  double extent = 0;      ///< No vertex is farther from the origin [m].
};

/// Hull of the points by qhull, or the reason why there is none (fewer than 4 points, all in one plane or
/// line, not finite, ...), ready to be put behind "body 'x': ".
std::variant<ConvexHull, std::string> make_convex_hull(const std::vector<Vec3>& points);

/// Polyhedron of known faces: vertex loops as indices of the points, counter-clockwise seen from outside. The
/// caller knows that it is convex; nothing if the faces do not close.
std::optional<ConvexHull> make_hull_of_faces(const std::vector<Vec3>& points,
                                             std::vector<std::vector<int>> faces);

/// Box as a hull, vertices in the order of the sign bits (x lowest); never fails for positive half extents.
ConvexHull make_box_hull(const Vec3& half_extents);

}  // namespace rigor
