#pragma once

#include "rigor/geometry/convex/distance_result.hpp"
#include "rigor/geometry/motion/rigid_motion.hpp"
#include "rigor/geometry/shape/shape.hpp"
#include "rigor/math/pose.hpp"

#include <span>

namespace rigor {

/// A shape on a moving body. Both must outlive it.
struct MovingShape {
  const Shape* shape;
  Pose X_BS;  ///< Place of the shape on the body.
  const RigidMotion* motion;

  Pose pose(double t) const { return motion->sample(t).X_WB * X_BS; }
};

struct TimeOfContactOptions {
  double time_tolerance = 1e-12;  ///< Width of the bracket [s]; never less than the resolution of time.
  int most_evaluations = 200000;  ///< Distances before the search gives up.
};

/// The first contact of two moving bodies with its proof.
struct TimeOfContact {
  bool is_contact = false;
  /// False if the search gave up, as for bodies that glide along each other at no distance: then the span is
  /// free until `lower`, and nothing is known of the rest.
  bool is_complete = true;
  double lower =
      0;  ///< At no time from t0 to here the bodies touch [s]; without contact the end of the span.
  double upper = 0;           ///< At this time they do, to rounding [s].
  DistanceResult distance{};  ///< In the bracket, of the parts that touch: witness points and normal.
  int shape_A = 0;            ///< Which shapes touch.
  int shape_B = 0;
  int evaluations = 0;  ///< Distances computed.
};

/// First time in [t0, t1] at which a shape of A touches a shape of B, or none. The bracket [lower, upper] is
/// no wider than the time tolerance; the span before it is proven free, not sampled. Shapes that touch or
/// overlap at t0 are in contact there, whichever way they move.
///
/// Conservative advancement, best first: every pair of convex parts (shapes, boxes of the nodes of a mesh's
/// tree, triangles) knows until when it is free. The pair with the least time is advanced by its certified
/// lower bound of the distance and the bound of SeparationBound, which is of second order; a box is then cut
/// into its children, which go on from that time. So parts that never come near are looked at once. Any pair
/// of shapes but two half-spaces; a half-space may turn about its normal only.
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
