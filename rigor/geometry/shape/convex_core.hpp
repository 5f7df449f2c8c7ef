#pragma once

#include "rigor/core/index.hpp"
#include "rigor/geometry/shape/shape.hpp"

#include <span>

namespace rigor {

/// A convex, bounded shape as the distance algorithms see it: a core that is the hull of a few simple pieces
/// (points, rings about z or one ellipsoid), grown by `radius` on all sides. A sphere is a point plus a
/// radius, a capsule a segment plus a radius. Owns nothing: the points (or the hull) must outlive it.
/// Building one costs no allocation.
struct ConvexCore {
  enum class Kind { point, segment, points, box, rings, ellipsoid };
  Kind kind = Kind::point;
  double radius = 0;         ///< Of the ball added to the core [m].
  Vec3 size = Vec3::Zero();  ///< Half extents; radii; (0, 0, half_length) of a segment; (lower radius, upper
                             ///< radius, half_length) of two rings that are not in `rings` [m].
  std::span<const Vec3> points;      ///< Vertices if kind is points [m].
  const ConvexHull* hull = nullptr;  ///< Adjacency and face normals of the points, where there are any.
  std::span<const Ring> rings;       ///< Of a solid of more than two, z ascending and convex; else empty.
  double extent = 0;                 ///< No point of the core is farther from the origin of its frame [m].
};

/// Core of a bounded convex shape (not a plane, not a mesh: a broken promise).
ConvexCore make_core(const Shape& shape);

/// Core of the hull of the points (a triangle has three), which may lie in one plane or line.
ConvexCore make_points_core(std::span<const Vec3> points);

/// A support point and the piece of the core it lies on.
struct CorePoint {
  Vec3 p;     ///< [m].
  int piece;  ///< Vertex (index or sign bits), ring (from 0, the lowest, up; one without a radius is an apex)
              ///< or ellipsoid (0).
};

/// The rings of a solid of revolution (a cylinder or a cone has two), from the lowest up.
inline int ring_count(const ConvexCore& core) {
  return core.rings.empty() ? 2 : static_cast<int>(core.rings.size());
}
inline Ring ring_of(const ConvexCore& core, int i) {
  if (!core.rings.empty()) return core.rings[at(i)];
  return i == 0 ? Ring{core.size.x(), -core.size.z()} : Ring{core.size.y(), core.size.z()};
}

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
