#pragma once

#include "rigor/geometry/shape/shape.hpp"

#include <span>

namespace rigor {

/// A convex, bounded shape as the distance algorithms see it: a core that is the hull of a few simple pieces
/// (points, circles or one ellipsoid), grown by `radius` on all sides. A sphere is a point plus a radius, a
/// capsule a segment plus a radius. Owns nothing: the points (or the hull) must outlive it. Building one
/// costs no allocation.
struct ConvexCore {
  enum class Kind { point, segment, points, box, cylinder, cone, ellipsoid };
  Kind kind = Kind::point;
  double radius = 0;  ///< Of the ball added to the core [m].
  Vec3 size =
      Vec3::Zero();  ///< Half extents; radii; (r, r, half_length); (0, 0, half_length) of a segment [m].
  std::span<const Vec3> points;      ///< Vertices if kind is points [m].
  const ConvexHull* hull = nullptr;  ///< Adjacency and face normals of the points, where there are any.
  double extent = 0;                 ///< No point of the core is farther from the origin of its frame [m].
};

/// Core of a bounded convex shape (not a plane, not a mesh: a broken promise).
ConvexCore make_core(const Shape& shape);

/// Core of the hull of the points (a triangle has three), which may lie in one plane or line.
ConvexCore make_points_core(std::span<const Vec3> points);

/// A support point and the piece of the core it lies on.
struct CorePoint {
  Vec3 p;     ///< [m].
  int piece;  ///< Vertex (index or sign bits), circle (0 at -z, 1 at +z; the apex of a cone is 1) or
              ///< ellipsoid (0).
};

/// Farthest point of the core along d (any length > 0). The search in a large hull begins at vertex `start`.
CorePoint core_support(const ConvexCore& core, const Vec3& d, int start = 0);

/// Farthest point of one piece along d.
Vec3 piece_point(const ConvexCore& core, int piece, const Vec3& d);

/// Derivative of piece_point with respect to d at the unit vector d [m]: the radii of curvature of the piece,
/// zero for a vertex.
Mat3 piece_curvature(const ConvexCore& core, int piece, const Vec3& d);

/// Is the core the hull of points only?
inline bool is_polytope(const ConvexCore& core) {
  return core.kind <= ConvexCore::Kind::box;
}

/// Outward unit normal of the flat face of the core that is best aligned with d, of a hull that at the vertex
/// farthest along d; zero if there is no flat face.
Vec3 nearest_face_normal(const ConvexCore& core, const Vec3& d);

}  // namespace rigor
