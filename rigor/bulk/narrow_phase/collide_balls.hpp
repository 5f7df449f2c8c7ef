#pragma once

#include "rigor/bulk/lanes/float_lanes.hpp"
#include "rigor/bulk/narrow_phase/manifold.hpp"
#include "rigor/geometry/lanes/lane_target.hpp"

namespace rigor {

/// Eight pairs of balls, along W's axes.
struct BallPairs {
  alignas(32) float p[3][kLaneCount];  ///< Centre of ball A from that of body A [m].
  alignas(32) float d[3][kLaneCount];  ///< From the centre of ball A to that of ball B [m].
  alignas(32) float radius_A[kLaneCount];
  alignas(32) float radius_B[kLaneCount];
};
/// The points where they are nearest to each other.
struct BallContacts {
  alignas(32) float normal[3][kLaneCount];  ///< From A to B; z where the centres coincide.
  alignas(32) float p[3][kLaneCount];       ///< As in a Manifold.
  alignas(32) float gap[kLaneCount];
};

/// The contacts of eight pairs of balls, whether they touch or not.
void collide_balls(const BallPairs& pairs, LaneTarget target, BallContacts& contacts);

/// The contact of one lane as a manifold of one point.
Manifold ball_manifold(const BallContacts& contacts, int lane);

}  // namespace rigor
