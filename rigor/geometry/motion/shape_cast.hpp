#pragma once

#include "rigor/geometry/shape/shape.hpp"
#include "rigor/math/pose.hpp"

#include <optional>

namespace rigor {

/// A shape that is pushed along without turning, from X_WS by translation_W.
struct ShapeCast {
  const Shape* shape;  ///< Must outlive this.
  Pose X_WS;
  Vec3 translation_W;  ///< [m].
};

/// Where a shape that is pushed along first touches another.
struct ShapeCastHit {
  /// The part of the translation that is proven free: at no smaller fraction they touch.
  double fraction = 0;
  /// At this fraction they do, to rounding; at most 1e-12 above `fraction`.
  double upper = 0;
  Vec3 p_W = Vec3::Zero();  ///< The point of contact [m].
  Vec3 n_W = Vec3::Zero();  ///< Unit normal there, from the cast shape to the other.
};

/// First contact of the cast shape with another shape, or nothing if the whole way is proven free. Shapes
/// that touch or overlap at the beginning meet at fraction 0. Not for two half-spaces.
std::optional<ShapeCastHit> cast_shape(const ShapeCast& cast, const Shape& other, const Pose& X_WO);

}  // namespace rigor
