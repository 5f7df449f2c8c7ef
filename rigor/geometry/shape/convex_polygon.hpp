#pragma once

#include "rigor/math/types.hpp"

#include <vector>

namespace rigor {

/// Plane normal · p = offset. What lies along the normal is in front of it, the rest behind.
struct CutPlane {
  Vec3 normal = Vec3::UnitZ();  ///< Unit.
  double offset = 0;            ///< [m].

  double height(const Vec3& p) const { return normal.dot(p) - offset; }
};

/// Corners of a flat convex polygon in space, in order [m].
using ConvexPolygon = std::vector<Vec3>;

/// The two parts of a polygon that a plane cuts; a part without area is empty.
struct PolygonParts {
  ConvexPolygon back, front;
  bool is_in_plane = false;  ///< All corners are on the plane; then both parts are empty.
};

/// Cuts the polygon. Corners within the tolerance [m] of the plane count as on it and are not moved, so that
/// cuts through corners and along edges make no slivers. Two polygons with a common edge, whichever way each
/// runs through it, get the same new corner there bit for bit.
PolygonParts cut_polygon(const ConvexPolygon& polygon, const CutPlane& plane, double tolerance);

/// Area vector: normal by the right-hand rule, as long as the area [m²].
Vec3 area_vector(const ConvexPolygon& polygon);

/// Distance of the point from the polygon [m].
double polygon_distance(const ConvexPolygon& polygon, const Vec3& p);

}  // namespace rigor
