#pragma once

#include "rigor/geometry/lanes/lane_target.hpp"
#include "rigor/math/types.hpp"

#include <array>

namespace rigor {

using TriangleCorners = std::array<Vec3, 3>;

/// The point as seen along a coordinate axis: its two other coordinates.
inline Vec2 seen_along(const Vec3& p, int axis) {
  return {p[(axis + 1) % 3], p[(axis + 2) % 3]};
}

/// Whether two triangles have a point in common, borders included: exact for the coordinates as they are.
bool triangles_meet(const TriangleCorners& t, const TriangleCorners& u);

/// Whether the segment pq has a point in common with the triangle, borders included; exact.
bool segment_meets(const Vec3& p, const Vec3& q, const TriangleCorners& t);

/// Distance of two triangles as sets of points, and the features that determine it.
struct TriangleDistance {
  double squared;  ///< [m²]; 0 exactly where they have a point in common.
  int feature;  ///< 0 to 8: edges i of A and k of B as 3 i + k (edge k runs from corner k to k + 1); 9 to 11:
                ///< corner of B and the face of A; 12 to 14: corner of A and the face of B; -1: they meet.
};

/// The least of the nine distances of two edges and the six of a corner and a face, or 0 if the triangles
/// meet. Nearly parallel edges lose no digits: parameters along them come from the cross product of their
/// directions. Errors: a few roundings of the coordinates relative to the first corner of A.
TriangleDistance triangle_distance(const TriangleCorners& a, const TriangleCorners& b,
                                   LaneTarget target = best_lane_target());

/// The points of A and B at that distance; where they meet, a point of the common segment, twice.
std::array<Vec3, 2> nearest_points(const TriangleCorners& a, const TriangleCorners& b, int feature);

}  // namespace rigor
