#pragma once

#include "rigor/bulk/broad_phase/box_tree.hpp"
#include "rigor/bulk/state/bulk_bodies.hpp"

#include <array>
#include <optional>

namespace rigor {

/// A bounded shape as the broad phase sees it: all points within `radius` of a core that is inside a box and
/// inside a ball, both about the same centre.
struct ShapeBound {
  float center_B[3];     ///< Centre in the body's frame [m].
  float half[3];         ///< Half extents of the box along the axes of the shape's frame [m].
  float reach;           ///< Radius of the ball [m].
  float radius;          ///< [m].
  float R_BS[9];         ///< Rows.
  bool is_turned;        ///< R_BS is not the identity.
  bool is_centred_ball;  ///< A ball about the centre of the body: rotation does not move it.
};

/// Where a shape is and how it moves: its centre relative to an origin, the velocity of its centre and its
/// angular velocity, along W's axes.
struct ShapePlace {
  float center[3];  ///< [m].
  float u[3];       ///< [m/s].
  float w[3];       ///< [rad/s].
  float slack;      ///< Bound of the rounding of all that [m].
  const ShapeBound* bound;
};

/// Rows of R_WS: the axes of a bound's box.
struct BoxAxes {
  float row[9];
};
BoxAxes axes_of(const ShapeBound& bound, const Quat& q_WB);

/// The bound of a bounded shape of a body.
ShapeBound make_shape_bound(const BodyShape& shape);

/// A shape's place now, and the box (relative to the origin) that holds it until h [s] from now at its
/// present velocities, with `margin` [m] around it.
struct SweptShape {
  ShapePlace place;
  FloatBox box;
};
struct SweepStep {
  const Vec3& origin;
  float h, margin;
};
SweptShape sweep_shape(const ShapeBound& bound, const BulkBodies& bodies, int body, const Vec3& origin,
                       float h, float margin);
/// The same, to the last bit, for eight consecutive bodies with one shape each, along the axes of the body:
/// their places and boxes are written from `places` and `boxes` on.
void sweep_eight_shapes(const std::array<const ShapeBound*, 8>& bounds, const BulkBodies& bodies,
                        int first_body, const SweepStep& step, ShapePlace* places, FloatBox* boxes);

/// The margin of a pair [m]: `margin` plus how far the two shapes can come to each other within h [s] at
/// their present velocities, to first order in h: the farther ends of a rotating shape count, the curvature
/// of their paths does not. Nothing if the boxes and balls are farther apart than that. q_WA and q_WB are the
/// orientations of the bodies.
struct PairPlaces {
  const ShapePlace &a, &b;
  const Quat &q_WA, &q_WB;
};
std::optional<float> find_pair_margin(const PairPlaces& pair, float h, float margin);

}  // namespace rigor
