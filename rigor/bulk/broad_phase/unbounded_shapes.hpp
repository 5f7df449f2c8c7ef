#pragma once

#include "rigor/bulk/broad_phase/shape_places.hpp"

namespace rigor {

/// A plane or a cavity of a body that is not dynamic.
struct UnboundedShape {
  int body, shape;
  bool is_cavity;
  Vec3 point_B;   ///< A point of the plane, or the centre of the cavity [m].
  Vec3 normal_B;  ///< Normal of the plane.
  double radius;  ///< Radius of the cavity [m].
};
/// Where an unbounded shape is and how it moves, relative to an origin, along W's axes.
struct UnboundedPlace {
  float point[3];   ///< [m].
  float normal[3];  ///< Normal of a plane.
  float u[3];       ///< Velocity of the body at `point` [m/s].
  float w[3];       ///< [rad/s].
  float slack;      ///< Bound of the rounding of all that [m].
};

UnboundedShape make_unbounded_shape(int body, int shape_index, const BodyShape& shape);
UnboundedPlace place_of(const UnboundedShape& shape, const BulkBodies& bodies, const Vec3& origin);

/// How far a bounded shape can come to an unbounded one within h [s]; and whether it may come within the
/// margin [m]. As for two bounded shapes.
float approach_bound(const UnboundedPlace& a, const ShapePlace& b, float h);
bool may_be_within(const UnboundedShape& shape, const UnboundedPlace& a, const ShapePlace& b,
                   const Quat& q_WB, float margin);

}  // namespace rigor
