#pragma once

#include "rigor/geometry/shape/shape.hpp"
#include "rigor/math/pose.hpp"

namespace rigor {

/// Where a point lies relative to a shape.
struct PointDistance {
  double distance = 0;      ///< [m]; negative inside.
  Vec3 p_W = Vec3::Zero();  ///< Nearest point of the surface [m].
  Vec3 n_W = Vec3::Zero();  ///< Unit, the gradient of the distance: outward. p = p_W + distance · n_W.
};

/// Signed distance of the point p_W from the surface of the shape. In closed form; of an ellipsoid by
/// Newton's method from the side where it cannot overshoot; of a polyhedron from outside by GJK, from inside
/// the nearest face. A mesh that is not closed has no inside: its distance is never negative. At places with
/// several nearest points, as on an axis, one of them.
PointDistance point_distance(const Shape& shape, const Pose& X_WS, const Vec3& p_W);

}  // namespace rigor
