#pragma once

#include "rigor/geometry/shape/revolution.hpp"
#include "rigor/math/types.hpp"

#include <memory>
#include <variant>

namespace rigor {

class MeshSolid;      // rigor/geometry/decomposition/mesh_solid.hpp
struct ConvexHull;    // rigor/geometry/shape/convex_hull.hpp
struct TriangleMesh;  // rigor/geometry/shape/triangle_mesh.hpp
struct TriangleTree;  // rigor/geometry/mesh/triangle_tree.hpp

// Every shape lies in its own frame S. Lengths in m. Axes of revolution are z.
//
// The shapes below are plain numbers: each function of shapes has a visitor with one overload for each of
// them. A shape in a file of its own (revolution.hpp) answers as members, which the last overload of a
// visitor calls. A shape that does neither does not compile: docs/extending.md lists the places.

/// Ball about the origin.
struct Sphere {
  double radius;  ///< > 0.
};
/// Box about the origin, edges along the axes.
struct Box {
  Vec3 half_extents;  ///< Each > 0.
};
/// All points within radius of the segment |z| ≤ half_length.
struct Capsule {
  double radius;       ///< > 0.
  double half_length;  ///< Of the cylindrical part, ≥ 0.
};
/// Cylinder |z| ≤ half_length, x² + y² ≤ radius².
struct Cylinder {
  double radius;       ///< > 0.
  double half_length;  ///< > 0.
};
/// Cone with its base disk of the given radius at z = -half_length and its apex at z = +half_length (so the
/// origin is at half height, not at the centre of mass, which lies at z = -half_length/2).
struct Cone {
  double radius;       ///< > 0.
  double half_length;  ///< > 0.
};
/// (x/a)² + (y/b)² + (z/c)² ≤ 1.
struct Ellipsoid {
  Vec3 radii;  ///< a, b, c, each > 0.
};
/// Half-space normal · p ≤ offset: unbounded, only on static or kinematic bodies.
struct HalfSpace {
  Vec3 normal;    ///< Unit, pointing out of the solid.
  double offset;  ///< [m].
};
/// Everything outside the ball of this radius about the origin: bodies are inside it. Unbounded, only on
/// static or kinematic bodies; goes with shapes that have corner balls (corner_balls.hpp).
struct Cavity {
  double radius;  ///< > 0.
};
/// Convex polyhedron; its vertices are in S.
struct Convex {
  /// Never null.
  std::shared_ptr<const ConvexHull> hull;
};
/// Closed (on dynamic bodies) surface of triangles, not necessarily convex; its vertices are in S. Made by
/// make_mesh.
struct Mesh {
  /// Never null.
  std::shared_ptr<const TriangleMesh> mesh;
  std::shared_ptr<const TriangleTree> tree;  ///< Of `mesh`; distance and contacts need it.
  std::shared_ptr<const MeshSolid> solid{};  ///< Its inside, computed when it is needed.
};

using Shape = std::variant<Sphere, Box, Capsule, Cylinder, Cone, Ellipsoid, HalfSpace, Convex, Mesh, Cavity,
                           Revolution>;

/// Name of the shape's type in a scene file: "sphere", "box", "capsule", "cylinder", "cone", "ellipsoid",
/// "plane", "convex", "mesh", "cavity" or "revolution".
const char* shape_type_name(const Shape& shape);

/// Half-spaces and cavities: solids without an end.
bool is_unbounded(const Shape& shape);

}  // namespace rigor
