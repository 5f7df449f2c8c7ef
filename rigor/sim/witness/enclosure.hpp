#pragma once

#include "rigor/geometry/shape/aabb.hpp"
#include "rigor/model/body_shapes.hpp"

namespace rigor {

/// A simple solid on a body that holds one of its shapes: a ball, all outside of a ball, a half-space, or a
/// box along the axes of the shape.
class Enclosure {
 public:
  explicit Enclosure(const BodyShape& shape);

  /// Distance of a point of the body's frame from the enclosure, so that the shape is no nearer; 0 inside
  /// [m].
  double gap(const Vec3& p_B) const;
  /// Rotations of the body by θ move no point of the enclosure, seen as a set, by more than θ times this [m].
  double turning_radius() const;
  /// A box in W that holds it.
  Aabb box(const Pose& X_WB) const;

 private:
  enum class Kind { ball, outside_of_ball, half_space, box };
  Kind kind_ = Kind::box;
  Pose X_SB_;             ///< Its frame has its middle as origin and its axes.
  double radius_ = 0;     ///< Of the ball [m].
  Vec3 normal_{0, 0, 1};  ///< Of the half-space, whose surface is `radius_` beyond the origin along it.
  Vec3 half_{0, 0, 0};    ///< Half sizes of the box [m].
};

}  // namespace rigor
