#pragma once

#include "rigor/geometry/shape/shape.hpp"

namespace rigor {

/// A point of the shape farthest along the direction d_S (any length > 0), in S [m]. The shape is convex and
/// bounded (not a plane); for a mesh the farthest vertex. Deterministic among equals.
Vec3 support_point(const Shape& shape, const Vec3& d_S);

/// max over the shape of d_S · p = d_S · support_point(d_S).
double support_value(const Shape& shape, const Vec3& d_S);

/// Radius of the smallest ball about c_S that holds the shape [m]; infinity for a plane.
double radius_about(const Shape& shape, const Vec3& c_S);

/// A point of the shape that lies on that ball: farthest from c_S. The shape is bounded. Deterministic among
/// equals.
Vec3 farthest_point(const Shape& shape, const Vec3& c_S);

}  // namespace rigor
