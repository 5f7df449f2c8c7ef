#pragma once

#include "rigor/geometry/shape/shape.hpp"
#include "rigor/math/pose.hpp"

namespace rigor {

/// Position of a point relative to a shape.
struct PointDistance {
  double distance = 0;      ///< [m]; negative inside.
  Vec3 p_W = Vec3::Zero();  ///< Nearest point of the surface [m].
  Vec3 n_W = Vec3::Zero();  ///< Unit, the gradient of the distance: outward. p = p_W + distance · n_W.
};

/// Signed distance of the point p_W from the surface of the shape, in closed form where there is one: for an
/// ellipsoid by Newton's method from the side where it cannot overshoot; for a polyhedron from outside by
/// GJK, from inside by the nearest face. A mesh that is not closed has no inside: its distance is never
/// negative. Where there are several nearest points, as on an axis, one of them is returned.
PointDistance point_distance(const Shape& shape, const Pose& X_WS, const Vec3& p_W);

}  // namespace rigor
