#pragma once

#include "rigor/bulk/narrow_phase/collide_polytopes.hpp"

#include <optional>

namespace rigor {

/// An ellipsoid in the frame O of a pair: the points M u + center, |u| = 1.
struct EllipsoidCore {
  Mat3f M;
  Vec3f center;  ///< [m].
  float extent;  ///< The largest radius [m].
  float inner;   ///< The least one [m].
  float rolls;   ///< Radius of a ball that can touch each point of the surface from inside [m].

  /// How far it reaches along n, from O.
  float reach(const Vec3f& n) const { return n.dot(center) + (M.transpose() * n).norm(); }
  /// Its point that is farthest along n.
  Vec3f farthest(const Vec3f& n) const;
};

EllipsoidCore place_ellipsoid(const BulkShape& shape, const PlacedShape& placed, const Vec3f& p_OB);

/// Where an ellipsoid and another core touch, or are nearest: at two points that differ along n alone.
struct SmoothTouch {
  Vec3f n;           ///< Unit, from the ellipsoid to the other core.
  Vec3f p;           ///< The ellipsoid's point [m]; that of the other core is p + separation n.
  float separation;  ///< What n parts the cores by; if that is more than the limit, p does not matter [m].
};

/// Finds where two ellipsoids touch; the answer depends on the poses alone. Nothing if it is not known.
std::optional<SmoothTouch> touch_ellipsoids(const EllipsoidCore& a, const EllipsoidCore& b, float limit);
/// Of an ellipsoid and a point, a segment, a box or a hull (without its radius).
std::optional<SmoothTouch> touch_polytope(const EllipsoidCore& own, const PlacedPolytope& other, float limit);
/// Of an ellipsoid and a point: where the search from the guess (unit, from the ellipsoid to the point) comes
/// to rest, however deep that is.
std::optional<SmoothTouch> touch_point_near(const EllipsoidCore& own, const Vec3f& q, const Vec3f& guess);

}  // namespace rigor
