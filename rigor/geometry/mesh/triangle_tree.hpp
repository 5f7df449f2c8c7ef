#pragma once

#include "rigor/geometry/mesh/wide_tree.hpp"
#include "rigor/geometry/shape/aabb.hpp"
#include "rigor/geometry/shape/shape.hpp"
#include "rigor/geometry/shape/triangle_mesh.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

namespace rigor {

/// What lies across an edge of a triangle, or around a corner of it.
enum class MeshEdgeKind : std::uint8_t {
  boundary,  ///< No neighbour, or more than one.
  flat,      ///< The neighbour lies in the same plane: not an edge of the surface at all.
  convex,    ///< The surface bends away.
  concave,   ///< The surface bends inwards: nothing convex can touch it there without touching the faces
             ///< first.
};

/// Several coplanar triangles whose border is a convex polygon.
struct MeshFace {
  std::vector<int>
      corners;  ///< Vertices where creases end, bend or meet, counter-clockwise seen from the front.
  std::vector<int> edges;  ///< Number of the edge from corner k to the next: 3 t + k of its lowest triangle.
  std::vector<bool>
      is_corner;               ///< Whether the border turns at corner k, or only another crease begins there.
  Vec3 normal = Vec3::Zero();  ///< Unit, outward.
  int patch = 0;               ///< The patch that it is.
};

/// Several coplanar triangles whose border is no convex polygon: a floor around a pillar.
struct MeshPatch {
  std::vector<Vec3> hull;      ///< Corners of its convex hull, counter-clockwise seen from the front [m].
  Vec3 normal = Vec3::Zero();  ///< Unit, outward.
  bool is_flat = false;        ///< All of it lies in one plane as well as a face does.
};

/// Hierarchy of boxes over the triangles of a mesh, with the kind of each edge and corner that neighbouring
/// triangles form. Immutable once built; everything is in the mesh's frame.
struct TriangleTree {
  struct Node {
    Aabb box;
    int first =
        0;  ///< Leaf: first entry of `order`. Inner node: its right child; the left child is the next node.
    int count = 0;  ///< Triangles of a leaf; 0 for an inner node.
  };
  struct Triangle {
    Vec3 normal = Vec3::Zero();          ///< Unit, outward; zero if the triangle has no area.
    std::array<int, 3> neighbour{};      ///< Triangle across the edge from corner k to k + 1, or -1.
    std::array<MeshEdgeKind, 3> edge{};  ///< The kind of that edge.
    std::array<bool, 3>
        is_patch_corner{};  ///< Corner k is a corner of the flat patch, not on a straight side or inside.
    int patch = 0;          ///< Least index of the triangles joined to this one by flat edges.
  };

  WideTree wide;                     ///< For mesh against mesh.
  std::vector<Node> nodes;           ///< Root first; empty for an empty mesh.
  std::vector<int> order;            ///< Triangle indices, leaf by leaf; those without area are left out.
  std::vector<Triangle> triangles;   ///< One per triangle of the mesh.
  std::vector<Vec3> vertex_normals;  ///< Sums of normals weighted by angle, for the sign of a distance.
  std::vector<std::vector<int>> vertex_triangles;  ///< Triangles at each vertex, ascending.
  std::vector<double> patch_areas;       ///< Of each flat patch at its least triangle [m²]; 0 elsewhere.
  std::vector<MeshFace> faces;           ///< Patches of several triangles that are convex polygons.
  std::vector<int> face_of_patch;        ///< Index in `faces` of each patch at its least triangle; else -1.
  std::vector<MeshPatch> other_patches;  ///< Those of several triangles that are no faces.
  std::vector<int> other_of_patch;       ///< Index there, as face_of_patch.
  std::map<int, int> straight_edges;     ///< Number of the straight edge that an edge of their borders is a
                                         ///< part of, where it is another one.
  std::shared_ptr<const Shape> convex;   ///< The solid inside, if it is convex; else null.
  double convex_error = 0;               ///< How far the two may differ: the surface is flat to this [m].
  std::vector<int> shell_vertices;       ///< One vertex of each part that is connected by edges.
  std::vector<bool>
      is_crease_corner;  ///< Vertex where creases end or bend: not inside a flat patch or a straight crease.
  bool is_closed =
      false;        ///< Every edge has exactly two triangles, which run through it in opposite directions.
  double size = 0;  ///< Longest side of the box about the mesh [m].

  /// Triangles whose boxes overlap the box, ascending.
  std::vector<int> overlapping(const Aabb& box) const;
};

/// Number of the edge from corner k of triangle t to the next, the same from both its sides: 3 t + k of the
/// lower triangle.
int edge_number(const TriangleMesh& mesh, const TriangleTree& tree, int t, int k);

/// The convex solid that a mesh bounds, or the shape itself.
inline const Shape& convex_solid(const Shape& shape) {
  const Mesh* const mesh = std::get_if<Mesh>(&shape);
  return mesh != nullptr && mesh->tree != nullptr && mesh->tree->convex != nullptr ? *mesh->tree->convex
                                                                                   : shape;
}

/// Builds the hierarchy by the surface-area heuristic on binned centres.
///
/// Source: Wald, On Fast Construction of SAH-based Bounding Volume Hierarchies, IEEE Symposium on Interactive
/// Ray Tracing, 2007.
std::shared_ptr<const TriangleTree> make_triangle_tree(const TriangleMesh& mesh);

}  // namespace rigor
