#pragma once

#include "rigor/geometry/convex/distance_result.hpp"
#include "rigor/geometry/motion/rigid_motion.hpp"
#include "rigor/geometry/shape/shape.hpp"
#include "rigor/math/pose.hpp"

#include <span>

namespace rigor {

/// A shape on a moving body. The shape and the motion must outlive it.
struct MovingShape {
  /// What moves.
  const Shape* shape;
  Pose X_BS;  ///< Pose of the shape on the body.
  /// How its body moves.
  const RigidMotion* motion;

  /// Where the shape is at t [s].
  Pose pose(double t) const { return motion->sample(t).X_WB * X_BS; }
};

/// How exactly the time is sought.
struct TimeOfContactOptions {
  double time_tolerance = 1e-12;  ///< Width of the bracket [s]; never less than the resolution of time.
  int most_evaluations = 200000;  ///< Number of distance computations before the search gives up.
};

/// The first contact of two moving bodies, with the bracket that proves it.
struct TimeOfContact {
  /// Whether they touch at all within the span.
  bool is_contact = false;
  /// False if the search gave up, as it does for bodies that glide along each other at almost no distance.
  /// Then the span is free until `lower`, and nothing is known of the rest.
  bool is_complete = true;
  double lower = 0;  ///< The bodies touch at no time in [t0, lower) [s]; without contact the end of the span.
  double upper = 0;  ///< The bodies touch at this time, to rounding [s].
  DistanceResult distance{};  ///< Of the parts that touch, at a time in the bracket.
  int shape_A = 0;            ///< Index in A of the shape that touches.
  int shape_B = 0;            ///< Index in B of the shape that touches.
  int evaluations = 0;        ///< Number of distances computed.
};

/// First time in [t0, t1] at which a shape of A touches a shape of B, or none. The bracket [lower, upper] is
/// no wider than the time tolerance; the span before it is proven free, not sampled. Shapes that touch or
/// overlap at t0 are in contact there, however they move.
///
/// Conservative advancement, best first: every pair of convex parts (shapes, boxes of the nodes of a mesh's
/// tree, triangles) has a time until which it is proven free. The pair with the least time is advanced by its
/// certified lower bound of the distance and by SeparationBound, which is of second order; a box is then
/// split into its children, which continue from that time. So parts that never come near are examined once.
/// Any pair of shapes is allowed except two half-spaces; a half-space may rotate about its normal only.
///
/// Sources: Mirtich, Impulse-based Dynamic Simulation of Rigid Body Systems, thesis, 1996, ch. 2; Tang, Kim
/// and Manocha, C2A: Controlled Conservative Advancement for Continuous Collision Detection of Polygonal
/// Models, ICRA 2009 (there depth first with one time for all parts). docs/theory/time_of_impact.md.
TimeOfContact find_time_of_contact(std::span<const MovingShape> A, std::span<const MovingShape> B, double t0,
                                   double t1, const TimeOfContactOptions& options = {});

/// The same for two shapes.
TimeOfContact find_time_of_contact(const MovingShape& A, const MovingShape& B, double t0, double t1,
                                   const TimeOfContactOptions& options = {});

}  // namespace rigor
