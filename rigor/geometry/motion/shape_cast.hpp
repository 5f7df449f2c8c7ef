#pragma once

#include "rigor/geometry/shape/shape.hpp"
#include "rigor/math/pose.hpp"

#include <optional>

namespace rigor {

/// A shape that is translated without rotation from the pose X_WS by translation_W.
struct ShapeCast {
  const Shape* shape;  ///< Must outlive this object.
  /// Where the shape is at the beginning [m].
  Pose X_WS;
  Vec3 translation_W;  ///< [m].
};

/// The place at which a cast shape first touches another.
struct ShapeCastHit {
  /// The fraction of the translation that is proven free: the shapes touch at no smaller one.
  double fraction = 0;
  /// The fraction at which the shapes touch, to rounding; at most 1e-12 above `fraction`.
  double upper = 0;
  Vec3 p_W = Vec3::Zero();  ///< The point of contact [m].
  Vec3 n_W = Vec3::Zero();  ///< Unit normal there, from the cast shape to the other.
};

/// First contact of the cast shape with another shape, or nothing if the whole path is proven free. Shapes
/// that touch or overlap at the start meet at fraction 0. Not defined for two half-spaces.
std::optional<ShapeCastHit> cast_shape(const ShapeCast& cast, const Shape& other, const Pose& X_WO);

}  // namespace rigor
